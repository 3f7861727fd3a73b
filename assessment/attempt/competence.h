// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/attempt/attempt_measures.h"
#include "assessment/attempt/run_verdict.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/statistics/run_dependence.h"

namespace torsio {

/// Properties of a design's LC-CUSUM within a number of runs, for runs that depend on each other as the
/// design says.
struct CompetenceErrors {
  std::int64_t attempts = 0;
  double falsePass = 0.0;  ///< probability that a trainee with the inadequate failure rate is declared
                           ///< competent
  double falseFail = 1.0;  ///< probability that a trainee with the adequate failure rate is not
  /// Probability that a trainee with the adequate rate, declared competent, loses it by a false alarm.
  double falseAlarm = 0.0;
  friend bool operator==(const CompetenceErrors&, const CompetenceErrors&) = default;
};

/// Computes the error rates exactly. Without attempts nobody is declared competent.
[[nodiscard]] CompetenceErrors competenceErrors(const CompetenceDesign& design, std::int64_t attempts);

/// True failure rates for which every verdict states how probable it is to be declared competent.
inline constexpr std::array kStatedFailureRates{0.10, 0.15, 0.20, 0.25, 0.30};
/// Probabilities of being declared competent within a number of runs, one per stated failure rate.
struct CompetenceOdds {
  std::int64_t attempts = 0;
  std::array<double, kStatedFailureRates.size()> declared{};
  friend bool operator==(const CompetenceOdds&, const CompetenceOdds&) = default;
};
[[nodiscard]] CompetenceOdds competenceOdds(const CompetenceDesign& design, std::int64_t attempts);

/// Probability that a trainee who fails this share of the runs is declared competent within `attempts` runs.
[[nodiscard]] double competenceProbability(const CompetenceDesign& design, double failureRate,
                                           std::int64_t attempts);

inline constexpr std::int64_t kMaxCompetenceAttempts = 1'000;
inline constexpr int kMaxValidDays = 36'500;
/// Returns the LC-CUSUM of a design.
[[nodiscard]] LcCusumDesign cusumOf(const CompetenceDesign& design);
/// Throws Error{kBadParameter} for NaN or values out of range, as plannedCompetence() does.
void requireSoundNumbers(const CompetenceDesign& design);
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

/// One run at an exercise.
struct CompetenceRun {
  RunOutcome outcome = RunOutcome::kNotPassed;
  bool excused = false;  ///< for an interrupted run: somebody with the right excused it
  std::int64_t startedUtc_us = 0;

  /// Empty: no attempt. A run passes or fails as a whole; an interrupted one has failed unless it is excused.
  [[nodiscard]] std::optional<bool> failed() const noexcept;
};

/// Judges a run by the exercise's rules and the design's tolerance. `measured_rad`: the tolerance with which
/// it was measured.
[[nodiscard]] RunOutcome competenceOutcome(const CompetenceDesign& design, const AttemptRules& rules,
                                           const AttemptMeasures& measures, double measured_rad);

/// Returns the outcomes of the runs that are attempts, oldest first; true: failed.
[[nodiscard]] std::vector<bool> failedAttempts(std::span<const CompetenceRun> runs);

/// Splits a person's runs, oldest first, into sessions: a new one begins after a pause of six hours.
[[nodiscard]] SessionOutcomes sessionsOf(std::span<const CompetenceRun> runs);

/// Sets how the runs depend on each other, as estimated, or as assumed without an estimate: then sessions are
/// as long as those of the record, if these are longer than the assumed ones.
void setDependence(CompetenceDesign& design, const EstimatedDependence& estimated);

enum class SkillLevel {
  kNotShown,  ///< fewer attempts than anybody needs to be shown competent
  kLearning,  ///< not yet shown to be competent
  kSteady,    ///< competent, without doubt
  kWatch,     ///< was competent; the last attempts raise a doubt
  kRelapsed,  ///< was competent; the doubt has become an alarm
  kExpired,   ///< was competent, and has made no run for longer than the design allows
};

/// Returns whether the level means competent now.
[[nodiscard]] constexpr bool isAble(SkillLevel level) noexcept {
  return level == SkillLevel::kSteady || level == SkillLevel::kWatch;
}

/// Conditions for success in a run and for competence.
struct CompetenceRule {
  CompetenceDesign design{};
  bool untwisting = false;  ///< a run is an untwisting
  AttemptRules run{};       ///< what a run needs to pass, with the exercise's tolerance
  friend bool operator==(const CompetenceRule&, const CompetenceRule&) = default;
};

/// Result of the rule for a trainee's runs.
struct CompetenceVerdict : CompetenceRule {
  CompetenceErrors errors{};  ///< within the runs made
  CompetenceOdds made{};      ///< within the runs made
  CompetenceOdds planned{};   ///< within the design's
  SkillLevel level = SkillLevel::kNotShown;
  std::size_t attempts = 0;
  std::size_t failed = 0;
  std::size_t attemptsUntilLevel = 0;   ///< for kNotShown
  std::vector<double> sums{};           ///< one per attempt: LC-CUSUM until competent, then the relapse watch
  std::optional<std::size_t> ableAt{};  ///< number of the attempt, from 1
  std::vector<TrialId> runs{};          ///< judged runs, oldest first
  std::size_t expiredRuns = 0;          ///< earlier runs, from before a pause after which competence expired
  friend bool operator==(const CompetenceVerdict&, const CompetenceVerdict&) = default;
};

/// Returns how many attempts without a failure prove competence.
[[nodiscard]] std::size_t fewestForAble(const CompetenceDesign& design);

/// Judges attempts, oldest first; true: failed. Computes no probabilities.
[[nodiscard]] CompetenceVerdict judgeAttempts(const CompetenceDesign& design,
                                              const std::vector<bool>& failed);
/// Returns the first attempt that counts: competence that was shown before a pause longer than the design
/// allows has expired, and is judged anew. `startedUtc_us`: of each attempt.
[[nodiscard]] std::size_t firstValidAttempt(const CompetenceDesign& design, const std::vector<bool>& failed,
                                            std::span<const std::int64_t> startedUtc_us);
/// Returns whether the time since the last run is longer than the design allows.
[[nodiscard]] bool isExpired(const CompetenceDesign& design, std::int64_t lastRunUtc_us, std::int64_t now_us);
/// Like judgeAttempts(), with the probabilities of its errors.
[[nodiscard]] CompetenceVerdict judgeCompetence(const CompetenceDesign& design,
                                                const std::vector<bool>& failed);

}  // namespace torsio
