// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace fakehd {

/// What happened, as the fake saw it.
enum class Seen : std::int32_t {
  kInit,
  kStart,
  kPush,       ///< the motors have a force
  kRest,       ///< ... and have none any more
  kZeroFrame,  ///< a frame with zero force was taken
  kOutputOn,
  kOutputOff,
  kStop,
  kUnschedule,
  kDisable,
  kFault,  ///< the story's fault began
};

struct SeenEvent {
  std::atomic<std::int64_t> time_ns;  ///< CLOCK_MONOTONIC, the same in all processes
  std::atomic<std::int64_t>
      waited_ns;  ///< run-queue waiting of the process's first and servo thread until then
  std::atomic<Seen> what;
};

/// The file that FAKEHD_RECORD names, mapped by the fake and by the test: it tells what the motors had
/// whoever was killed. All zero at first.
struct FakeRecord {
  static constexpr std::size_t kMost = 4096;
  std::atomic<std::int64_t> process;    ///< that loaded the fake
  std::atomic<std::int64_t> servo;      ///< its servo thread
  std::atomic<std::int64_t> ticks;      ///< that have begun
  std::atomic<std::int64_t> motors_uN;  ///< norm of the force that the motors have now
  std::atomic<std::int64_t> most_uN;    ///< the largest that they ever had
  std::atomic<std::int64_t> count;      ///< of events
  std::array<SeenEvent, kMost> events;
};

/// Time that a thread of a process has waited for a processor, ns (the second number of its schedstat); 0
/// where the system does not say.
std::int64_t waited_ns(std::int64_t process, std::int64_t thread);

}  // namespace fakehd
