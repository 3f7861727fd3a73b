// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/scripted_twist.h"

#include <cmath>

#include "sim/base/latest_value.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/servo_loop.h"

namespace torsio::gui {

namespace {

constexpr std::int64_t kTick_us = 1000;
constexpr double kLongestTrial_s = 30.0;
constexpr double kLeastTarget_rad = 1e-3;
// An instructor's hand: nothing left to learn.
const HandProfile kPractised{.initialSkill = 1.0, .finalSkill = 1.0, .learningTime_min = 1.0};

}  // namespace

LiveState scriptedTwist(const Scene& scene, double target_rad) {
  const bool turns = std::abs(target_rad) > kLeastTarget_rad;
  ScriptedHandOptions hand;
  hand.task = handTask(scene);
  hand.task.targetAngle_rad = turns ? target_rad : kLeastTarget_rad;
  hand.profile = kPractised;
  hand.duration_s = kLongestTrial_s;
  ScriptedHand device(hand);
  LatestValue<LiveState> live;
  ServoOptions options;
  options.targetAngle_rad = target_rad;
  ServoLoop loop({.device = &device, .scene = &scene, .live = &live}, options);

  LiveState best;
  double nearest_rad = std::abs(target_rad) + 1.0;
  for (std::int64_t time_us = 0; time_us < static_cast<std::int64_t>(kLongestTrial_s * 1e6);
       time_us += kTick_us) {
    loop.tick(time_us);
    const LiveState& state = live.latest();
    const bool held = state.phase == ExercisePhase::kTwisting;
    const double away_rad = std::abs(state.response.angle_rad - target_rad);
    if (held && away_rad < nearest_rad) {
      best = state;
      nearest_rad = away_rad;
    }
    const bool over = state.phase == ExercisePhase::kReleased;
    if (over || (device.cycles() > 0 && static_cast<double>(time_us) * 1e-6 > device.span_s(0)[1])) break;
  }
  return best;
}

}  // namespace torsio::gui
