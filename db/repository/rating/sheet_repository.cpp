// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/sheet_repository.h"

#include <algorithm>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/sheet_check.h"
#include "db/connection/db_error.h"
#include "db/repository/base/row_columns.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr auto kAssignment = rowColumns<Assignment>(
    "assignment",
    "id, rater_id, enrolment_id, occasion, trial_id, rubric_revision_id, case_label, position, due_utc_us,"
    " assigned_by, assigned_utc_us, demonstration",
    &Assignment::id, &Assignment::raterId, &Assignment::enrolmentId, &Assignment::occasionCode,
    OrNull{&Assignment::trialId}, &Assignment::rubricRevisionId, &Assignment::caseLabel,
    &Assignment::position, &Assignment::dueUtc_us, &Assignment::assignedBy, &Assignment::assignedUtc_us,
    &Assignment::demonstration);

std::vector<SheetRow> sheetRows(Connection& connection, std::string_view fromWhere, const std::string& key) {
  std::string select = "SELECT row_code, score_steps, not_assessable_reason FROM ";
  select.append(fromWhere).append(" = ? ORDER BY row_code");
  return selectAll(connection, select, {key}, [](RowReader& row) {
    return SheetRow{row.text(), row.maybeInt64(), row.text()};
  });
}

Assignment assignmentOf(Connection& connection, const AssignmentId& assignmentId) {
  std::optional<Assignment> found =
      selectFirst(connection, selectAssignments() + " WHERE a.id = ?", {assignmentId}, readAssignment);
  if (!found) {
    refuse(Text::tr("no such assignment"), assignmentId, Text::tr("Read the queue again"));
  }
  return std::move(*found);
}

DbError changedElsewhere(const Connection& connection, const std::string& operation) {
  return DbError(DbFault::kConflict, operation,
                 Text::tr("this sheet was changed at another station meanwhile"), connection.location(),
                 Text::tr("Open the sheet again"));
}

/// Returns the start of a query for statusOf().
std::string selectStatus() {
  return selectAssignments(
      ", CASE WHEN " + isAskedFor("a") +
      " THEN 0 ELSE 1 END,"
      " (SELECT MAX(m.submitted_utc_us) FROM training_mark m WHERE m.assignment_id = a.id),"
      " (SELECT d.changed_utc_us FROM mark_draft d WHERE d.assignment_id = a.id)");
}

AssignmentStatus statusOf(RowReader& row) {
  AssignmentStatus status{readAssignment(row)};
  const bool withdrawn = row.int64() > 0;
  const std::optional<std::int64_t> submitted_us = row.maybeInt64();
  const std::optional<std::int64_t> drafted_us = row.maybeInt64();
  status.state = sheetStateOf(withdrawn, submitted_us.has_value(), drafted_us.has_value());
  status.changedUtc_us = submitted_us ? *submitted_us : drafted_us.value_or(0);
  return status;
}

QueueEntry queueEntryOf(RowReader& row) {
  QueueEntry entry{row.text(), row.text(), row.text(), row.text(), row.maybeInt64()};
  const std::optional<std::int64_t> submitted_us = row.maybeInt64();
  const bool drafted = row.int64() > 0;
  entry.state = sheetStateOf(false, submitted_us.has_value(), drafted);
  entry.submittedUtc_us = submitted_us.value_or(0);
  return entry;
}

void checkAnswer(const std::optional<std::int64_t>& score_steps, const std::string& reason,
                 const ScoreScale& scale, const std::string& where) {
  const AnswerFault fault = faultOf({score_steps, reason}, scale);
  if (fault == AnswerFault::kMissing || fault == AnswerFault::kContradicts) {
    refuse(Text::tr("needs either a mark or a reason why there is none"), where, Text::tr("Fill it in"));
  }
  if (fault == AnswerFault::kOutsideScale) {
    refuse(Text::tr("mark of %1 steps is outside its scale", *score_steps), where,
           Text::tr("Correct the mark"));
  }
}

/// Throws unless every row of the rubric, and no other, has an answer on its scale.
void checkComplete(const Sheet& sheet, const RubricRevision& rubric, const std::string& caseLabel) {
  const std::string where = "case " + caseLabel;
  checkAnswer(sheet.overall_steps, sheet.notAssessableReason, rubric.overall, where + ", overall mark");
  for (const SheetRow& row : sheet.rows) {
    const auto known = std::count_if(rubric.rows.begin(), rubric.rows.end(),
                                     [&](const RubricLine& line) { return line.code == row.code; });
    if (known == 0) {
      refuse(Text::tr("the rubric has no row %1", row.code), where, Text::tr("Use the assigned rubric"));
    }
  }
  for (const RubricLine& line : rubric.rows) {
    const auto answer = std::find_if(sheet.rows.begin(), sheet.rows.end(),
                                     [&](const SheetRow& row) { return row.code == line.code; });
    if (answer == sheet.rows.end()) {
      refuse(Text::tr("row %1 is not answered", line.code), where, Text::tr("Fill it in"));
    }
    checkAnswer(answer->score_steps, answer->notAssessableReason, line.scale, where + ", row " + line.code);
  }
}

std::optional<std::int64_t> versionOf(Connection& connection, const MarkId& markId) {
  return selectFirst(connection, "SELECT version FROM training_mark WHERE id = ?", {markId}, readInt64);
}

}  // namespace

std::string selectAssignments(std::string_view more) {
  std::string select = kAssignment.select("a");
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
  return kAssignment(row);
}

std::vector<SheetRow> draftRows(Connection& connection, const AssignmentId& assignmentId) {
  return sheetRows(connection, "mark_draft_row WHERE assignment_id", assignmentId);
}

std::vector<SheetRow> markRows(Connection& connection, const MarkId& markId) {
  return sheetRows(connection, "training_mark_row WHERE mark_id", markId);
}

void SheetRepository::assign(std::span<const Assignment> assignments) {
  Transaction transaction(connection_);
  Statement insert = connection_.prepare(kAssignment.insert());
  for (const Assignment& part : assignments) {
    insert.execute(kAssignment.values(part));
  }
  transaction.commit();
}

std::vector<AssignmentStatus> SheetRepository::assignments(const CohortId& cohortId) const {
  return selectAll(
      connection_,
      selectStatus() +
          " JOIN enrolment e ON e.id = a.enrolment_id JOIN occasion s ON s.code = a.occasion"
          " JOIN person p ON p.id = e.trainee_id JOIN person r ON r.id = a.rater_id WHERE e.cohort_id = ?"
          " ORDER BY s.position, p.code, r.code",
      {cohortId}, statusOf);
}

std::vector<Assignment> SheetRepository::assignmentsOf(const RaterId& raterId) const {
  return selectAll(connection_, selectAssignments() + " WHERE a.rater_id = ? ORDER BY a.position", {raterId},
                   readAssignment);
}

std::optional<AssignmentStatus> SheetRepository::findAssignment(const AssignmentId& assignmentId) const {
  return selectFirst(connection_, selectStatus() + " WHERE a.id = ?", {assignmentId}, statusOf);
}

void SheetRepository::withdraw(const AssignmentId& assignmentId, const std::string& reason,
                               const std::string& withdrawnBy, std::int64_t utc_us) {
  Transaction transaction(connection_);
  const SheetState state = stateOf(assignmentId);
  if (state == SheetState::kSubmitted) {
    refuse(Text::tr("the sheet was submitted already"), assignmentId,
           Text::tr("Submitted marks stay; amend the mark instead"));
  }
  if (state == SheetState::kWithdrawn) {
    refuse(Text::tr("the sheet was withdrawn already"), assignmentId, Text::tr("Read the matrix again"));
  }
  decide(assignmentId, true, reason, withdrawnBy, utc_us);
  transaction.commit();
}

void SheetRepository::giveBack(const AssignmentId& assignmentId, const std::string& reason,
                               const std::string& decidedBy, std::int64_t utc_us) {
  Transaction transaction(connection_);
  if (stateOf(assignmentId) != SheetState::kWithdrawn) {
    refuse(Text::tr("the sheet was not taken back from its rater"), assignmentId,
           Text::tr("Read the matrix again"));
  }
  decide(assignmentId, false, reason, decidedBy, utc_us);
  transaction.commit();
}

void SheetRepository::decide(const AssignmentId& assignmentId, bool withdrawn, const std::string& reason,
                             const std::string& decidedBy, std::int64_t utc_us) {
  connection_.execute(
      "INSERT INTO assignment_withdrawal (assignment_id, sequence, withdrawn, reason, decided_by,"
      " decided_utc_us) VALUES (?, (SELECT COALESCE(MAX(w.sequence), 0) + 1 FROM assignment_withdrawal w"
      " WHERE w.assignment_id = ?), ?, ?, ?, ?)",
      {assignmentId, assignmentId, withdrawn, reason, decidedBy, utc_us});
}

std::vector<QueueEntry> SheetRepository::queue(const RaterId& raterId) const {
  return selectAll(connection_,
                   "SELECT a.id, a.case_label, a.trial_id, a.rubric_revision_id, a.due_utc_us,"
                   " (SELECT MAX(m.submitted_utc_us) FROM training_mark m WHERE m.assignment_id = a.id),"
                   " (SELECT count(*) FROM mark_draft d WHERE d.assignment_id = a.id) FROM assignment a"
                   " WHERE a.rater_id = ? AND " +
                       isAskedFor("a") + " ORDER BY a.position, a.case_label",
                   {raterId}, queueEntryOf);
}

SheetState SheetRepository::stateOf(const AssignmentId& assignmentId) const {
  const std::optional<AssignmentStatus> status = findAssignment(assignmentId);
  if (!status) {
    refuse(Text::tr("no such assignment"), assignmentId, Text::tr("Read the queue again"));
  }
  return status->state;
}

std::int64_t SheetRepository::saveDraft(const AssignmentId& assignmentId, const Sheet& sheet) {
  Transaction transaction(connection_);
  const SheetState state = stateOf(assignmentId);
  if (state == SheetState::kWithdrawn || state == SheetState::kSubmitted) {
    refuse(state == SheetState::kSubmitted ? Text::tr("the sheet was submitted already")
                                           : Text::tr("the sheet was withdrawn"),
           assignmentId, Text::tr("Read the queue again"));
  }
  const std::int64_t next = sheet.revision + 1;
  const std::int64_t changed =
      sheet.revision == 0
          ? connection_.execute(
                insertInto("mark_draft",
                           "assignment_id, revision, overall_steps, not_assessable_reason, comment, "
                           "changed_utc_us") +
                    " ON CONFLICT (assignment_id) DO NOTHING",
                {assignmentId, next, sheet.overall_steps, textOrNull(sheet.notAssessableReason),
                 textOrNull(sheet.comment), sheet.changedUtc_us})
          : connection_.execute(
                "UPDATE mark_draft SET revision = ?, overall_steps = ?, not_assessable_reason = ?, comment = "
                "?,"
                " changed_utc_us = ? WHERE assignment_id = ? AND revision = ?",
                {next, sheet.overall_steps, textOrNull(sheet.notAssessableReason), textOrNull(sheet.comment),
                 sheet.changedUtc_us, assignmentId, sheet.revision});
  if (changed != 1) {
    throw changedElsewhere(connection_, "UPDATE mark_draft");
  }
  connection_.execute("DELETE FROM mark_draft_row WHERE assignment_id = ?", {assignmentId});
  Statement insert = connection_.prepare(
      insertInto("mark_draft_row", "assignment_id, row_code, score_steps, not_assessable_reason"));
  for (const SheetRow& row : sheet.rows) {
    insert.execute({assignmentId, row.code, row.score_steps, textOrNull(row.notAssessableReason)});
  }
  transaction.commit();
  return next;
}

std::optional<Sheet> SheetRepository::draft(const AssignmentId& assignmentId) const {
  std::optional<Sheet> sheet = selectFirst(
      connection_,
      "SELECT revision, overall_steps, not_assessable_reason, comment, changed_utc_us FROM mark_draft"
      " WHERE assignment_id = ?",
      {assignmentId}, [](RowReader& row) {
        return Sheet{row.int64(), row.maybeInt64(), row.text(), row.text(), {}, row.int64()};
      });
  if (sheet) {
    sheet->rows = draftRows(connection_, assignmentId);
  }
  return sheet;
}

void SheetRepository::submit(const AssignmentId& assignmentId, const MarkId& markId, const Sheet& sheet,
                             const std::string& amendReason, std::int64_t submittedUtc_us) {
  Transaction transaction(connection_);
  const Assignment assignment = assignmentOf(connection_, assignmentId);
  const std::optional<std::int64_t> storedVersion = versionOf(connection_, markId);  // not empty: a retry
  if (!storedVersion && stateOf(assignmentId) == SheetState::kWithdrawn) {
    refuse(Text::tr("the sheet was withdrawn"), assignment.caseLabel, Text::tr("Read the queue again"));
  }
  const RubricRevision rubric = RubricRepository(connection_).revision(assignment.rubricRevisionId).value();
  checkComplete(sheet, rubric, assignment.caseLabel);
  SubmittedMark mark;
  mark.id = markId;
  mark.enrolmentId = assignment.enrolmentId;
  mark.raterId = assignment.raterId;
  mark.occasionCode = assignment.occasionCode;
  mark.assignmentId = assignmentId;
  mark.trialId = assignment.trialId;
  mark.score_steps = sheet.overall_steps;
  mark.scale = rubric.overall;
  mark.notAssessableReason = sheet.notAssessableReason;
  mark.comment = sheet.comment;
  mark.amendReason = amendReason;
  mark.submittedUtc_us = submittedUtc_us;
  mark.demonstration = assignment.demonstration;
  if (storedVersion) {
    mark.version = *storedVersion;
  } else {
    const std::vector<SubmittedMark> earlier =
        RatingRepository(connection_).history(mark.enrolmentId, mark.raterId, mark.occasionCode);
    if (std::any_of(earlier.begin(), earlier.end(),
                    [](const SubmittedMark& one) { return !one.importId.empty(); })) {
      refuse(Text::tr("the mark of this case was imported and cannot be changed"), assignment.caseLabel,
             Text::tr("Let the sheet be withdrawn"));
    }
    if (!amendReason.empty()) {
      mark.version = sheet.revision + 1;
      if (mark.version != static_cast<std::int64_t>(1 + earlier.size())) {
        throw changedElsewhere(connection_, "INSERT training_mark");
      }
    }
  }
  for (const SheetRow& row : sheet.rows) {
    mark.rows.push_back({rubric.id, row.code, row.score_steps, row.notAssessableReason});
  }
  try {
    RatingRepository(connection_).submit(std::span(&mark, 1));
  } catch (const DbError& error) {
    if (error.fault() == DbFault::kUnique && !amendReason.empty()) {
      throw changedElsewhere(connection_, error.operation());
    }
    throw;
  }
  connection_.execute("DELETE FROM mark_draft_row WHERE assignment_id = ?", {assignmentId});
  connection_.execute("DELETE FROM mark_draft WHERE assignment_id = ?", {assignmentId});
  transaction.commit();
}

std::optional<Sheet> SheetRepository::submitted(const AssignmentId& assignmentId) const {
  MarkId markId;
  std::optional<Sheet> sheet = selectFirst(
      connection_,
      "SELECT id, version, score_steps, not_assessable_reason, comment, submitted_utc_us FROM training_mark"
      " WHERE assignment_id = ? ORDER BY version DESC LIMIT 1",
      {assignmentId}, [&markId](RowReader& row) {
        markId = row.text();
        return Sheet{row.int64(), row.maybeInt64(), row.text(), row.text(), {}, row.int64()};
      });
  if (sheet) {
    sheet->rows = markRows(connection_, markId);
  }
  return sheet;
}

bool SheetRepository::allSubmitted(const EnrolmentId& enrolmentId, const std::string& occasionCode) const {
  return selectFirst(connection_,
                     "SELECT count(*) FROM assignment a WHERE a.enrolment_id = ? AND a.occasion = ?"
                     " AND NOT EXISTS (SELECT 1 FROM training_mark m WHERE m.assignment_id = a.id)"
                     " AND " +
                         isAskedFor("a"),
                     {enrolmentId, occasionCode}, readInt64)
             .value_or(1) == 0;
}

std::optional<std::int64_t> SheetRepository::panelOpenedUtc_us(const EnrolmentId& enrolmentId,
                                                               const std::string& occasionCode) const {
  std::vector<std::int64_t> first =
      selectAll(connection_,
                "SELECT MIN(m.submitted_utc_us) FROM training_mark m"
                " WHERE m.enrolment_id = ? AND m.occasion = ? GROUP BY m.rater_id",
                {enrolmentId, occasionCode}, readInt64);
  // Once a discrepancy has been decided, the marks stay visible even if further raters are assigned.
  const std::vector<std::int64_t> decided = selectAll(
      connection_,
      "SELECT d.decided_utc_us FROM alignment_decision d JOIN assignment a ON a.id = d.assignment_id"
      " WHERE a.enrolment_id = ? AND a.occasion = ? ORDER BY d.decided_utc_us LIMIT 1",
      {enrolmentId, occasionCode}, readInt64);
  if (!decided.empty()) {
    std::erase_if(first, [&](std::int64_t submitted_us) { return submitted_us > decided.front(); });
  } else if (!allSubmitted(enrolmentId, occasionCode)) {
    return std::nullopt;
  }
  return first.size() < 2 ? std::nullopt : std::optional(*std::max_element(first.begin(), first.end()));
}

std::optional<std::int64_t> SheetRepository::ownSheetsDoneUtc_us(const EnrolmentId& enrolmentId,
                                                                 const std::string& occasionCode,
                                                                 const RaterId& raterId) const {
  const std::vector<std::optional<std::int64_t>> first =
      selectAll(connection_,
                "SELECT (SELECT MIN(m.submitted_utc_us) FROM training_mark m WHERE m.assignment_id = a.id)"
                " FROM assignment a JOIN enrolment e ON e.id = a.enrolment_id"
                " JOIN enrolment o ON o.cohort_id = e.cohort_id"
                " WHERE o.id = ? AND a.occasion = ? AND a.rater_id = ? AND " +
                    isAskedFor("a"),
                {enrolmentId, occasionCode, raterId}, [](RowReader& row) { return row.maybeInt64(); });
  std::int64_t done_us = 0;
  for (const std::optional<std::int64_t>& one : first) {
    if (!one) {
      return std::nullopt;
    }
    done_us = std::max(done_us, *one);
  }
  return done_us;
}

std::vector<CohortId> SheetRepository::cohortsWithRaterWork(std::int64_t fromUtc_us,
                                                            std::int64_t toUtc_us) const {
  return selectAll(
      connection_,
      "SELECT e.cohort_id FROM live_call c JOIN enrolment e ON e.id = c.enrolment_id WHERE NOT c.cancelled"
      " AND (c.ended_utc_us IS NULL OR (c.called_utc_us >= ? AND c.called_utc_us < ?))"
      " UNION SELECT e.cohort_id FROM assignment a JOIN enrolment e ON e.id = a.enrolment_id"
      " WHERE a.due_utc_us < ?"
      " AND NOT EXISTS (SELECT 1 FROM training_mark m WHERE m.assignment_id = a.id) AND " +
          isAskedFor("a"),
      {fromUtc_us, toUtc_us, toUtc_us}, readId<CohortId>);
}

std::int64_t SheetRepository::openAssignments(const CohortId& cohortId) const {
  return selectFirst(connection_,
                     "SELECT count(*) FROM enrolment e JOIN assignment a ON a.enrolment_id = e.id WHERE "
                     "e.cohort_id = ?"
                     " AND NOT EXISTS (SELECT 1 FROM training_mark m WHERE m.assignment_id = a.id)"
                     " AND " +
                         isAskedFor("a"),
                     {cohortId}, readInt64)
      .value_or(0);
}

void SheetRepository::setReleased(const CohortId& cohortId, const std::string& occasionCode, bool released,
                                  const std::string& reason, const std::string& decidedBy,
                                  std::int64_t utc_us) {
  connection_.execute(
      "INSERT INTO mark_release (cohort_id, occasion, sequence, released, reason, decided_by, "
      "decided_utc_us)"
      " VALUES (?, ?, (SELECT COALESCE(MAX(r.sequence), 0) + 1 FROM mark_release r WHERE r.cohort_id = ?"
      " AND r.occasion = ?), ?, ?, ?, ?)",
      {cohortId, occasionCode, cohortId, occasionCode, released, reason, decidedBy, utc_us});
}

bool SheetRepository::isReleased(const CohortId& cohortId, const std::string& occasionCode) const {
  return selectFirst(connection_,
                     "SELECT released FROM mark_release WHERE cohort_id = ? AND occasion = ?"
                     " ORDER BY sequence DESC LIMIT 1",
                     {cohortId, occasionCode}, readBoolean)
      .value_or(false);
}

}  // namespace torsio
