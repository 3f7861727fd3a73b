// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/forearm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "sim/anatomy/curves.h"
#include "sim/anatomy/remesh.h"
#include "sim/anatomy/tube.h"
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

namespace {

constexpr double kExponent = 2.3;  // of the superellipse
constexpr std::array<double, 9> kGirthAt{0, .10, .22, .35, .50, .65, .80, .92, 1};

double power(double x, double exponent) {
  return x > 0.0 ? portableExp(exponent * portableLog(x)) : 0.0;
}

// Girth of a superellipse with half axes `ratio` and 1.
double unitGirth(double ratio) {
  constexpr int kSides = 512;
  const auto at = [ratio](int i) {
    const SinCos a = portableSinCos(2.0 * kPi * i / kSides);
    const auto axis = [](double c) { return (c < 0.0 ? -1.0 : 1.0) * power(std::abs(c), 2.0 / kExponent); };
    return Vec3{ratio * axis(a.cos), axis(a.sin), 0.0};
  };
  double girth = 0.0;
  for (int i = 0; i < kSides; ++i) {
    girth += norm(at(i + 1) - at(i));
  }
  return girth;
}

// Sections of the palm: shares of its length, of the hand's breadth and of its thickness.
struct PalmRow {
  double length, breadth, thickness;
};
constexpr std::array<PalmRow, 5> kPalm{
    {{0.21, 0.75, 1.38}, {0.43, 0.86, 1.20}, {0.65, 0.97, 1.07}, {0.79, 1.0, 1.0}, {0.93, 0.96, 0.86}}};

// A curve over the height above the elbow, from the rows of the forearm and of the palm.
MonotoneCurve alongArm(const ArmMeasures& m, const std::function<double(std::size_t)>& forearm,
                       const std::function<double(const PalmRow&)>& palm) {
  std::vector<double> height(kGirthAt.size() + kPalm.size());
  std::vector<double> value(height.size());
  for (std::size_t i = 0; i < height.size(); ++i) {
    const bool onForearm = i < kGirthAt.size();
    const PalmRow& row = kPalm[onForearm ? 0 : i - kGirthAt.size()];
    height[i] =
        onForearm ? kGirthAt[i] * m.forearmLength_mm : m.forearmLength_mm + row.length * m.palmLength_mm;
    value[i] = onForearm ? forearm(i) : palm(row);
  }
  return {std::move(height), std::move(value)};
}

MonotoneCurve halfWidths(const ArmMeasures& m) {
  return alongArm(
      m, [&m](std::size_t i) { return m.widthToDepth[i] * m.girth_mm[i] / unitGirth(m.widthToDepth[i]); },
      [&m](const PalmRow& row) { return 0.5 * row.breadth * m.handBreadth_mm; });
}

MonotoneCurve halfDepths(const ArmMeasures& m) {
  return alongArm(
      m, [&m](std::size_t i) { return m.girth_mm[i] / unitGirth(m.widthToDepth[i]); },
      [&m](const PalmRow& row) { return 0.5 * row.thickness * m.handThickness_mm; });
}

// A finger from its crease at `crease`, splayed by `splay` towards the thumb, bent towards the palm.
std::vector<RoundCone> finger(const Vec3& crease, double splay_rad, double length, double radiusRoot,
                              double radiusTip) {
  constexpr std::array<double, 3> kSegments{0.45, 0.29, 0.26};
  constexpr std::array<double, 3> kBend{radians(15), radians(35),
                                        radians(45)};  // 15, 20, 10 one after another
  constexpr double kRoot = 24.0;                       // how far the finger reaches into the palm
  const SinCos splay = portableSinCos(splay_rad);
  const Vec3 straight{splay.sin, 0.0, splay.cos};
  std::vector<RoundCone> cones{{crease - kRoot * straight, crease, radiusRoot, radiusRoot}};
  double share = 0.0;
  for (std::size_t k = 0; k < kSegments.size(); ++k) {
    const SinCos bend = portableSinCos(kBend[k]);
    const Vec3 direction = bend.cos * straight + bend.sin * Vec3{0, -1, 0};
    const double end = share + kSegments[k];
    const double segment = length * kSegments[k] - (k == 2 ? radiusTip : 0.0);
    const auto radius = [=](double s) { return radiusRoot + s * (radiusTip - radiusRoot); };
    cones.push_back({cones.back().b, cones.back().b + segment * direction, radius(share), radius(end)});
    share = end;
  }
  return cones;
}

}  // namespace

void setWrist(ArmMeasures& measures, double width_mm, double thickness_mm) {
  constexpr double kFlatFrom = 0.5;  // of the way to the wrist
  const double ratio = width_mm / thickness_mm;
  const double flatter = ratio / measures.widthToDepth.back();
  const double thicker = 0.5 * thickness_mm * unitGirth(ratio) / measures.girth_mm.back();
  for (std::size_t i = 0; i < kGirthAt.size(); ++i) {
    const double share = std::clamp((kGirthAt[i] - kFlatFrom) / (1.0 - kFlatFrom), 0.0, 1.0);
    measures.widthToDepth[i] *= 1.0 + share * (flatter - 1.0);
    measures.girth_mm[i] *= thicker;
  }
}

ArmShape::ArmShape(const ArmMeasures& m)
    : wristZ_(m.forearmLength_mm), halfWidth_(halfWidths(m)), halfDepth_(halfDepths(m)), palmEndZ_(0.0) {
  const double z = wristZ_;
  const double palm = m.palmLength_mm;
  const double w = m.handBreadth_mm / 88.0;    // the shape below was drawn for a breadth of 88 mm
  const double b = m.girth_mm.back() / 176.0;  // and the bones of the wrist for this girth
  palmEndZ_ = z + 0.95 * palm;
  struct Root {
    double x, height, splay_deg, radiusRoot, radiusTip;
  };
  constexpr std::array<Root, 4> kRoots{{{33.3, 0.95, 8.0, 9.1, 7.3},
                                        {11.2, 1.00, 2.2, 9.3, 7.5},
                                        {-11.2, 0.96, -4.2, 9.0, 7.2},
                                        {-32.4, 0.86, -12.0, 8.1, 6.4}}};
  for (std::size_t k = 0; k < kRoots.size(); ++k) {
    const Root& r = kRoots[k];
    const Vec3 crease{w * r.x, 0.0, z + r.height * palm};
    fingers_[k] =
        finger(crease, radians(r.splay_deg), m.fingerLength_mm[k + 1], w * r.radiusRoot, w * r.radiusTip);
    const Vec3 knuckle{0.93 * w * r.x, 7.5, crease.z - 0.18 * palm};
    knuckles_[k] = {knuckle, knuckle + Vec3{0, 0, 6}, 8.5 * w, 7.5 * w};
  }
  const double thumb = m.fingerLength_mm[0];
  const Vec3 base{w * 20, -8, z + 14};
  const Vec3 joint = base + 46.0 * normalized(Vec3{0.64, -0.34, 0.69});
  const Vec3 middle = joint + 0.57 * thumb * normalized(Vec3{0.52, -0.26, 0.82});
  const Vec3 tip = middle + (0.43 * thumb - 8.5 * w) * normalized(Vec3{0.36, -0.24, 0.90});
  thumb_ = {{base, joint, 15.0 * w, 12.2 * w},
            {joint, middle, 12.0 * w, 10.8 * w},
            {middle, tip, 10.8 * w, 8.5 * w}};
  eminences_ = {{{w * 14, -9, z + 20}, {w * 34, -16, z + 44}, 14.0 * w, 14.5 * w},          // thenar
                {{w * -22, -5, z + 24}, {w * -31, -3, z + 72}, 13.0 * w, 12.0 * w},         // hypothenar
                {{b * -20, b * 12, z - 22}, {b * -21, b * 13, z - 12}, 9.5 * b, 10.5 * b},  // ulnar head
                {{b * 24, b * 1, z - 16}, {b * 25, b * 1, z - 4}, 9.0 * b, 9.5 * b}};       // radial styloid
}

double ArmShape::tube(const Vec3& p) const {
  const double a = halfWidth_(p.z);
  const double b = halfDepth_(p.z);
  const double u = std::abs(p.x) / a;
  const double v = std::abs(p.y) / b;
  const double pu = power(u, kExponent - 1.0);
  const double pv = power(v, kExponent - 1.0);
  const double sum = pu * u + pv * v;
  constexpr double kCentre = 1e-6;
  double side = -std::min(a, b);
  if (sum > kCentre) {
    // (g - 1) / |grad g| with g = (u^n + v^n)^(1/n): the distance to first order.
    const double g = power(sum, 1.0 / kExponent);
    const double slope = g / sum * std::sqrt(pu * pu / (a * a) + pv * pv / (b * b));
    side = (g - 1.0) / slope;
  }
  constexpr double kRounding = 14.0;
  return -joined(-side, palmEndZ_ - p.z, kRounding);  // the tube ends at the roots of the fingers
}

double ArmShape::operator()(const Vec3& p) const {
  constexpr double kFleshy = 12.0;  // widths of the roundings, mm
  constexpr double kBony = 8.0;
  constexpr double kWebs = 8.0;
  constexpr double kJoints = 3.0;
  constexpr double kRim = 5.0;
  double d = tube(p);
  for (std::size_t k = 0; k < eminences_.size(); ++k) {
    d = joined(d, distanceTo(eminences_[k], p), k < 2 ? kFleshy : kBony);
  }
  constexpr double kHandBegins = 45.0;  // below the wrist crease nothing of the hand is felt any more
  if (p.z > wristZ_ - kHandBegins) {
    double hand = std::numeric_limits<double>::max();
    for (const std::vector<RoundCone>& f : fingers_) {
      hand = joined(hand, joinedChain(f, p, kJoints), kWebs);
    }
    d = joined(d, hand, kBony);
    for (const RoundCone& knuckle : knuckles_) {
      d = joined(d, distanceTo(knuckle, p), kBony);
    }
    d = joined(d, joinedChain(thumb_, p, kBony), kFleshy);
  }
  return -joined(-d, p.z, kRim);  // cut at the elbow
}

}  // namespace torsio
