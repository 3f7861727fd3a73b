// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

namespace torsio {

/// The one deadline that a rater is told for every recorded case, UTC in microseconds: the latest of theirs.
/// Deadlines of their own would sort the cases by occasion, and one that moved with each submitted sheet
/// would tell the occasion of what is left.
class BlindedDue {
 public:
  /// Takes in the deadline of a recorded case, submitted or not; empty where it has none.
  void add(std::optional<std::int64_t> due_us) {
    if (due_us) {
      latest_us_ = std::max(latest_us_.value_or(*due_us), *due_us);
    }
  }
  /// Returns the deadline to tell; empty where no case has one.
  [[nodiscard]] std::optional<std::int64_t> told() const noexcept { return latest_us_; }

 private:
  std::optional<std::int64_t> latest_us_;
};

}  // namespace torsio
