// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <cstddef>
#include <ctime>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "sim/core/deadline.h"

namespace torsio {

namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
// Above ordinary real-time work, below the kernel's own threads (99).
constexpr int kPriority = 80;
// A tick that never ends must not keep its watchdog from running.
constexpr int kWatchdogPriority = 81;
// More than a tick takes (DeformedSurface), far less than any thread has.
constexpr std::size_t kStack = 256 * 1024;
constexpr std::size_t kPage = 4096;

}  // namespace

std::int64_t deadlineNow_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * kSecond_ns + now.tv_nsec;
}

void sleepUntil(std::int64_t deadline_ns) noexcept {
  timespec deadline{};
  deadline.tv_sec = static_cast<decltype(deadline.tv_sec)>(deadline_ns / kSecond_ns);
  deadline.tv_nsec = static_cast<decltype(deadline.tv_nsec)>(deadline_ns % kSecond_ns);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
  }
}

bool requestRealTime(RealTimeRank rank) noexcept {
#ifdef __linux__
  // The default timer slack of 50 us would delay every wake-up of an ordinary thread.
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
#endif
  sched_param parameters{};
  parameters.sched_priority = rank == RealTimeRank::kWatchdog ? kWatchdogPriority : kPriority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

LockedMemory::LockedMemory(const void* object, std::size_t bytes) noexcept : object_(object), bytes_(bytes) {
  volatile std::byte stack[kStack];
  for (std::size_t at = 0; at < kStack; at += kPage) {
    stack[at] = std::byte{0};
    (void)stack[at];
  }
  stack_ =
      const_cast<const std::byte*>(&stack[0]);  // NOLINT: the pages outlive the array, it is their address
  locked_ = mlock(stack_, kStack) == 0 && mlock(object_, bytes_) == 0;
}

LockedMemory::~LockedMemory() {
  munlock(object_, bytes_);
  munlock(stack_, kStack);
}

}  // namespace torsio
