// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "sim/tissue/rod/rod_pose.h"

namespace torsio {

/// Spring between a point of a section and a place of the world: energy stiffness/2 (|x + R arm - anchor| -
/// slack)^2, only while it is longer than its slack. Slack 0 is a pin, more is a ligament.
struct PointSpring {
  int node = 0;
  Vec3 arm_m;     ///< the point, in the axes of the section
  Vec3 anchor_m;  ///< the place, world frame
  double slack_m = 0.0;
  double stiffness_N_per_m = 0.0;
};

/// Spring that turns a section back to an orientation: energy stiffness/2 |4 sigma(orientation* q)|^2, where
/// 4 |sigma| = 4 tan(angle / 4).
struct TurnSpring {
  int node = 0;
  Quat orientation;
  double stiffness_Nm_per_rad = 0.0;
};

/// A node some of whose freedoms are held where the pose has them: x, y, z of the world, turns about its own
/// e1, e2, t.
struct HeldNode {
  int node = 0;
  std::array<bool, 6> freedoms{true, true, true, true, true, true};
};

/// All that holds a rod.
struct RodRestraints {
  std::vector<PointSpring> points;
  std::vector<TurnSpring> turns;
  std::vector<HeldNode> held;
};

}  // namespace torsio
