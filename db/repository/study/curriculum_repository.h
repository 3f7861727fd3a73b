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

/// The text somebody is working on; becomes a version when it is done.
struct CurriculumDraftRow {
  std::int64_t revision = 0;  ///< counts the saves; 0: never saved
  std::string contentJson{};
  std::string changedBy{};
  std::int64_t changedUtc_us = 0;
};

/// Curricula. One call, one transaction.
class CurriculumRepository {
 public:
  explicit CurriculumRepository(Connection& connection) : connection_(connection) {}

  void addCurriculum(const Curriculum& curriculum);
  [[nodiscard]] std::vector<Curriculum> curricula() const;

  /// `draft.revision` is the one that was read. Returns the new revision. Throws DbError (kConflict) when
  /// somebody saved in between: nothing is overwritten.
  std::int64_t saveDraft(const CurriculumId& curriculumId, const CurriculumDraftRow& draft);
  [[nodiscard]] std::optional<CurriculumDraftRow> draft(const CurriculumId& curriculumId) const;

  /// Stores a version in state kDraft. Throws Error (kBadData) when a prerequisite is no module of the
  /// version or when prerequisites run in a circle.
  void addVersion(const CurriculumVersion& version, const std::string& createdBy);
  [[nodiscard]] std::optional<CurriculumVersion> version(const CurriculumVersionId& versionId) const;
  /// Empty: no such module.
  [[nodiscard]] std::optional<TrainingModule> module(const ModuleId& moduleId) const;
  /// Ids, oldest version first.
  [[nodiscard]] std::vector<CurriculumVersionId> versionIds(const CurriculumId& curriculumId) const;
  /// draft -> running -> closed; throws Error (kBadData) for any other step.
  void moveTo(const CurriculumVersionId& versionId, CurriculumState state, const std::string& changedBy,
              std::int64_t changedUtc_us);

  /// Ties a cohort and its groups (number by number) to a version and its arms. Throws Error (kBadData)
  /// unless the version is running and has an arm for every group.
  void assign(const CohortId& cohortId, const CurriculumVersionId& versionId);

 private:
  [[nodiscard]] std::optional<CurriculumState> stateOf(const CurriculumVersionId& versionId) const;
  Connection& connection_;
};

}  // namespace torsio
