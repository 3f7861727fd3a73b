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
#include "assessment/domain/study/competence_design.h"

namespace torsio {

/// What an LC-CUSUM with the limit of a design does within so many attempts.
struct CompetenceErrors {
  std::int64_t attempts = 0;
  double falsePass = 0.0;  ///< probability that a trainee with the inadequate failure rate is declared able
  double falseFail = 0.0;  ///< probability that a trainee with the adequate failure rate is not
  /// Probability that one with the adequate rate was declared able and is, by a false alarm, not any more.
  double falseAlarm = 0.0;
  friend bool operator==(const CompetenceErrors&, const CompetenceErrors&) = default;
};

/// Computes both error rates, exactly. `attempts` at least 1.
[[nodiscard]] CompetenceErrors competenceErrors(const CompetenceDesign& design, std::int64_t attempts);

inline constexpr std::int64_t kMaxCompetenceAttempts = 1'000;
/// Checks the numbers of a design and gives it the smallest limit, in steps of 0.01, that keeps its largest
/// false pass within its attempts. Throws Error{kBadParameter} for a number that is no number or out of range
/// (rates above 0 and below 1, inadequate above adequate, 1 to kMaxCompetenceAttempts attempts, a tolerance
/// above 0 and at most half a turn), and when no limit keeps the largest false pass.
[[nodiscard]] CompetenceDesign plannedCompetence(CompetenceDesign design);
/// A planned design and what it does, before anybody registers it.
struct CompetencePreview {
  CompetenceDesign design{};
  CompetenceErrors errors{};
  bool falseFailKept = false;
};
/// Plans a design and computes its error rates. Throws as plannedCompetence.
[[nodiscard]] CompetencePreview previewOfCompetence(const CompetenceDesign& design);
/// Throws Error{kBadParameter} when a planned design does not keep its largest false fail; the message says
/// which remains.
void requireFalseFailKept(const CompetenceDesign& design);

/// Returns the design shipped with every exercise, with the tolerance of this one.
[[nodiscard]] CompetenceDesign shippedCompetence(const ModuleId& moduleId, double tolerance_rad);

/// Returns the design that counts for somebody: the newest that was registered when the first attempt began,
/// else the shipped one. What is registered later is for those who begin later. `registered`: oldest first.
[[nodiscard]] CompetenceDesign designInForce(std::span<const CompetenceDesign> registered,
                                             const CompetenceDesign& shipped,
                                             std::optional<std::int64_t> firstAttemptUtc_us);

/// One run that counts.
struct CompetenceRun {
  bool untwisting = false;
  RunOutcome outcome = RunOutcome::kNotPassed;  ///< of an untwisting; one that was not judged is no attempt
  bool withinLimits = true;                     ///< kept the limits of force and torque of the exercise
  double tolerance_rad = 0.0;                   ///< by which `twists` were judged
  std::vector<JudgedTwist> twists{};
};

/// Cuts runs, oldest first, into attempts; true: failed. In a run that went beyond a limit no twist succeeds.
[[nodiscard]] std::vector<bool> failedAttempts(const CompetenceDesign& design,
                                               std::span<const CompetenceRun> runs);

enum class SkillLevel {
  kNotShown,  ///< fewer attempts than anybody needs to be shown able
  kLearning,  ///< not yet shown to be able
  kSteady,    ///< able, and stays so
  kWatch,     ///< able before; the last attempts raise a doubt
  kRelapsed,  ///< able before; the doubt has become an alarm
};

/// Whether a level says that somebody is able now.
[[nodiscard]] constexpr bool isAble(SkillLevel level) noexcept {
  return level == SkillLevel::kSteady || level == SkillLevel::kWatch;
}

/// By what an attempt at an exercise is a success, and somebody competent.
struct CompetenceRule {
  CompetenceDesign design{};
  bool untwisting = false;               ///< an attempt is a whole untwisting
  std::optional<double> forceLimit_N{};  ///< of the exercise: no twist of a run beyond it is a success
  std::optional<double> torqueLimit_Nm{};
  friend bool operator==(const CompetenceRule&, const CompetenceRule&) = default;
};

/// What the rule says of somebody's attempts.
struct CompetenceVerdict : CompetenceRule {
  CompetenceErrors errors{};  ///< within the attempts of the design, or those made when they are more
  SkillLevel level = SkillLevel::kNotShown;
  std::size_t attempts = 0;
  std::size_t failed = 0;
  std::size_t attemptsUntilLevel = 0;   ///< of kNotShown
  std::vector<double> sums{};           ///< one an attempt: LC-CUSUM until able, the relapse watch after
  std::optional<std::size_t> ableAt{};  ///< number of the attempt, from 1
  std::vector<TrialId> runs{};          ///< the runs that were judged, oldest first
  friend bool operator==(const CompetenceVerdict&, const CompetenceVerdict&) = default;
};

/// Returns how many attempts without a failure show somebody to be able.
[[nodiscard]] std::size_t fewestForAble(const CompetenceDesign& design);

/// Judges attempts, oldest first; true: failed.
[[nodiscard]] CompetenceVerdict judgeCompetence(const CompetenceDesign& design,
                                                const std::vector<bool>& failed);

}  // namespace torsio
