// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/tool_pose.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "sim/servo/tool_touch.h"

namespace torsio::gui {

namespace {

constexpr double kParkingWay_m = 0.020;
constexpr double kParkingStep_m = 0.002;
constexpr double kFarthestParking_m = 0.300;
constexpr int kParkingTurns = 12;
constexpr double kInsideEnd = 0.04;  // a section at the very end is too small to point at
const Vec3 kTowardsViewer{0.0, -1.0, 0.0};

/// Returns the possible initial states of an organ; one that comes twisted may have any angle.
std::vector<OrganState> possibleStates(const Scene& scene) {
  std::vector<OrganState> ways{OrganState{}};
  if (scene.hollow) {
    for (int i = 1; i < kParkingTurns; ++i) {
      ways.push_back(scene.stateAt(2.0 * std::numbers::pi * i / kParkingTurns));
    }
  }
  return ways;
}

}  // namespace

Vec3 parkingPoint_m(const Scene& scene) {
  const double share = std::clamp(scene.pattern.graspArc, kInsideEnd, 1.0 - kInsideEnd);
  const Vec3 centre_m = scene.lattice().frameAt(share * scene.lattice().length_m()).centre_m;
  const std::vector<OrganState> lies = possibleStates(scene);
  for (double way_m = 0.0; way_m < kFarthestParking_m; way_m += kParkingStep_m) {
    const Vec3 point_m = centre_m + kTowardsViewer * way_m;
    const bool clear = std::ranges::all_of(lies, [&](const OrganState& organ) {
      return nearestSurface(point_m, scene, organ).distance_m >= kParkingWay_m;
    });
    if (clear) {
      return point_m;
    }
  }
  return centre_m + kTowardsViewer * kFarthestParking_m;
}

}  // namespace torsio::gui
