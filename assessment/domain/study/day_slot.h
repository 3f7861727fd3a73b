// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "assessment/domain/ids.h"

namespace torsio {

using DaySlotId = Id<struct DaySlotIdTag>;

/// An appointment: trainee, place and time.
struct DaySlot {
  DaySlotId id{};
  EnrolmentId enrolmentId{};
  std::string place{};  ///< a station or a room
  std::int64_t startsUtc_us = 0;
  std::int64_t duration_us = 0;
  std::string traineeCode{};  ///< filled when read

  [[nodiscard]] std::int64_t endsUtc_us() const noexcept { return startsUtc_us + duration_us; }
};

/// A trainee who has not begun by this time after the start of the slot is overdue.
inline constexpr std::int64_t kSlotGrace_us = 5LL * 60 * 1'000'000;

}  // namespace torsio
