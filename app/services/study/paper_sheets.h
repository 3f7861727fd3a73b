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

/// A missing live sheet, for typing it from paper; reveals neither trainee nor stage.
struct PaperCase {
  AssignmentId assignmentId{};
  std::string caseLabel{};
  std::string raterCode{};
  std::int64_t calledUtc_us = 0;
  bool byMe = false;         ///< typed by the actor
  std::size_t byOthers = 0;  ///< number of others who have typed it
  bool differs = false;      ///< typed by two people with differences
};
/// Returns called live sheets of a cohort that are missing, by case, then rater. kStudySetup.
[[nodiscard]] std::vector<PaperCase> paperCases(SessionContext& session, const CohortId& cohortId);

/// Content of the form: the rubric, and what the actor has typed before.
struct PaperForm {
  std::string caseLabel{};
  std::string raterCode{};
  RubricRevision rubric{};
  Sheet own{};
  /// Codes of rows in which somebody else typed another mark from the same paper; neither person nor mark is
  /// revealed.
  std::vector<std::string> differing{};
};
/// kStudySetup. Throws Error{kBadData} unless it is a live sheet that was called and is neither submitted nor
/// withdrawn.
[[nodiscard]] PaperForm paperForm(SessionContext& session, const AssignmentId& assignmentId);

enum class PaperOutcome {
  kFirst,    ///< stored; somebody else has to type it too
  kDiffers,  ///< both stored, but not counted: both check the paper again
  kCounts,   ///< typed alike by two people: sealed as the rater's mark
};
/// Stores what was typed from paper. A mark counts once two people have typed the same marks in every row;
/// reasons and comments are not compared, the second one's are kept. Audited with both typists once it
/// counts; until then it is like a draft, not part of the record. kStudySetup. Throws Error like paperForm();
/// {kBadData} for an unanswered row or a mark off its scale.
PaperOutcome enterPaperSheet(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet);

/// A sheet to print: one rater, one case, the rows of the rubric; no trainee, group or stage.
struct PaperSheet {
  std::string caseLabel{};
  std::string raterCode{};
  RubricRevision rubric{};
};
/// Returns missing sheets of one trainee (`enrolmentId`) or the whole cohort, at one occasion; if empty, at
/// the one due for each. By case, then rater. kStudySetup.
[[nodiscard]] std::vector<PaperSheet> paperSheets(SessionContext& session, const CohortId& cohortId,
                                                  const EnrolmentId& enrolmentId,
                                                  const std::string& occasionCode);

}  // namespace torsio
