// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "assessment/catalogue/quantity.h"

namespace torsio {

/// Rule "the quantity reaches the threshold in this many successive attempts".
struct MasteryRule {
  std::optional<Quantity> quantity{};  ///< empty: unknown to this version
  bool atMost = false;                 ///< the value must be at most the threshold; otherwise at least
  double threshold = 0.0;
  std::int64_t consecutive = 1;
  /// Returns "Overshoot: at most 5.0°".
  [[nodiscard]] Text text() const;
  friend bool operator==(const MasteryRule&, const MasteryRule&) = default;
};

/// Progress towards a rule.
struct MasteryProgress {
  std::int64_t streak = 0;  ///< current number of successive attempts that satisfy it
  bool met = false;         ///< the required number was reached once: mastery is permanent
  std::optional<double> last{};
};

/// Returns whether a single `value` satisfies the rule.
[[nodiscard]] bool reaches(const MasteryRule& rule, double value) noexcept;

/// Evaluates a rule over the values of attempts that count, oldest first. An undefined value ends the streak.
[[nodiscard]] MasteryProgress masteryProgress(const MasteryRule& rule,
                                              std::span<const std::optional<double>> values);

/// Returns how many of `twists` completed twists must be released on target to pass: four in five of them, or
/// of the exercise's `least` number, and at least one.
[[nodiscard]] std::int64_t wantedOnTarget(std::int64_t twists, std::int64_t least = 1) noexcept;

}  // namespace torsio
