// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/posed_states.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "app/services/recording/recorded_run.h"
#include "sim/core/contracts.h"
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

constexpr double kNearlyLost = 0.95;  // ischaemic dose
constexpr double kLongest_s = 12.0 * 3600.0;
constexpr double kStep_s = 600.0;

/// Blood of an organ, and how long it has been twisted.
struct TwistHistory {
  PerfusionState blood;
  double since_s = 0.0;
};

double angleOf(const HollowOrgan& organ, UntwistingState state) {
  const Detorsion& detorsion = organ.detorsion();
  const double pressure_Pa = detorsion.wall.pressure_Pa;
  const double most_rad = detorsion.start.most_rad;
  switch (state) {
    case UntwistingState::kOnset:
      return organ.tube(0) != nullptr ? std::min(organ.onset_rad(pressure_Pa), most_rad) : 0.25 * most_rad;
    case UntwistingState::kClosed:
      return organ.tube(0) != nullptr ? std::min(organ.shut_rad(pressure_Pa), most_rad) : 0.5 * most_rad;
    case UntwistingState::kIschaemic:
      return most_rad;
    case UntwistingState::kRest:
    case UntwistingState::kRecovered:
      break;
  }
  return 0.0;
}

/// Returns the blood of an organ that has been twisted until it is nearly lost, or for long if that harms it
/// little.
TwistHistory twistedUntilNearlyLost(const HollowOrgan& organ) {
  const Detorsion& detorsion = organ.detorsion();
  const double pressure_mmHg = detorsion.wall.pressure_Pa / kPascalsPerMmHg;
  TwistHistory history;
  while (history.since_s + kStep_s <= kLongest_s && history.blood.dose < kNearlyLost) {
    history.since_s += kStep_s;
    history.blood = organ.vessels().after(detorsion.start.most_rad, pressure_mmHg, history.since_s);
  }
  return history;
}

void putBlood(const PerfusionState& blood, HollowPose& pose) {
  pose.reading.flow = blood.flow;
  pose.reading.dose = blood.dose;
  pose.congestion = blood.congestion;
  pose.saturation = blood.saturation;
}

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
    state.pose = organ.pose;
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

LiveState untwistingState(const Scene& scene, UntwistingState state) {
  TORSIO_EXPECTS(scene.comesTwisted());
  const HollowOrgan& organ = *scene.hollow;
  const Detorsion& detorsion = organ.detorsion();
  LiveState live = scriptedTwist(scene, detorsion.start.sign * angleOf(organ, state));
  HollowPose& pose = live.hollow;
  if (state == UntwistingState::kIschaemic) {
    const TwistHistory history = twistedUntilNearlyLost(organ);
    putBlood(history.blood, pose);
    pose.scaled_s = history.since_s;
  } else if (state == UntwistingState::kRecovered) {
    TwistHistory history = twistedUntilNearlyLost(organ);
    const double back_s = 20.0 * detorsion.vessels.flowTime_s;
    organ.vessels().step(history.blood, 0.0, 0.0, back_s);
    putBlood(history.blood, pose);
    pose.scaled_s = history.since_s + back_s;
    pose.reading.pressure_Pa =
        detorsion.wall.vent ? detorsion.wall.ventedPressure_Pa : detorsion.wall.restPressure_Pa;
    pose.reading.patency = organ.patency(0.0, pose.reading.pressure_Pa);
  } else if (state == UntwistingState::kRest) {
    pose.reading.pressure_Pa = detorsion.wall.restPressure_Pa;
  }
  return live;
}

}  // namespace torsio::gui
