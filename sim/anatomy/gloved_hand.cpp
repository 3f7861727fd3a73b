// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/gloved_hand.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "sim/anatomy/curves.h"
#include "sim/anatomy/remesh.h"
#include "sim/anatomy/round_cone.h"

namespace torsio {

namespace {

/// All in millimetres. The fingers lie one behind the other along the shaft, the thumb points at the tip.
class HandShape {
 public:
  HandShape() {
    for (std::size_t k = 0; k < fingers_.size(); ++k) {
      const double z = 212.0 + 19.5 * static_cast<double>(k);
      const double size = kFingerSize[k];
      const Vec3 knuckle{22.0, -21.0, z};
      const Vec3 middle{22.0 + 6.0 * size, 6.0 * size, z - 2.0};
      const Vec3 last{9.0 * size, 22.0 * size, z - 3.0};
      const Vec3 tip{-6.0, 16.0 * size, z - 3.0};
      fingers_[k] = {{{knuckle, middle, 10.5 * size, 9.8 * size},
                      {middle, last, 9.6 * size, 8.8 * size},
                      {last, tip, 8.8 * size, 8.0 * size}}};
    }
    thumb_ = {{{{-16, -22, 262}, {-22, -4, 226}, 15.5, 12.5},
               {{-22, -4, 226}, {-15, 13, 206}, 12.0, 10.6},
               {{-15, 13, 206}, {-6, 17, 188}, 10.4, 8.6}}};
    palm_ = {{{{13, -25, 212}, {12, -27, 272}, 14.0, 14.5},
              {{-4, -28, 216}, {-4, -30, 276}, 16.0, 17.5},
              {{-2, -30, 276}, {-6, -40, 318}, 20.0, 25.0}}};
    cuff_ = {{-6, -40, 312}, {-12, -58, 372}, 30.0, 36.0};
    roll_ = {{-6, -40, 309}, {-6.4, -41, 313}, 31.5, 31.5};
  }

  double operator()(const Vec3& p) const {
    constexpr double kJoints = 4.0;
    constexpr double kWebs = 5.0;
    constexpr double kFleshy = 14.0;
    double fingers = std::numeric_limits<double>::max();
    for (const std::array<RoundCone, 3>& finger : fingers_) {
      fingers = joined(fingers, joinedChain(finger, p, kJoints), kWebs);
    }
    double hand = joined(joinedChain(palm_, p, kFleshy), fingers, 9.0);
    hand = joined(hand, joinedChain(thumb_, p, 6.0), 10.0);
    const double sleeve = joined(distanceTo(cuff_, p), distanceTo(roll_, p), 2.0);
    return -joined(-joined(hand, sleeve, 3.0), kEnd - p.z, 4.0);  // the sleeve goes on out of the picture
  }

  static constexpr double kEnd = 366.0;

 private:
  static constexpr std::array<double, 4> kFingerSize{0.98, 1.04, 1.0, 0.88};
  std::array<std::array<RoundCone, 3>, 4> fingers_;
  std::array<RoundCone, 3> thumb_;
  std::array<RoundCone, 3> palm_;
  RoundCone cuff_;
  RoundCone roll_;
};

}  // namespace

TriangleMesh makeGlovedHand() {
  constexpr double kVoxel_mm = 2.5;
  constexpr double kSlope = 1.2;
  constexpr double kEdge_mm = 4.5;
  const HandShape shape;
  SampleGrid grid;
  grid.step = kVoxel_mm;
  grid.origin = {-62.3, -106.1, 168.4};
  const Vec3 extent{110.0, 152.0, 206.0};
  const auto points = [](double length) { return static_cast<std::size_t>(length / kVoxel_mm) + 2; };
  grid.count = {points(extent.x), points(extent.y), points(extent.z)};
  const TriangleMesh fine = zeroSurface(grid, kSlope, [&shape](const Vec3& p) { return shape(p); });
  TriangleMesh hand = remeshed(fine, [](const Vec3&) { return kEdge_mm; });
  for (Vec3& v : hand.vertices_m) {
    v *= kMillimetre_m;
  }
  return hand;
}

}  // namespace torsio
