// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/signature_repository.h"

#include "db/repository/base/row_columns.h"

namespace torsio {

namespace {

constexpr auto kSignature = rowColumns<Signature>(
    "signature",
    "object_kind, object_id, user_id, person_id, meaning, reason, signed_utc_us, password_shown_utc_us,"
    " demonstration",
    &Signature::kind, &Signature::objectId, &Signature::userId, OrNull{&Signature::personId},
    &Signature::meaning, &Signature::reason, &Signature::signedUtc_us, &Signature::passwordShownUtc_us,
    &Signature::demonstration);

}  // namespace

void SignatureRepository::add(const Signature& signature) {
  connection_.prepare(kSignature.insert()).execute(kSignature.values(signature));
}

std::map<std::string, Signature> SignatureRepository::all(SignedKind kind) const {
  std::map<std::string, Signature> found;
  for (Signature& one :
       selectAll(connection_, kSignature.select("s") + " FROM signature s WHERE s.object_kind = ?",
                 {storedText(kind)}, kSignature)) {
    found.emplace(one.objectId, std::move(one));
  }
  return found;
}

void DutyRepository::add(const DutyRequest& request) {
  connection_.execute(
      insertInto("duty_request", "id, act, subject, detail_json, reason, requested_by, requested_utc_us"),
      {request.id, storedText(request.act), request.subject, request.detailJson, request.reason,
       request.requestedBy, request.requestedUtc_us});
}

std::vector<DutyRequest> DutyRepository::open(std::int64_t sinceUtc_us) const {
  return selectAll(connection_,
                   "SELECT r.id, r.act, r.subject, r.detail_json, r.reason, r.requested_by,"
                   " r.requested_utc_us FROM duty_request r WHERE r.requested_utc_us >= ? AND NOT EXISTS"
                   " (SELECT 1 FROM duty_decision d WHERE d.request_id = r.id)"
                   " ORDER BY r.requested_utc_us, r.id",
                   {sinceUtc_us}, [](RowReader& row) {
                     return DutyRequest{
                         row.text(), readTerm<DutyAct>(row), row.text(), row.text(), row.text(), row.text(),
                         row.int64()};
                   });
}

void DutyRepository::decide(const std::string& requestId, DutyDecision decision, const UserId& decidedBy,
                            std::int64_t utc_us) {
  connection_.execute(insertInto("duty_decision", "request_id, decision, decided_by, decided_utc_us"),
                      {requestId, storedText(decision), decidedBy, utc_us});
}

}  // namespace torsio
