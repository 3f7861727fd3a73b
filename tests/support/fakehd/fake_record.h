// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace fakehd {

/// Events, as seen by the fake.
enum class Seen : std::int32_t {
  kInit,
  kStart,
  kPush,       ///< the motors have a force
  kRest,       ///< the motors have no more force
  kZeroFrame,  ///< a frame with zero force was accepted
  kOutputOn,
  kOutputOff,
  kStop,
  kUnschedule,
  kDisable,
  kFault,  ///< the story's fault started
};

struct SeenEvent {
  std::atomic<std::int64_t> time_ns;  ///< CLOCK_MONOTONIC, the same in all processes
  std::atomic<std::int64_t>
      waited_ns;  ///< run-queue waiting time of the process's first and servo thread until then
  std::atomic<Seen> what;
};

/// The file named by FAKEHD_RECORD, mapped by fake and test: the force at the motors, whichever process is
/// killed. Initially zero.
struct FakeRecord {
  static constexpr std::size_t kMost = 4096;
  std::atomic<std::int64_t> process;    ///< process with the fake
  std::atomic<std::int64_t> servo;      ///< its servo thread
  std::atomic<std::int64_t> ticks;      ///< ticks started
  std::atomic<std::int64_t> motors_uN;  ///< norm of the present force at the motors
  std::atomic<std::int64_t> most_uN;    ///< maximum so far
  std::atomic<std::int64_t> orphan;     ///< process that the fake left behind
  std::atomic<std::int64_t> count;      ///< number of events
  std::array<SeenEvent, kMost> events;
};

/// Returns the time that a thread has waited for a processor, ns (the second number of its schedstat); 0 if
/// unknown.
std::int64_t waited_ns(std::int64_t process, std::int64_t thread);

}  // namespace fakehd
