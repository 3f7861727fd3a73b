// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/call_repository.h"

#include "assessment/domain/ids.h"
#include "db/repository/base/row_columns.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr auto kCall = rowColumns<LiveCall>(
    "live_call", "id, enrolment_id, occasion, room, called_by, called_utc_us, ended_utc_us, cancelled",
    &LiveCall::id, &LiveCall::enrolmentId, &LiveCall::occasionCode, &LiveCall::room, &LiveCall::calledBy,
    &LiveCall::calledUtc_us, &LiveCall::endedUtc_us, &LiveCall::cancelled);

const std::string kSelectCalls = kCall.select("c") + " FROM live_call c";

}  // namespace

void CallRepository::add(std::span<const LiveCall> calls) {
  Transaction transaction(connection_);
  Statement insert = connection_.prepare(kCall.insert());
  for (const LiveCall& call : calls) {
    insert.execute(kCall.values(call));
  }
  transaction.commit();
}

void CallRepository::end(const LiveCallId& callId, bool cancelled, std::int64_t utc_us) {
  const std::int64_t changed = connection_.execute(
      "UPDATE live_call SET ended_utc_us = ?, cancelled = ? WHERE id = ? AND ended_utc_us IS NULL",
      {utc_us, cancelled, callId});
  if (changed != 1) {
    refuse(Text::tr("this call has ended already"), callId, Text::tr("Refresh Today's sessions"));
  }
}

std::vector<LiveCall> CallRepository::calls(const CohortId& cohortId) const {
  return selectAll(connection_,
                   kSelectCalls +
                       " JOIN enrolment e ON e.id = c.enrolment_id WHERE e.cohort_id = ?"
                       " ORDER BY c.called_utc_us, c.id",
                   {cohortId}, kCall);
}

std::optional<LiveCall> CallRepository::openIn(const std::string& room) const {
  return selectFirst(connection_, kSelectCalls + " WHERE c.room = ? AND c.ended_utc_us IS NULL", {room},
                     kCall);
}

bool CallRepository::wasCalled(const EnrolmentId& enrolmentId, const std::string& occasionCode) const {
  return selectFirst(connection_,
                     "SELECT count(*) FROM live_call WHERE enrolment_id = ? AND occasion = ?"
                     " AND cancelled = FALSE",
                     {enrolmentId, occasionCode}, readInt64)
             .value_or(0) > 0;
}

std::optional<std::int64_t> CallRepository::lastCalledUtc_us(const EnrolmentId& enrolmentId,
                                                             const std::string& occasionCode) const {
  return selectFirst(connection_,
                     "SELECT called_utc_us FROM live_call WHERE enrolment_id = ? AND occasion = ?"
                     " AND cancelled = FALSE ORDER BY called_utc_us DESC LIMIT 1",
                     {enrolmentId, occasionCode}, readInt64);
}

std::vector<CallNotice> CallRepository::noticesFor(const RaterId& raterId) const {
  return selectAll(connection_,
                   "SELECT a.id, c.room, c.called_utc_us, c.ended_utc_us FROM assignment a"
                   " JOIN live_call c ON c.enrolment_id = a.enrolment_id AND c.occasion = a.occasion"
                   " WHERE a.rater_id = ? AND a.trial_id IS NULL AND c.cancelled = FALSE"
                   " AND NOT EXISTS (SELECT 1 FROM live_call n WHERE n.enrolment_id = c.enrolment_id"
                   "  AND n.occasion = c.occasion AND n.cancelled = FALSE AND (n.called_utc_us >"
                   "  c.called_utc_us OR (n.called_utc_us = c.called_utc_us AND n.id > c.id)))"
                   " ORDER BY c.called_utc_us, a.position",
                   {raterId}, [](RowReader& row) {
                     CallNotice notice{row.text(), row.text(), row.int64()};
                     notice.open = !row.maybeInt64().has_value();
                     return notice;
                   });
}

std::string CallRepository::stamp() const {
  return selectFirst(connection_,
                     "SELECT count(*), COALESCE(max(called_utc_us), 0), count(ended_utc_us),"
                     " COALESCE(max(ended_utc_us), 0) FROM live_call",
                     {},
                     [](RowReader& row) {
                       std::string stamp;
                       for (int column = 0; column < 4; ++column) {
                         stamp += std::to_string(row.int64()) + " ";
                       }
                       return stamp;
                     })
      .value();
}

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
