// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"

namespace torsio {

/// Trainees in order, and the places available.
struct DayPlanRequest {
  CohortId cohortId{};
  std::vector<EnrolmentId> enrolmentIds{};  ///< in order of arrival
  std::vector<std::string> places{};        ///< stations and rooms used in parallel
  std::int64_t firstUtc_us = 0;
  std::int64_t duration_us = 0;
  std::int64_t pause_us = 0;  ///< between two trainees at each place
};

/// Gives each trainee a slot: in rounds of as many as there are places. Audited. kStudySetup. Throws
/// Error{kBadParameter} without trainees, places or a duration, or for a duplicate place; {kBadData} if a
/// trainee is not in the cohort or has withdrawn, or a place or trainee has another slot at that time, in any
/// cohort.
std::vector<DaySlot> planDay(SessionContext& session, const DayPlanRequest& request);

/// Returns a cohort's slots that overlap [from, to), by start and place. kStudySetup.
[[nodiscard]] std::vector<DaySlot> daySlots(SessionContext& session, const CohortId& cohortId,
                                            std::int64_t fromUtc_us, std::int64_t toUtc_us);

/// Removes slots from the plan. Audited. kStudySetup. Throws Error{kBadData} for a slot that no longer
/// exists.
void removeSlots(SessionContext& session, const CohortId& cohortId, std::span<const DaySlotId> slotIds);

/// Returns the slot that applies to a trainee at a time: the one that is running or started last on that day,
/// else the next one; null if none. `slots`: of this and other trainees, by start.
[[nodiscard]] const DaySlot* slotAt(std::span<const DaySlot> slots, const EnrolmentId& enrolmentId,
                                    std::int64_t utc_us);

/// Returns the slot in the audit trail's format.
[[nodiscard]] nlohmann::json slotJson(const DaySlot& slot);

/// Half a day before and after a time: what belongs to the same working day.
inline constexpr std::int64_t kHalfDay_us = 12LL * 3600 * 1'000'000;

}  // namespace torsio
