// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/measured_trial.h"

#include <algorithm>
#include <cmath>

#include "assessment/attempt/foreign_measures.h"
#include "assessment/attempt/recorded_detorsion.h"
#include "assessment/attempt/recorded_twists.h"
#include "assessment/metrics/signal.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

namespace {

/// A recording with the data for judging it.
struct Reading {
  SampleTimes times;
  std::vector<double> targets_rad;
  std::vector<RecordedTwist> twists;
};

Reading readingOf(const TrialHeader& header, std::span<const Sample> samples) {
  Reading reading{sampleTimes(header, samples), targetsInForce(header, samples), {}};
  reading.twists = recordedTwists(samples, reading.times.us, reading.targets_rad);
  return reading;
}

double secondsBetween(const Reading& reading, std::size_t from, std::size_t to) {
  return static_cast<double>(reading.times.us[to] - reading.times.us[from]) / kMicrosecondsPerSecond;
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

/// Returns how long the twist was on target before its release.
double heldTime_s(const Reading& reading, const RecordedTwist& twist, std::size_t since) {
  return since == twist.letGo ? 0.0 : secondsBetween(reading, since, twist.letGo - 1);
}

void markHolds(const Reading& reading, std::span<const Sample> samples, double tolerance_rad,
               TrialTrace& trace) {
  for (const RecordedTwist& twist : reading.twists) {
    const std::size_t since = onTargetSince(twist, samples, tolerance_rad);
    if (heldTime_s(reading, twist, since) < kShortestHold_s) {
      continue;
    }
    std::fill(trace.phase.begin() + static_cast<std::ptrdiff_t>(since),
              trace.phase.begin() + static_cast<std::ptrdiff_t>(twist.letGo), TracePhase::kHolding);
  }
}

TrialTrace traceOf(const Reading& reading, std::span<const Sample> samples, double tolerance_rad,
                   const OrganKnowledge& organ) {
  TrialTrace trace;
  trace.times_us = reading.times.us;
  trace.targetAngle_rad = reading.targets_rad;
  for (const Sample& sample : samples) {
    const TwistResponse& response = sample.response;
    trace.phase.push_back(tracePhase(sample.phase));
    trace.tip_m.push_back({sample.device.position[0] * kPositionStep_m,
                           sample.device.position[1] * kPositionStep_m,
                           sample.device.position[2] * kPositionStep_m});
    trace.angle_rad.push_back(response.angle_rad);
    trace.force_N.push_back(tissueForce_N(sample));
    trace.deviceForce_N.push_back(norm(sample.force_N));
    trace.torque_Nm.push_back(response.torque_Nm);
    if (organ.peakShear_Pa) {
      trace.patchShear_Pa.push_back(organ.peakShear_Pa(sample));
    }
  }
  markHolds(reading, samples, tolerance_rad, trace);
  return trace;
}

template <class T>
std::vector<T> cut(const std::vector<T>& list, std::size_t first, std::size_t end) {
  if (list.empty()) {
    return {};
  }
  return {list.begin() + static_cast<std::ptrdiff_t>(first), list.begin() + static_cast<std::ptrdiff_t>(end)};
}

TrialTrace cut(const TrialTrace& trace, std::size_t first, std::size_t end) {
  TrialTrace out;
  out.times_us = cut(trace.times_us, first, end);
  out.phase = cut(trace.phase, first, end);
  out.tip_m = cut(trace.tip_m, first, end);
  out.angle_rad = cut(trace.angle_rad, first, end);
  out.targetAngle_rad = cut(trace.targetAngle_rad, first, end);
  out.force_N = cut(trace.force_N, first, end);
  out.deviceForce_N = cut(trace.deviceForce_N, first, end);
  out.torque_Nm = cut(trace.torque_Nm, first, end);
  out.patchShear_Pa = cut(trace.patchShear_Pa, first, end);
  return out;
}

TrialTargets targetsOf(const AttemptRules& rules, const OrganKnowledge& organ) {
  TrialTargets targets;
  targets.tolerance_rad = rules.tolerance_rad;
  targets.forceLimit_N = rules.forceLimit_N;
  targets.torqueLimit_Nm = rules.torqueLimit_Nm;
  targets.shearLimit_Pa = organ.shearLimit_Pa;
  return targets;
}

Outcome<TrialMetrics> measured(const TrialTrace& trace, const TrialTargets& targets) {
  if (trace.times_us.size() < 2) {
    return Outcome<TrialMetrics>::undefined(Text::tr("there are fewer than two samples"));
  }
  if (!longGaps(trace.times_us).empty()) {
    return Outcome<TrialMetrics>::undefined(Text::tr("samples are missing for more than 20 ms"));
  }
  return measureTrial(trace, targets);
}

/// Measures a grip that began at `first` and ended before `end`. Peaks include the samples from `since`, such
/// as pressing before the grip.
Outcome<TrialMetrics> measuredGrip(const TrialTrace& trace, const TrialTargets& targets,
                                   std::span<const Sample> since, std::size_t first, std::size_t end) {
  const Outcome<TrialMetrics> grip = measured(cut(trace, first, end), targets);
  if (!grip) {
    return grip;
  }
  TrialMetrics metrics = *grip;
  const RecordedLoads loads = recordedLoads(since);
  const auto set = [&metrics](Quantity quantity, const std::optional<double>& peak) {
    metrics.set(quantity,
                peak ? Outcome<double>(*peak)
                     : Outcome<double>::undefined(Text::tr("the tissue's response is not known throughout")));
  };
  set(Quantity::kPeakForce, loads.tissueForce_N);
  set(Quantity::kDeviceForce, loads.deviceForce_N);
  set(Quantity::kPeakTorque, loads.torque_Nm);
  return metrics;
}

/// Removes from a trace what applies only to twists.
void dropTwists(TrialTrace& trace) {
  trace.angle_rad.clear();
  trace.targetAngle_rad.clear();
}

MeasuredDetorsion measuredDetorsion(const Reading& reading, std::span<const Sample> samples,
                                    const AttemptRules& rules, const OrganKnowledge& organ) {
  MeasuredDetorsion out;
  out.metrics = measureRecordedDetorsion(samples, reading.times.us, rules.detorsion, organ.peakShear_Pa);
  TrialTrace trace = traceOf(reading, samples, rules.tolerance_rad, organ);
  dropTwists(trace);
  const TrialTargets targets = targetsOf(rules, organ);
  out.whole = measured(trace, targets);
  std::size_t since = 0;
  for (const RecordedTwist& grip : reading.twists) {
    out.grips.push_back(
        measuredGrip(trace, targets, samples.subspan(since, grip.letGo - since), grip.first, grip.letGo));
    since = grip.letGo;
  }
  return out;
}

template <class Metrics>
void addValue(const Outcome<Metrics>& metrics, Quantity quantity, std::vector<double>& values) {
  if (const std::optional<double> value = metrics ? metrics->valueOf(quantity) : std::nullopt) {
    values.push_back(*value);
  }
}

std::vector<double> valuesOfDetorsion(const MeasuredDetorsion& detorsion, Quantity quantity) {
  std::vector<double> values;
  switch (rowOf(quantity).scope) {
    case QuantityScope::kUntwisting:
      addValue(detorsion.metrics, quantity, values);
      break;
    case QuantityScope::kHand:
      addValue(detorsion.whole, quantity, values);
      break;
    case QuantityScope::kGrip:
      for (const Outcome<TrialMetrics>& grip : detorsion.grips) {
        addValue(grip, quantity, values);
      }
      break;
    case QuantityScope::kRun:
      break;
  }
  return values;
}

/// Counts what could not be measured because of gaps in the samples.
std::int64_t tornIn(const Reading& reading, const MeasuredTrial& measured) {
  if (longGaps(reading.times.us).empty()) {
    return 0;
  }
  if (measured.detorsion) {
    return measured.detorsion->metrics ? 0 : 1;
  }
  return std::count_if(measured.twists.begin(), measured.twists.end(), [](const MeasuredTwist& twist) {
    return !twist.metrics || twist.twist.ending == TwistEnding::kNotSeen;
  });
}

}  // namespace

double MeasuredTrial::duration_s() const noexcept {
  return static_cast<double>(duration_us) / kMicrosecondsPerSecond;
}

std::vector<const MeasuredTwist*> MeasuredTrial::completed() const {
  std::vector<const MeasuredTwist*> out;
  for (const MeasuredTwist& twist : twists) {
    if (twist.twist.completed()) {
      out.push_back(&twist);
    }
  }
  return out;
}

std::int64_t MeasuredTrial::unfinished() const noexcept {
  return std::count_if(twists.begin(), twists.end(),
                       [](const MeasuredTwist& twist) { return !twist.twist.completed(); });
}

std::vector<double> MeasuredTrial::valuesOf(Quantity quantity) const {
  if (detorsion) {
    return valuesOfDetorsion(*detorsion, quantity);
  }
  std::vector<double> values;
  for (const MeasuredTwist* twist : completed()) {
    addValue(twist->metrics, quantity, values);
  }
  return values;
}

TrialTrace trialTrace(const TrialHeader& header, std::span<const Sample> samples, double tolerance_rad,
                      const OrganKnowledge& organ) {
  return traceOf(readingOf(header, samples), samples, tolerance_rad, organ);
}

MeasuredTrial measureTwists(const TrialHeader& header, std::span<const Sample> samples,
                            const AttemptRules& rules, const OrganKnowledge& organ) {
  const Reading reading = readingOf(header, samples);
  MeasuredTrial out{.deviceClock = reading.times.deviceClock,
                    .duration_us = recordedDuration_us(header, samples),
                    .loads = recordedLoads(samples)};
  if (comesTwisted(samples)) {
    out.detorsion = measuredDetorsion(reading, samples, rules, organ);
    out.torn = tornIn(reading, out);
    return out;
  }
  if (reading.twists.empty()) {
    return out;
  }
  const TrialTrace trace = traceOf(reading, samples, rules.tolerance_rad, organ);
  TrialTargets targets = targetsOf(rules, organ);
  std::size_t since = 0;
  for (const RecordedTwist& twist : reading.twists) {
    if (organ.axisAt) {
      const GraspAxis axis = organ.axisAt(samples[twist.letGo - 1].response.graspArc_m);
      targets.axisPoint_m = axis.point_m;
      targets.axis = axis.direction;
    }
    out.twists.push_back(
        {.twist = twist,
         .start_s = secondsBetween(reading, 0, twist.first),
         .letGo_s = secondsBetween(reading, 0, twist.letGo - 1),
         .held_s = heldTime_s(reading, twist, onTargetSince(twist, samples, rules.tolerance_rad)),
         .onTarget = twist.onTarget(rules.tolerance_rad),
         .metrics = measuredGrip(trace, targets, samples.subspan(since, twist.letGo - since), twist.first,
                                 twist.end)});
    since = twist.letGo;
  }
  out.torn = tornIn(reading, out);
  return out;
}

Outcome<TrialMetrics> measureWhole(const TrialHeader& header, std::span<const Sample> samples,
                                   const AttemptRules& rules, const OrganKnowledge& organ) {
  if (isForeign(header.sceneId)) {
    return measureForeign(header, samples);
  }
  TrialTrace trace = trialTrace(header, samples, rules.tolerance_rad, organ);
  if (comesTwisted(samples)) {
    dropTwists(trace);
  }
  return measured(trace, targetsOf(rules, organ));
}

}  // namespace torsio
