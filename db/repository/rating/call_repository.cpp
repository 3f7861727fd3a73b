// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/call_repository.h"

#include "assessment/domain/ids.h"
#include "db/connection/row_reader.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr const char* kSelectCalls =
    "SELECT c.id, c.enrolment_id, c.occasion, c.room, c.called_by, c.called_utc_us, c.ended_utc_us, "
    "c.cancelled"
    " FROM live_call c";

LiveCall readCall(RowReader& row) {
  return LiveCall{row.text(), row.text(),  row.text(),       row.text(),
                  row.text(), row.int64(), row.maybeInt64(), row.boolean()};
}

}  // namespace

void CallRepository::add(std::span<const LiveCall> calls) {
  Transaction transaction(connection_);
  Statement insert = connection_.prepare(insertInto(
      "live_call", "id, enrolment_id, occasion, room, called_by, called_utc_us, ended_utc_us, cancelled"));
  for (const LiveCall& call : calls) {
    insert.execute({call.id, call.enrolmentId, call.occasionCode, call.room, call.calledBy, call.calledUtc_us,
                    call.endedUtc_us, call.cancelled});
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
                   std::string(kSelectCalls) +
                       " JOIN enrolment e ON e.id = c.enrolment_id WHERE e.cohort_id = ?"
                       " ORDER BY c.called_utc_us, c.id",
                   {cohortId}, readCall);
}

std::optional<LiveCall> CallRepository::openIn(const std::string& room) const {
  return selectFirst(connection_, std::string(kSelectCalls) + " WHERE c.room = ? AND c.ended_utc_us IS NULL",
                     {room}, readCall);
}

bool CallRepository::wasCalled(const EnrolmentId& enrolmentId, const std::string& occasionCode) const {
  return selectFirst(connection_,
                     "SELECT count(*) FROM live_call WHERE enrolment_id = ? AND occasion = ?"
                     " AND cancelled = FALSE",
                     {enrolmentId, occasionCode}, readInt64)
             .value_or(0) > 0;
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

}  // namespace torsio
