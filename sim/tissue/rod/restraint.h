// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "sim/core/organ_pose.h"

namespace torsio {

/// Spring between a point of a section and a place of the world: energy stiffness/2 (|x + R arm - anchor| -
/// slack)^2, only while it is longer than its slack. Slack 0 is a pin, more is a ligament.
struct PointSpring {
  int node = 0;
  Vec3 arm_m{};     ///< the point, in the axes of the section
  Vec3 anchor_m{};  ///< the place, world frame
  double slack_m = 0.0;
  double stiffness_N_per_m = 0.0;
};

/// Spring that turns a section back to an orientation: energy stiffness/2 |4 sigma(orientation* q)|^2, where
/// 4 |sigma| = 4 tan(angle / 4).
struct TurnSpring {
  int node = 0;
  Quat orientation{};
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

/// A run of neighbouring nodes.
struct NodeRange {
  int first = 0;
  int last = 0;
  [[nodiscard]] constexpr int count() const noexcept { return last - first + 1; }
};

/// Returns the nodes within `halfWidth_m` of arc length `arc_m`, `most` at most and one at least, of a rod of
/// `elements`. What holds a section is spread over the nodes within half its radius: a single
/// node that carries a point load kinks. Real time.
template <typename Elements>
[[nodiscard]] constexpr NodeRange nodesAround(const Elements& elements, double arc_m, double halfWidth_m,
                                              int most) noexcept {
  NodeRange range{.first = 0, .last = -1};
  int nearest = 0;
  double nearest_m = 1e300;
  double at_m = 0.0;
  int node = 0;
  const auto look = [&] {
    const double apart_m = at_m < arc_m ? arc_m - at_m : at_m - arc_m;
    if (apart_m < nearest_m) {
      nearest = node;
      nearest_m = apart_m;
    }
    if (apart_m <= halfWidth_m * (1.0 + 1e-9)) {
      range = {.first = range.last < 0 ? node : range.first, .last = node};
    }
  };
  look();
  for (const auto& e : elements) {
    at_m += e.length_m;
    ++node;
    look();
  }
  if (range.last < 0) {
    return {.first = nearest, .last = nearest};
  }
  while (range.count() > most) {  // give away the end that lies further from the middle of the patch
    if (nearest - range.first > range.last - nearest) {
      ++range.first;
    } else {
      --range.last;
    }
  }
  return range;
}

/// A spring of a point of the organ, shared alike by the nodes of a patch.
struct PatchSpring {
  NodeRange nodes{};
  Vec3 point_m{};   ///< at rest, world frame
  Vec3 anchor_m{};  ///< world frame
  double slack_m = 0.0;
  double stiffness_N_per_m = 0.0;
};

/// Adds the point springs of a patch on `rest`.
void addPatchSpring(const PatchSpring& spring, const RodPose& rest, RodRestraints& restraints);

/// Adds turn springs of `stiffness_Nm_per_rad` in sum towards the orientations at rest of `nodes`.
void addPatchTurn(NodeRange nodes, double stiffness_Nm_per_rad, const RodPose& rest,
                  RodRestraints& restraints);

}  // namespace torsio
