// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/day_slot.h"
#include "db/connection/connection.h"

namespace torsio {

/// Appointments. Each call is one transaction.
class SlotRepository {
 public:
  explicit SlotRepository(Connection& connection) : connection_(connection) {}

  void add(std::span<const DaySlot> slots);
  void remove(const DaySlotId& slotId);
  /// Gives a slot to another trainee.
  void give(const DaySlotId& slotId, const EnrolmentId& enrolmentId);
  /// Slots of a cohort (empty: of all) that overlap [from, to), by start and place.
  [[nodiscard]] std::vector<DaySlot> between(const CohortId& cohortId, std::int64_t fromUtc_us,
                                             std::int64_t toUtc_us) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
