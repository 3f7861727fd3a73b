// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/attempt_measures.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "assessment/attempt/foreign_measures.h"
#include "assessment/statistics/quantiles.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

namespace {

double overTwists(Quantity quantity, const std::vector<double>& values) {
  switch (rowOf(quantity).traits.over) {
    case OverTwists::kSum:
      return std::accumulate(values.begin(), values.end(), 0.0);
    case OverTwists::kLargest:
      return *std::max_element(values.begin(), values.end());
    case OverTwists::kMedian:
      break;
  }
  return quantile(values, 0.5).value();
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

void setValue(AttemptMeasures& out, Quantity quantity, const std::optional<double>& value) {
  out.values.erase(quantity);
  if (value) {
    out.values[quantity] = *value;
  }
}

/// Returns the shortest hold among the twists on target.
std::optional<double> shortestHold_s(const MeasuredTrial& measured) {
  std::optional<double> shortest_s;
  for (const MeasuredTwist* twist : measured.completed()) {
    if (twist->onTarget) {
      shortest_s = std::min(shortest_s.value_or(twist->held_s), twist->held_s);
    }
  }
  return shortest_s;
}

void addValues(const MeasuredTrial& measured, AttemptMeasures& out) {
  for (const QuantityRow& row : quantityRows()) {
    const std::vector<double> values = measured.valuesOf(row.quantity);
    if (!values.empty()) {
      out.values[row.quantity] = overTwists(row.quantity, values);
    }
  }
  // Adds peaks over the whole recording, however many twists it has.
  setValue(out, Quantity::kPeakForce, measured.loads.tissueForce_N);
  setValue(out, Quantity::kDeviceForce, measured.loads.deviceForce_N);
  setValue(out, Quantity::kPeakTorque, measured.loads.torque_Nm);
  setValue(out, Quantity::kTornTwists, static_cast<double>(measured.torn));
  if (measured.detorsion) {
    return;  // no twists
  }
  const auto reached = static_cast<double>(out.twistsOnTarget());
  setValue(out, Quantity::kCompletedTwists, static_cast<double>(out.twists.size()));
  setValue(out, Quantity::kTargetsReached, reached);
  setValue(out, Quantity::kShortestHold, shortestHold_s(measured));
  if (!out.twists.empty()) {
    setValue(out, Quantity::kOnTarget, reached / static_cast<double>(out.twists.size()));
  }
}

}  // namespace

std::int64_t AttemptMeasures::twistsOnTarget() const noexcept {
  return std::count_if(twists.begin(), twists.end(), [](const JudgedTwist& twist) { return twist.onTarget; });
}

std::int64_t AttemptMeasures::twistsCutOff() const noexcept {
  const auto torn = static_cast<std::int64_t>(valueIn(values, Quantity::kTornTwists).value_or(0.0));
  return std::max<std::int64_t>(0, unfinished - torn);
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
  addValues(measured, out);
  return out;
}

}  // namespace torsio
