// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/attempt/attempt_measures.h"
#include "assessment/attempt/run_verdict.h"
#include "assessment/domain/study/curriculum.h"

namespace torsio {

/// Properties of an LC-CUSUM with a design's limit within a number of attempts.
struct CompetenceErrors {
  std::int64_t attempts = 0;
  double falsePass = 0.0;  ///< probability that a trainee with the inadequate failure rate is declared
                           ///< competent
  double falseFail = 0.0;  ///< probability that a trainee with the adequate failure rate is not
  /// Probability that a trainee with the adequate rate, declared competent, loses it by a false alarm.
  double falseAlarm = 0.0;
  friend bool operator==(const CompetenceErrors&, const CompetenceErrors&) = default;
};

/// Computes the error rates exactly. `attempts` at least 1.
[[nodiscard]] CompetenceErrors competenceErrors(const CompetenceDesign& design, std::int64_t attempts);

inline constexpr std::int64_t kMaxCompetenceAttempts = 1'000;
/// Checks a design's numbers and sets the smallest limit, in steps of 0.01, that meets its maximum false-pass
/// rate within its attempts. Throws Error{kBadParameter} for NaN or values out of range (rates above 0 and
/// below 1, inadequate above adequate, 1 to kMaxCompetenceAttempts attempts, a tolerance above 0 and at most
/// half a turn), and if no limit meets the maximum.
[[nodiscard]] CompetenceDesign plannedCompetence(CompetenceDesign design);
/// A planned design and its properties before registration.
struct CompetencePreview {
  CompetenceDesign design{};
  CompetenceErrors errors{};
  bool falseFailKept = false;
};
/// Plans a design and computes its error rates. Throws like plannedCompetence().
[[nodiscard]] CompetencePreview previewOfCompetence(const CompetenceDesign& design);
/// Throws Error{kBadParameter} if a planned design exceeds its maximum false-fail rate; the message states
/// the actual one.
void requireFalseFailKept(const CompetenceDesign& design);

/// Returns the design shipped with every exercise, with this exercise's tolerance.
[[nodiscard]] CompetenceDesign shippedCompetence(const ModuleId& moduleId, double tolerance_rad);

/// Returns the design for a trainee: the latest one registered before the first attempt, else the shipped
/// one. Later ones apply to trainees who start later. `registered`: oldest first.
[[nodiscard]] CompetenceDesign designInForce(std::span<const CompetenceDesign> registered,
                                             const CompetenceDesign& shipped,
                                             std::optional<std::int64_t> firstAttemptUtc_us);

/// One run that counts.
struct CompetenceRun {
  bool untwisting = false;
  RunOutcome outcome = RunOutcome::kNotPassed;  ///< of an untwisting; a run that was not judged is not an
                                                ///< attempt
  bool withinLimits = true;                     ///< within the exercise's limits of force and torque
  double tolerance_rad = 0.0;                   ///< with which `twists` were judged
  std::vector<JudgedTwist> twists{};
};

/// Splits runs, oldest first, into attempts; true: failed. All twists of a run beyond a limit count as
/// failed.
[[nodiscard]] std::vector<bool> failedAttempts(const CompetenceDesign& design,
                                               std::span<const CompetenceRun> runs);

enum class SkillLevel {
  kNotShown,  ///< fewer attempts than anybody needs to be shown competent
  kLearning,  ///< not yet shown to be competent
  kSteady,    ///< competent, without doubt
  kWatch,     ///< was competent; the last attempts raise a doubt
  kRelapsed,  ///< was competent; the doubt has become an alarm
};

/// Returns whether the level means competent now.
[[nodiscard]] constexpr bool isAble(SkillLevel level) noexcept {
  return level == SkillLevel::kSteady || level == SkillLevel::kWatch;
}

/// Conditions for success in an attempt and for competence.
struct CompetenceRule {
  CompetenceDesign design{};
  bool untwisting = false;               ///< an attempt is a whole untwisting
  std::optional<double> forceLimit_N{};  ///< of the exercise; all twists of a run beyond it count as failed
  std::optional<double> torqueLimit_Nm{};
  friend bool operator==(const CompetenceRule&, const CompetenceRule&) = default;
};

/// Result of the rule for a trainee's attempts.
struct CompetenceVerdict : CompetenceRule {
  CompetenceErrors errors{};  ///< within the design's attempts, or those made if there are more
  SkillLevel level = SkillLevel::kNotShown;
  std::size_t attempts = 0;
  std::size_t failed = 0;
  std::size_t attemptsUntilLevel = 0;   ///< for kNotShown
  std::vector<double> sums{};           ///< one per attempt: LC-CUSUM until competent, then the relapse watch
  std::optional<std::size_t> ableAt{};  ///< number of the attempt, from 1
  std::vector<TrialId> runs{};          ///< judged runs, oldest first
  friend bool operator==(const CompetenceVerdict&, const CompetenceVerdict&) = default;
};

/// Returns how many attempts without a failure prove competence.
[[nodiscard]] std::size_t fewestForAble(const CompetenceDesign& design);

/// Judges attempts, oldest first; true: failed.
[[nodiscard]] CompetenceVerdict judgeCompetence(const CompetenceDesign& design,
                                                const std::vector<bool>& failed);

}  // namespace torsio
