// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/untwisting_states.h"

#include <cmath>

#include "app/gui/simulator/scripted_twist.h"
#include "sim/base/contracts.h"
#include "sim/scene/hollow_organ.h"

namespace torsio::gui {

namespace {

constexpr double kNearlyLost = 0.95;  // dose
constexpr double kLongest_s = 12.0 * 3600.0;
constexpr double kStep_s = 600.0;

double angleOf(const HollowOrgan& organ, UntwistingState state) {
  const Detorsion& detorsion = organ.detorsion();
  const double pressure_Pa = detorsion.wall.pressure_Pa;
  const double most_rad = detorsion.start.most_rad;
  switch (state) {
    case UntwistingState::kOnset:
      return organ.tube(0) != nullptr ? organ.onset_rad(pressure_Pa) : 0.25 * most_rad;
    case UntwistingState::kClosed:
      return organ.tube(0) != nullptr ? organ.closing_rad(pressure_Pa) : 0.5 * most_rad;
    case UntwistingState::kIschaemic:
      return most_rad;
    case UntwistingState::kRest:
    case UntwistingState::kRecovered:
      break;
  }
  return 0.0;
}

/// Blood of an organ that has lain twisted until it is nearly lost, or for long where that harms it little.
PerfusionState starved(const HollowOrgan& organ) {
  const Detorsion& detorsion = organ.detorsion();
  const double pressure_mmHg = detorsion.wall.pressure_Pa / kPascalsPerMmHg;
  PerfusionState blood;
  for (double since_s = kStep_s; since_s <= kLongest_s && blood.dose < kNearlyLost; since_s += kStep_s) {
    blood = organ.vessels().after(detorsion.start.most_rad, pressure_mmHg, since_s);
  }
  return blood;
}

void putBlood(const PerfusionState& blood, HollowPose& pose) {
  pose.reading.flow = blood.flow;
  pose.reading.dose = blood.dose;
  pose.congestion = blood.congestion;
  pose.saturation = blood.saturation;
}

}  // namespace

LiveState untwistingState(const Scene& scene, UntwistingState state) {
  TORSIO_EXPECTS(scene.hollow != nullptr);
  const HollowOrgan& organ = *scene.hollow;
  const Detorsion& detorsion = organ.detorsion();
  LiveState live = scriptedTwist(scene, detorsion.start.sign * angleOf(organ, state));
  HollowPose& pose = live.hollow;
  if (state == UntwistingState::kIschaemic) {
    putBlood(starved(organ), pose);
  } else if (state == UntwistingState::kRecovered) {
    PerfusionState blood = starved(organ);
    organ.vessels().step(blood, 0.0, 0.0, 20.0 * detorsion.vessels.flowTime_s);
    putBlood(blood, pose);
    pose.reading.pressure_Pa =
        detorsion.wall.vent ? detorsion.wall.ventedPressure_Pa : detorsion.wall.restPressure_Pa;
    pose.reading.patency = organ.patency(0.0, pose.reading.pressure_Pa);
  } else if (state == UntwistingState::kRest) {
    pose.reading.pressure_Pa = detorsion.wall.restPressure_Pa;
  }
  return live;
}

}  // namespace torsio::gui
