// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "sim/core/text.h"

namespace torsio {

/// Version of all formulas for measuring a recording: quantities, definition of a twist, of on target. Stored
/// with every value. Increment it whenever a number changes: values of older versions are ignored and
/// recordings are measured again.
inline constexpr std::int64_t kMetricsVersion = 9;

/// Measured quantities of a run, in the order of all lists and tables.
enum class Quantity : std::uint8_t {
  kOnTarget,
  kTargetsReached,
  kCompletedTwists,
  kShortestHold,
  kTornTwists,
  kTimesUnseen,
  kUnseen,
  kUnseenShare,
  kTime,
  kTipPath,
  kAngularPath,
  kEconomy,
  kIdleTime,
  kSparc,
  kLdlj,
  kLdljUnsigned,
  kSubMovements,
  kOvershoot,
  kExcursions,
  kTimeToTarget,
  kSettling,
  kTrackingRms,
  kTrackingMean,
  kTrackingBias,
  kLag,
  kTrackingWithoutLag,
  kHoldSteadiness,
  kAxisWander,
  kMeanForce,
  kPeakForce,
  kDeviceForce,
  kHighForce,
  kForceImpulse,
  kForceRate,
  kForceViolations,
  kForceViolationTime,
  kForceExcess,
  kMeanTorque,
  kPeakTorque,
  kTorqueViolations,
  kReleaseRate,
  kWorkDelivered,
  kWorkLoop,
  kShearOverLimit,
  kUntwisted,
  kTimeToFlow,
  kDose,
  kDoseAtFlow,
  kResidual,
  kRelapse,
  kFirstDirection,
  kWrongWay,
  kRegrips,
  kLeastRegrips,
  kSlipBack,
  kPeakJaw,
  kPeakShear,
  kOverloadTime,
  kLeastPatency,
  kVentedFirst,
  kLongestStage,
  kInStages,
  kEnd,
};

enum class Direction : std::uint8_t { kLowerIsBetter, kHigherIsBetter, kNeither };

/// Type of a quantity's values.
enum class QuantityKind : std::uint8_t {
  kMeasure,
  kCount,   ///< whole numbers, on axes too
  kAnswer,  ///< 1: yes, 0: no; without scale or learning curve
};

/// What a quantity is measured on.
enum class QuantityScope : std::uint8_t {
  kRun,         ///< the run as a whole
  kHand,        ///< each twist; for an untwisting or a foreign recording, the whole recording
  kGrip,        ///< each twist, or each grip of an untwisting
  kUntwisting,  ///< an untwisting, which has no quantities of twists
};

/// How the values of several twists are combined for the run.
enum class OverTwists : std::uint8_t { kMedian, kSum, kLargest };

/// Where to look for a value in a twist.
enum class QuantityMoment : std::uint8_t {
  kWholeTwist,
  kPeakForce,     ///< at the maximum force on the tissue
  kPeakTorque,    ///< at the maximum torque on the tissue
  kFarthestTurn,  ///< at the maximum angle in the target's direction
  kFromGrip,      ///< the value is the time in seconds since the grip
  kHold,          ///< while the angle is held
  kRelease,       ///< at the release
};

/// How a value is displayed.
struct ShownUnit {
  std::string_view unit{};  ///< "\u00b0", "mm"; empty: dimensionless
  double scale = 1.0;       ///< displayed value / stored value
  int decimals = 0;
};

/// How a quantity counts in strengths and weaknesses (assessment/attempt/merit.h).
struct MeritWeight {
  double weight = 0.0;  ///< 0: not at all; above 1 for a quantity that is a logarithm and varies little
  double floor = 0.0;   ///< imperceptible difference, SI
};

/// Properties of some quantities only.
struct QuantityTraits {
  QuantityKind kind = QuantityKind::kMeasure;
  OverTwists over = OverTwists::kMedian;
  bool asked = false;    ///< usable in rules of a curriculum
  double least = 0.0;    ///< minimum possible value, SI; lower end for thresholds
  bool inTrend = false;  ///< offered in trends even if no rule uses it
  MeritWeight merit{};
  Phrase advice{};  ///< for a trainee with this weakness; a quantity that a rule may ask for has one
  QuantityMoment moment = QuantityMoment::kWholeTwist;
  Phrase missing = Text::tr("not measured");  ///< shown if a run has no value
};

/// A row of the catalogue: everything known of a quantity besides its value.
struct QuantityRow {
  Quantity quantity{};
  std::string_view id{};  ///< "twist.overshoot", used in the database and files; never changes
  Phrase name{};
  Phrase meaning{};  ///< one sentence for a physician
  Phrase formula{};
  std::string_view unit{};  ///< of stored values: SI, "1" or "count"
  ShownUnit shown{};
  Direction direction = Direction::kNeither;
  Phrase window{};  ///< part of a run that it is measured in
  QuantityScope scope = QuantityScope::kGrip;
  QuantityTraits traits{};
  std::int64_t version = kMetricsVersion;
};

/// Returns all rows, in the order of Quantity.
[[nodiscard]] std::span<const QuantityRow> quantityRows() noexcept;
[[nodiscard]] const QuantityRow& rowOf(Quantity quantity);
/// Returns the quantity of a stored id; empty if unknown to this version.
[[nodiscard]] std::optional<Quantity> quantityOf(std::string_view id) noexcept;

[[nodiscard]] inline std::string idOf(Quantity quantity) {
  return std::string(rowOf(quantity).id);
}
[[nodiscard]] inline bool isAnswer(Quantity quantity) {
  return rowOf(quantity).traits.kind == QuantityKind::kAnswer;
}
[[nodiscard]] inline bool isOfUntwisting(Quantity quantity) {
  return rowOf(quantity).scope == QuantityScope::kUntwisting;
}

/// Values by quantity, SI; undefined ones are missing.
using QuantityValues = std::map<Quantity, double>;
[[nodiscard]] inline std::optional<double> valueIn(const QuantityValues& values, Quantity quantity) {
  const auto found = values.find(quantity);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

/// Formats a stored value for display without its unit: "12.4", "\u22120.8". `more`: additional decimals.
[[nodiscard]] std::string shownNumber(Quantity quantity, double value, int more = 0);
/// Formats "12.4 s", "3.1\u00b0", "62 %"; "yes" and "no" for an answer.
[[nodiscard]] Text shownValue(Quantity quantity, double value, int more = 0);
/// Formats the value, or the text for a missing one.
[[nodiscard]] Text shownValue(Quantity quantity, const std::optional<double>& value);
/// Returns "Overshoot (\u00b0)"; only the name if the quantity has no displayed unit.
[[nodiscard]] Text titleWithUnit(Quantity quantity);

}  // namespace torsio
