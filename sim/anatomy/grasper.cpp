// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/grasper.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "sim/anatomy/curves.h"
#include "sim/anatomy/remesh.h"
#include "sim/anatomy/round_cone.h"
#include "sim/anatomy/tube.h"
#include "sim/core/angle.h"
#include "sim/core/portable_math.h"

namespace torsio {

namespace {

// Joins closed outlines of equally many points, one behind the other, and closes both ends with a fan about
// their middle. Outlines run anticlockwise seen from +z, heights ascend.
TriangleMesh loft(const std::vector<std::vector<Vec3>>& outlines) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(outlines.front().size());
  const auto count = static_cast<std::uint32_t>(outlines.size());
  for (const std::vector<Vec3>& outline : outlines) {
    mesh.vertices_m.insert(mesh.vertices_m.end(), outline.begin(), outline.end());
  }
  for (const std::vector<Vec3>& end : {outlines.front(), outlines.back()}) {
    Vec3 middle;
    for (const Vec3& p : end) {
      middle += p / static_cast<double>(n);
    }
    mesh.vertices_m.push_back(middle);
  }
  joinRings(mesh, n, count);
  return mesh;
}

std::vector<Vec3> circle(double radius_mm, double z_mm) {
  constexpr int kSides = 24;
  std::vector<Vec3> outline;
  for (int i = 0; i < kSides; ++i) {
    const SinCos a = portableSinCos(2.0 * kPi * i / kSides);
    outline.push_back(kMillimetre_m * Vec3{radius_mm * a.cos, radius_mm * a.sin, z_mm});
  }
  return outline;
}

// Half a disc above y = `bite_mm`: the back is round, the biting face flat.
std::vector<Vec3> halfDisc(double radius_mm, double bite_mm, double z_mm) {
  constexpr int kBack = 10;
  std::vector<Vec3> outline;
  for (int i = 0; i <= kBack; ++i) {
    const SinCos a = portableSinCos(kPi * i / kBack);
    outline.push_back(kMillimetre_m * Vec3{radius_mm * a.cos, bite_mm + (radius_mm - bite_mm) * a.sin, z_mm});
  }
  constexpr int kFace = 4;
  for (int i = 1; i < kFace; ++i) {
    const double x = -radius_mm + 2.0 * radius_mm * i / kFace;
    outline.push_back(kMillimetre_m * Vec3{x, bite_mm, z_mm});
  }
  return outline;
}

TriangleMesh upperJaw(double pivot_mm) {
  constexpr double kTooth_mm = 1.0;
  constexpr double kLow_mm = 0.08;  // the jaws do not touch when closed
  constexpr double kHigh_mm = 0.45;
  constexpr double kTipRadius_mm = 1.5;
  constexpr double kRootRadius_mm = 2.3;
  std::vector<std::vector<Vec3>> outlines;
  outlines.push_back(halfDisc(0.6, kLow_mm, 0.0));
  outlines.push_back(halfDisc(1.2, kLow_mm, 0.4));
  const int teeth = static_cast<int>(pivot_mm / kTooth_mm) - 3;
  for (int i = 0; i <= 2 * teeth; ++i) {
    const double z = 1.0 + 0.5 * kTooth_mm * i;
    const double radius = kTipRadius_mm + (kRootRadius_mm - kTipRadius_mm) * z / pivot_mm;
    outlines.push_back(halfDisc(radius, i % 2 == 0 ? kLow_mm : kHigh_mm, z));
  }
  outlines.push_back(halfDisc(kRootRadius_mm, kLow_mm, pivot_mm));
  outlines.push_back(halfDisc(kRootRadius_mm, kLow_mm, pivot_mm + 2.0));
  return loft(outlines);
}

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

Grasper makeGrasper() {
  constexpr double kPivot_mm = 20.0;
  constexpr double kRadius_mm = 2.5;
  constexpr double kLength_mm = 250.0;
  Grasper grasper;
  // A shaft with a bevelled front; it begins behind the hinge.
  std::vector<std::vector<Vec3>> outlines{circle(1.9, kPivot_mm - 0.5), circle(kRadius_mm, kPivot_mm + 1.0)};
  constexpr double kPiece_mm = 22.8;
  for (double z = kPivot_mm + 1.0 + kPiece_mm; z < kLength_mm - 1.0; z += kPiece_mm) {
    outlines.push_back(circle(kRadius_mm, z));
  }
  outlines.push_back(circle(kRadius_mm, kLength_mm));
  grasper.shaft = loft(outlines);
  grasper.upperJaw = upperJaw(kPivot_mm);
  grasper.lowerJaw = grasper.upperJaw;
  for (Vec3& v : grasper.lowerJaw.vertices_m) {
    v = {-v.x, -v.y, v.z};  // half a turn about the shaft
  }
  grasper.jawPivot_m = {0, 0, kMillimetre_m * kPivot_mm};
  grasper.shaftLength_m = kMillimetre_m * kLength_mm;
  grasper.shaftRadius_m = kMillimetre_m * kRadius_mm;
  grasper.jawOpening_rad = radians(25.0);
  return grasper;
}

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
