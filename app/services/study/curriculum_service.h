// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/study/curriculum_content.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/curriculum.h"

namespace torsio {

/// One version in a list.
struct CurriculumVersionRow {
  CurriculumVersionId id{};
  std::int64_t number = 1;
  std::string note{};
  CurriculumState state = CurriculumState::kDraft;
  std::int64_t createdUtc_us = 0;
  std::vector<std::string> cohorts{};  ///< names of those that follow it
};

struct CurriculumRow {
  Curriculum curriculum{};
  bool hasDraft = false;
  std::int64_t draftChangedUtc_us = 0;
  std::vector<CurriculumVersionRow> versions{};  ///< oldest first
};

/// All curricula by name. kPersonViewCoded (whoever administers the study).
[[nodiscard]] std::vector<CurriculumRow> curricula(SessionContext& session);
/// A published version with codes in place of ids: as it looks in the editor, and as a start of the next
/// draft. kPersonViewCoded. Throws Error{kBadData} for an unknown id.
[[nodiscard]] CurriculumVersion publishedContent(SessionContext& session,
                                                 const CurriculumVersionId& versionId);

/// A new curriculum with a first draft: empty, or from a template. Returns its id. kCurriculumEdit. Throws
/// Error{kBadParameter} for an empty name, DbError{kUnique} when the name is taken.
CurriculumId addCurriculum(SessionContext& session, const std::string& name, const std::string& description,
                           const std::optional<CurriculumVersion>& content = std::nullopt,
                           bool demonstration = false);

/// What is being written (curriculum_content.h: codes in place of ids).
struct CurriculumDraft {
  std::int64_t revision = 0;  ///< to be given back when saving
  CurriculumVersion content{};
  std::string changedBy{};
  std::int64_t changedUtc_us = 0;
};
/// The draft; without one: the newest version as a start of the next, revision 0. kCurriculumEdit.
[[nodiscard]] CurriculumDraft curriculumDraft(SessionContext& session, const CurriculumId& curriculumId);
/// Saves also what cannot be published yet. Returns the new revision. kCurriculumEdit. Throws
/// DbError{kConflict} when somebody else saved meanwhile: nothing is overwritten.
std::int64_t saveCurriculumDraft(SessionContext& session, const CurriculumId& curriculumId,
                                 const CurriculumDraft& draft);

/// Makes a version that never changes out of the saved draft. Returns its id. Audited. kCurriculumEdit.
/// Throws Error{kBadData} with the first problem.
CurriculumVersionId publishCurriculum(SessionContext& session, const CurriculumId& curriculumId,
                                      const std::string& note, const std::filesystem::path& assets);
/// From now on cohorts can follow it / no cohort may begin it any more; what was closed may run again, with a
/// reason. Audited. kCurriculumEdit. Throws Error{kBadData} for any other step.
void runCurriculum(SessionContext& session, const CurriculumVersionId& versionId,
                   const std::string& reason = {});
void closeCurriculum(SessionContext& session, const CurriculumVersionId& versionId,
                     const std::string& reason);

}  // namespace torsio
