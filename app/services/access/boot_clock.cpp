// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/boot_clock.h"

#include <ctime>

namespace torsio {

#ifdef CLOCK_BOOTTIME

std::int64_t BootClock::now_us() const noexcept {
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return std::int64_t{now.tv_sec} * 1'000'000 + now.tv_nsec / 1000;
}

#else

std::int64_t BootClock::now_us() const noexcept {
  return MonotonicClock().now_us();
}

#endif

}  // namespace torsio
