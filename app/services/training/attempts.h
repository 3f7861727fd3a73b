// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/attempt/attempt_measures.h"
#include "assessment/attempt/mastery.h"
#include "assessment/attempt/run_verdict.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// One recorded try at a module, with what it is judged by.
struct Attempt {
  TrialId trialId{};
  ModuleId moduleId{};
  PhaseId phaseId{};
  std::optional<AttemptMode> mode{};  ///< empty: free practice
  std::int64_t startedUtc_us = 0;
  double duration_s = 0.0;
  bool ended = true;            ///< false: running, or interrupted and not closed yet
  std::int64_t twists = 0;      ///< completed
  std::int64_t onTarget = 0;    ///< of them, released on target
  std::int64_t unfinished = 0;  ///< not completed, counted apart
  std::int64_t forceCuts = 0;   ///< ServoHealth
  QuantityValues values{};      ///< AttemptMeasures::values
  RunVerdict verdict{};         ///< of one that has ended

  /// The program or the machine went down: kept, not counted.
  [[nodiscard]] bool interrupted() const noexcept { return verdict.outcome == RunOutcome::kInterrupted; }
  /// What it came to: "3 of 4 on target", or how an organ was untwisted.
  [[nodiscard]] Text result() const;
};

/// Reads what was measured of a stored trial (recording/kept_digests.h); measures it when nobody has yet.
/// kTrialViewOwn, own trials only.
Attempt attemptOf(SessionContext& session, const TrialId& trialId);

/// The tries of a trainee, oldest first, without what a tracker saw of the real arm; empty `moduleId`: at all
/// modules. Trials that were not measured yet are measured now. kTrialViewOwn, own trials only.
[[nodiscard]] std::vector<Attempt> attemptsOf(SessionContext& session, const PersonId& personId,
                                              const ModuleId& moduleId = {});

/// Whether an attempt counts for mastery and for the limit: ended in good order, and graded unless the module
/// is there for practice.
[[nodiscard]] bool counts(const Attempt& attempt, const TrainingModule& module);

/// How far one rule is.
struct RuleProgress {
  MasteryRule rule{};
  std::int64_t streak = 0;  ///< attempts in a row up to the last one
  bool met = false;         ///< so many in a row were reached once: mastery is not lost again
  std::optional<double> last{};

  /// "Overshoot: at most 5.0°, in 2 runs in a row (1 so far)".
  [[nodiscard]] Text text() const;
};
/// Over the attempts that count, oldest first. An attempt that does not meet the demands of the module, or
/// for which the metric of a rule is not defined, breaks the row.
[[nodiscard]] std::vector<RuleProgress> ruleProgress(const TrainingModule& module,
                                                     std::span<const Attempt> attempts);

}  // namespace torsio
