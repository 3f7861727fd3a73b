// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/rating/paper_entry.h"

#include <algorithm>

namespace torsio {

namespace {

SheetAnswer answerIn(const Sheet& sheet, const std::string& code) {
  if (code == kOverallRow) {
    return {sheet.overall_steps, sheet.notAssessableReason};
  }
  const auto row = std::find_if(sheet.rows.begin(), sheet.rows.end(),
                                [&](const SheetRow& one) { return one.code == code; });
  return row == sheet.rows.end() ? SheetAnswer{} : SheetAnswer{row->score_steps, row->notAssessableReason};
}

/// Codes of the rows for which `wrong` is true, in the order of the sheet.
template <class Wrong>
std::vector<std::string> rowsWhere(const RubricRevision& rubric, const Wrong& wrong) {
  std::vector<std::string> codes;
  for (const RubricLine& row : rubric.rows) {
    if (wrong(row.code, row.scale)) {
      codes.push_back(row.code);
    }
  }
  if (wrong(kOverallRow, rubric.overall)) {
    codes.push_back(kOverallRow);
  }
  return codes;
}

}  // namespace

std::vector<std::string> differencesOf(const RubricRevision& rubric, const Sheet& first,
                                       const Sheet& second) {
  return rowsWhere(rubric, [&](const std::string& code, const ScoreScale&) {
    return answerIn(first, code).score_steps != answerIn(second, code).score_steps;
  });
}

std::vector<std::string> faultyRows(const RubricRevision& rubric, const Sheet& sheet) {
  return rowsWhere(rubric, [&](const std::string& code, const ScoreScale& scale) {
    return faultOf(answerIn(sheet, code), scale) != AnswerFault::kNone;
  });
}

}  // namespace torsio
