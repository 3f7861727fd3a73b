// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/untwisting_states.h"

#include <cmath>

#include "app/gui/simulator/scripted_twist.h"
#include "sim/core/contracts.h"
#include "sim/scene/hollow_organ.h"

namespace torsio::gui {

namespace {

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
      return organ.tube(0) != nullptr ? organ.onset_rad(pressure_Pa) : 0.25 * most_rad;
    case UntwistingState::kClosed:
      return organ.tube(0) != nullptr ? organ.shut_rad(pressure_Pa) : 0.5 * most_rad;
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
