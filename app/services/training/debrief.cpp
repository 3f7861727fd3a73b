// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/debrief.h"

#include <algorithm>
#include <cmath>

#include "assessment/attempt/force_felt.h"
#include "assessment/attempt/merit.h"
#include "assessment/attempt/recorded_loads.h"
#include "assessment/catalogue/quantity.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

constexpr std::size_t kTracePoints = 20'000;
constexpr std::size_t kFindings = 2;
constexpr double kClearlyBetter = 0.15;  // of the logarithm: about one sixth

TwistResult resultOf(const MeasuredTwist& twist) {
  return {.when = {twist.start_s, twist.letGo_s},
          .target_rad = twist.twist.target_rad,
          .released_rad = twist.twist.releasedAt_rad,
          .held_s = twist.held_s,
          .passed = twist.onTarget};
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
    const Seconds when = strength ? Seconds{twist.start_s, twist.letGo_s}
                                  : momentInTwist(criterion.quantity, found.value, line, own, twist);
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
    out.missed = missedTargets(out.verdict, line, *out.detorsion);
    return out;
  }
  out.missed = missedTargets(out.verdict, line, measured);
  if (expert != nullptr) {
    addExpert(*expert, rules, line, measured, out);
  }
  return out;
}

}  // namespace torsio
