// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace torsio {

/// Monotonic time in microseconds for phases, trials and ticks. Thread safe unless stated.
class Clock {
 public:
  virtual ~Clock() = default;
  [[nodiscard]] virtual std::int64_t now_us() const noexcept = 0;
};

/// The machine's monotonic clock; zero is arbitrary.
class MonotonicClock final : public Clock {
 public:
  [[nodiscard]] std::int64_t now_us() const noexcept override;
};

/// A clock that only moves when told to: replay, tests and the demonstration. One thread.
class ManualClock final : public Clock {
 public:
  explicit ManualClock(std::int64_t start_us = 0) noexcept : now_us_(start_us) {}
  [[nodiscard]] std::int64_t now_us() const noexcept override { return now_us_; }
  void advance_us(std::int64_t step_us) noexcept { now_us_ += step_us; }

 private:
  std::int64_t now_us_;
};

/// Returns the wall-clock time, microseconds since 1970-01-01 UTC. For records, never for measuring
/// durations.
[[nodiscard]] std::int64_t utcNow_us() noexcept;

// Times within a recording and durations below an hour, as minutes and seconds. What is measured or compared
// with a limit (a hold, a time to the target, a computing time) stays in seconds with its unit; planned
// durations are whole minutes in words. Any thread.

/// Elapsed time, rounded down to seconds: "2:05".
[[nodiscard]] std::string clockText(std::int64_t time_us);
/// Time left, rounded up to seconds: "2:05"; "0:00" when nothing is left.
[[nodiscard]] std::string clockLeftText(std::int64_t left_us);
/// To the nearest tenth: "2:05.4".
[[nodiscard]] std::string clockTenthsText(double time_s);

}  // namespace torsio
