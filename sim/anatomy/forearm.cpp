// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/forearm.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/anatomy/curves.h"
#include "sim/anatomy/forearm_shape.h"
#include "sim/anatomy/marching_tetrahedra.h"
#include "sim/anatomy/millimetre.h"
#include "sim/anatomy/organ_places.h"
#include "sim/anatomy/remesh.h"
#include "sim/core/angle.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/query/collision_mesh.h"

namespace torsio {

namespace {

constexpr double kVoxel_mm = 2.0;  // fingers are further apart than two of them
constexpr double kSlope = 1.35;    // of the field, which is a distance to first order only

TriangleMesh fineSurface(const ArmShape& shape) {
  SampleGrid grid;
  grid.step = kVoxel_mm;
  // The elbow's plane z = 0 lies half way between two layers of the grid.
  grid.origin = {-60.0, -66.0, -3.5 * kVoxel_mm};
  const Vec3 extent{158.0, 124.0, shape.wristZ() + 216.0};
  const auto points = [](double length) { return static_cast<std::size_t>(length / kVoxel_mm) + 2; };
  grid.count = {points(extent.x), points(extent.y), points(extent.z)};
  return zeroSurface(grid, kSlope, [&shape](const Vec3& p) { return shape(p); });
}

// Taubin 1995: a step in, a step out, so that the steps of the grid go and the volume stays.
void smooth(TriangleMesh& mesh, int passes) {
  constexpr std::array<double, 2> kSteps{0.5, -0.53};
  std::vector<std::uint32_t> count(mesh.vertices_m.size(), 0);
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) {
      count[corner] += 2;
    }
  }
  for (int pass = 0; pass < 2 * passes; ++pass) {
    std::vector<Vec3> sum(mesh.vertices_m.size());
    for (const TriangleMesh::Triangle& t : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        sum[t[k]] += mesh.vertices_m[t[(k + 1) % 3]] + mesh.vertices_m[t[(k + 2) % 3]];
      }
    }
    const double step = kSteps[static_cast<std::size_t>(pass % 2)];
    for (std::size_t v = 0; v < sum.size(); ++v) {
      mesh.vertices_m[v] += step * (sum[v] / static_cast<double>(count[v]) - mesh.vertices_m[v]);
    }
  }
}

double ramp(double x, double low, double high) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Finer towards the fingers, whose girth is small, and finest at the webs between them.
double edgeLength_mm(const Vec3& p, double wristZ, double websZ) {
  constexpr double kForearm = 5.0;
  constexpr double kFingers = 2.8;
  constexpr double kWebs = 2.0;
  const double coarse = kForearm + ramp(p.z, wristZ - 30.0, wristZ + 60.0) * (kFingers - kForearm);
  const double nearWebs = 1.0 - ramp(std::abs(p.z - websZ), 6.0, 20.0);
  return coarse + nearWebs * (kWebs - coarse);
}

// The point of the skin that a ray from the axis meets, at height `z` and direction `angle_deg`.
Vec3 skinAt(const ArmShape& shape, double z, double angle_deg) {
  const SinCos a = portableSinCos(radians(angle_deg));
  double inside = 0.0;
  double outside = 80.0;
  for (int i = 0; i < 60; ++i) {
    const double r = 0.5 * (inside + outside);
    (shape({r * a.cos, r * a.sin, z}) < 0.0 ? inside : outside) = r;
  }
  return {inside * a.cos, inside * a.sin, z};
}

std::vector<ArmMarker> placeMarkers(const ArmShape& shape, const TriangleMesh& surface_m) {
  const double wrist = shape.wristZ();
  const Vec3 tip = shape.middleTip();
  struct Place {
    const char* name;
    Vec3 near_mm;
  };
  const std::array<Place, 10> places{
      {{"dorsal forearm, 60 mm from the wrist crease", skinAt(shape, wrist - 60, 90)},
       {"palmar forearm, 60 mm from the wrist crease", skinAt(shape, wrist - 60, 270)},
       {"radial styloid", skinAt(shape, wrist - 8, 0)},
       {"ulnar head", skinAt(shape, wrist - 15, 145)},
       {"dorsal wrist centre", skinAt(shape, wrist - 4, 90)},
       {"palmar wrist crease centre", skinAt(shape, wrist, 270)},
       {"thumb base (first carpometacarpal joint)", shape.thumbBase() + Vec3{25, 0, 0}},
       {"second knuckle (index metacarpal head)", shape.knuckle(0) + Vec3{10, 16, 0}},
       {"fifth knuckle (ulnar border)", shape.knuckle(3) + Vec3{-20, 4, 0}},
       {"tip of the middle finger", tip + 20.0 * normalized(Vec3{0, -0.7, 0.7})}}};
  const CollisionMesh skin(surface_m);
  std::vector<ArmMarker> markers;
  for (const Place& place : places) {
    const Vec3 p = skin.closest(kMillimetre_m * place.near_mm).position_m;
    const double angle_rad = portableAtan2(p.y, p.x);
    markers.push_back({static_cast<int>(markers.size()) + 1, place.name, p, p.z,
                       angle_rad < 0.0 ? angle_rad + 2.0 * kPi : angle_rad});
  }
  return markers;
}

/// The radial side of the forearm, from which angles count.
std::vector<Vec3> radialLine(const ArmShape& shape, const TriangleMesh& surface_m) {
  std::vector<CurveFrame> axis;
  for (int z = 0; z <= static_cast<int>(shape.wristZ()); ++z) {
    axis.push_back({.arc = static_cast<double>(z),
                    .centre = {0, 0, static_cast<double>(z)},
                    .tangent = {0, 0, 1},
                    .e1 = {1, 0, 0},
                    .e2 = {0, 1, 0}});
  }
  return placesOn(surface_m, axis, 0.0, {}).zeroLine_m;
}

}  // namespace

Arm makeArm(const ArmMeasures& measures, double edges) {
  const ArmShape shape(measures);
  TriangleMesh fine = fineSurface(shape);
  constexpr int kSmoothing = 6;
  smooth(fine, kSmoothing);
  Arm arm;
  const double websZ = shape.wristZ() + measures.palmLength_mm;
  arm.surface =
      remeshed(fine, [&](const Vec3& p) { return edges * edgeLength_mm(p, shape.wristZ(), websZ); });
  constexpr double kOnPlane_mm = 1e-6;
  for (Vec3& v : arm.surface.vertices_m) {
    if (std::abs(v.z) < kOnPlane_mm) {
      v.z = 0.0;
    }
    v *= kMillimetre_m;
  }
  arm.wrist_m = {0, 0, kMillimetre_m * shape.wristZ()};
  arm.ridgeZero = {1, 0, 0};
  arm.markers = placeMarkers(shape, arm.surface);
  arm.zeroLine_m = radialLine(shape, arm.surface);
  arm.freeEnd_m = arm.markers.back().position_m;
  for (const Vec3& v : arm.surface.vertices_m) {
    const double turn = portableAtan2(v.y, v.x) / (2.0 * kPi);
    arm.texture.push_back(
        {static_cast<float>(v.z / arm.freeEnd_m.z), static_cast<float>(turn - std::floor(turn))});
  }
  return arm;
}

}  // namespace torsio
