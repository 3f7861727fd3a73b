// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/metrics/trial_metrics.h"
#include "sim/base/live_types.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"

namespace torsio {

/// A turn of less than this was a touch, not an attempt.
inline constexpr double kSmallestMeasuredTwist_rad = 0.0349065850398866;  // 2 degrees
/// The angle has been held when it stayed near the target for at least this long until it was let go.
inline constexpr double kShortestHold_s = 0.2;

struct TrialMeasurement {
  double tolerance_rad = TrialTargets{}.tolerance_rad;
  std::optional<double> forceLimit_N;
  std::optional<double> torqueLimit_Nm;
  std::optional<double> shearLimit_Pa;  ///< needs the scene
  bool wholeTrial = true;               ///< false: its twists only; saves most of the time for a long trial
};

/// One twist from grip to the end of the elastic return, or why it cannot be measured.
struct MeasuredTwist {
  std::size_t firstSample = 0;
  std::size_t samples = 0;
  double start_s = 0.0;  ///< since the first sample of the trial
  double target_rad = 0.0;
  double releasedAt_rad = 0.0;
  Outcome<TrialMetrics> metrics = Outcome<TrialMetrics>::undefined("not measured");
};

/// Metrics of a whole trial and of every twist in it.
struct MeasuredTrial {
  bool deviceClock = true;  ///< time stamps of the device; false: ticks, because the stamps do not rise
  double duration_s = 0.0;
  Outcome<TrialMetrics> whole = Outcome<TrialMetrics>::undefined("not measured");
  std::vector<MeasuredTwist> twists;
};

/// A recorded trial as the trace that the metrics read: angle, force as sent to the device, torque and tip of
/// every sample. The samples from the last entry into target +- tolerance until letting go count as hold.
/// With a scene also the largest shear stress of the organ's surface.
[[nodiscard]] TrialTrace trialTrace(const TrialHeader& header, std::span<const Sample> samples,
                                    double tolerance_rad, const Scene* scene = nullptr);

/// `samples`: the decoded samples of the trial, at least two. `scene`: that of the trial, for shear stress
/// and the wander about the axis; may be null. A gap of more than 20 ms leaves the stretch that holds it
/// undefined.
[[nodiscard]] MeasuredTrial measureRecordedTrial(const TrialHeader& header, std::span<const Sample> samples,
                                                 const TrialMeasurement& options,
                                                 const Scene* scene = nullptr);

}  // namespace torsio
