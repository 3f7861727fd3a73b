// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/domain/study/protocol_terms.h"
#include "db/connection/connection.h"

namespace torsio {

/// A curriculum being edited; becomes a version when done.
struct CurriculumDraftRow {
  std::int64_t revision = 0;  ///< number of saves; 0: never saved
  std::string contentJson{};
  std::string changedBy{};
  std::int64_t changedUtc_us = 0;
};

/// Curricula. Each call is one transaction.
class CurriculumRepository {
 public:
  explicit CurriculumRepository(Connection& connection) : connection_(connection) {}

  void addCurriculum(const Curriculum& curriculum);
  [[nodiscard]] std::vector<Curriculum> curricula() const;

  /// Saves a draft; `draft.revision` is the revision read. Returns the new one. Throws DbError (kConflict) if
  /// somebody saved in between; nothing is overwritten.
  std::int64_t saveDraft(const CurriculumId& curriculumId, const CurriculumDraftRow& draft);
  [[nodiscard]] std::optional<CurriculumDraftRow> draft(const CurriculumId& curriculumId) const;

  /// Stores a version in state kDraft. Throws Error (kBadData) if a prerequisite is not a module of the
  /// version or prerequisites are cyclic.
  void addVersion(const CurriculumVersion& version, const std::string& createdBy);
  [[nodiscard]] std::optional<CurriculumVersion> version(const CurriculumVersionId& versionId) const;
  /// Empty: no such module.
  [[nodiscard]] std::optional<TrainingModule> module(const ModuleId& moduleId) const;
  /// Ids of a curriculum's versions, oldest first.
  [[nodiscard]] std::vector<CurriculumVersionId> versionIds(const CurriculumId& curriculumId) const;
  /// Changes the state draft -> running -> closed; throws Error (kBadData) for any other transition.
  void moveTo(const CurriculumVersionId& versionId, CurriculumState state, const std::string& changedBy,
              std::int64_t changedUtc_us);

  /// Assigns a version to a cohort, and its arms to the groups, by number. Throws Error (kBadData) unless the
  /// version is running and has an arm for every group.
  void assign(const CohortId& cohortId, const CurriculumVersionId& versionId);

 private:
  [[nodiscard]] std::optional<CurriculumState> stateOf(const CurriculumVersionId& versionId) const;
  Connection& connection_;
};

/// Registered competence designs. Append-only.
class CompetenceRepository {
 public:
  explicit CompetenceRepository(Connection& connection) : connection_(connection) {}

  /// Stores `design` as the next version of its module and returns it with its number. Throws DbError if the
  /// module does not exist.
  CompetenceDesign add(CompetenceDesign design);
  /// Returns the designs of a module, oldest first.
  [[nodiscard]] std::vector<CompetenceDesign> ofModule(const ModuleId& moduleId) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
