// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/debrief.h"

#include <algorithm>
#include <cmath>

#include "assessment/attempt/force_felt.h"
#include "assessment/attempt/merit.h"
#include "assessment/attempt/recorded_loads.h"
#include "assessment/attempt/recorded_twists.h"
#include "assessment/catalogue/quantity.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

constexpr std::size_t kTracePoints = 20'000;
constexpr std::size_t kFindings = 2;
constexpr double kClearlyBetter = 0.15;  // of the logarithm: about one sixth
constexpr double kMoment_s = 0.5;        // before and after the time of a maximum

/// The samples of a recording with their times since the first one.
struct Timeline {
  std::span<const Sample> samples;
  std::vector<std::int64_t> times_us;

  Timeline(const TrialHeader& header, std::span<const Sample> all)
      : samples(all), times_us(sampleTimes(header, all).us) {}
  [[nodiscard]] double at_s(std::size_t i) const {
    return static_cast<double>(times_us[i] - times_us.front()) * 1e-6;
  }
};

TwistResult resultOf(const MeasuredTwist& twist) {
  return {.when = {twist.start_s, twist.letGo_s},
          .target_rad = twist.twist.target_rad,
          .released_rad = twist.twist.releasedAt_rad,
          .held_s = twist.held_s,
          .passed = twist.onTarget};
}

/// Returns the part of the twist that shows a metric. `since`: first sample after the previous twist; peaks
/// of force from there on belong to this one.
Seconds rangeShowing(Quantity quantity, double value, const Timeline& line, const MeasuredTwist& measured,
                     std::size_t since) {
  const RecordedTwist& twist = measured.twist;
  const Seconds whole{measured.start_s, measured.letGo_s};
  const auto momentOf = [&](std::size_t first, auto&& size) {
    std::size_t at = first;
    for (std::size_t i = first; i < twist.letGo; ++i) {
      if (size(line.samples[i]) > size(line.samples[at])) {
        at = i;
      }
    }
    const double t = line.at_s(at);
    // A peak before the grip is shown up to the grip, so that some of the twist is always visible.
    return Seconds{std::max(std::min(whole.from_s, t), t - kMoment_s),
                   std::min(whole.to_s + kMoment_s, std::max(t, whole.from_s) + kMoment_s)};
  };
  switch (rowOf(quantity).traits.moment) {
    case QuantityMoment::kPeakForce:
      return momentOf(since, tissueForce_N);
    case QuantityMoment::kFarthestTurn: {
      const double sign = twist.target_rad < 0.0 ? -1.0 : 1.0;
      return momentOf(twist.first, [sign](const Sample& s) { return sign * s.response.angle_rad; });
    }
    case QuantityMoment::kFromGrip:
      return {whole.from_s, std::min(whole.to_s, whole.from_s + value)};
    case QuantityMoment::kHold:
      return {std::max(whole.from_s, whole.to_s - measured.held_s), whole.to_s};
    case QuantityMoment::kRelease:
      return {whole.to_s - kMoment_s, whole.to_s + kMoment_s};
    case QuantityMoment::kWholeTwist:
      break;
  }
  return whole;
}

/// Returns the first sample after the grip before this twist.
std::size_t sinceBefore(const MeasuredTrial& run, const MeasuredTwist& twist) {
  std::size_t since = 0;
  for (const MeasuredTwist& other : run.twists) {
    if (other.twist.letGo <= twist.twist.first) {
      since = std::max(since, other.twist.letGo);
    }
  }
  return since;
}

DebriefTrace traceOf(const Timeline& line, std::size_t first, std::size_t end) {
  DebriefTrace trace;
  const std::size_t stride = std::max<std::size_t>(1, (end - first + kTracePoints - 1) / kTracePoints);
  for (std::size_t i = first; i < end; i += stride) {
    // Keep a short peak of force from being lost between two points.
    double force_N = 0.0;
    for (std::size_t k = i; k < std::min(i + stride, end); ++k) {
      force_N = std::max(force_N, tissueForce_N(line.samples[k]));
    }
    trace.time_s.push_back(line.at_s(i));
    trace.angle_rad.push_back(line.samples[i].response.angle_rad);
    trace.torque_Nm.push_back(line.samples[i].response.torque_Nm);
    trace.force_N.push_back(force_N);
  }
  return trace;
}

void addExpert(const Trial& expert, const AttemptRules& rules, const Timeline& line, const MeasuredTrial& own,
               Debrief& out) {
  const std::vector<Sample> shown = decodeTrial(expert);
  const MeasuredTrial reference = measureTwists(expert.header, shown, rules);
  const std::vector<const MeasuredTwist*> examples = reference.completed();
  if (examples.empty()) {
    return;
  }
  const RecordedTwist& example = examples.front()->twist;
  out.expert = traceOf(Timeline(expert.header, shown), example.first, example.end);
  const double grip_s = out.expert.time_s.front();
  out.expertGrip_s = grip_s;
  for (double& t : out.expert.time_s) {
    t -= grip_s;
  }
  const std::vector<const MeasuredTwist*> twists = own.completed();
  const std::vector<QuantityMerit> all = meritsAgainst(own, reference);
  const auto finding = [&](const QuantityMerit& criterion, const TwistMerit& found, bool strength) {
    const MeasuredTwist& twist = *twists[found.twist];
    // A strength applies to the whole twist; a weakness has its moment.
    const Seconds when =
        strength ? Seconds{twist.start_s, twist.letGo_s}
                 : rangeShowing(criterion.quantity, found.value, line, twist, sinceBefore(own, twist));
    return DebriefFinding{criterion.quantity, found.value, criterion.expert, found.merit,
                          found.twist,        when,        strength};
  };
  const std::size_t each = std::min(kFindings, all.size() / 2);
  for (std::size_t i = 0; i < each; ++i) {
    const QuantityMerit& last = all[all.size() - 1 - i];
    out.strengths.push_back(finding(all[i], all[i].best, true));
    out.weaknesses.push_back(finding(last, last.worst, false));
  }
}

}  // namespace

Text DebriefFinding::text() const {
  // The run's peak is shown in its check, so this one needs a different name.
  const Text name = quantity == Quantity::kPeakForce ? Text(Text::tr("Peak force of one twist"))
                                                     : Text(rowOf(quantity).name);
  const Text own = shownValue(quantity, value);
  const Text other = shownValue(quantity, expert);
  if (!strength) {
    return Text::tr("%1: %2 (expert: %3)", name, own, other);
  }
  return merit > kClearlyBetter     ? Text::tr("%1: %2, better than the expert (%3)", name, own, other)
         : merit >= 0.0             ? Text::tr("%1: %2, as good as the expert (%3)", name, own, other)
         : merit >= -kClearlyBetter ? Text::tr("%1: %2, close to the expert (%3)", name, own, other)
                                    : Text::tr("%1: %2, closest to the expert (%3)", name, own, other);
}

Text DebriefFinding::advice() const {
  return strength ? Text() : Text(rowOf(quantity).traits.advice);
}

Debrief makeDebrief(const TrialHeader& header, std::span<const Sample> samples, const AttemptRules& rules,
                    const Trial* expert) {
  return makeDebrief(header, samples, measureTwists(header, samples, rules), rules, expert);
}

Debrief makeDebrief(const TrialHeader& header, std::span<const Sample> samples, const MeasuredTrial& measured,
                    const AttemptRules& rules, const Trial* expert) {
  Debrief out;
  out.trialId = header.trialId;
  out.phaseLabel = header.phaseLabel;
  out.startedUtc_us = header.startedUtc_us;
  out.demonstration = header.demonstration;
  out.forceFelt = forceFelt(header.drive);
  out.target_rad = header.targetAngle_rad;
  out.tolerance_rad = rules.tolerance_rad;
  out.forceLimit_N = rules.forceLimit_N.value_or(0.0);
  out.duration_s = measured.duration_s();
  const Timeline line(header, samples);
  if (samples.size() >= 2) {
    out.own = traceOf(line, 0, samples.size());
  }
  for (const MeasuredTwist* twist : measured.completed()) {
    out.twists.push_back(resultOf(*twist));
    out.grips_s.push_back(twist->start_s);
  }
  out.unfinishedTwists = measured.unfinished();
  out.verdict = judgeRun(measureAttempt(measured), rules);
  out.deviceForce_N = measured.loads.deviceForce_N;
  if (measured.detorsion && rules.detorsion) {
    out.detorsion = detorsionStory(samples, line.times_us, *rules.detorsion, measured.detorsion->metrics);
  } else if (expert != nullptr) {
    addExpert(*expert, rules, line, measured, out);
  }
  return out;
}

}  // namespace torsio
