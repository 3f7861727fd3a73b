// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "assessment/domain/rating/sheet.h"

namespace torsio {

/// Which stretches of a recording were played, at which speeds, and how long the rater has been at work.
/// Jumps over the time axis count for nothing: only what went by was watched. Plain value, any one thread.
class WatchLog {
 public:
  WatchLog() = default;
  /// `length_us` 0: live, nothing to watch.
  explicit WatchLog(std::int64_t length_us) : length_us_(length_us) {}
  /// As it was stored with the draft; a text that cannot be read counts as nothing watched.
  WatchLog(std::int64_t length_us, const SheetViewing& stored);

  /// The recording went from `from_us` to `to_us` by itself, at `speed` (1: as it happened).
  void played(std::int64_t from_us, std::int64_t to_us, double speed);
  void worked(std::int64_t us) noexcept { worked_us_ += us; }
  /// Takes in what another log of the same recording knows, that of another desk or of an earlier save:
  /// nothing that was watched is lost, and no minute counts twice.
  void join(const WatchLog& other);

  /// 0..1; 1 for a live case.
  [[nodiscard]] double share() const noexcept;
  [[nodiscard]] double slowest() const noexcept { return slowest_; }
  [[nodiscard]] double fastest() const noexcept { return fastest_; }
  [[nodiscard]] std::int64_t worked_us() const noexcept { return worked_us_; }
  [[nodiscard]] std::int64_t length_us() const noexcept { return length_us_; }
  [[nodiscard]] SheetViewing stored() const;
  /// What was watched, microseconds, disjoint and rising.
  [[nodiscard]] std::vector<std::pair<std::int64_t, std::int64_t>> spans() const {
    return {spans_.begin(), spans_.end()};
  }

 private:
  void add(std::int64_t from, std::int64_t to);

  std::int64_t length_us_ = 0;
  std::map<std::int64_t, std::int64_t> spans_;  // from -> to, microseconds, disjoint
  double slowest_ = 1.0;
  double fastest_ = 1.0;
  std::int64_t worked_us_ = 0;
};

}  // namespace torsio
