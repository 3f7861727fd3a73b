// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/request_repository.h"

#include "db/connection/row_reader.h"
#include "db/repository/base/stored_term.h"
#include "sim/core/error.h"

namespace torsio {

void RequestRepository::add(const PersonRequest& request) {
  connection_.execute(insertInto("person_request", "id, person_id, kind, asked_utc_us"),
                      {request.id, request.personId, storedText(request.kind), request.askedUtc_us});
}

void RequestRepository::answer(const std::string& requestId, PersonRequestAnswer answer,
                               const std::string& reason, std::int64_t utc_us) {
  const std::int64_t changed = connection_.execute(
      "UPDATE person_request SET answer = ?, answer_reason = ?, answered_utc_us = ?"
      " WHERE id = ? AND answer IS NULL",
      {storedText(answer), textOrNull(reason), utc_us, requestId});
  if (changed != 1) {
    refuse(Text::tr("this request was answered already"), requestId, Text::tr("Read the list again"));
  }
}

std::vector<PersonRequest> RequestRepository::all() const {
  return selectAll(
      connection_,
      "SELECT r.id, r.person_id, r.kind, r.asked_utc_us, r.answer, r.answer_reason,"
      " r.answered_utc_us, p.code FROM person_request r JOIN person p ON p.id = r.person_id"
      " ORDER BY r.asked_utc_us DESC, r.id",
      {}, [](RowReader& row) {
        PersonRequest request{row.text(), row.text(), readTerm<PersonRequestKind>(row, "kind"), row.int64()};
        request.answer = readMaybeTerm<PersonRequestAnswer>(row, "answer");
        request.reason = row.text();
        request.answeredUtc_us = row.maybeInt64().value_or(0);
        request.personCode = row.text();
        return request;
      });
}

}  // namespace torsio
