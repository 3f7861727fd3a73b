// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "assessment/domain/rating/sheet.h"

namespace torsio {

/// Records which stretches of a recording were played, at which speeds, and the rater's working time. Seeking
/// does not count as watching. A plain value for one thread at a time.
class WatchLog {
 public:
  WatchLog() = default;
  /// `length_us` 0: a live case without a recording.
  explicit WatchLog(std::int64_t length_us) : length_us_(length_us) {}
  /// Restores the state stored with the draft; an invalid text counts as nothing watched.
  WatchLog(std::int64_t length_us, const SheetViewing& stored);

  /// Adds playback from `from_us` to `to_us` at `speed` (1: real time).
  void played(std::int64_t from_us, std::int64_t to_us, double speed);
  void worked(std::int64_t us) noexcept { worked_us_ += us; }
  /// Merges another log of the same recording, such as that of another desk or an earlier save: keeps
  /// everything watched and counts no minute twice.
  void join(const WatchLog& other);
  /// Merges only the working time.
  void joinWork(const WatchLog& other) noexcept { worked_us_ = std::max(worked_us_, other.worked_us_); }
  /// Returns the stretches of this log that `other` lacks, microseconds, ascending.
  [[nodiscard]] std::vector<std::pair<std::int64_t, std::int64_t>> without(const WatchLog& other) const;

  /// Returns the share watched, 0..1; 1 for a live case.
  [[nodiscard]] double share() const noexcept;
  [[nodiscard]] double slowest() const noexcept { return slowest_; }
  [[nodiscard]] double fastest() const noexcept { return fastest_; }
  [[nodiscard]] std::int64_t worked_us() const noexcept { return worked_us_; }
  [[nodiscard]] std::int64_t length_us() const noexcept { return length_us_; }
  [[nodiscard]] SheetViewing stored() const;
  /// Returns what was watched, microseconds, disjoint and ascending.
  [[nodiscard]] std::vector<std::pair<std::int64_t, std::int64_t>> spans() const {
    return {spans_.begin(), spans_.end()};
  }

 private:
  void add(std::int64_t from, std::int64_t to);

  std::int64_t length_us_ = 0;
  std::map<std::int64_t, std::int64_t> spans_;  // start -> end, microseconds, disjoint
  double slowest_ = 1.0;
  double fastest_ = 1.0;
  std::int64_t worked_us_ = 0;
};

}  // namespace torsio
