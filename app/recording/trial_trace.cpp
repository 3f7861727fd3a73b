// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/trial_trace.h"

#include <algorithm>
#include <cmath>

#include "assessment/metrics/signal.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

/// Samples [first, end) of one twist; [first, letGo) is the turning.
struct Stretch {
  std::size_t first = 0;
  std::size_t letGo = 0;
  std::size_t end = 0;
};

std::vector<Stretch> twistsIn(std::span<const Sample> samples) {
  std::vector<Stretch> twists;
  const auto in = [&](std::size_t i, ExercisePhase phase) {
    return i < samples.size() && samples[i].phase == phase;
  };
  for (std::size_t i = 0; i < samples.size();) {
    if (!in(i, ExercisePhase::kTwisting)) {
      ++i;
      continue;
    }
    Stretch twist{i, i, i};
    while (in(i, ExercisePhase::kTwisting)) ++i;
    twist.letGo = i;
    while (in(i, ExercisePhase::kReleased)) ++i;
    twist.end = i;
    const double last_rad = samples[twist.letGo - 1].response.angle_rad;
    if (std::abs(last_rad) >= kSmallestMeasuredTwist_rad) twists.push_back(twist);
  }
  return twists;
}

/// The target in force at every sample: the header's until a command changes it.
std::vector<double> targetsOf(const TrialHeader& header, std::span<const Sample> samples) {
  std::vector<double> targets;
  targets.reserve(samples.size());
  double target_rad = header.targetAngle_rad;
  for (const Sample& sample : samples) {
    if (sample.command.kind == ServoCommand::Kind::kSetTarget) target_rad = sample.command.value;
    targets.push_back(target_rad);
  }
  return targets;
}

bool stampsRise(std::span<const Sample> samples) {
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (samples[i].device.time_us <= samples[i - 1].device.time_us) return false;
  return true;
}

TracePhase tracePhase(ExercisePhase phase) {
  switch (phase) {
    case ExercisePhase::kTracking:
      return TracePhase::kFree;
    case ExercisePhase::kContact:
      return TracePhase::kContact;
    case ExercisePhase::kTwisting:
      return TracePhase::kTwisting;
    case ExercisePhase::kReleased:
      return TracePhase::kReleasing;
  }
  return TracePhase::kFree;
}

void markHolds(TrialTrace& trace, const std::vector<Stretch>& twists, const std::vector<double>& targets,
               double tolerance_rad) {
  for (const Stretch& twist : twists) {
    std::size_t first = twist.letGo;
    while (first > twist.first &&
           std::abs(trace.angle_rad[first - 1] - targets[twist.letGo - 1]) <= tolerance_rad)
      --first;
    if (first == twist.letGo) continue;
    const double held_s = static_cast<double>(trace.times_us[twist.letGo - 1] - trace.times_us[first]) / 1e6;
    if (held_s < kShortestHold_s) continue;
    std::fill(trace.phase.begin() + static_cast<std::ptrdiff_t>(first),
              trace.phase.begin() + static_cast<std::ptrdiff_t>(twist.letGo), TracePhase::kHolding);
  }
}

template <class T>
std::vector<T> cut(const std::vector<T>& list, std::size_t first, std::size_t end) {
  if (list.empty()) return {};
  return {list.begin() + static_cast<std::ptrdiff_t>(first), list.begin() + static_cast<std::ptrdiff_t>(end)};
}

TrialTrace cut(const TrialTrace& trace, std::size_t first, std::size_t end) {
  TrialTrace out;
  out.times_us = cut(trace.times_us, first, end);
  out.phase = cut(trace.phase, first, end);
  out.tip_m = cut(trace.tip_m, first, end);
  out.angle_rad = cut(trace.angle_rad, first, end);
  out.force_N = cut(trace.force_N, first, end);
  out.torque_Nm = cut(trace.torque_Nm, first, end);
  out.patchShear_Pa = cut(trace.patchShear_Pa, first, end);
  return out;
}

Outcome<TrialMetrics> measured(const TrialTrace& trace, const TrialTargets& targets) {
  if (trace.times_us.size() < 2) return Outcome<TrialMetrics>::undefined("there are fewer than two samples");
  if (!longGaps(trace.times_us).empty())
    return Outcome<TrialMetrics>::undefined("samples are missing for more than 20 ms");
  return measureTrial(trace, targets);
}

}  // namespace

TrialTrace trialTrace(const TrialHeader& header, std::span<const Sample> samples, double tolerance_rad,
                      const Scene* scene) {
  TrialTrace trace;
  const bool deviceClock = stampsRise(samples);
  for (const Sample& sample : samples) {
    trace.times_us.push_back(deviceClock ? sample.device.time_us : sample.tick * header.tickPeriod_us);
    trace.phase.push_back(tracePhase(sample.phase));
    trace.tip_m.push_back({sample.device.position[0] * kPositionStep_m,
                           sample.device.position[1] * kPositionStep_m,
                           sample.device.position[2] * kPositionStep_m});
    trace.angle_rad.push_back(sample.response.angle_rad);
    trace.force_N.push_back(norm(sample.force_N));
    trace.torque_Nm.push_back(sample.response.torque_Nm);
    if (scene != nullptr)
      trace.patchShear_Pa.push_back(
          sample.response.angle_rad == 0.0
              ? 0.0
              : scene->model.peakShear_Pa({sample.response.graspArc_m, sample.response.angle_rad}));
  }
  markHolds(trace, twistsIn(samples), targetsOf(header, samples), tolerance_rad);
  return trace;
}

MeasuredTrial measureRecordedTrial(const TrialHeader& header, std::span<const Sample> samples,
                                   const TrialMeasurement& options, const Scene* scene) {
  if (samples.size() < 2)
    throw Error(ErrorCode::kBadData, "the trial has fewer than two samples", Text("trial %1", header.trialId),
                "Choose another trial");
  MeasuredTrial out;
  out.deviceClock = stampsRise(samples);
  const TrialTrace trace = trialTrace(header, samples, options.tolerance_rad, scene);
  out.duration_s = static_cast<double>(trace.times_us.back() - trace.times_us.front()) / 1e6;
  TrialTargets targets;
  targets.target_rad = header.targetAngle_rad;
  targets.tolerance_rad = options.tolerance_rad;
  targets.forceLimit_N = options.forceLimit_N;
  targets.torqueLimit_Nm = options.torqueLimit_Nm;
  targets.shearLimit_Pa = options.shearLimit_Pa;
  if (options.wholeTrial) out.whole = measured(trace, targets);
  const std::vector<double> wanted = targetsOf(header, samples);
  for (const Stretch& stretch : twistsIn(samples)) {
    const Sample& last = samples[stretch.letGo - 1];
    targets.target_rad = wanted[stretch.letGo - 1];
    if (scene != nullptr) {
      const AxisFrame frame = scene->lattice().frameAt(last.response.graspArc_m);
      targets.axisPoint_m = frame.centre_m;
      targets.axis = frame.tangent;
    }
    MeasuredTwist twist;
    twist.firstSample = stretch.first;
    twist.samples = stretch.end - stretch.first;
    twist.start_s = static_cast<double>(trace.times_us[stretch.first] - trace.times_us.front()) / 1e6;
    twist.target_rad = targets.target_rad;
    twist.releasedAt_rad = last.response.angle_rad;
    twist.metrics = measured(cut(trace, stretch.first, stretch.end), targets);
    out.twists.push_back(std::move(twist));
  }
  return out;
}

}  // namespace torsio
