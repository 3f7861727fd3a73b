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

/// A rubric that ships as a file of assets/rubrics; ids in `revision` are empty.
struct RubricTemplate {
  std::string id{};  ///< file name without .json
  std::string title{};
  std::string source{};  ///< where it comes from
  RubricRevision revision{};
};
/// All templates, ordered by id. Throws Error{kFileMissing, kFileUnreadable, kBadData} with file and field.
[[nodiscard]] std::vector<RubricTemplate> rubricTemplates(const std::filesystem::path& assets);
[[nodiscard]] RubricTemplate parseRubric(const std::string& json, const std::string& id);
/// Writes what parseRubric() reads.
[[nodiscard]] std::string rubricText(const std::string& title, const RubricRevision& revision);

/// What of a rubric is meant.
enum class RubricField { kOverall, kRows, kLabel, kScale, kWeight, kAnchors };
/// What is wrong with a rubric.
struct RubricProblem {
  RubricField field = RubricField::kRows;
  std::size_t row = 0;  ///< of kLabel, kScale, kWeight and kAnchors
  Text what{};
  Text where{};
  Text remedy{};
};
/// Everything that is wrong, in the order of the rows; empty: it can be published.
[[nodiscard]] std::vector<RubricProblem> rubricProblems(const RubricRevision& revision);

/// Throws Error{kBadParameter}: no rows, a row without code or label, a code twice, a scale or an anchor out
/// of range, no row with a weight. It is the first of rubricProblems().
void checkRubric(const RubricRevision& revision);
/// Makes a code for a criterion of this name that no row of the revision has.
[[nodiscard]] std::string codeForCriterion(const RubricRevision& revision, const std::string& label);

struct RubricRow {
  RubricId id{};
  std::string name{};
  std::vector<RubricRevision> revisions{};  ///< oldest first; the last one is offered
};
/// All rubrics by name. kPersonViewCoded (whoever administers the study).
[[nodiscard]] std::vector<RubricRow> rubrics(SessionContext& session);

/// Stores a rubric with its first revision. Returns the id of the revision. Audited. kCurriculumEdit. Throws
/// Error{kBadParameter} as checkRubric().
RubricRevisionId addRubric(SessionContext& session, const std::string& name, const RubricRevision& first,
                           bool demonstration = false);
/// The next revision: sheets that were assigned keep theirs. Returns its id. Audited. kCurriculumEdit.
RubricRevisionId reviseRubric(SessionContext& session, const RubricId& rubricId, const RubricRevision& next,
                              const std::string& note);

}  // namespace torsio
