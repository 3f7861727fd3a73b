// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/study/protocol_terms.h"
#include "db/connection/connection.h"

namespace torsio {

/// "The metric reaches the threshold in so many attempts in a row."
struct StoredMasteryRule {
  std::string metric{};
  std::string comparison = "at_least";  ///< "at_least", "at_most"
  double threshold = 0.0;
  std::string unit{};
  std::int64_t consecutive = 1;
};

/// One exercise of a curriculum.
struct StoredModule {
  std::string id{};
  std::string code{};  ///< unique within the version
  std::string title{};
  std::string sceneId{};
  std::string patternId{};
  AttemptMode mode = AttemptMode::kPractice;
  double targetAngle_rad = 0.0;
  double tolerance_rad = 0.1;
  std::int64_t hold_us = 0;
  std::optional<double> maxForce_N{};
  std::optional<double> maxTorque_Nm{};
  std::optional<std::int64_t> attemptLimit{};
  std::vector<std::string> requires_{};  ///< ids of modules of the same version that must be mastered first
  std::vector<StoredMasteryRule> mastery{};
};

/// A stretch of training on the virtual or the real arm.
struct StoredPhase {
  std::string id{};
  PhaseKind kind = PhaseKind::kVirtual;
  std::string label{};
  std::int64_t duration_us = 0;
  std::string moduleId{};  ///< empty: any module
};

/// What one group of a study goes through (paper section 6). Rest stops the clock of the phases.
struct StudyArm {
  std::string id{};
  std::string code{};
  std::string label{};
  std::int64_t restAllowance_us = 0;
  bool restSplittable = false;
  std::vector<StoredPhase> phases{};
};

struct PlannedOccasion {
  std::string code{};                 ///< "pre", "mid", "post"
  std::int64_t afterExposure_us = 0;  ///< 0: before training
};

/// A version of a curriculum with all its parts, in their order. Never changes once stored.
struct StoredCurriculumVersion {
  std::string id{};
  std::string curriculumId{};
  std::int64_t number = 1;
  std::string note{};
  std::int64_t createdUtc_us = 0;
  std::vector<StoredModule> modules{};
  std::vector<StudyArm> arms{};
  std::vector<PlannedOccasion> plannedOccasions{};
  CurriculumState state = CurriculumState::kDraft;  ///< filled when read
};

struct StoredCurriculum {
  std::string id{};
  std::string name{};  ///< unique
  std::string description{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// The text somebody is working on; becomes a version when it is done.
struct StoredDraft {
  std::int64_t revision = 0;  ///< counts the saves; 0: never saved
  std::string contentJson{};
  std::string changedBy{};
  std::int64_t changedUtc_us = 0;
};

/// Curricula. One call, one transaction.
class CurriculumRepository {
 public:
  explicit CurriculumRepository(Connection& connection) : connection_(connection) {}

  void addCurriculum(const StoredCurriculum& curriculum);
  [[nodiscard]] std::vector<StoredCurriculum> curricula() const;

  /// `draft.revision` is the one that was read. Returns the new revision. Throws DbError (kConflict) when
  /// somebody saved in between: nothing is overwritten.
  std::int64_t saveDraft(const std::string& curriculumId, const StoredDraft& draft);
  [[nodiscard]] std::optional<StoredDraft> draft(const std::string& curriculumId) const;

  /// Stores a version in state kDraft. Throws Error (kBadData) when a prerequisite is no module of the
  /// version or when prerequisites run in a circle.
  void addVersion(const StoredCurriculumVersion& version, const std::string& createdBy);
  [[nodiscard]] std::optional<StoredCurriculumVersion> version(const std::string& versionId) const;
  /// Ids, oldest version first.
  [[nodiscard]] std::vector<std::string> versionIds(const std::string& curriculumId) const;
  /// draft -> running -> closed; throws Error (kBadData) for any other step.
  void moveTo(const std::string& versionId, CurriculumState state, const std::string& changedBy,
              std::int64_t changedUtc_us);

  /// Ties a cohort and its groups (number by number) to a version and its arms. Throws Error (kBadData)
  /// unless the version is running and has an arm for every group.
  void assign(const std::string& cohortId, const std::string& versionId);

 private:
  [[nodiscard]] std::optional<CurriculumState> stateOf(const std::string& versionId) const;
  Connection& connection_;
};

}  // namespace torsio
