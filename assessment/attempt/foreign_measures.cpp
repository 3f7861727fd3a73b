// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/foreign_measures.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "assessment/attempt/recorded_twists.h"
#include "assessment/metrics/signal.h"

namespace torsio {

namespace {

constexpr std::int64_t kGridStep_us = 1'000;  // of measureTrial
constexpr double kSamplesInGap = 2.5;

Vec3 tipOf(const Sample& sample) {
  const auto& steps = sample.device.position;
  return {steps[0] * kPositionStep_m, steps[1] * kPositionStep_m, steps[2] * kPositionStep_m};
}

/// The tip every millisecond, on straight lines between the samples.
TrialTrace evenTrace(std::span<const std::int64_t> times_us, std::span<const Sample> samples) {
  TrialTrace trace;
  std::size_t at = 0;
  for (std::int64_t now_us = times_us.front(); now_us <= times_us.back(); now_us += kGridStep_us) {
    while (at + 2 < times_us.size() && times_us[at + 1] <= now_us) {
      ++at;
    }
    const double share =
        static_cast<double>(now_us - times_us[at]) / static_cast<double>(times_us[at + 1] - times_us[at]);
    const Vec3 from = tipOf(samples[at]);
    trace.times_us.push_back(now_us);
    trace.tip_m.push_back(from + share * (tipOf(samples[at + 1]) - from));
  }
  trace.phase.assign(trace.times_us.size(), TracePhase::kFree);
  return trace;
}

bool hasLongGap(const TrialHeader& header, std::span<const std::int64_t> times_us) {
  const double longest_us =
      std::max(1e6 * kLargestGap_s, kSamplesInGap * static_cast<double>(header.tickPeriod_us));
  for (std::size_t i = 0; i + 1 < times_us.size(); ++i) {
    if (static_cast<double>(times_us[i + 1] - times_us[i]) > longest_us) {
      return true;
    }
  }
  return false;
}

}  // namespace

Outcome<TrialMetrics> measureForeign(const TrialHeader& header, std::span<const Sample> samples) {
  using Result = Outcome<TrialMetrics>;
  if (samples.size() < 2) {
    return Result::undefined(Text::tr("there are fewer than two samples"));
  }
  if (static_cast<double>(header.tickPeriod_us) * kSlowestForeign_Hz > kMicrosecondsPerSecond) {
    return Result::undefined(Text::tr("fewer than 20 samples a second were recorded"));
  }
  const SampleTimes times = sampleTimes(header, samples);
  if (hasLongGap(header, times.us)) {
    return Result::undefined(Text::tr("samples are missing"));
  }
  const TrialTrace trace = evenTrace(times.us, samples);
  if (trace.times_us.size() < 2) {
    return Result::undefined(Text::tr("there are fewer than two samples"));
  }
  TrialMetrics metrics = measureTrial(trace, {});
  for (MetricValue& metric : metrics.values) {
    if (!metric.value) {
      metric.value = Outcome<double>::undefined(Text::tr("not applicable: foreign recording"));
    }
  }
  return metrics;
}

AttemptMeasures foreignAttempt(const TrialHeader& header, std::span<const Sample> samples) {
  AttemptMeasures out;
  out.duration_us = recordedDuration_us(header, samples);
  out.values["time.total"] = static_cast<double>(out.duration_us) / kMicrosecondsPerSecond;
  if (const Outcome<TrialMetrics> metrics = measureForeign(header, samples)) {
    for (const MetricValue& metric : metrics->values) {
      if (metric.value) {
        out.values[std::string(metric.id)] = *metric.value;
      }
    }
  }
  return out;
}

}  // namespace torsio
