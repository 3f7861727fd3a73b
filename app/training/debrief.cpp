// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/training/debrief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "app/recording/trial_trace.h"
#include "assessment/metrics/metric_cards.h"
#include "assessment/statistics/quantiles.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

constexpr std::size_t kTracePoints = 20'000;
constexpr std::size_t kFindings = 2;
/// Of the twists, so many must end on target for a run to pass.
constexpr double kWantedShare = 0.8;
constexpr double kMoment_s = 0.5;  // round the instant of a largest value

/// A quantity on which a hand can be praised or corrected. `floor`: a difference that nobody can see, so that
/// a ratio to nearly nothing says nothing. `weight`: SPARC is a logarithm already and moves little.
struct Criterion {
  std::string_view metric;
  double floor = 0.0;
  double weight = 1.0;
};
constexpr std::array<Criterion, 9> kCriteria{{{"twist.time_to_target", 0.5},
                                              {"twist.settling", 0.5},
                                              {"twist.overshoot", 0.0349},
                                              {"twist.hold_steadiness", 0.0087},
                                              {"twist.sparc", 0.0, 2.0},
                                              {"twist.economy", 0.1},
                                              {"twist.peaks", 2.0},
                                              {"force.peak", 0.2},
                                              {"torque.release_rate", 0.1}}};

struct Twist {
  std::size_t first = 0;
  std::size_t letGo = 0;
  std::size_t end = 0;
};

double timeAt(const TrialHeader& header, std::span<const Sample> samples, std::size_t i) {
  return static_cast<double>((samples[i].tick - samples.front().tick) * header.tickPeriod_us) * 1e-6;
}

Twist boundsOf(const MeasuredTwist& twist, std::span<const Sample> samples) {
  Twist bounds{twist.firstSample, twist.firstSample, twist.firstSample + twist.samples};
  while (bounds.letGo < bounds.end && samples[bounds.letGo].phase == ExercisePhase::kTwisting) ++bounds.letGo;
  return bounds;
}

TwistResult resultOf(const TrialHeader& header, std::span<const Sample> samples, const MeasuredTwist& twist,
                     double tolerance_rad) {
  const Twist bounds = boundsOf(twist, samples);
  TwistResult result;
  result.when = {timeAt(header, samples, bounds.first), timeAt(header, samples, bounds.letGo - 1)};
  result.target_rad = twist.target_rad;
  result.released_rad = twist.releasedAt_rad;
  result.passed = std::abs(twist.releasedAt_rad - twist.target_rad) <= tolerance_rad;
  std::size_t held = bounds.letGo;
  while (held > bounds.first &&
         std::abs(samples[held - 1].response.angle_rad - twist.target_rad) <= tolerance_rad)
    --held;
  if (held < bounds.letGo) result.held_s = result.when.to_s - timeAt(header, samples, held);
  return result;
}

double meritOf(const Criterion& criterion, double own, double expert) {
  const bool higher = metricCard(criterion.metric).direction == Direction::kHigherIsBetter;
  // Both smoothness measures are negative, nearer 0 is better.
  const bool negative = own < 0.0 || expert < 0.0;
  const double a = std::max(std::abs(own) + criterion.floor, 1e-9);
  const double b = std::max(std::abs(expert) + criterion.floor, 1e-9);
  return criterion.weight * (higher && !negative ? std::log(a / b) : std::log(b / a));
}

/// Median of a metric over all twists of the trial in which it is defined.
std::optional<double> medianOf(const MeasuredTrial& trial, std::string_view metric) {
  std::vector<double> values;
  for (const MeasuredTwist& twist : trial.twists) {
    if (twist.metrics && twist.metrics->at(metric)) values.push_back(*twist.metrics->at(metric));
  }
  return quantile(values, 0.5);
}

/// Where in the twist the eye should look.
Seconds whereIs(std::string_view metric, double value, const TrialHeader& header,
                std::span<const Sample> samples, const MeasuredTwist& twist, const TwistResult& result) {
  const Twist bounds = boundsOf(twist, samples);
  const Seconds whole = result.when;
  const auto momentOf = [&](auto&& size) {
    std::size_t at = bounds.first;
    for (std::size_t i = bounds.first; i < bounds.letGo; ++i)
      if (size(samples[i]) > size(samples[at])) at = i;
    const double t = timeAt(header, samples, at);
    return Seconds{std::max(whole.from_s, t - kMoment_s), std::min(whole.to_s + kMoment_s, t + kMoment_s)};
  };
  if (metric == "force.peak") return momentOf([](const Sample& s) { return norm(s.force_N); });
  if (metric == "twist.overshoot") {
    const double sign = twist.target_rad < 0.0 ? -1.0 : 1.0;
    return momentOf([sign](const Sample& s) { return sign * s.response.angle_rad; });
  }
  if (metric == "twist.time_to_target" || metric == "twist.settling")
    return {whole.from_s, std::min(whole.to_s, whole.from_s + value)};
  if (metric == "twist.hold_steadiness")
    return {std::max(whole.from_s, whole.to_s - result.held_s), whole.to_s};
  if (metric == "torque.release_rate") return {whole.to_s - kMoment_s, whole.to_s + kMoment_s};
  return whole;
}

/// Every criterion with its usual merit, and the twist that shows it best or worst.
struct Judged {
  double merit = 0.0;
  DebriefFinding best;
  DebriefFinding worst;
};

std::vector<Judged> judgeAll(const TrialHeader& header, std::span<const Sample> samples,
                             const MeasuredTrial& own, const MeasuredTrial& expert,
                             const std::vector<TwistResult>& results) {
  std::vector<Judged> all;
  for (const Criterion& criterion : kCriteria) {
    const std::optional<double> reference = medianOf(expert, criterion.metric);
    const std::optional<double> mine = medianOf(own, criterion.metric);
    if (!reference || !mine) continue;
    Judged judged;
    judged.merit = meritOf(criterion, *mine, *reference);
    bool first = true;
    for (std::size_t i = 0; i < own.twists.size(); ++i) {
      const MeasuredTwist& twist = own.twists[i];
      if (!twist.metrics || !twist.metrics->at(criterion.metric)) continue;
      const double value = *twist.metrics->at(criterion.metric);
      const DebriefFinding finding{std::string(criterion.metric),
                                   value,
                                   *reference,
                                   meritOf(criterion, value, *reference),
                                   i,
                                   whereIs(criterion.metric, value, header, samples, twist, results[i])};
      if (first || finding.merit > judged.best.merit) judged.best = finding;
      if (first || finding.merit < judged.worst.merit) judged.worst = finding;
      first = false;
    }
    all.push_back(std::move(judged));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Judged& a, const Judged& b) { return a.merit > b.merit; });
  return all;
}

DebriefTrace traceOf(const TrialHeader& header, std::span<const Sample> samples, std::size_t first,
                     std::size_t end) {
  DebriefTrace trace;
  const std::size_t stride = std::max<std::size_t>(1, (end - first + kTracePoints - 1) / kTracePoints);
  for (std::size_t i = first; i < end; i += stride) {
    // A short peak of force must not fall between two points.
    double force_N = 0.0;
    for (std::size_t k = i; k < std::min(i + stride, end); ++k)
      force_N = std::max(force_N, norm(samples[k].force_N));
    trace.time_s.push_back(timeAt(header, samples, i));
    trace.angle_rad.push_back(samples[i].response.angle_rad);
    trace.torque_Nm.push_back(samples[i].response.torque_Nm);
    trace.force_N.push_back(force_N);
  }
  return trace;
}

/// A twist that the end of the recording cut off is not judged.
void dropCutOff(MeasuredTrial& trial, std::span<const Sample> samples) {
  std::erase_if(trial.twists, [&](const MeasuredTwist& twist) { return cutOff(twist, samples); });
}

std::optional<double> largest(const MeasuredTrial& trial, std::string_view metric) {
  std::optional<double> top;
  for (const MeasuredTwist& twist : trial.twists) {
    if (!twist.metrics || !twist.metrics->at(metric)) continue;
    top = std::max(top.value_or(0.0), *twist.metrics->at(metric));
  }
  return top;
}

void addChecks(const MeasuredTrial& own, const DebriefRules& rules, Debrief& out) {
  using Kind = TargetCheck::Kind;
  const auto twists = static_cast<double>(out.twists.size());
  const auto hits = static_cast<double>(
      std::count_if(out.twists.begin(), out.twists.end(), [](const TwistResult& t) { return t.passed; }));
  const double wanted = std::max(1.0, std::ceil(kWantedShare * twists));
  out.checks.push_back({.kind = Kind::kAngle, .passed = hits >= wanted, .value = hits, .wanted = wanted});
  if (rules.hold_s > 0.0) {
    std::optional<double> shortest;
    for (const TwistResult& twist : out.twists)
      if (twist.passed) shortest = std::min(shortest.value_or(twist.held_s), twist.held_s);
    out.checks.push_back({.kind = Kind::kHold,
                          .passed = shortest && *shortest >= rules.hold_s,
                          .value = shortest,
                          .wanted = rules.hold_s});
  }
  const auto limit = [&](Kind kind, std::string_view metric, std::optional<double> most) {
    if (!most) return;
    const std::optional<double> top = largest(own, metric);
    out.checks.push_back(
        {.kind = kind, .passed = top && *top <= *most, .value = top, .wanted = *most, .atLeast = false});
  };
  limit(Kind::kForce, "force.peak", rules.forceLimit_N);
  limit(Kind::kTorque, "torque.peak", rules.torqueLimit_Nm);
}

void addExpert(const Trial& expert, const DebriefRules& rules, const TrialHeader& header,
               std::span<const Sample> samples, const MeasuredTrial& own, Debrief& out) {
  const std::vector<Sample> shown = decodeTrial(expert);
  if (shown.size() < 2) return;
  MeasuredTrial reference = measureTwists(expert.header, shown, rules);
  dropCutOff(reference, shown);
  if (reference.twists.empty()) return;
  const MeasuredTwist& twist = reference.twists.front();
  out.expert = traceOf(expert.header, shown, twist.firstSample, twist.firstSample + twist.samples);
  const double grip_s = out.expert.time_s.front();
  for (double& t : out.expert.time_s) t -= grip_s;
  const std::vector<Judged> all = judgeAll(header, samples, own, reference, out.twists);
  const std::size_t each = std::min(kFindings, all.size() / 2);
  for (std::size_t i = 0; i < each; ++i) out.strengths.push_back(all[i].best);
  for (std::size_t i = 0; i < each; ++i) out.weaknesses.push_back(all[all.size() - 1 - i].worst);
}

}  // namespace

MeasuredTrial measureTwists(const TrialHeader& header, std::span<const Sample> samples,
                            const DebriefRules& rules) {
  if (samples.size() < 2) return {};
  TrialMeasurement options;
  options.tolerance_rad = rules.tolerance_rad;
  options.forceLimit_N = rules.forceLimit_N;
  options.wholeTrial = false;
  options.torqueLimit_Nm = rules.torqueLimit_Nm;
  return measureRecordedTrial(header, samples, options);
}

Debrief makeDebrief(const TrialHeader& header, std::span<const Sample> samples, const DebriefRules& rules,
                    const Trial* expert) {
  return makeDebrief(header, samples, measureTwists(header, samples, rules), rules, expert);
}

Debrief makeDebrief(const TrialHeader& header, std::span<const Sample> samples, MeasuredTrial own,
                    const DebriefRules& rules, const Trial* expert) {
  dropCutOff(own, samples);
  Debrief out;
  out.trialId = header.trialId;
  out.phaseLabel = header.phaseLabel;
  out.startedUtc_us = header.startedUtc_us;
  out.demonstration = header.demonstration;
  out.target_rad = header.targetAngle_rad;
  out.tolerance_rad = rules.tolerance_rad;
  out.forceLimit_N = rules.forceLimit_N.value_or(0.0);
  if (samples.size() >= 2) {
    out.duration_s = timeAt(header, samples, samples.size() - 1);
    out.own = traceOf(header, samples, 0, samples.size());
  }
  for (const MeasuredTwist& twist : own.twists) {
    out.twists.push_back(resultOf(header, samples, twist, rules.tolerance_rad));
    out.grips_s.push_back(out.twists.back().when.from_s);
  }
  addChecks(own, rules, out);
  if (expert != nullptr) addExpert(*expert, rules, header, samples, own, out);
  out.passed =
      std::all_of(out.checks.begin(), out.checks.end(), [](const TargetCheck& c) { return c.passed; });
  return out;
}

}  // namespace torsio
