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

/// A recorded attempt at a module, with its measures.
struct Attempt {
  TrialId trialId{};
  ModuleId moduleId{};
  PhaseId phaseId{};
  std::optional<AttemptMode> mode{};  ///< empty: free practice
  std::int64_t startedUtc_us = 0;
  double duration_s = 0.0;
  bool ended = true;            ///< false: running, or interrupted and not yet closed
  std::int64_t twists = 0;      ///< completed
  std::int64_t onTarget = 0;    ///< of these, released on target
  std::int64_t unfinished = 0;  ///< not completed, counted separately
  std::int64_t forceCuts = 0;   ///< ServoHealth
  QuantityValues values{};      ///< AttemptMeasures::values
  RunVerdict verdict{};         ///< only if the run has ended
  bool excused = false;         ///< an interrupted run that does not count as failed

  /// Program or machine failed: kept, but not counted.
  [[nodiscard]] bool interrupted() const noexcept { return verdict.outcome == RunOutcome::kInterrupted; }
  /// Describes the result: "3 of 4 on target", or how an organ was untwisted.
  [[nodiscard]] Text result() const;
};

/// Returns a trainee's attempts, oldest first, without tracked recordings of the real arm; empty `moduleId`:
/// at all modules. Measures trials that were not measured yet. kTrialViewOwn, the actor's trials.
[[nodiscard]] std::vector<Attempt> attemptsOf(SessionContext& session, const PersonId& personId,
                                              const ModuleId& moduleId = {});

/// A tracker's recording on the real arm, which is no attempt at a module.
struct RealArmRun {
  TrialId trialId{};
  std::int64_t startedUtc_us = 0;
  double duration_s = 0.0;
  std::vector<Text> sentences{};  ///< foreignSentences()
};
/// Returns a trainee's recordings on the real arm that have ended, oldest first, and measures those that were
/// not measured yet. kTrialViewOwn, the actor's trials.
[[nodiscard]] std::vector<RealArmRun> realArmRuns(SessionContext& session, const PersonId& personId);

/// Returns whether an attempt counts for mastery and for the attempt limit: ended properly, and graded unless
/// the module is for practice.
[[nodiscard]] bool counts(const Attempt& attempt, const TrainingModule& module);

/// Progress towards one rule.
struct RuleProgress {
  MasteryRule rule{};
  std::int64_t streak = 0;  ///< current number of successive attempts that satisfy it
  bool met = false;         ///< the required number was reached once: mastery is permanent
  std::optional<double> last{};

  /// Returns "Overshoot: at most 5.0°, in 2 runs in a row (1 so far)".
  [[nodiscard]] Text text() const;
};
/// Evaluates the attempts that count, oldest first. An attempt that does not meet the module's demands,
/// lacks the rule's metric, or was interrupted without an excuse, ends the streak.
[[nodiscard]] std::vector<RuleProgress> ruleProgress(const TrainingModule& module,
                                                     std::span<const Attempt> attempts);

}  // namespace torsio
