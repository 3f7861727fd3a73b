// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"

namespace torsio {

/// One live sheet that is not in yet, for whoever types it from paper: nothing tells who or which stage.
struct PaperCase {
  AssignmentId assignmentId{};
  std::string caseLabel{};
  std::string raterCode{};
  std::int64_t calledUtc_us = 0;
  bool byMe = false;         ///< typed by who asks
  std::size_t byOthers = 0;  ///< typed by that many others
  bool differs = false;      ///< typed by two people, and not alike
};
/// The live sheets of a cohort that were called and are not in, by case, then rater. kStudySetup.
[[nodiscard]] std::vector<PaperCase> paperCases(SessionContext& session, const CohortId& cohortId);

/// What the form shows: the rubric, and what this person has typed before.
struct PaperForm {
  std::string caseLabel{};
  std::string raterCode{};
  RubricRevision rubric{};
  Sheet own{};
  /// Codes of rows at which somebody else read another mark from the same paper; whose and which is not told.
  std::vector<std::string> differing{};
};
/// kStudySetup. Throws Error{kBadData}: no live sheet, not called yet, submitted or withdrawn.
[[nodiscard]] PaperForm paperForm(SessionContext& session, const AssignmentId& assignmentId);

enum class PaperOutcome {
  kFirst,    ///< kept: somebody else has to type it, too
  kDiffers,  ///< both kept, nothing counts: both look at the paper again
  kCounts,   ///< typed alike by two people: sealed as the rater's mark
};
/// Keeps what was read from paper. A mark counts once two people have typed the same marks in every row;
/// reasons and comments are not compared, those of the second one stay. Audited with both typists once it
/// counts: like a draft, what one person typed is nobody's record. kStudySetup. Throws Error like
/// paperForm(); {kBadData}: a row is unanswered or off its scale.
PaperOutcome enterPaperSheet(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet);

/// A sheet to print: one rater, one case, the rows of the rubric; nothing of trainee, group and stage.
struct PaperSheet {
  std::string caseLabel{};
  std::string raterCode{};
  RubricRevision rubric{};
};
/// Sheets that are not in, of one trainee (`enrolmentId`) or of the whole cohort, at one occasion; empty: at
/// the one that is due for each. By case, then rater. kStudySetup.
[[nodiscard]] std::vector<PaperSheet> paperSheets(SessionContext& session, const CohortId& cohortId,
                                                  const EnrolmentId& enrolmentId,
                                                  const std::string& occasionCode);

}  // namespace torsio
