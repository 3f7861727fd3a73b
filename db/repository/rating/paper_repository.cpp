// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/paper_repository.h"

#include "assessment/domain/ids.h"
#include "db/connection/row_reader.h"

namespace torsio {

namespace {

constexpr const char* kSelectEntries =
    "SELECT n.assignment_id, n.entered_by, n.overall_steps, n.not_assessable_reason, n.comment,"
    " n.entered_utc_us FROM paper_entry n";

PaperEntry readEntry(RowReader& row) {
  PaperEntry entry;
  entry.assignmentId = row.text();
  entry.enteredBy = row.text();
  entry.sheet.overall_steps = row.maybeInt64();
  entry.sheet.notAssessableReason = row.text();
  entry.sheet.comment = row.text();
  entry.enteredUtc_us = row.int64();
  return entry;
}

}  // namespace

void PaperRepository::put(const PaperEntry& entry) {
  Transaction transaction(connection_);
  connection_.execute("DELETE FROM paper_entry_row WHERE assignment_id = ? AND entered_by = ?",
                      {entry.assignmentId, entry.enteredBy});
  connection_.execute("DELETE FROM paper_entry WHERE assignment_id = ? AND entered_by = ?",
                      {entry.assignmentId, entry.enteredBy});
  connection_.execute(
      insertInto("paper_entry",
                 "assignment_id, entered_by, overall_steps, not_assessable_reason, comment, entered_utc_us"),
      {entry.assignmentId, entry.enteredBy, entry.sheet.overall_steps,
       textOrNull(entry.sheet.notAssessableReason), textOrNull(entry.sheet.comment), entry.enteredUtc_us});
  Statement insert = connection_.prepare(insertInto(
      "paper_entry_row", "assignment_id, entered_by, row_code, score_steps, not_assessable_reason"));
  for (const SheetRow& row : entry.sheet.rows) {
    insert.execute({entry.assignmentId, entry.enteredBy, row.code, row.score_steps,
                    textOrNull(row.notAssessableReason)});
  }
  transaction.commit();
}

std::vector<PaperEntry> PaperRepository::of(const AssignmentId& assignmentId) const {
  std::vector<PaperEntry> entries = selectAll(
      connection_,
      std::string(kSelectEntries) + " WHERE n.assignment_id = ? ORDER BY n.entered_utc_us, n.entered_by",
      {assignmentId}, readEntry);
  for (PaperEntry& entry : entries) {
    entry.sheet.rows = selectAll(connection_,
                                 "SELECT row_code, score_steps, not_assessable_reason FROM paper_entry_row"
                                 " WHERE assignment_id = ? AND entered_by = ? ORDER BY row_code",
                                 {assignmentId, entry.enteredBy}, [](RowReader& row) {
                                   return SheetRow{row.text(), row.maybeInt64(), row.text()};
                                 });
  }
  return entries;
}

std::vector<PaperEntry> PaperRepository::ofCohort(const CohortId& cohortId) const {
  return selectAll(
      connection_,
      std::string(kSelectEntries) +
          " JOIN assignment a ON a.id = n.assignment_id JOIN enrolment e ON e.id = a.enrolment_id"
          " WHERE e.cohort_id = ? ORDER BY n.entered_utc_us, n.entered_by",
      {cohortId}, readEntry);
}

void PaperRepository::remove(const AssignmentId& assignmentId) {
  Transaction transaction(connection_);
  connection_.execute("DELETE FROM paper_entry_row WHERE assignment_id = ?", {assignmentId});
  connection_.execute("DELETE FROM paper_entry WHERE assignment_id = ?", {assignmentId});
  transaction.commit();
}

}  // namespace torsio
