// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/foreign_measures.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/attempt/recorded_twists.h"
#include "assessment/metrics/signal.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

namespace {

constexpr std::int64_t kGridStep_us = 1'000;  // of measureTrial
constexpr double kSamplesInGap = 2.5;

Vec3 tipOf(const Sample& sample) {
  const auto& steps = sample.device.position;
  return {steps[0] * kPositionStep_m, steps[1] * kPositionStep_m, steps[2] * kPositionStep_m};
}

/// Samples the tip every millisecond by linear interpolation.
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

bool samePose(const Sample& a, const Sample& b) {
  return a.device.position == b.device.position && a.device.orientation == b.device.orientation;
}

/// Returns for each sample whether it repeats a pose that stays the same for more than kFrozenPose_us; the
/// first of them is a pose.
std::vector<bool> frozenSamples(std::span<const std::int64_t> times_us, std::span<const Sample> samples) {
  std::vector<bool> frozen(samples.size(), false);
  for (std::size_t first = 0; first < samples.size();) {
    std::size_t last = first;
    while (last + 1 < samples.size() && samePose(samples[first], samples[last + 1])) {
      ++last;
    }
    if (times_us[last] - times_us[first] > kFrozenPose_us) {
      std::fill(frozen.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                frozen.begin() + static_cast<std::ptrdiff_t>(last) + 1, true);
    }
    first = last + 1;
  }
  return frozen;
}

/// Returns the ranges without long gaps and repeated poses, [first, last).
std::vector<std::pair<std::size_t, std::size_t>> stretches(const TrialHeader& header,
                                                           std::span<const std::int64_t> times_us,
                                                           std::span<const Sample> samples) {
  const std::vector<bool> frozen = frozenSamples(times_us, samples);
  const double longest_us =
      std::max(1e6 * kLargestGap_s, kSamplesInGap * static_cast<double>(header.tickPeriod_us));
  std::vector<std::pair<std::size_t, std::size_t>> found;
  std::size_t first = 0;
  for (std::size_t i = 1; i <= times_us.size(); ++i) {
    if (i == times_us.size() || frozen[i] != frozen[i - 1] ||
        static_cast<double>(times_us[i] - times_us[i - 1]) > longest_us) {
      if (!frozen[i - 1]) {
        found.emplace_back(first, i);
      }
      first = i;
    }
  }
  return found;
}

/// Returns what is between the stretches, and after the last.
std::vector<Unseen> gapsBetween(std::span<const std::int64_t> times_us,
                                const std::vector<std::pair<std::size_t, std::size_t>>& seen) {
  std::vector<Unseen> gaps;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const std::size_t last = seen[i].second - 1;
    const std::size_t next = i + 1 < seen.size() ? seen[i + 1].first : times_us.size() - 1;
    if (next > last) {
      gaps.push_back({times_us[last] - times_us.front(), times_us[next] - times_us.front()});
    }
  }
  return gaps;
}

}  // namespace

std::vector<Unseen> unseenStretches(const TrialHeader& header, std::span<const Sample> samples) {
  if (samples.size() < 2) {
    return {};
  }
  const SampleTimes times = sampleTimes(header, samples);
  return gapsBetween(times.us, stretches(header, times.us, samples));
}

Outcome<TrialMetrics> measureForeign(const TrialHeader& header, std::span<const Sample> samples) {
  using Result = Outcome<TrialMetrics>;
  if (samples.size() < 2) {
    return Result::undefined(Text::tr("there are fewer than two samples"));
  }
  if (static_cast<double>(header.tickPeriod_us) * kSlowestForeign_Hz > kMicrosecondsPerSecond) {
    return Result::undefined(Text::tr("fewer than 20 samples a second were recorded"));
  }
  const SampleTimes times = sampleTimes(header, samples);
  const std::int64_t whole_us = times.us.back() - times.us.front();
  std::int64_t seen_us = whole_us;
  for (const Unseen& gap : gapsBetween(times.us, stretches(header, times.us, samples))) {
    seen_us -= gap.to_us - gap.from_us;
  }
  std::optional<TrialMetrics> metrics;
  double path_m = 0.0;
  double idle_s = 0.0;
  for (const auto& [first, last] : stretches(header, times.us, samples)) {
    const std::int64_t span_us = times.us[last - 1] - times.us[first];
    if (span_us < kGridStep_us) {
      continue;
    }
    metrics = measureTrial(
        evenTrace(std::span(times.us).subspan(first, last - first), samples.subspan(first, last - first)),
        {});
    path_m += *metrics->at(Quantity::kTipPath);
    idle_s += *metrics->at(Quantity::kIdleTime);
  }
  if (!metrics) {
    return Result::undefined(Text::tr("there are fewer than two samples"));
  }
  if (static_cast<double>(seen_us) < kLeastSeen * static_cast<double>(whole_us)) {
    return Result::undefined(Text::tr("the instrument was seen for %1 % of the time only",
                                      std::to_string((100 * seen_us + whole_us / 2) / whole_us)));
  }
  metrics->set(Quantity::kTime, static_cast<double>(whole_us) / kMicrosecondsPerSecond);
  metrics->set(Quantity::kTipPath, path_m);
  metrics->set(Quantity::kIdleTime, idle_s);
  metrics->lostSamples =
      static_cast<std::size_t>(samples.back().tick - samples.front().tick + 1) - samples.size();
  metrics->explainMissing(Text::tr("not applicable: foreign recording"));
  return *metrics;
}

AttemptMeasures foreignAttempt(const TrialHeader& header, std::span<const Sample> samples) {
  AttemptMeasures out;
  out.duration_us = recordedDuration_us(header, samples);
  out.values[Quantity::kTime] = static_cast<double>(out.duration_us) / kMicrosecondsPerSecond;
  if (samples.size() >= 2) {
    const std::vector<Unseen> gaps = unseenStretches(header, samples);
    double lost_s = 0.0;
    for (const Unseen& gap : gaps) {
      lost_s += static_cast<double>(gap.to_us - gap.from_us) / kMicrosecondsPerSecond;
    }
    const double whole_s = out.values[Quantity::kTime];
    out.values[Quantity::kTimesUnseen] = static_cast<double>(gaps.size());
    out.values[Quantity::kUnseen] = lost_s;
    out.values[Quantity::kUnseenShare] = whole_s > 0.0 ? lost_s / whole_s : 0.0;
  }
  if (const Outcome<TrialMetrics> metrics = measureForeign(header, samples)) {
    for (const auto& [quantity, value] : metrics->all()) {
      if (value) {
        out.values[quantity] = *value;
      }
    }
  }
  return out;
}

std::vector<Text> foreignSentences(const QuantityValues& values) {
  std::vector<Text> said;
  for (const Quantity quantity : {Quantity::kTipPath, Quantity::kIdleTime}) {
    if (const std::optional<double> value = valueIn(values, quantity)) {
      said.push_back(Text::tr("%1: %2.", rowOf(quantity).name, shownValue(quantity, *value)));
    }
  }
  const std::optional<double> times = valueIn(values, Quantity::kTimesUnseen);
  if (!times) {
    said.push_back(Text::tr("Too little was recorded to measure the path."));
  } else if (*times == 0.0) {
    said.push_back(Text::tr("The instrument was in view all the time."));
  } else {
    said.push_back(Text::tr("The instrument was out of view %1 {time|times}, for %2 in all (%3 of the time).",
                            static_cast<std::int64_t>(*times),
                            shownValue(Quantity::kUnseen, valueIn(values, Quantity::kUnseen)),
                            shownValue(Quantity::kUnseenShare, valueIn(values, Quantity::kUnseenShare))));
  }
  if (times && valueIn(values, Quantity::kTipPath)) {
    if (*times > 0.0) {
      said.push_back(Text::tr("Path and idle time leave this time out; nothing is guessed."));
    }
  } else if (times) {
    said.push_back(
        Text::tr("Path and idle time are not measured: too few poses came, or too much is missing."));
  }
  return said;
}

}  // namespace torsio
