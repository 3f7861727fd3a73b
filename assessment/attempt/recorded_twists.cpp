// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/recorded_twists.h"

#include <algorithm>
#include <cmath>

#include "assessment/metrics/signal.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr std::uint32_t kHandGone = kDeviceLost | kDeviceUncalibrated;

bool isIn(std::span<const Sample> samples, std::size_t i, ExercisePhase phase) {
  return i < samples.size() && samples[i].phase == phase;
}

bool stampsIncrease(std::span<const Sample> samples) {
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples[i].device.time_us <= samples[i - 1].device.time_us) {
      return false;
    }
  }
  return true;
}

/// Returns how the grip [.., letGo) ended.
TwistEnding endingOf(std::span<const Sample> samples, std::span<const std::int64_t> times_us,
                     std::size_t letGo) {
  if (letGo == samples.size() || (samples[letGo].device.status & kDeviceEnded) != 0) {
    return TwistEnding::kRecordingEnded;
  }
  if ((samples[letGo].device.status & kHandGone) != 0) {
    return TwistEnding::kDeviceFault;
  }
  const double missing_s =
      static_cast<double>(times_us[letGo] - times_us[letGo - 1]) / kMicrosecondsPerSecond;
  return missing_s > kLargestGap_s ? TwistEnding::kNotSeen : TwistEnding::kLetGo;
}

}  // namespace

double RecordedTwist::error_rad() const noexcept {
  return std::abs(releasedAt_rad - target_rad);
}

bool RecordedTwist::onTarget(double tolerance_rad) const noexcept {
  return completed() && error_rad() <= tolerance_rad;
}

SampleTimes sampleTimes(const TrialHeader& header, std::span<const Sample> samples) {
  SampleTimes times{.deviceClock = stampsIncrease(samples)};
  times.us.reserve(samples.size());
  for (const Sample& sample : samples) {
    times.us.push_back(times.deviceClock ? sample.device.time_us : sample.tick * header.tickPeriod_us);
  }
  return times;
}

std::int64_t recordedDuration_us(const TrialHeader& header, std::span<const Sample> samples) {
  if (samples.empty()) {
    return 0;
  }
  const Sample& first = samples.front();
  const Sample& last = samples.back();
  const std::int64_t span_us = stampsIncrease(samples) ? last.device.time_us - first.device.time_us
                                                       : (last.tick - first.tick) * header.tickPeriod_us;
  return span_us + header.tickPeriod_us;
}

std::vector<double> targetsInForce(const TrialHeader& header, std::span<const Sample> samples) {
  std::vector<double> targets;
  targets.reserve(samples.size());
  double target_rad = header.targetAngle_rad;
  for (const Sample& sample : samples) {
    if (sample.command.kind == ServoCommand::Kind::kSetTarget) {
      target_rad = sample.command.value;
    }
    targets.push_back(target_rad);
  }
  return targets;
}

std::vector<RecordedTwist> recordedTwists(std::span<const Sample> samples,
                                          std::span<const std::int64_t> times_us,
                                          std::span<const double> targets_rad) {
  TORSIO_EXPECTS(times_us.size() == samples.size() && targets_rad.size() == samples.size());
  std::vector<RecordedTwist> twists;
  for (std::size_t i = 0; i < samples.size();) {
    if (!isIn(samples, i, ExercisePhase::kTwisting)) {
      ++i;
      continue;
    }
    RecordedTwist twist;
    twist.first = i;
    double largest_rad = 0.0;
    for (; isIn(samples, i, ExercisePhase::kTwisting); ++i) {
      largest_rad = std::max(largest_rad, std::abs(samples[i].response.angle_rad));
    }
    twist.letGo = i;
    while (isIn(samples, i, ExercisePhase::kReleased)) {
      ++i;
    }
    twist.end = i;
    if (largest_rad < kSmallestTwist_rad) {
      continue;
    }
    twist.target_rad = targets_rad[twist.letGo - 1];
    twist.releasedAt_rad = samples[twist.letGo - 1].response.angle_rad;
    twist.ending = endingOf(samples, times_us, twist.letGo);
    twists.push_back(twist);
  }
  return twists;
}

std::size_t onTargetSince(const RecordedTwist& twist, std::span<const Sample> samples, double tolerance_rad) {
  std::size_t since = twist.letGo;
  while (since > twist.first &&
         std::abs(samples[since - 1].response.angle_rad - twist.target_rad) <= tolerance_rad) {
    --since;
  }
  return since;
}

}  // namespace torsio
