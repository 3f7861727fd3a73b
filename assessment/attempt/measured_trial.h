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

/// By what a run is judged: everything that its exercise asks for.
struct AttemptRules {
  double tolerance_rad = kDefaultTolerance_rad;  ///< > 0
  std::optional<double> forceLimit_N{};
  std::optional<double> torqueLimit_Nm{};
  double hold_s = 0.0;           ///< on target before letting go, asked for to pass; changes no measure
  std::int64_t leastTwists = 1;  ///< completed, asked for to pass; changes no measure
  std::optional<DetorsionRules> detorsion{};  ///< of a recording that comesTwisted
  std::vector<MasteryRule> mastery{};         ///< of the exercise, asked for to pass; change no measure
  friend bool operator==(const AttemptRules&, const AttemptRules&) = default;
};

/// The axis that a grasped section turns about.
struct GraspAxis {
  Vec3 point_m;
  Vec3 direction;  ///< unit
};

/// What the organ adds to a recording when its scene is at hand; without a function the metrics that need it
/// stay undefined.
struct OrganKnowledge {
  /// Largest shear stress of the surface, Pa, as the organ lies in a sample of the recording.
  std::function<double(const Sample& sample)> peakShear_Pa{};
  std::function<GraspAxis(double arc_m)> axisAt{};
  std::optional<double> shearLimit_Pa{};
};

/// One twist with its metrics, or why it cannot be measured. What was not completed is measured as well, but
/// counts nowhere.
struct MeasuredTwist {
  RecordedTwist twist{};
  double start_s = 0.0;   ///< grip, since the first sample of the recording
  double letGo_s = 0.0;   ///< last sample of the grip, since the first sample of the recording
  double held_s = 0.0;    ///< on target until it was let go
  bool onTarget = false;  ///< completed, within the tolerance of the target in force
  Outcome<TrialMetrics> metrics = Outcome<TrialMetrics>::undefined(Text::tr("not measured"));
};

/// An untwisting with its metrics, or why it cannot be measured.
struct MeasuredDetorsion {
  Outcome<DetorsionMetrics> metrics = Outcome<DetorsionMetrics>::undefined(Text::tr("not measured"));
  /// Of the whole recording: time, path and rest of the hand.
  Outcome<TrialMetrics> whole = Outcome<TrialMetrics>::undefined(Text::tr("not measured"));
  std::vector<Outcome<TrialMetrics>> grips{};  ///< one a grip: forces and torques; no metric of twisting
};

/// What one recording comes to, twist by twist; or the untwisting of an organ that came twisted.
struct MeasuredTrial {
  bool deviceClock = true;                       ///< SampleTimes::deviceClock
  std::int64_t duration_us = 0;                  ///< recordedDuration_us
  std::vector<MeasuredTwist> twists{};           ///< all of them, in their order; none of an untwisting
  std::optional<MeasuredDetorsion> detorsion{};  ///< empty: an exercise of twisting
  RecordedLoads loads{};                         ///< over the whole recording
  /// Twists, or 1 of an untwisting, that could not be measured because samples are missing for more than
  /// 20 ms.
  std::int64_t torn = 0;

  /// Duration in seconds.
  [[nodiscard]] double duration_s() const noexcept;
  /// The twists that count.
  [[nodiscard]] std::vector<const MeasuredTwist*> completed() const;
  /// Number of twists that were cut off by the end of the recording, a fault or missing samples.
  [[nodiscard]] std::int64_t unfinished() const noexcept;
  /// Values of one quantity over the completed twists in which it is defined. Of an untwisting: its own
  /// metrics and those of the whole recording have one value or none, loads one a grip, metrics of twisting
  /// none. Peaks of force and torque are those since the grip before was let go; those of the recording are
  /// `loads`.
  [[nodiscard]] std::vector<double> valuesOf(Quantity quantity) const;
};

/// Turns a recording into the trace that the metrics read: angle, target in force, force on the tissue and
/// as sent to the device, torque and tip of every sample. The samples of a stay on target until letting go
/// count as hold when it lasted at least kShortestHold_s.
[[nodiscard]] TrialTrace trialTrace(const TrialHeader& header, std::span<const Sample> samples,
                                    double tolerance_rad, const OrganKnowledge& organ = {});

/// Measures every twist of a recording; of one that comesTwisted its untwisting instead. Fewer than two
/// samples give no twists. A gap of more than 20 ms leaves the metrics of the twist that holds it undefined.
/// Slow: seconds for an hour.
[[nodiscard]] MeasuredTrial measureTwists(const TrialHeader& header, std::span<const Sample> samples,
                                          const AttemptRules& rules, const OrganKnowledge& organ = {});

/// Measures a recording as one stretch, from its first sample to its last, without metrics of twisting if it
/// comesTwisted; undefined with fewer than two
/// samples or a gap of more than 20 ms.
[[nodiscard]] Outcome<TrialMetrics> measureWhole(const TrialHeader& header, std::span<const Sample> samples,
                                                 const AttemptRules& rules, const OrganKnowledge& organ = {});

}  // namespace torsio
