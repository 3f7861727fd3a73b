// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/assignment_rows.h"

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"

namespace torsio {

namespace {

std::vector<SheetRow> sheetRows(Connection& connection, std::string_view fromWhere, const std::string& key) {
  std::string select = "SELECT row_code, score_steps, not_assessable_reason FROM ";
  select.append(fromWhere).append(" = ? ORDER BY row_code");
  return selectAll(connection, select, {key}, [](RowReader& row) {
    return SheetRow{row.text(), row.maybeInt64(), row.text()};
  });
}

}  // namespace

std::string selectAssignments(std::string_view more) {
  std::string select =
      "SELECT a.id, a.rater_id, a.enrolment_id, a.occasion, a.trial_id, a.rubric_revision_id,"
      " a.case_label, a.position, a.due_utc_us, a.assigned_by, a.assigned_utc_us, a.demonstration";
  select.append(more).append(" FROM assignment a");
  return select;
}

std::string isAskedFor(std::string_view alias) {
  std::string condition = "NOT EXISTS (SELECT 1 FROM assignment_withdrawal w WHERE w.assignment_id = ";
  condition.append(alias).append(
      ".id AND w.withdrawn AND NOT EXISTS (SELECT 1 FROM assignment_withdrawal v"
      " WHERE v.assignment_id = w.assignment_id AND v.sequence > w.sequence))");
  return condition;
}

Assignment readAssignment(RowReader& row) {
  return {.id = row.text(),
          .raterId = row.text(),
          .enrolmentId = row.text(),
          .occasionCode = row.text(),
          .trialId = row.text(),
          .rubricRevisionId = row.text(),
          .caseLabel = row.text(),
          .position = row.int64(),
          .dueUtc_us = row.maybeInt64(),
          .assignedBy = row.text(),
          .assignedUtc_us = row.int64(),
          .demonstration = row.boolean()};
}

std::vector<SheetRow> draftRows(Connection& connection, const AssignmentId& assignmentId) {
  return sheetRows(connection, "mark_draft_row WHERE assignment_id", assignmentId);
}

std::vector<SheetRow> markRows(Connection& connection, const MarkId& markId) {
  return sheetRows(connection, "training_mark_row WHERE mark_id", markId);
}

}  // namespace torsio
