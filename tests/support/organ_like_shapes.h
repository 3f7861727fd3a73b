// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "sim/anatomy/remesh.h"
#include "sim/core/portable_math.h"

namespace torsio::testing {

/// Closed surfaces of genus 0 that a mesh file may contain although they cannot be twisted meaningfully.
/// Metres.
namespace shapes {

using Field = std::function<double(const Vec3&)>;

/// Signed distance to a round bar from a to b, negative inside.
inline double bar(const Vec3& p, const Vec3& a, const Vec3& b, double radius_m) {
  const Vec3 along = b - a;
  const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
  return norm(p - (a + t * along)) - radius_m;
}

/// Approximate signed distance to an ellipsoid, negative inside.
inline double egg(const Vec3& p, const Vec3& centre, const Vec3& half_m) {
  const Vec3 q = p - centre;
  const double k = norm(Vec3{q.x / half_m.x, q.y / half_m.y, q.z / half_m.z});
  return (k - 1.0) * std::min({half_m.x, half_m.y, half_m.z});
}

/// Union with a fillet of about `round_m`.
inline double joined(double a, double b, double round_m) {
  const double h = std::max(round_m - std::abs(a - b), 0.0);
  return std::min(a, b) - h * h / (4.0 * round_m);
}

/// Bars along a polyline.
inline double chain(const Vec3& p, const std::vector<Vec3>& line, double radius_m) {
  double least = 1.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    least = std::min(least, bar(p, line[i], line[i + 1], radius_m));
  }
  return least;
}

inline TriangleMesh surfaceOf(const Vec3& low_m, const Vec3& high_m, double step_m, const Field& field) {
  SampleGrid grid;
  grid.origin = low_m;
  grid.step = step_m;
  const auto points = [step_m](double side_m) {
    return static_cast<std::size_t>(std::ceil(side_m / step_m)) + 1;
  };
  grid.count = {points(high_m.x - low_m.x), points(high_m.y - low_m.y), points(high_m.z - low_m.z)};
  return zeroSurface(grid, 1.5, field);
}

}  // namespace shapes

inline TriangleMesh ballShape() {
  return shapes::surfaceOf({-0.06, -0.06, -0.06}, {0.06, 0.06, 0.06}, 0.005,
                           [](const Vec3& p) { return norm(p) - 0.05; });
}

/// A stem that divides into two arms of its own length.
inline TriangleMesh branchingShape() {
  return shapes::surfaceOf({-0.1, -0.03, -0.13}, {0.1, 0.03, 0.11}, 0.004, [](const Vec3& p) {
    const double stem = shapes::bar(p, {0, 0, -0.1}, {0, 0, 0}, 0.016);
    const double left = shapes::bar(p, {0, 0, 0}, {0.065, 0, 0.08}, 0.014);
    const double right = shapes::bar(p, {0, 0, 0}, {-0.065, 0, 0.08}, 0.014);
    return shapes::joined(stem, shapes::joined(left, right, 0.008), 0.008);
  });
}

/// A plate of 240 x 110 x 16 mm with rounded edges.
inline TriangleMesh slabShape() {
  return shapes::surfaceOf({-0.06, -0.015, -0.125}, {0.06, 0.015, 0.125}, 0.004, [](const Vec3& p) {
    const Vec3 q{std::abs(p.x) - 0.05, std::abs(p.y) - 0.003, std::abs(p.z) - 0.115};
    const Vec3 outside{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
    return norm(outside) + std::min(std::max({q.x, q.y, q.z}), 0.0) - 0.005;
  });
}

/// A thick handle, a thin shaft and a hook at its end that turns back on itself.
inline TriangleMesh hookedToolShape() {
  std::vector<Vec3> shaft{{0, 0, 0.09}, {0, 0, 0.2}};
  constexpr double kBend_m = 0.009;
  for (int i = 1; i <= 8; ++i) {
    const double turn = kPi * i / 8.0;
    shaft.push_back({kBend_m * (1.0 - std::cos(turn)), 0, 0.2 + kBend_m * std::sin(turn)});
  }
  shaft.push_back({2.0 * kBend_m, 0, 0.17});
  return shapes::surfaceOf({-0.022, -0.022, -0.022}, {0.03, 0.022, 0.225}, 0.002, [shaft](const Vec3& p) {
    const double handle = shapes::bar(p, {0, 0, 0}, {0, 0, 0.09}, 0.017);
    return shapes::joined(handle, shapes::chain(p, shaft, 0.006), 0.002);
  });
}

/// A large and a small lobe, 240 mm across, a litre and a half.
inline TriangleMesh liverShape() {
  return shapes::surfaceOf({-0.1, -0.085, -0.095}, {0.18, 0.085, 0.095}, 0.006, [](const Vec3& p) {
    const double right = shapes::egg(p, {0, 0, 0}, {0.085, 0.07, 0.08});
    const double left = shapes::egg(p, {0.09, -0.02, 0.02}, {0.075, 0.04, 0.03});
    return shapes::joined(right, left, 0.02);
  });
}

/// A bean of 110 x 60 x 50 mm with a deep notch.
inline TriangleMesh kidneyShape() {
  std::vector<Vec3> spine;
  for (int i = -6; i <= 6; ++i) {
    const double turn = 1.25 * i / 6.0;
    spine.push_back({0.03 * std::cos(turn), 0, 0.03 * std::sin(turn)});
  }
  return shapes::surfaceOf({-0.03, -0.03, -0.065}, {0.065, 0.03, 0.065}, 0.004,
                           [spine](const Vec3& p) { return shapes::chain(p, spine, 0.025); });
}

/// A horseshoe with upturned ends of two tips each.
inline TriangleMesh jawShape() {
  std::vector<Vec3> arch;
  for (int i = -8; i <= 8; ++i) {
    const double turn = 0.5 * kPi * i / 8.0;
    arch.push_back({0.04 * std::sin(turn), -0.07 * std::cos(turn), 0});
  }
  return shapes::surfaceOf({-0.065, -0.095, -0.03}, {0.065, 0.05, 0.09}, 0.004, [arch](const Vec3& p) {
    double jaw = shapes::chain(p, arch, 0.012);
    for (const double side : {0.04, -0.04}) {
      jaw = shapes::joined(jaw, shapes::bar(p, {side, 0, 0}, {side, 0.03, 0.06}, 0.01), 0.006);
      jaw = shapes::joined(jaw, shapes::bar(p, {side, 0.01, 0.025}, {side, -0.015, 0.065}, 0.008), 0.006);
    }
    return jaw;
  });
}

/// A gently bent, tapering tube: a possible organ.
inline TriangleMesh tubeShape() {
  return shapes::surfaceOf({-0.05, -0.04, -0.035}, {0.09, 0.04, 0.22}, 0.005, [](const Vec3& p) {
    double tube = 1.0;
    for (int i = 0; i <= 60; ++i) {
      const double t = i / 60.0;
      const Vec3 centre{0.04 * t * t, 0, 0.18 * t};
      tube = std::min(tube, norm(p - centre) - (0.03 - 0.008 * t));
    }
    return tube;
  });
}

}  // namespace torsio::testing
