// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/rubric.h"
#include "sim/core/text.h"

namespace torsio {

/// A rubric shipped in assets/rubrics; ids in `revision` are empty.
struct RubricTemplate {
  std::string id{};  ///< file name without .json
  std::string title{};
  std::string source{};  ///< origin
  RubricRevision revision{};
};
/// Returns all templates, ordered by id. Throws Error{kFileMissing, kFileUnreadable, kBadData} with file and
/// field.
[[nodiscard]] std::vector<RubricTemplate> rubricTemplates(const std::filesystem::path& assets);
[[nodiscard]] RubricTemplate parseRubric(const std::string& json, const std::string& id);
/// Formats a rubric for parseRubric().
[[nodiscard]] std::string rubricText(const std::string& title, const RubricRevision& revision);

/// Part of a rubric that has a problem.
enum class RubricField { kOverall, kRows, kLabel, kScale, kWeight, kAnchors };
/// A problem of a rubric.
struct RubricProblem {
  RubricField field = RubricField::kRows;
  std::size_t row = 0;  ///< for kLabel, kScale, kWeight and kAnchors
  Text what{};
  Text where{};
  Text remedy{};
};
/// Returns all problems in row order; empty: it can be published.
[[nodiscard]] std::vector<RubricProblem> rubricProblems(const RubricRevision& revision);

/// Throws Error{kBadParameter} with the first of rubricProblems(): no rows, a row without code or label, a
/// duplicate code, a scale or anchor out of range, no row with a weight.
void checkRubric(const RubricRevision& revision);
/// Creates a unique code for a criterion of this name.
[[nodiscard]] std::string codeForCriterion(const RubricRevision& revision, const std::string& label);

struct RubricRow {
  RubricId id{};
  std::string name{};
  std::vector<RubricRevision> revisions{};  ///< oldest first; new sheets use the last one
};
/// Returns all rubrics by name. kPersonViewCoded.
[[nodiscard]] std::vector<RubricRow> rubrics(SessionContext& session);

/// Stores a rubric with its first revision. Returns the revision's id. Audited. kCurriculumEdit. Throws
/// Error{kBadParameter} like checkRubric().
RubricRevisionId addRubric(SessionContext& session, const std::string& name, const RubricRevision& first,
                           bool demonstration = false);
/// Adds a revision; assigned sheets keep theirs. Returns its id. Audited. kCurriculumEdit.
RubricRevisionId reviseRubric(SessionContext& session, const RubricId& rubricId, const RubricRevision& next,
                              const std::string& note);

}  // namespace torsio
