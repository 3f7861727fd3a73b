// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "assessment/catalogue/quantity.h"

namespace torsio {

/// "The quantity reaches the threshold in so many attempts in a row."
struct MasteryRule {
  std::optional<Quantity> quantity{};  ///< empty: this version of Torsio does not measure it
  bool atMost = false;                 ///< the value must be at most the threshold; false: at least
  double threshold = 0.0;
  std::int64_t consecutive = 1;
  /// "Overshoot: at most 5.0°".
  [[nodiscard]] Text text() const;
  friend bool operator==(const MasteryRule&, const MasteryRule&) = default;
};

/// How far somebody has come with one rule.
struct MasteryProgress {
  std::int64_t streak = 0;  ///< attempts in a row up to the last one
  bool met = false;         ///< so many in a row were reached once: mastery is not lost again
  std::optional<double> last{};
};

/// Whether `value` satisfies the rule once.
[[nodiscard]] bool reaches(const MasteryRule& rule, double value) noexcept;

/// Follows one rule over the values of the attempts that count, oldest first. A value that is not defined
/// breaks the row.
[[nodiscard]] MasteryProgress masteryProgress(const MasteryRule& rule,
                                              std::span<const std::optional<double>> values);

/// Returns how many of `twists` completed twists must be released on target for a run to pass: four in five
/// of them, or of the `least` number that the exercise asks for, and one at least.
[[nodiscard]] std::int64_t wantedOnTarget(std::int64_t twists, std::int64_t least = 1) noexcept;

}  // namespace torsio
