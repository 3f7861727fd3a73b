// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// "The metric reaches the threshold in so many attempts in a row."
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
  std::int64_t leastTwists = 1;  ///< that a run must complete to pass
  std::optional<double> maxForce_N{};
  std::optional<double> maxTorque_Nm{};
  std::optional<std::int64_t> attemptLimit{};
  std::vector<ModuleId> requires_{};  ///< ids of modules of the same version that must be mastered first
  std::vector<MasteryCriterion> mastery{};
};

/// A stretch of training on the virtual or the real arm.
struct TrainingPhase {
  PhaseId id{};
  PhaseKind kind = PhaseKind::kVirtual;
  std::string label{};
  std::int64_t duration_us = 0;
  ModuleId moduleId{};  ///< empty: any module
};

/// What one group of a study goes through (paper section 6). Rest stops the clock of the phases.
struct StudyArm {
  ArmId id{};
  std::string code{};
  std::string label{};
  std::int64_t restAllowance_us = 0;
  bool restSplittable = false;
  std::vector<TrainingPhase> phases{};
};

/// When a curriculum asks for marks.
struct PlannedOccasion {
  std::string code{};                 ///< "pre", "mid", "post"
  std::int64_t afterExposure_us = 0;  ///< 0: before training
};

/// A version of a curriculum with all its parts, in their order. Never changes once stored.
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

/// A curriculum in a list; what it says stands in its versions.
struct Curriculum {
  CurriculumId id{};
  std::string name{};  ///< unique
  std::string description{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

}  // namespace torsio
