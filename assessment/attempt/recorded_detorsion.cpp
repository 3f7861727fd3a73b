// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/recorded_detorsion.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "assessment/metrics/signal.h"
#include "sim/core/contracts.h"
#include "sim/core/device_sample.h"

namespace torsio {

namespace {

constexpr std::uint32_t kHandLost = kDeviceLost | kDeviceUncalibrated;

/// Returns the closure of the jaw; a button closes it fully.
double closure(const DeviceSample& device) noexcept {
  const bool grips = (device.buttons & kButtonGrip) != 0;
  return grips ? 1.0 : std::clamp(static_cast<double>(device.grip) * kGripStep, 0.0, 1.0);
}

std::vector<DetorsionTick> ticksOf(std::span<const Sample> samples, std::span<const std::int64_t> times_us,
                                   const DetorsionRules& rules,
                                   const std::function<double(const Sample&)>& peakShear_Pa) {
  std::vector<DetorsionTick> ticks;
  ticks.reserve(samples.size());
  RecordedSwitches switches;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    switches.obey(sample);
    DetorsionTick tick{.time_us = times_us[i],
                       .angle_rad = sample.response.angle_rad,
                       .patency = sample.hollow.patency,
                       .flow = sample.hollow.flow,
                       .dose = sample.hollow.dose,
                       .force_N = norm(sample.response.force_N),
                       .jaw_Pa = rules.jaw_Pa * closure(sample.device),
                       .held = sample.phase == ExercisePhase::kTwisting,
                       .clipped = switches.clipped(),
                       .handGone = (sample.device.status & kHandLost) != 0,
                       .venting = switches.venting()};
    if (peakShear_Pa) {
      tick.shear_Pa = peakShear_Pa(sample);
    }
    ticks.push_back(tick);
  }
  return ticks;
}

}  // namespace

void RecordedSwitches::obey(const Sample& sample) noexcept {
  const bool pressed = (sample.device.buttons & kButtonSecond) != 0;
  if (sample.command.kind == ServoCommand::Kind::kHoldOrgan) {
    clipped_ = sample.command.value != 0.0;
  } else if (pressed && !pressed_ && atOrgan_) {
    clipped_ = !clipped_;
  }
  if (sample.command.kind == ServoCommand::Kind::kVent) {
    venting_ = sample.command.value != 0.0;
  }
  pressed_ = pressed;
  atOrgan_ = sample.phase == ExercisePhase::kContact || sample.phase == ExercisePhase::kTwisting;
}

bool comesTwisted(std::span<const Sample> samples) noexcept {
  return !samples.empty() && areOfDetorsion(samples.front().rules);
}

Outcome<DetorsionMetrics> measureRecordedDetorsion(
    std::span<const Sample> samples, std::span<const std::int64_t> times_us,
    const std::optional<DetorsionRules>& rules,
    const std::function<double(const Sample& sample)>& peakShear_Pa) {
  TORSIO_EXPECTS(times_us.size() == samples.size());
  if (!rules) {
    return Outcome<DetorsionMetrics>::undefined(Text::tr("the limits of the exercise are not known"));
  }
  if (samples.size() < 2) {
    return Outcome<DetorsionMetrics>::undefined(Text::tr("there are fewer than two samples"));
  }
  if (!longGaps(times_us).empty()) {
    return Outcome<DetorsionMetrics>::undefined(Text::tr("samples are missing for more than 20 ms"));
  }
  return measureDetorsion(ticksOf(samples, times_us, *rules, peakShear_Pa), *rules);
}

}  // namespace torsio
