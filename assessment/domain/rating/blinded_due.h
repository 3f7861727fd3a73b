// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

namespace torsio {

/// The one deadline shown to a rater for all recorded cases, UTC in microseconds: the latest of them.
/// Individual deadlines would sort the cases by occasion, and a deadline that moved with each submitted sheet
/// would reveal the occasion of the remaining ones.
class BlindedDue {
 public:
  /// Adds the deadline of a recorded case, submitted or not; empty if it has none.
  void add(std::optional<std::int64_t> due_us) {
    if (due_us) {
      latest_us_ = std::max(latest_us_.value_or(*due_us), *due_us);
    }
  }
  /// Returns the deadline to show; empty if no case has one.
  [[nodiscard]] std::optional<std::int64_t> latest() const noexcept { return latest_us_; }

 private:
  std::optional<std::int64_t> latest_us_;
};

}  // namespace torsio
