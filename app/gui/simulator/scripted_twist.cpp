// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/scripted_twist.h"

#include <cmath>
#include <memory>
#include <utility>

#include "app/services/recording/recorded_run.h"
#include "sim/core/time_units.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/scene/hollow_organ.h"
#include "sim/servo/hand_task.h"

namespace torsio::gui {

namespace {

constexpr double kLongestTrial_s = 30.0;
constexpr double kLeastTarget_rad = 1e-3;
// An instructor's hand, with nothing left to learn.
const HandProfile kPractised{.initialSkill = 1.0, .finalSkill = 1.0, .learningTime_min = 1.0};

}  // namespace

LiveState scriptedTwist(const Scene& scene, double target_rad) {
  const bool turns = std::abs(target_rad) > kLeastTarget_rad;
  ScriptedHandOptions options;
  options.task = handTask(scene, turns ? target_rad : kLeastTarget_rad);
  options.profile = kPractised;
  options.duration_s = kLongestTrial_s;
  auto hand = std::make_unique<ScriptedHand>(options);
  const double ends_s = hand->cycles() > 0 ? hand->span_s(0)[1] : kLongestTrial_s;
  RecordedRun run(borrowed(scene), std::move(hand), {.targetAngle_rad = target_rad}, nullptr);

  if (scene.hollow) {  // comes twisted: returned at this angle, without the hand
    run.step();
    LiveState state = run.latest();
    const OrganState organ = scene.stateAt(target_rad);
    state.response.angle_rad = organ.twist.graspAngle_rad;
    state.response.graspArc_m = organ.twist.graspArc_m;
    state.hollow = organ.hollow;
    return state;
  }
  LiveState best;
  double nearest_rad = std::abs(target_rad) + 1.0;
  for (std::int64_t tick = 0; tick < ticksIn(kLongestTrial_s); ++tick) {
    run.step();
    const LiveState& state = run.latest();
    const bool held = state.phase == ExercisePhase::kTwisting;
    const double away_rad = std::abs(state.response.angle_rad - target_rad);
    if (held && away_rad < nearest_rad) {
      best = state;
      nearest_rad = away_rad;
    }
    if (state.phase == ExercisePhase::kReleased || spanOf_s(tick) > ends_s) {
      break;
    }
  }
  return best;
}

double usualAngle_rad(const Scene& scene) {
  return scene.hollow ? scene.hollow->start(0).twist.graspAngle_rad : scene.pattern.targetAngle_rad;
}

}  // namespace torsio::gui
