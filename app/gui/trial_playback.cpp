// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trial_playback.h"

#include <algorithm>
#include <cmath>

#include "sim/base/contracts.h"
#include "sim/base/error.h"
#include "sim/record/sample_codec.h"

namespace torsio::gui {

TrialPlayback::TrialPlayback(const Trial& trial) : header_(trial.header), samples_(decodeTrial(trial)) {
  if (samples_.empty()) {
    throw Error(ErrorCode::kBadData, "the recording is empty", Text("trial %1", header_.trialId),
                "Choose another recording");
  }
  double target_rad = header_.targetAngle_rad;
  targets_rad_.reserve(samples_.size());
  for (const Sample& sample : samples_) {
    if (sample.command.kind == ServoCommand::Kind::kSetTarget) target_rad = sample.command.value;
    targets_rad_.push_back(target_rad);
  }
}

std::int64_t TrialPlayback::duration_us() const noexcept {
  return samples_.back().device.time_us - samples_.front().device.time_us;
}

void TrialPlayback::seek_us(std::int64_t position_us) noexcept {
  position_us_ = std::clamp<std::int64_t>(position_us, 0, duration_us());
}

void TrialPlayback::setPlaying(bool playing) noexcept {
  if (playing && position_us_ >= duration_us()) position_us_ = 0;
  playing_ = playing;
}

void TrialPlayback::setSpeed(double speed) {
  TORSIO_EXPECTS(std::isfinite(speed) && speed > 0.0);
  speed_ = speed;
}

void TrialPlayback::advance(double elapsed_s) noexcept {
  if (!playing_) return;
  seek_us(position_us_ + std::llround(elapsed_s * speed_ * 1e6));
  if (position_us_ >= duration_us()) playing_ = false;
}

const Sample& TrialPlayback::sample() const noexcept {
  const std::int64_t time_us = samples_.front().device.time_us + position_us_;
  const auto after = std::upper_bound(samples_.begin(), samples_.end(), time_us,
                                      [](std::int64_t t, const Sample& s) { return t < s.device.time_us; });
  return after == samples_.begin() ? samples_.front() : *(after - 1);
}

LiveState TrialPlayback::state() const noexcept {
  const Sample& now = sample();
  const ToolState tool = toolState(now.device);
  LiveState state;
  state.time_us = now.device.time_us;
  state.tick = now.tick;
  state.tool = tool.pose;
  state.grip = tool.grip;
  state.phase = now.phase;
  state.response = now.response;
  state.force_N = now.force_N;
  state.limits = now.limits;
  state.targetAngle_rad = targets_rad_[static_cast<std::size_t>(&now - samples_.data())];
  return state;
}

}  // namespace torsio::gui
