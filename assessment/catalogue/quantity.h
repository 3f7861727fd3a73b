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

/// Version of all formulas by which a recording is measured: quantities, what a twist is, what is on target.
/// It is stored beside every value. Count it up whenever a number changes: values of an older version are not
/// read, the recording is measured again.
inline constexpr std::int64_t kMetricsVersion = 7;

/// What is measured of a run. The order is that of all lists and tables.
enum class Quantity : std::uint8_t {
  kOnTarget,
  kTargetsReached,
  kCompletedTwists,
  kShortestHold,
  kTornTwists,
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

/// What kind of number a quantity is.
enum class QuantityKind : std::uint8_t {
  kMeasure,
  kCount,   ///< whole numbers, also on an axis
  kAnswer,  ///< 1 is yes, 0 is no; it has neither scale nor learning curve
};

/// What a quantity is measured of.
enum class QuantityScope : std::uint8_t {
  kRun,         ///< the run as a whole
  kHand,        ///< each twist; of an untwisting or of a foreign recording the whole recording
  kGrip,        ///< each twist, or each grip of an untwisting
  kUntwisting,  ///< the untwisting of an organ that came twisted; there the quantities of twisting are
                ///< missing
};

/// How the values of several twists become one of the run.
enum class OverTwists : std::uint8_t { kMedian, kSum, kLargest };

/// Where in a twist to look for a value.
enum class QuantityMoment : std::uint8_t {
  kWholeTwist,
  kPeakForce,     ///< where the force on the tissue is largest
  kFarthestTurn,  ///< where the angle is farthest in the direction of the target
  kFromGrip,      ///< as many seconds from the grip on as the value says
  kHold,          ///< while the angle is held
  kRelease,       ///< when the organ is let go
};

/// How a value is shown.
struct ShownUnit {
  std::string_view unit{};  ///< "\u00b0", "mm"; empty: a mere number
  double scale = 1.0;       ///< a stored value times this is the shown one
  int decimals = 0;
};

/// How a hand is praised or corrected by a quantity (assessment/attempt/merit.h).
struct MeritWeight {
  double weight = 0.0;  ///< 0: not at all; above 1 for a quantity that is a logarithm and moves little
  double floor = 0.0;   ///< a difference that nobody can see, SI
};

/// What holds for some quantities only.
struct QuantityTraits {
  QuantityKind kind = QuantityKind::kMeasure;
  OverTwists over = OverTwists::kMedian;
  bool asked = false;    ///< whether a curriculum may ask for it
  double least = 0.0;    ///< the smallest value that it can have, SI; thresholds begin there
  bool inTrend = false;  ///< whether a trend offers it even where no curriculum asks for it
  MeritWeight merit{};
  Phrase advice{};  ///< to a trainee whose weakness it is; empty: none
  QuantityMoment moment = QuantityMoment::kWholeTwist;
  Phrase missing = Text::tr("not measured");  ///< stands in place of a value that a run does not have
};

/// One row of the catalogue: everything that is known of a quantity whatever its value.
struct QuantityRow {
  Quantity quantity{};
  std::string_view id{};  ///< "twist.overshoot": in the database and in files; never changes
  Phrase name{};
  Phrase meaning{};  ///< one sentence for a physician
  Phrase formula{};
  std::string_view unit{};  ///< of a stored value: SI, "1" or "count"
  ShownUnit shown{};
  Direction direction = Direction::kNeither;
  Phrase window{};  ///< which part of a run
  QuantityScope scope = QuantityScope::kGrip;
  QuantityTraits traits{};
  std::int64_t version = kMetricsVersion;
};

/// All rows, in the order of Quantity.
[[nodiscard]] std::span<const QuantityRow> quantityRows() noexcept;
[[nodiscard]] const QuantityRow& rowOf(Quantity quantity);
/// Returns the quantity of a stored id; empty: this version of Torsio measures nothing of that name.
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

/// Values by quantity, SI; what is not defined is missing.
using QuantityValues = std::map<Quantity, double>;
[[nodiscard]] inline std::optional<double> valueIn(const QuantityValues& values, Quantity quantity) {
  const auto found = values.find(quantity);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

/// Returns the shown number of a stored value without its unit: "12.4", "\u22120.8". `more`: further
/// decimals.
[[nodiscard]] std::string shownNumber(Quantity quantity, double value, int more = 0);
/// "12.4 s", "3.1\u00b0", "62 %"; "yes" and "no" of an answer.
[[nodiscard]] Text shownValue(Quantity quantity, double value, int more = 0);
/// The value, or what stands in its place.
[[nodiscard]] Text shownValue(Quantity quantity, const std::optional<double>& value);
/// "Overshoot (\u00b0)"; the bare name of a quantity without a shown unit.
[[nodiscard]] Text titleWithUnit(Quantity quantity);

}  // namespace torsio
