// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/attempt_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "assessment/statistics/quantiles.h"

namespace torsio {

namespace {

/// Mishaps of all twists add up, and of a largest value the largest counts; else the middle one does.
constexpr std::array<std::string_view, 6> kSummed{"twist.excursions",     "force.violations",
                                                  "force.violation_time", "force.excess",
                                                  "torque.violations",    "shear.over_limit"};
constexpr std::array<std::string_view, 4> kLargest{"force.peak", "force.peak_raw", "torque.peak",
                                                   "force.rate"};

template <std::size_t N>
bool isOneOf(const std::array<std::string_view, N>& ids, std::string_view id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

double overTwists(std::string_view id, const std::vector<double>& values) {
  if (isOneOf(kLargest, id)) {
    return *std::max_element(values.begin(), values.end());
  }
  if (!isOneOf(kSummed, id)) {
    return quantile(values, 0.5).value();
  }
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum;
}

void judgeTwists(const MeasuredTrial& measured, AttemptMeasures& out) {
  double errorSum_rad = 0.0;
  for (const MeasuredTwist* twist : measured.completed()) {
    const double error_rad = twist->twist.error_rad();
    errorSum_rad += error_rad;
    out.twists.push_back({degrees(error_rad), twist->onTarget});
  }
  out.unfinished = measured.unfinished();
  if (!out.twists.empty()) {
    out.meanAbsoluteError_deg = degrees(errorSum_rad / static_cast<double>(out.twists.size()));
  }
}

void findPeaks(std::span<const Sample> samples, AttemptMeasures& out) {
  double torque_Nm = 0.0;
  double force_N = 0.0;
  for (const Sample& sample : samples) {
    torque_Nm = std::max(torque_Nm, std::abs(sample.response.torque_Nm));
    force_N = std::max(force_N, norm(sample.force_N));
  }
  out.peakTorque_Nm = torque_Nm;
  out.peakForce_N = force_N;
}

void addMetrics(const MeasuredTrial& measured, AttemptMeasures& out) {
  for (const MetricCard& card : metricCards()) {
    const std::vector<double> values = measured.valuesOf(card.id);
    if (!values.empty()) {
      out.values[std::string(card.id)] = overTwists(card.id, values);
    }
  }
  if (measured.detorsion) {
    return;  // no targets
  }
  const auto reached = static_cast<double>(out.twistsOnTarget());
  out.values[kTargetsReachedMetric] = reached;
  if (!out.twists.empty()) {
    out.values[kOnTargetMetric] = reached / static_cast<double>(out.twists.size());
  }
}

}  // namespace

std::int64_t AttemptMeasures::twistsOnTarget() const noexcept {
  return std::count_if(twists.begin(), twists.end(), [](const JudgedTwist& twist) { return twist.onTarget; });
}

AttemptMeasures measureAttempt(const TrialHeader& header, std::span<const Sample> samples,
                               const AttemptRules& rules) {
  return measureAttempt(samples, measureTwists(header, samples, rules));
}

AttemptMeasures measureAttempt(std::span<const Sample> samples, const MeasuredTrial& measured) {
  AttemptMeasures out;
  out.duration_us = measured.duration_us;
  judgeTwists(measured, out);
  if (!out.twists.empty()) {
    findPeaks(samples, out);
  }
  addMetrics(measured, out);
  return out;
}

}  // namespace torsio
