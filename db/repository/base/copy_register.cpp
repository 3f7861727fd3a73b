// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/copy_register.h"

#include "db/connection/row_reader.h"
#include "db/repository/base/id_source.h"
#include "db/repository/base/stored_term.h"

namespace torsio {

namespace {

constexpr const char* kListed =
    "SELECT c.kind, c.place, c.station, c.person_id, c.made_utc_us, c.id FROM record_copy c"
    " WHERE c.gone_utc_us IS NULL";

RecordCopy copyOf(RowReader& row) {
  return {.kind = readTerm<CopyKind>(row, "record_copy.kind"),
          .place = row.text(),
          .station = row.text(),
          .personId = row.text(),
          .madeUtc_us = row.int64(),
          .id = row.text()};
}

}  // namespace

std::string CopyRegister::add(const RecordCopy& copy) {
  Transaction transaction(connection_);
  std::string id = SystemIdSource().newUuid();
  connection_.execute(
      "UPDATE record_copy SET gone_utc_us = ? WHERE place = ? AND station = ? AND gone_utc_us IS NULL",
      {copy.madeUtc_us, copy.place, copy.station});
  connection_.execute(
      insertInto("record_copy", "id, kind, place, station, person_id, made_utc_us"),
      {id, storedText(copy.kind), copy.place, copy.station, textOrNull(copy.personId), copy.madeUtc_us});
  transaction.commit();
  return id;
}

std::vector<RecordCopy> CopyRegister::all() const {
  return selectAll(connection_, std::string(kListed) + " ORDER BY c.made_utc_us DESC, c.id", {}, copyOf);
}

std::vector<RecordCopy> CopyRegister::holding(const PersonId& personId) const {
  return selectAll(connection_,
                   std::string(kListed) +
                       " AND (c.person_id = ? OR (c.person_id IS NULL AND c.made_utc_us >="
                       " (SELECT p.created_utc_us FROM person p WHERE p.id = ?)))"
                       " ORDER BY c.made_utc_us DESC, c.id",
                   {personId, personId}, copyOf);
}

void CopyRegister::setGone(const std::string& id, std::int64_t utc_us) {
  connection_.execute("UPDATE record_copy SET gone_utc_us = ? WHERE id = ?", {utc_us, id});
}

}  // namespace torsio
