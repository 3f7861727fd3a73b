// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/hand_task.h"

#include <algorithm>
#include <cmath>

#include "sim/base/error.h"
#include "sim/base/portable_math.h"
#include "sim/scene/rod_organ.h"

namespace torsio {

namespace {

constexpr int kDirections = 24;        // tried round the section
constexpr double kStartWay_m = 0.090;  // of the resting tip from the surface
constexpr double kFreeFrom_m = 0.006;  // from here outwards nothing may be in the way
constexpr double kProbe_m = 0.004;
constexpr double kSmallestArm_m = 0.008;  // nearer to the axis a twist has no lever
// An end section may lie within its cap: the hand grasps a little inside.
constexpr double kEndMargin = 0.02;

struct Candidate {
  Vec3 point_m;
  Vec3 outwards;
  double facing = -1.0;  // cosine between the surface normal and the way out; -1: cannot be reached
};

Candidate candidateAt(const Scene& scene, double arc_m, double angle_rad) {
  Candidate found;
  found.point_m = scene.lattice().surfacePoint({arc_m, angle_rad}).position_m;
  const AxisFrame axis = scene.graspFrame(arc_m, found.point_m);
  const Vec3 way = found.point_m - axis.centre_m;
  const Vec3 arm = way - axis.tangent * dot(way, axis.tangent);
  if (norm(arm) < kSmallestArm_m) {
    return found;
  }
  found.outwards = normalized(arm);
  const double tipRadius_m = scene.instrument.tipRadius_m;
  for (double height_m = kFreeFrom_m; height_m <= kStartWay_m; height_m += kProbe_m) {
    const Vec3 probe_m = found.point_m + found.outwards * height_m;
    if (scene.collision.closest(probe_m).distance_m <= tipRadius_m) {
      return found;
    }
  }
  found.facing = dot(scene.collision.closest(found.point_m + found.outwards * 1e-4).normal, found.outwards);
  return found;
}

}  // namespace

HandTask handTask(const Scene& scene) {
  return handTask(scene, scene.pattern.targetAngle_rad);
}

HandTask handTask(const Scene& scene, double angle_rad) {
  const double fraction = std::clamp(scene.pattern.graspArc, kEndMargin, 1.0 - kEndMargin);
  const double arc_m = fraction * scene.lattice().length_m();
  Candidate best;
  for (int i = 0; i < kDirections; ++i) {
    const Candidate next = candidateAt(scene, arc_m, 2.0 * kPi * i / kDirections);
    if (next.facing > best.facing) {
      best = next;
    }
  }
  if (!(best.facing > 0.0)) {
    throw Error(ErrorCode::kBadParameter,
                Text::verbatim("no point of the grasped section can be reached from outside"),
                Text::verbatim("scene %1, pattern %2", scene.id, scene.pattern.id),
                Text::verbatim("Choose another grasp section"));
  }
  const AxisFrame axis = scene.graspFrame(arc_m, best.point_m);
  HandTask task;
  task.start_m = best.point_m + best.outwards * kStartWay_m;
  task.graspPoint_m = best.point_m;
  task.axisCentre_m = axis.centre_m;
  task.axisDirection = axis.tangent;
  // What the task of a rod measures is not what the hand turns.
  task.targetAngle_rad = scene.rod ? atAngle(scene.rod->path(), angle_rad).hand_rad : angle_rad;
  task.tipRadius_m = scene.instrument.tipRadius_m;
  return task;
}

}  // namespace torsio
