// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/grasper.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/anatomy/curves.h"
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
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back({count * n, next, i});
    for (std::uint32_t r = 0; r + 1 < count; ++r) {
      const std::uint32_t a = r * n + i;
      const std::uint32_t b = r * n + next;
      mesh.triangles.push_back({a, b, b + n});
      mesh.triangles.push_back({a, b + n, a + n});
    }
    mesh.triangles.push_back({(count - 1) * n + i, (count - 1) * n + next, count * n + 1});
  }
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

}  // namespace torsio
