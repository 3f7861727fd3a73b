// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <thread>

#include "sim/core/deadline.h"

namespace torsio {

std::int64_t deadlineNow_ns() noexcept {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

void sleepUntil(std::int64_t deadline_ns) noexcept {
  const std::chrono::steady_clock::time_point deadline{
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::nanoseconds(deadline_ns))};
  std::this_thread::sleep_until(deadline);
}

bool requestRealTime(RealTimeRank) noexcept {
  return false;
}

LockedMemory::LockedMemory(const void* object, std::size_t bytes) noexcept : object_(object), bytes_(bytes) {}

LockedMemory::~LockedMemory() = default;

}  // namespace torsio
