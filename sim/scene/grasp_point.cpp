// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/grasp_point.h"

#include <algorithm>

#include "sim/core/portable_math.h"

namespace torsio {

namespace {

constexpr int kDirections = 24;        // tried round the section
constexpr double kFreeFrom_m = 0.006;  // from here outwards nothing may be in the way
constexpr double kHandProbe_m = 0.004;
constexpr double kSmallestArm_m = 0.008;  // nearer to the axis a twist has no lever
constexpr double kEndMargin = 0.02;

struct Candidate {
  GraspPoint place;
  double facing = -1.0;  // cosine between the surface normal and the way out; -1: cannot be reached
};

Candidate candidateAt(const Scene& scene, double arc_m, double angle_rad) {
  Candidate found;
  const Vec3 point_m = scene.lattice().surfacePoint({arc_m, angle_rad}).position_m;
  const AxisFrame axis = scene.graspFrame(arc_m, point_m);
  const Vec3 way = point_m - axis.centre_m;
  const Vec3 arm = way - axis.tangent * dot(way, axis.tangent);
  if (norm(arm) < kSmallestArm_m) {
    return found;
  }
  const Vec3 outwards = normalized(arm);
  found.place = {point_m, outwards};
  for (double height_m = kFreeFrom_m; height_m <= kHandStartWay_m; height_m += kHandProbe_m) {
    if (scene.collision.closest(point_m + outwards * height_m).distance_m <= scene.instrument.tipRadius_m) {
      return found;
    }
  }
  found.facing = dot(scene.collision.closest(point_m + outwards * 1e-4).normal, outwards);
  return found;
}

}  // namespace

double handGrasp_m(const Scene& scene) noexcept {
  return std::clamp(scene.pattern.graspArc, kEndMargin, 1.0 - kEndMargin) * scene.lattice().length_m();
}

std::optional<GraspPoint> graspPoint(const Scene& scene) {
  Candidate best;
  for (int i = 0; i < kDirections; ++i) {
    const Candidate next = candidateAt(scene, handGrasp_m(scene), 2.0 * kPi * i / kDirections);
    if (next.facing > best.facing) {
      best = next;
    }
  }
  return best.facing > 0.0 ? std::optional(best.place) : std::nullopt;
}

}  // namespace torsio
