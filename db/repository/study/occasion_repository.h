// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/occasion.h"
#include "db/connection/connection.h"

namespace torsio {

/// All occasions, and which of them a cohort uses. Each call is one transaction.
class OccasionRepository {
 public:
  explicit OccasionRepository(Connection& connection) : connection_(connection) {}

  /// Returns all occasions in chronological order, without training times: those belong to curricula.
  [[nodiscard]] Occasions all() const;
  /// Adds an occasion as the last one. Throws DbError{kUnique} if the code is taken.
  void add(const Occasion& occasion);
  /// Returns the codes of occasions with marks or assignments in a cohort.
  [[nodiscard]] std::set<std::string> usedBy(const CohortId& cohortId) const;
  /// True if a cohort was imported with foreign recordings (sim/core/foreign_recording.h); a tracker's
  /// recordings belong to a phase of their own curriculum.
  [[nodiscard]] bool cameFromElsewhere(const CohortId& cohortId) const;

 private:
  Connection& connection_;
};

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
