// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace torsio {

/// Version of all formulas by which a recording is measured: metrics, what a twist is, what is on target. It
/// stands beside every stored value. Count it up whenever a number changes: values of an older version are
/// not read, the recording is measured anew.
inline constexpr std::int64_t kMetricsVersion = 2;

enum class Direction { kLowerIsBetter, kHigherIsBetter, kNeither };

/// What a measured quantity means; shown wherever its number is shown.
struct MetricCard {
  std::string_view id;  ///< "twist.overshoot"
  std::string_view name;
  std::string_view meaning;  ///< one sentence for a physician
  std::string_view formula;
  std::string_view unit;
  std::string_view window;  ///< which part of the trial
  Direction direction = Direction::kNeither;
  std::int64_t version = kMetricsVersion;
};

[[nodiscard]] std::span<const MetricCard> metricCards();
/// The card of an id; our own bug when there is none.
[[nodiscard]] const MetricCard& metricCard(std::string_view id);

}  // namespace torsio
