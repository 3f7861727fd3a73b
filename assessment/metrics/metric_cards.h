// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "assessment/catalogue/quantity.h"

namespace torsio {

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

/// Lists the cards of all metrics.
[[nodiscard]] std::span<const MetricCard> metricCards();
/// Returns the card of an id; a missing one is a bug of Torsio.
[[nodiscard]] const MetricCard& metricCard(std::string_view id);

/// Share of the twists that were let go within the tolerance of the target, 0..1. A metric of a whole
/// attempt, without a card.
inline constexpr const char* kOnTargetMetric = "twist.on_target";
/// Number of the twists that were let go within the tolerance of the target. Without a card, too.
inline constexpr const char* kTargetsReachedMetric = "twist.targets_reached";

/// Largest force and torque on the tissue: what limits are held against.
inline constexpr const char* kPeakForceMetric = "force.peak";
inline constexpr const char* kPeakTorqueMetric = "torque.peak";
/// Largest force that the device was told to give; shown beside kPeakForceMetric, never judged.
inline constexpr const char* kDeviceForceMetric = "force.device_peak";

/// With this the ids of the metrics of an untwisting begin. They exist for recordings of an organ that came
/// twisted, and there the metrics of twisting do not.
inline constexpr std::string_view kDetorsionMetrics = "detorse.";
/// Whether the organ was undone and stayed so hands off: 1 or 0. By it an untwisting passes where no rule
/// says otherwise.
inline constexpr const char* kDetorsionDoneMetric = "detorse.done";
/// Whether an id is that of a metric of an untwisting.
[[nodiscard]] constexpr bool isDetorsionMetric(std::string_view id) noexcept {
  return id.substr(0, kDetorsionMetrics.size()) == kDetorsionMetrics;
}
/// Whether a metric answers a question: 1 is yes, 0 is no. It has neither scale nor learning curve.
[[nodiscard]] constexpr bool isAnswerMetric(std::string_view id) noexcept {
  return id == kDetorsionDoneMetric || id == "detorse.relapse" || id == "detorse.first_direction" ||
         id == "detorse.vented_first" || id == "detorse.in_stages";
}

/// Whether a metric counts something: whole numbers, also on an axis.
[[nodiscard]] constexpr bool isCountMetric(std::string_view id) noexcept {
  return id == "twist.peaks" || id == "twist.excursions" || id == "force.violations" ||
         id == "torque.violations" || id == "detorse.regrips" || id == "detorse.least_regrips";
}

/// Name of a metric in English: of its card, or of the two above; the id itself when there is none.
[[nodiscard]] std::string metricTitle(const std::string& metric);

}  // namespace torsio
