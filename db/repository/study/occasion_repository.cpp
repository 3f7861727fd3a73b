// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/study/occasion_repository.h"

#include <utility>
#include <vector>

#include "assessment/domain/ids.h"
#include "db/connection/row_reader.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

Occasions OccasionRepository::all() const {
  return Occasions(selectAll(connection_, "SELECT code, label FROM occasion ORDER BY position, code", {},
                             [](RowReader& row) {
                               return Occasion{row.text(), row.text(), {}};
                             }));
}

void OccasionRepository::add(const Occasion& occasion) {
  connection_.execute(
      "INSERT INTO occasion (code, label, position)"
      " VALUES (?, ?, (SELECT COALESCE(MAX(s.position), 0) + 1 FROM occasion s))",
      {occasion.code, occasion.label});
}

bool OccasionRepository::cameFromElsewhere(const CohortId& cohortId) const {
  return selectFirst(connection_,
                     "SELECT t.id FROM trial t JOIN enrolment e ON e.id = t.enrolment_id"
                     " WHERE e.cohort_id = ? AND t.scene_id = ? AND t.phase_id IS NULL LIMIT 1",
                     {cohortId, std::string(kForeignScene)}, readText)
      .has_value();
}

std::set<std::string> OccasionRepository::usedBy(const CohortId& cohortId) const {
  const std::vector<std::string> codes =
      selectAll(connection_,
                // The first sheet or mark of each occasion is enough; a large study has a hundred thousand.
                "SELECT s.code FROM occasion s WHERE"
                " EXISTS (SELECT 1 FROM enrolment e JOIN assignment a ON a.enrolment_id = e.id"
                " WHERE e.cohort_id = ? AND a.occasion = s.code)"
                " OR EXISTS (SELECT 1 FROM enrolment e JOIN training_mark m ON m.enrolment_id = e.id"
                " WHERE e.cohort_id = ? AND m.occasion = s.code)",
                {cohortId, cohortId}, readText);
  return {codes.begin(), codes.end()};
}

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
