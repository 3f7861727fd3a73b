// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/attempt_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "assessment/attempt/foreign_measures.h"
#include "assessment/statistics/quantiles.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

namespace {

/// Mishaps of all twists add up, and of a largest value the largest counts; else the middle one does.
constexpr std::array<std::string_view, 6> kSummed{"twist.excursions",     "force.violations",
                                                  "force.violation_time", "force.excess",
                                                  "torque.violations",    "shear.over_limit"};
constexpr std::array<std::string_view, 1> kLargest{"force.rate"};

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

/// Peaks are those of the recording, however many twists it has.
void addPeaks(const RecordedLoads& loads, AttemptMeasures& out) {
  const auto add = [&out](std::string_view id, const std::optional<double>& peak) {
    out.values.erase(std::string(id));
    if (peak) {
      out.values[std::string(id)] = *peak;
    }
  };
  add(kPeakForceMetric, loads.tissueForce_N);
  add(kDeviceForceMetric, loads.deviceForce_N);
  add(kPeakTorqueMetric, loads.torque_Nm);
}

void addMetrics(const MeasuredTrial& measured, AttemptMeasures& out) {
  for (const MetricCard& card : metricCards()) {
    const std::vector<double> values = measured.valuesOf(card.id);
    if (!values.empty()) {
      out.values[std::string(card.id)] = overTwists(card.id, values);
    }
  }
  addPeaks(measured.loads, out);
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
  if (isForeign(header.sceneId)) {
    return foreignAttempt(header, samples);
  }
  return measureAttempt(measureTwists(header, samples, rules));
}

AttemptMeasures measureAttempt(const MeasuredTrial& measured) {
  AttemptMeasures out;
  out.duration_us = measured.duration_us;
  judgeTwists(measured, out);
  if (!out.twists.empty()) {
    out.peakTorque_Nm = measured.loads.torque_Nm;
    out.peakForce_N = measured.loads.tissueForce_N;
  }
  addMetrics(measured, out);
  return out;
}

}  // namespace torsio
