// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/hand_task.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/scene/grasp_point.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/rod_organ.h"
#include "sim/servo/detorsion.h"
#include "sim/servo/exercise.h"

namespace torsio {

namespace {

constexpr double kRestShare = 1.1;  // of the rest that is asked for
constexpr double kGripBand = 0.04;  // of the length: so far beside the pattern's section a hand grips
constexpr Vec3 kFront{0.0, -1.0, 0.0};

GraspPoint reachable(const Scene& scene) {
  const std::optional<GraspPoint> best = graspPoint(scene);
  if (!best) {
    throw Error(ErrorCode::kBadParameter,
                Text::verbatim("no point of the grasped section can be reached from outside"),
                Text::verbatim("scene %1, pattern %2", scene.id, scene.pattern.id),
                Text::verbatim("Choose another grasp section"));
  }
  return *best;
}

HandTask taskAt(const Scene& scene, double arc_m, const GraspPoint& best) {
  const AxisFrame axis = scene.graspFrame(arc_m, best.point_m);
  HandTask task;
  task.start_m = best.point_m + best.outwards * kHandStartWay_m;
  task.graspPoint_m = best.point_m;
  task.axisCentre_m = axis.centre_m;
  task.axisDirection = axis.tangent;
  task.tipRadius_m = scene.instrument.tipRadius_m;
  return task;
}

/// The grasped section round its outline, at rest; of limbs that are wound round each other the whole mobile
/// part, of which another place lies outwards after each turn.
std::vector<Vec3> outlineAt(const Scene& scene, double arc_m) {
  constexpr int kPoints = 144;
  constexpr int kSections = 9;
  std::vector<double> arcs_m{arc_m};
  if (scene.hollow->swing() != nullptr) {
    arcs_m = {arc_m - kGripBand * scene.lattice().length_m(), arc_m,
              arc_m + kGripBand * scene.lattice().length_m()};
  } else if (scene.hollow->wound()) {
    const std::vector<WrungSpan>& spans = scene.hollow->detorsion().spans;
    const double from = spans.front().mobile;
    const double to = spans.size() > 1 ? spans.back().mobile : 1.0;
    arcs_m.clear();
    for (int i = 1; i <= kSections; ++i) {
      const double share = from + (to - from) * i / (kSections + 1);
      arcs_m.push_back(share * scene.lattice().length_m());
    }
  }
  std::vector<Vec3> points_m;
  for (const double each_m : arcs_m) {
    for (int i = 0; i < kPoints; ++i) {
      points_m.push_back(scene.lattice().surfacePoint({each_m, 2.0 * kPi * i / kPoints}).position_m);
    }
  }
  return points_m;
}

/// The point of an outline that lies farthest outwards when the mobile part is turned by an angle.
Vec3 outwardPoint(const Scene& scene, const HandTask& task, const std::vector<Vec3>& outline_m,
                  const Vec3& outwards, double angle_rad) {
  const OrganState lies = scene.hollow->stateAt(angle_rad);
  Vec3 found_m = task.graspPoint_m;
  double farthest_m = -std::numeric_limits<double>::max();  // all of it may lie behind the axis
  for (const Vec3& rest_m : outline_m) {
    const Vec3 point_m = scene.toDeformed_m(rest_m, lies);
    const double out_m = dot(point_m - task.axisCentre_m, outwards);
    if (out_m > farthest_m) {
      farthest_m = out_m;
      found_m = point_m;
    }
  }
  return found_m;
}

/// How tight a jaw holds a wall without harm.
double carefulClosure(const DetorsionLimits& limits, double dose) {
  constexpr double kCareful = 0.8;
  constexpr double kDoseToCome = 0.3;
  const double strength = 1.0 - kIschaemicWeakness * std::min(dose + kDoseToCome, 1.0);
  const double most = kCareful * strength * limits.bruise_Pa * limits.jawArea_m2 / limits.jawForce_N;
  return std::clamp(most, kJawCloses + 0.1, 1.0);
}

}  // namespace

HandTask handTask(const Scene& scene) {
  return handTask(scene, scene.pattern.targetAngle_rad);
}

HandTask handTask(const Scene& scene, double angle_rad) {
  if (scene.comesTwisted()) {
    return detorseTask(scene, detorsionSeed({}));
  }
  const double arc_m = handGrasp_m(scene);
  HandTask task = taskAt(scene, arc_m, reachable(scene));
  // What the task of a rod measures is not what the hand turns.
  task.targetAngle_rad = scene.rod ? scene.rod->pointAt(angle_rad).hand_rad : angle_rad;
  return task;
}

HandTask detorseTask(const Scene& scene, std::uint64_t seed) {
  const double arc_m = handGrasp_m(scene);
  const GraspPoint best = reachable(scene);
  HandTask task = taskAt(scene, arc_m, best);
  const OrganState start = scene.hollow->start(seed);
  const double start_rad = start.twist.graspAngle_rad;
  Vec3 outwards = best.outwards;
  if (scene.hollow->swing() !=
      nullptr) {  // what swings round the line is taken from where the surgeon stands
    outwards = normalized(kFront - dot(kFront, task.axisDirection) * task.axisDirection);
    task.outwards = outwards;
  }
  const int turns = std::max(1, static_cast<int>(std::ceil(std::abs(start_rad) / kHandTurn_rad)));
  const std::vector<Vec3> outline_m = outlineAt(scene, arc_m);
  const Detorsion& detorsion = scene.hollow->detorsion();
  double stage_rad = 0.0;
  for (int i = 0; i < turns; ++i) {
    const double left_rad = start_rad * (turns - i) / turns;
    HandTurn turn{outwardPoint(scene, task, outline_m, outwards, left_rad), -start_rad / turns};
    stage_rad += std::abs(turn.angle_rad);
    const bool rests = detorsion.stages.asked() && i + 1 < turns &&
                       stage_rad + std::abs(turn.angle_rad) > detorsion.stages.turn_rad;
    if (rests) {
      turn.rest_s = kRestShare * detorsion.stages.rest_s / detorsion.timeScale;
      stage_rad = 0.0;
    }
    task.turns.push_back(turn);
  }
  task.graspPoint_m = task.turns.front().graspPoint_m;
  if (scene.hollow->swing() != nullptr) {
    task.start_m = task.graspPoint_m + outwards * kHandStartWay_m;
  }
  task.closure = carefulClosure(scene.hollow->detorsion().limits, start.hollow.reading.dose);
  return task;
}

double undone_s(const HollowOrgan& organ, const ScriptedHand& hand) {
  constexpr double kAfterwards_s = 1.0;
  return hand.ends_s() + organ.detorsion().limits.handsOff_s + kAfterwards_s;
}

}  // namespace torsio
