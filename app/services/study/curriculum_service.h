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

/// A version in a list.
struct CurriculumVersionRow {
  CurriculumVersionId id{};
  std::int64_t number = 1;
  std::string note{};
  CurriculumState state = CurriculumState::kDraft;
  std::int64_t createdUtc_us = 0;
  std::vector<std::string> cohorts{};  ///< names of cohorts that follow it
};

struct CurriculumRow {
  Curriculum curriculum{};
  bool hasDraft = false;
  std::int64_t draftChangedUtc_us = 0;
  std::vector<CurriculumVersionRow> versions{};  ///< oldest first
};

/// Returns all curricula by name. kPersonViewCoded.
[[nodiscard]] std::vector<CurriculumRow> curricula(SessionContext& session);
/// Returns a published version with codes instead of ids, for display in the editor and as the basis of the
/// next draft. kPersonViewCoded. Throws Error{kBadData} for an unknown id.
[[nodiscard]] CurriculumVersion publishedContent(SessionContext& session,
                                                 const CurriculumVersionId& versionId);

/// Creates a curriculum with a first draft: empty, or from a template. Returns its id. kCurriculumEdit.
/// Throws Error{kBadParameter} for an empty name, DbError{kUnique} if the name is in use.
CurriculumId addCurriculum(SessionContext& session, const std::string& name, const std::string& description,
                           const std::optional<CurriculumVersion>& content = std::nullopt,
                           bool demonstration = false);

/// A draft (curriculum_content.h: codes instead of ids).
struct CurriculumDraft {
  std::int64_t revision = 0;  ///< to be passed when saving
  CurriculumVersion content{};
  std::string changedBy{};
  std::int64_t changedUtc_us = 0;
};
/// Returns the draft; if there is none, the latest version as the basis of the next, revision 0.
/// kCurriculumEdit.
[[nodiscard]] CurriculumDraft curriculumDraft(SessionContext& session, const CurriculumId& curriculumId);
/// Saves a draft, even if it cannot be published yet. Returns the new revision. kCurriculumEdit. Throws
/// DbError{kConflict} if somebody else saved in between; nothing is overwritten.
std::int64_t saveCurriculumDraft(SessionContext& session, const CurriculumId& curriculumId,
                                 const CurriculumDraft& draft);

/// Publishes the saved draft as an immutable version. Returns its id. Audited. kCurriculumEdit. Throws
/// Error{kBadData} with the first problem.
CurriculumVersionId publishCurriculum(SessionContext& session, const CurriculumId& curriculumId,
                                      const std::string& note, const std::filesystem::path& assets);
/// Changes a version's state: running (cohorts can follow it), closed (no new cohorts), or running again,
/// with a reason. Audited. kCurriculumEdit. Throws Error{kBadData} for other changes.
void runCurriculum(SessionContext& session, const CurriculumVersionId& versionId,
                   const std::string& reason = {});
void closeCurriculum(SessionContext& session, const CurriculumVersionId& versionId,
                     const std::string& reason);

}  // namespace torsio
