// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/copy_register.h"

#include "db/repository/base/id_source.h"
#include "db/repository/base/row_columns.h"

namespace torsio {

namespace {

constexpr auto kCopy = rowColumns<RecordCopy>(
    "record_copy", "id, kind, place, station, person_id, made_utc_us", &RecordCopy::id, &RecordCopy::kind,
    &RecordCopy::place, &RecordCopy::station, OrNull{&RecordCopy::personId}, &RecordCopy::madeUtc_us);
const std::string kListed = kCopy.select("c") + " FROM record_copy c WHERE c.gone_utc_us IS NULL";

}  // namespace

std::string CopyRegister::add(RecordCopy copy) {
  Transaction transaction(connection_);
  copy.id = SystemIdSource().newUuid();
  connection_.execute(
      "UPDATE record_copy SET gone_utc_us = ? WHERE place = ? AND station = ? AND gone_utc_us IS NULL",
      {copy.madeUtc_us, copy.place, copy.station});
  connection_.prepare(kCopy.insert()).execute(kCopy.values(copy));
  transaction.commit();
  return copy.id;
}

std::vector<RecordCopy> CopyRegister::all() const {
  return selectAll(connection_, kListed + " ORDER BY c.made_utc_us DESC, c.id", {}, kCopy);
}

std::vector<RecordCopy> CopyRegister::holding(const PersonId& personId) const {
  return selectAll(connection_,
                   kListed +
                       " AND (c.person_id = ? OR (c.person_id IS NULL AND c.made_utc_us >="
                       " (SELECT p.created_utc_us FROM person p WHERE p.id = ?)))"
                       " ORDER BY c.made_utc_us DESC, c.id",
                   {personId, personId}, kCopy);
}

void CopyRegister::setGone(const std::string& id, std::int64_t utc_us) {
  connection_.execute("UPDATE record_copy SET gone_utc_us = ? WHERE id = ?", {utc_us, id});
}

}  // namespace torsio
