// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/signature_repository.h"

#include "db/connection/row_reader.h"
#include "db/repository/base/stored_term.h"

namespace torsio {

void SignatureRepository::add(const Signature& signature) {
  connection_.execute(insertInto("signature",
                                 "object_kind, object_id, user_id, person_id, meaning, reason, signed_utc_us,"
                                 " password_shown_utc_us, demonstration"),
                      {storedText(signature.kind), signature.objectId, signature.userId,
                       textOrNull(signature.personId), storedText(signature.meaning), signature.reason,
                       signature.signedUtc_us, signature.passwordShownUtc_us, signature.demonstration});
}

std::map<std::string, Signature> SignatureRepository::all(SignedKind kind) const {
  std::map<std::string, Signature> found;
  for (Signature& one : selectAll(
           connection_,
           "SELECT object_id, user_id, person_id, meaning, reason, signed_utc_us, password_shown_utc_us,"
           " demonstration FROM signature WHERE object_kind = ?",
           {storedText(kind)}, [kind](RowReader& row) {
             return Signature{.kind = kind,
                              .objectId = row.text(),
                              .userId = row.text(),
                              .personId = row.text(),
                              .meaning = readTerm<SignatureMeaning>(row, "meaning"),
                              .reason = row.text(),
                              .signedUtc_us = row.int64(),
                              .passwordShownUtc_us = row.int64(),
                              .demonstration = row.boolean()};
           })) {
    found.emplace(one.objectId, std::move(one));
  }
  return found;
}

}  // namespace torsio
