// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/access/workplace.h"
#include "app/recording/trial_trace.h"
#include "assessment/study/protocol_terms.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/base/live_types.h"
#include "sim/record/trial.h"

namespace torsio {

/// One recorded try at a module, with what it is judged by.
struct Attempt {
  std::string trialId{};
  std::string moduleId{};
  std::string phaseId{};
  std::optional<AttemptMode> mode{};  ///< empty: free practice
  std::int64_t startedUtc_us = 0;
  double duration_s = 0.0;
  bool ended = true;         ///< false: running, or interrupted and not closed yet
  bool interrupted = false;  ///< the program or the machine went down: kept, not counted
  std::int64_t twists = 0;
  std::int64_t onTarget = 0;
  /// By metric id, SI. Of a metric of single twists: the median over the twists. What is not defined is
  /// missing.
  std::map<std::string, double> values{};
};

/// Whether the recording ended in the middle of this twist: such a twist is not judged.
[[nodiscard]] bool cutOff(const MeasuredTwist& twist, std::span<const Sample> samples);

/// What one recording gives, from its samples. `tolerance_rad` and limits are those of the module.
[[nodiscard]] Attempt measureAttempt(const TrialHeader& header, std::span<const Sample> samples,
                                     double tolerance_rad, std::optional<double> forceLimit_N,
                                     std::optional<double> torqueLimit_Nm);
/// The same from twists that were measured already (wholeTrial off).
[[nodiscard]] Attempt attemptFrom(const TrialHeader& header, std::span<const Sample> samples,
                                  const MeasuredTrial& measured, double tolerance_rad);
/// Keeps what was measured beside the trial, with the version of the formulas, unless that was done before.
void keepAttempt(TrialRepository& trials, const std::string& trialId, const Attempt& attempt);

/// Measures a stored trial once and keeps the values beside it, with the version of the formulas. Does
/// nothing when they are there. kTrialViewOwn, own trials only.
Attempt attemptOf(Workplace& workplace, const std::string& trialId);

/// The tries of a trainee, oldest first; empty `moduleId`: at all modules. Trials that were not measured yet
/// are measured now. kTrialViewOwn, own trials only.
[[nodiscard]] std::vector<Attempt> attemptsOf(Workplace& workplace, const std::string& personId,
                                              const std::string& moduleId = {});

/// Whether an attempt counts for mastery and for the limit: ended in good order, and graded unless the module
/// is there for practice.
[[nodiscard]] bool counts(const Attempt& attempt, const StoredModule& module);

/// How far one rule is.
struct RuleProgress {
  StoredMasteryRule rule{};
  std::int64_t streak = 0;  ///< attempts in a row up to the last one
  bool met = false;         ///< so many in a row were reached once: mastery is not lost again
  std::optional<double> last{};
};
[[nodiscard]] bool reaches(const StoredMasteryRule& rule, double value) noexcept;
/// Over the attempts that count, oldest first. A rule whose metric is not defined for an attempt breaks the
/// row.
[[nodiscard]] std::vector<RuleProgress> ruleProgress(const StoredModule& module,
                                                     std::span<const Attempt> attempts);

}  // namespace torsio
