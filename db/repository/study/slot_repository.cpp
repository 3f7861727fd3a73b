// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/study/slot_repository.h"

#include "db/connection/row_reader.h"

namespace torsio {

void SlotRepository::add(std::span<const DaySlot> slots) {
  Transaction transaction(connection_);
  Statement insert =
      connection_.prepare(insertInto("day_slot", "id, enrolment_id, place, starts_utc_us, duration_us"));
  for (const DaySlot& slot : slots) {
    insert.execute({slot.id, slot.enrolmentId, slot.place, slot.startsUtc_us, slot.duration_us});
  }
  transaction.commit();
}

void SlotRepository::remove(const DaySlotId& slotId) {
  connection_.execute("DELETE FROM day_slot WHERE id = ?", {slotId});
}

void SlotRepository::give(const DaySlotId& slotId, const EnrolmentId& enrolmentId) {
  connection_.execute("UPDATE day_slot SET enrolment_id = ? WHERE id = ?", {enrolmentId, slotId});
}

std::vector<DaySlot> SlotRepository::between(const CohortId& cohortId, std::int64_t fromUtc_us,
                                             std::int64_t toUtc_us) const {
  return selectAll(connection_,
                   "SELECT s.id, s.enrolment_id, s.place, s.starts_utc_us, s.duration_us, p.code"
                   " FROM day_slot s JOIN enrolment e ON e.id = s.enrolment_id"
                   " JOIN person p ON p.id = e.trainee_id"
                   " WHERE (? = '' OR e.cohort_id = ?) AND s.starts_utc_us < ?"
                   " AND s.starts_utc_us + s.duration_us > ? ORDER BY s.starts_utc_us, s.place, s.id",
                   {cohortId, cohortId, toUtc_us, fromUtc_us}, [](RowReader& row) {
                     return DaySlot{row.text(), row.text(), row.text(), row.int64(), row.int64(), row.text()};
                   });
}

}  // namespace torsio
