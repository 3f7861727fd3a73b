// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "assessment/attempt/mastery.h"
#include "assessment/attempt/recorded_loads.h"
#include "assessment/attempt/recorded_twists.h"
#include "assessment/metrics/detorsion.h"
#include "assessment/metrics/trial_metrics.h"
#include "sim/core/live_types.h"
#include "sim/core/vec3.h"
#include "sim/record/trial.h"

namespace torsio {

/// Rules for judging a run: all requirements of its exercise.
struct AttemptRules {
  double tolerance_rad = kDefaultTolerance_rad;  ///< > 0
  std::optional<double> forceLimit_N{};
  std::optional<double> torqueLimit_Nm{};
  double hold_s = 0.0;           ///< required time on target before release; affects passing, not measures
  std::int64_t leastTwists = 1;  ///< required completed twists; affects passing, not measures
  std::optional<DetorsionRules> detorsion{};  ///< for a recording with comesTwisted()
  std::vector<MasteryRule> mastery{};         ///< required to pass; they affect no measure
  friend bool operator==(const AttemptRules&, const AttemptRules&) = default;
};

/// Axis of rotation of a grasped section.
struct GraspAxis {
  Vec3 point_m;
  Vec3 direction;  ///< unit vector
};

/// Data from the scene's organ, if available; metrics that need a missing function are undefined.
struct OrganKnowledge {
  /// Returns the maximum shear stress of the surface, Pa, for a sample's state.
  std::function<double(const Sample& sample)> peakShear_Pa{};
  std::function<GraspAxis(double arc_m)> axisAt{};
  std::optional<double> shearLimit_Pa{};
};

/// A twist with its metrics, or why it cannot be measured. Twists not completed are measured but never
/// counted.
struct MeasuredTwist {
  RecordedTwist twist{};
  double start_s = 0.0;   ///< of the grip, since the first sample
  double letGo_s = 0.0;   ///< last sample of the grip, since the first sample
  double held_s = 0.0;    ///< on target until the release
  bool onTarget = false;  ///< completed, within the tolerance of its target
  Outcome<TrialMetrics> metrics = Outcome<TrialMetrics>::undefined(Text::tr("not measured"));
};

/// An untwisting with its metrics, or why it cannot be measured.
struct MeasuredDetorsion {
  Outcome<DetorsionMetrics> metrics = Outcome<DetorsionMetrics>::undefined(Text::tr("not measured"));
  /// Of the whole recording: time, path and idle time of the hand.
  Outcome<TrialMetrics> whole = Outcome<TrialMetrics>::undefined(Text::tr("not measured"));
  std::vector<Outcome<TrialMetrics>> grips{};  ///< one per grip: forces and torques, no metrics of twists
};

/// Measures of a recording by twist, or of an untwisting.
struct MeasuredTrial {
  bool deviceClock = true;                       ///< SampleTimes::deviceClock
  std::int64_t duration_us = 0;                  ///< recordedDuration_us
  std::vector<MeasuredTwist> twists{};           ///< all, in order; none for an untwisting
  std::optional<MeasuredDetorsion> detorsion{};  ///< empty: an exercise with twists
  RecordedLoads loads{};                         ///< over the whole recording
  /// Number of twists, or 1 for an untwisting, not measurable because more than 20 ms of samples are missing.
  std::int64_t torn = 0;

  /// Duration in seconds.
  [[nodiscard]] double duration_s() const noexcept;
  /// Returns the completed twists.
  [[nodiscard]] std::vector<const MeasuredTwist*> completed() const;
  /// Counts the twists cut off by the end of the recording, a fault or missing samples.
  [[nodiscard]] std::int64_t unfinished() const noexcept;
  /// Returns a quantity's values over the completed twists that define it. For an untwisting: at most one
  /// value of its own quantities and those of the whole recording, one per grip for loads, none for
  /// quantities of twists. Peaks of force and torque are those since the previous release; `loads` has those
  /// of the recording.
  [[nodiscard]] std::vector<double> valuesOf(Quantity quantity) const;
};

/// Converts a recording to the trace for the metrics: angle, target, force on the tissue and sent to the
/// device, torque and tip of every sample. Samples on target before a release count as holding if they last
/// at least kShortestHold_s.
[[nodiscard]] TrialTrace trialTrace(const TrialHeader& header, std::span<const Sample> samples,
                                    double tolerance_rad, const OrganKnowledge& organ = {});

/// Measures every twist of a recording; if comesTwisted(), its untwisting instead. Fewer than two samples
/// give no twists. A gap of more than 20 ms makes its twist's metrics undefined. Slow: seconds for an hour.
[[nodiscard]] MeasuredTrial measureTwists(const TrialHeader& header, std::span<const Sample> samples,
                                          const AttemptRules& rules, const OrganKnowledge& organ = {});

/// Measures a recording as a whole, without metrics of twists if comesTwisted(); undefined with fewer than
/// two samples or a gap of more than 20 ms.
[[nodiscard]] Outcome<TrialMetrics> measureWhole(const TrialHeader& header, std::span<const Sample> samples,
                                                 const AttemptRules& rules, const OrganKnowledge& organ = {});

}  // namespace torsio
