// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/forearm_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/portable_math.h"

namespace torsio {

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
