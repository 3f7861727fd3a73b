// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/day_slot.h"

namespace torsio {

/// Who comes in which order, and where there is room for them.
struct DayPlanRequest {
  CohortId cohortId{};
  std::vector<EnrolmentId> enrolmentIds{};  ///< in the order in which they come
  std::vector<std::string> places{};        ///< stations and rooms that work side by side
  std::int64_t firstUtc_us = 0;
  std::int64_t duration_us = 0;
  std::int64_t pause_us = 0;  ///< at each place, between two
};

/// Gives each trainee a slot: as many at a time as there are places, one round after the other. Audited.
/// kStudySetup. Throws Error{kBadParameter}: nobody, no place, a place that comes twice, no duration;
/// {kBadData}: somebody is not in the cohort or has withdrawn; a place or a trainee has another slot at that
/// time, in any cohort.
std::vector<DaySlot> planDay(SessionContext& session, const DayPlanRequest& request);

/// The slots of a cohort that touch [from, to), by start and place. kStudySetup.
[[nodiscard]] std::vector<DaySlot> daySlots(SessionContext& session, const CohortId& cohortId,
                                            std::int64_t fromUtc_us, std::int64_t toUtc_us);

/// Takes slots out of the plan. Audited. kStudySetup. Throws Error{kBadData} for a slot that is there no
/// more.
void removeSlots(SessionContext& session, const CohortId& cohortId, std::span<const DaySlotId> slotIds);

/// The slot that counts for a trainee at a time: the one that runs or began last on that day, else the next
/// one; null: none. `slots`: of that trainee among others, by start.
[[nodiscard]] const DaySlot* slotAt(std::span<const DaySlot> slots, const EnrolmentId& enrolmentId,
                                    std::int64_t utc_us);

/// The slot as the audit trail keeps it.
[[nodiscard]] std::string slotJson(const DaySlot& slot);

/// Half a day to either side of a time: what belongs to the day of whoever works then.
inline constexpr std::int64_t kHalfDay_us = 12LL * 3600 * 1'000'000;

}  // namespace torsio
