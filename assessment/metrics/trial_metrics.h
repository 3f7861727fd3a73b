// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <vector>

#include "assessment/catalogue/quantity.h"
#include "assessment/statistics/values.h"
#include "sim/core/angle.h"
#include "sim/core/vec3.h"

namespace torsio {

/// Phase of a sample.
enum class TracePhase : std::uint8_t { kFree, kContact, kTwisting, kHolding, kReleasing };

/// One trial between its task start and end, one entry per sample. Lists that do not apply are empty; the
/// others have the length of `times_us`. There is one stylus, so no handedness or two-handed measures.
struct TrialTrace {
  std::vector<std::int64_t> times_us;
  std::vector<TracePhase> phase;
  std::vector<Vec3> tip_m;
  std::vector<double> angle_rad;        ///< unwrapped twist
  std::vector<double> targetAngle_rad;  ///< at each sample; empty: always TrialTargets::target_rad
  std::vector<double> force_N;          ///< magnitude on the tissue
  std::vector<double> deviceForce_N;    ///< magnitude sent to the device
  std::vector<double> torque_Nm;        ///< signed
  std::vector<double> patchShear_Pa;
};

/// Default tolerance, if neither module nor pattern has one: two degrees.
inline constexpr double kDefaultTolerance_rad = radians(2.0);

/// The exercise's parameters used by the metrics.
struct TrialTargets {
  double target_rad = 0.0;  ///< 0: no target angle. Ignored if the trace has its own targets
  double tolerance_rad = kDefaultTolerance_rad;
  std::optional<double> forceLimit_N;
  std::optional<double> torqueLimit_Nm;
  std::optional<double> shearLimit_Pa;
  std::optional<Vec3> axisPoint_m;
  Vec3 axis{0.0, 0.0, 1.0};
};

/// Measured values, or why they are undefined.
class MetricValues {
 public:
  /// Contains the quantities of these scopes, all undefined.
  explicit MetricValues(std::initializer_list<QuantityScope> scopes);
  /// Returns the value of a quantity, which must be included.
  [[nodiscard]] const Outcome<double>& at(Quantity quantity) const;
  void set(Quantity quantity, Outcome<double> value);
  [[nodiscard]] std::optional<double> valueOf(Quantity quantity) const;
  /// Sets the reason of all undefined quantities.
  void explainMissing(const Text& reason);
  [[nodiscard]] const std::map<Quantity, Outcome<double>>& all() const noexcept { return values_; }

 private:
  std::map<Quantity, Outcome<double>> values_;
};

/// Quantities of kHand and kGrip for a part of a recording.
struct TrialMetrics : MetricValues {
  TrialMetrics() : MetricValues({QuantityScope::kHand, QuantityScope::kGrip}) {}

  std::size_t lostSamples = 0;
  double poseCutoff_Hz = 0.0;
  double forceCutoff_Hz = 0.0;
};

/// Computes all metrics of a trial: resample, filter, derive, measure. Throws Error{kBadData} if lists differ
/// in length, values are not finite, time stamps do not increase, or a gap exceeds 20 ms.
[[nodiscard]] TrialMetrics measureTrial(const TrialTrace& trace, const TrialTargets& targets);

}  // namespace torsio
