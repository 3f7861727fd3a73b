// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"
#include "sim/core/text.h"

namespace torsio {

/// "The metric meets the threshold in so many attempts in a row."
struct MasteryCriterion {
  std::string metric{};
  std::string comparison = "at_least";  ///< "at_least", "at_most"
  double threshold = 0.0;
  std::string unit{};
  std::int64_t consecutive = 1;
};

/// One exercise of a curriculum.
struct TrainingModule {
  ModuleId id{};
  std::string code{};  ///< unique within the version
  std::string title{};
  SceneId sceneId{};
  PatternId patternId{};
  AttemptMode mode = AttemptMode::kPractice;
  double targetAngle_rad = 0.0;
  double tolerance_rad = 0.1;
  std::int64_t hold_us = 0;
  std::int64_t leastTwists = 1;  ///< completed twists that a run needs to pass
  std::optional<double> maxForce_N{};
  std::optional<double> maxTorque_Nm{};
  std::optional<std::int64_t> attemptLimit{};
  std::vector<ModuleId> requires_{};  ///< modules of the same version that must be mastered first
  std::vector<MasteryCriterion> mastery{};
};

/// A training phase on the virtual or the real arm.
struct TrainingPhase {
  PhaseId id{};
  PhaseKind kind = PhaseKind::kVirtual;
  std::string label{};
  std::int64_t duration_us = 0;
  ModuleId moduleId{};  ///< empty: any module
};

/// The phases of one study group (paper section 6). Rest stops their clock.
struct StudyArm {
  ArmId id{};
  std::string code{};
  std::string label{};
  std::int64_t restAllowance_us = 0;
  bool restSplittable = false;
  std::vector<TrainingPhase> phases{};
};

/// A point of the curriculum at which marks are due.
struct PlannedOccasion {
  std::string code{};                 ///< "pre", "mid", "post"
  std::int64_t afterExposure_us = 0;  ///< 0: before training
};

/// A version of a curriculum with all its parts, in order. Immutable once stored.
struct CurriculumVersion {
  CurriculumVersionId id{};
  CurriculumId curriculumId{};
  std::int64_t number = 1;
  std::string note{};
  std::int64_t createdUtc_us = 0;
  std::vector<TrainingModule> modules{};
  std::vector<StudyArm> arms{};
  std::vector<PlannedOccasion> plannedOccasions{};
  CurriculumState state = CurriculumState::kDraft;  ///< filled when read
};

/// A curriculum as listed; its content is in its versions.
struct Curriculum {
  CurriculumId id{};
  std::string name{};  ///< unique
  std::string description{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// Source of the tolerance of a competence design.
enum class ToleranceSource : std::uint8_t { kExercise, kExperts, kChosen };
inline constexpr std::array<Term<ToleranceSource>, 3> kToleranceSources{{
    {ToleranceSource::kExercise, "exercise", Text::tr("of the exercise"),
     "what the exercise itself counts as on target"},
    {ToleranceSource::kExperts, "experts", Text::tr("from the centre's own experts"),
     "covers nine in ten experts with 95 % confidence"},
    {ToleranceSource::kChosen, "chosen", Text::tr("chosen by the centre"), "set by hand, with a reason"},
}};
static_assert(isWholeTable(kToleranceSources, ToleranceSource{3}));
[[nodiscard]] constexpr const auto& termsOf(ToleranceSource) noexcept {
  return kToleranceSources;
}

/// Criterion by which a trainee counts as competent in one exercise version: an LC-CUSUM over runs, which
/// pass or fail as a whole. Immutable once registered.
struct CompetenceDesign {
  ModuleId moduleId{};
  std::int64_t version = 0;  ///< 0: the design shipped with every exercise; registered ones count from 1
  std::int64_t registeredUtc_us = 0;
  double tolerance_rad = 0.1;  ///< of the angle at release; unused for an untwisting
  ToleranceSource source = ToleranceSource::kExercise;
  std::int64_t experts = 0;      ///< number of experts for kExperts; otherwise 0
  double adequate = 0.05;        ///< share of runs that a competent trainee fails
  double inadequate = 0.3;       ///< share that a trainee who is not competent fails; greater than `adequate`
  std::int64_t attempts = 80;    ///< number of runs for which the two error rates hold
  double falsePassMost = 0.025;  ///< alpha: largest probability that an inadequate trainee passes
  double falseFailMost = 0.10;   ///< beta: largest probability that an adequate trainee does not pass
  // How a trainee's runs depend on each other (assessment/statistics/cusum.h). The values here are assumed
  // until the centre has enough runs: more than where days differ by SD 1 logit, which gives 0.42, so that
  // both error rates stated with them are upper bounds for that, and for a lag correlation up to 0.4.
  double sessionCorrelation = 0.45;
  double lagCorrelation = 0.0;
  std::int64_t runsPerSession = 5;
  std::int64_t dependenceRuns = 0;  ///< number of runs from which they were estimated; 0: assumed
  std::int64_t validDays = 0;       ///< days that a verdict lasts after the last run; 0: it does not expire
  double limit = 11.30;  ///< of the sum; follows from the other numbers (assessment/attempt/competence.h)
  std::string reason{};  ///< required for kChosen; optional otherwise
  friend bool operator==(const CompetenceDesign&, const CompetenceDesign&) = default;
};

}  // namespace torsio
