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

/// What a sample of a trace belongs to.
enum class TracePhase : std::uint8_t { kFree, kContact, kTwisting, kHolding, kReleasing };

/// One trial between its task start and task end, one entry a sample. Lists that do not apply stay empty; the
/// others have the length of `times_us`. Handedness and two-handed measures do not exist: there is one
/// stylus.
struct TrialTrace {
  std::vector<std::int64_t> times_us;
  std::vector<TracePhase> phase;
  std::vector<Vec3> tip_m;
  std::vector<double> angle_rad;  ///< unwrapped twist
  std::vector<double>
      targetAngle_rad;                ///< in force at the sample; empty: TrialTargets::target_rad throughout
  std::vector<double> force_N;        ///< magnitude on the tissue
  std::vector<double> deviceForce_N;  ///< magnitude that was sent to the device
  std::vector<double> torque_Nm;      ///< signed
  std::vector<double> patchShear_Pa;
};

/// Which error still counts as on target where neither a module nor a pattern says another: two degrees.
inline constexpr double kDefaultTolerance_rad = radians(2.0);

/// Parts of the exercise version that the judgement uses.
struct TrialTargets {
  double target_rad = 0.0;  ///< 0: no end angle. Not read when the trace has targets of its own
  double tolerance_rad = kDefaultTolerance_rad;
  std::optional<double> forceLimit_N;
  std::optional<double> torqueLimit_Nm;
  std::optional<double> shearLimit_Pa;
  std::optional<Vec3> axisPoint_m;
  Vec3 axis{0.0, 0.0, 1.0};
};

/// What was measured, or why it could not be.
class MetricValues {
 public:
  /// Holds the quantities of these scopes, all of them undefined.
  explicit MetricValues(std::initializer_list<QuantityScope> scopes);
  /// The value of a quantity that it holds; another is a bug of Torsio.
  [[nodiscard]] const Outcome<double>& at(Quantity quantity) const;
  void set(Quantity quantity, Outcome<double> value);
  [[nodiscard]] std::optional<double> valueOf(Quantity quantity) const;
  /// Gives this reason to everything that has no value.
  void explainMissing(const Text& reason);
  [[nodiscard]] const std::map<Quantity, Outcome<double>>& all() const noexcept { return values_; }

 private:
  std::map<Quantity, Outcome<double>> values_;
};

/// Quantities of kHand and kGrip of a stretch of a recording.
struct TrialMetrics : MetricValues {
  TrialMetrics() : MetricValues({QuantityScope::kHand, QuantityScope::kGrip}) {}

  std::size_t lostSamples = 0;
  double poseCutoff_Hz = 0.0;
  double forceCutoff_Hz = 0.0;
};

/// All metrics of one trial, in the order of preparation: uniform time, filter, derive, measure. Throws
/// Error{kBadData} when lists differ in length, values are not finite, time stamps do not rise, or a gap
/// exceeds 20 ms.
[[nodiscard]] TrialMetrics measureTrial(const TrialTrace& trace, const TrialTargets& targets);

}  // namespace torsio
