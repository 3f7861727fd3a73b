// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/rod_organ.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/contracts.h"
#include "sim/core/index.h"
#include "sim/core/portable_math.h"

namespace torsio {

namespace {

constexpr int kMaxPatchNodes = 7;
// Assumed: a stomach that is let go swings back with a time constant of 0.12 s, as a straight organ does.
constexpr double kDrag_Ns_per_m = 0.005;
constexpr double kPathStep_rad = radians(3.0);
constexpr double kBeyondTarget = 1.15;  // of the target: how far the path goes
constexpr double kMaxHandTurn = 3.0;    // of the target, for a measured turn that stays behind the hand
constexpr double kNearLine_m = 1e-6;
// Nothing slips back by a whole turn before the organ has turned by about half a one.
constexpr double kLeastBeforeSlip_rad = radians(120.0);

// Rounds of a secant until the torque of a law and that of the rod agree; assumed.
constexpr int kMaxRounds = 12;
constexpr double kSameShare = 1e-4;
constexpr double kLeastShare = 1e-3;

OrganRod organOf(const RodOrgan::Parts& parts, const SolvedSections& sections) {
  const TwistModel& model = *parts.model;
  return rodOfOrgan(model.lattice(), sections,
                    {.shearModulus_Pa = model.material().shearModulus_Pa, .wall = parts.wall},
                    {.node_m = parts.graspArc * model.lattice().length_m()});
}

std::vector<TwistLaw> twoAtMost(std::vector<TwistLaw> laws) {
  TORSIO_EXPECTS(laws.size() <= 2);
  return laws;
}

std::size_t nearestNode(std::span<const double> arcs_m, double arc_m) noexcept {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < arcs_m.size(); ++i) {
    if (std::abs(arcs_m[i] - arc_m) < std::abs(arcs_m[nearest] - arc_m)) {
      nearest = i;
    }
  }
  return nearest;
}

/// Adds what a restraint does at one place of the organ.
class RestraintPlacer {
 public:
  RestraintPlacer(const OrganRod& organ, const SectionLattice& lattice)
      : organ_(organ),
        lattice_(lattice),
        ends_m_{lattice.frameAt(0.0).centre_m, lattice.frameAt(lattice.length_m()).centre_m} {}

  void add(const Restraint& restraint, double fraction, RodRestraints& all) const {
    const double arc_m =
        restraint.point_m ? lattice_.nearestArc_m(*restraint.point_m) : fraction * lattice_.length_m();
    const std::size_t node = nearestNode(organ_.arcs_m, arc_m);
    const double halfWidth_m =
        restraint.halfWidth_m > 0.0 ? restraint.halfWidth_m : 0.5 * organ_.radii_m[node];
    const NodeRange patch = nodesAround(organ_.elements, organ_.arcs_m[node] - organ_.arcs_m.front(),
                                        halfWidth_m, kMaxPatchNodes);
    if (restraint.stiffness_N_per_m > 0.0) {
      const Vec3 point_m = restraint.point_m ? *restraint.point_m : pointAt(restraint.side, node);
      const Vec3 anchor_m = anchorOf(restraint, point_m);
      addPatchSpring({.nodes = patch,
                      .point_m = point_m,
                      .anchor_m = anchor_m,
                      .slack_m = norm(anchor_m - point_m) + restraint.slack_m,
                      .stiffness_N_per_m = restraint.stiffness_N_per_m},
                     organ_.rest, all);
    }
    if (restraint.turn_Nm_per_rad > 0.0) {
      addPatchTurn(patch, restraint.turn_Nm_per_rad, organ_.rest, all);
    }
  }

 private:
  [[nodiscard]] Vec3 onChord(const Vec3& point_m) const {
    const Vec3 chord = ends_m_[1] - ends_m_[0];
    const double length2 = dot(chord, chord);
    const double share = length2 > 0.0 ? dot(point_m - ends_m_[0], chord) / length2 : 0.0;
    return ends_m_[0] + std::clamp(share, 0.0, 1.0) * chord;
  }

  [[nodiscard]] Vec3 anchorOf(const Restraint& restraint, const Vec3& point_m) const {
    if (restraint.anchor_m) {
      return *restraint.anchor_m;
    }
    return restraint.towardsChord ? onChord(point_m) : point_m;
  }

  [[nodiscard]] Vec3 pointAt(SectionSide side, std::size_t node) const {
    const Pose& at = organ_.rest.nodes[node];
    if (side == SectionSide::kCentre) {
      return at.position_m;
    }
    const Vec3 tangent = rotate(at.orientation, {0, 0, 1});
    const Vec3 towards = 0.5 * (ends_m_[0] + ends_m_[1]) - at.position_m;
    const Vec3 inside = normalized(towards - dot(towards, tangent) * tangent);
    const double reach_m = (side == SectionSide::kInner ? 1.0 : -1.0) * organ_.radii_m[node];
    return at.position_m + reach_m * inside;
  }

  const OrganRod& organ_;
  const SectionLattice& lattice_;
  std::array<Vec3, 2> ends_m_;
};

RodRestraints placed(const std::vector<Restraint>& restraints, const OrganRod& organ,
                     const SectionLattice& lattice) {
  const RestraintPlacer placer(organ, lattice);
  RodRestraints all;
  for (const Restraint& restraint : restraints) {
    for (int k = 0; k < restraint.count; ++k) {
      const double share = restraint.count > 1 ? static_cast<double>(k) / (restraint.count - 1) : 0.0;
      placer.add(restraint, restraint.from + share * (restraint.to - restraint.from), all);
    }
  }
  return all;
}

Quat between(const Quat& a, Quat b, double share) noexcept {
  if (a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z < 0.0) {
    b = {-b.w, -b.x, -b.y, -b.z};
  }
  return normalized(Quat{a.w + share * (b.w - a.w), a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
                         a.z + share * (b.z - a.z)});
}

double mix(double a, double b, double share) noexcept {
  return a + share * (b - a);
}

TaskPoint between(const TaskPoint& a, const TaskPoint& b, double share) noexcept {
  TaskPoint point = a;
  point.hand_rad = mix(a.hand_rad, b.hand_rad, share);
  point.angle_rad = mix(a.angle_rad, b.angle_rad, share);
  point.torque_Nm = mix(a.torque_Nm, b.torque_Nm, share);
  point.force_N = mix(a.force_N, b.force_N, share);
  for (std::size_t i = 0; i < point.twist_rad.size(); ++i) {
    point.twist_rad[i] = mix(a.twist_rad[i], b.twist_rad[i], share);
  }
  point.pose = poseBetween(a.pose, b.pose, share);
  return point;
}

}  // namespace

RodPose poseBetween(const RodPose& a, const RodPose& b, double share) noexcept {
  RodPose pose = a;
  for (std::size_t i = 0; i < static_cast<std::size_t>(a.count); ++i) {
    pose.nodes[i] = {
        .position_m = a.nodes[i].position_m + share * (b.nodes[i].position_m - a.nodes[i].position_m),
        .orientation = between(a.nodes[i].orientation, b.nodes[i].orientation, share)};
  }
  return pose;
}

TaskPoint atAngle(std::span<const TaskPoint> path, double angle_rad) {
  const double direction = path.back().angle_rad < 0.0 ? -1.0 : 1.0;
  const double wanted_rad = direction * angle_rad;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double before_rad = direction * path[i - 1].angle_rad;
    const double after_rad = direction * path[i].angle_rad;
    if (after_rad >= wanted_rad && after_rad > before_rad) {
      const double share = std::clamp((wanted_rad - before_rad) / (after_rad - before_rad), 0.0, 1.0);
      return between(path[i - 1], path[i], share);
    }
  }
  return path.back();
}

bool reaches(std::span<const TaskPoint> path, double angle_rad) noexcept {
  const double end_rad = path.back().angle_rad;
  return angle_rad == 0.0 ||
         (std::abs(end_rad) >= std::abs(angle_rad) && (end_rad < 0.0) == (angle_rad < 0.0));
}

RodOrgan::RodOrgan(const Parts& parts)
    : RodOrgan(parts, solvedSections(parts.model->lattice(), parts.model->options())) {}

RodOrgan::RodOrgan(const Parts& parts, const SolvedSections& sections)
    : organ_(organOf(parts, sections)),
      skin_(organ_, parts.model->lattice(), sections, *parts.mesh),
      rod_(organ_.elements, organ_.rest, organ_.radii_m,
           placed(parts.restraints, organ_, parts.model->lattice()), {.drag_Ns_per_m = kDrag_Ns_per_m}),
      laws_(twoAtMost(parts.laws)),
      length_m_(parts.model->lattice().length_m()),
      graspArc_(parts.graspArc),
      task_(parts.task) {
  if (task_.measured) {
    marks_ = {skin_.placeOf(task_.measured->from), skin_.placeOf(task_.measured->point),
              skin_.placeOf(task_.measured->to)};
    task_.measured = marksOf(skin_.curveOf(rod_.rest()));
  }
  path_ = follow(parts.graspArc, kBeyondTarget * parts.targetAngle_rad, false, &pathEnd_);
  for (std::size_t i = 1; i < path_.size(); ++i) {
    const double way_rad = path_[i].hand_rad - path_[i - 1].hand_rad;
    turnStiffness_Nm_per_rad_ =
        std::max(turnStiffness_Nm_per_rad_, (path_[i].torque_Nm - path_[i - 1].torque_Nm) / way_rad);
  }
}

Landmarks RodOrgan::marksOf(const RodCurve& curve) const noexcept {
  return {.from = skin_.positionOf_m(marks_[0], curve),
          .point = skin_.positionOf_m(marks_[1], curve),
          .to = skin_.positionOf_m(marks_[2], curve)};
}

AxisFrame RodOrgan::axisOf(const RodPose& pose, int node, const Vec3& hand_m) const noexcept {
  const Pose& at = pose.nodes[torsio::at(node)];
  AxisFrame axis;
  axis.tangent = rotate(at.orientation, {0, 0, 1});
  axis.centre_m = at.position_m;
  if (task_.axis == GripAxis::kLine) {
    axis.tangent = normalized(task_.axisTo_m - task_.axisFrom_m);
    axis.centre_m = task_.axisFrom_m + dot(at.position_m - task_.axisFrom_m, axis.tangent) * axis.tangent;
  }
  const Vec3 way = hand_m - axis.centre_m;
  const Vec3 arm = way - dot(way, axis.tangent) * axis.tangent;
  axis.e1 = norm(arm) > kNearLine_m ? normalized(arm) : rotate(at.orientation, {1, 0, 0});
  axis.e2 = cross(axis.tangent, axis.e1);
  return axis;
}

OrganGrip RodOrgan::grip(const RodPose& pose, double arc_m, const Pose& hand) const noexcept {
  OrganGrip grip;
  const std::size_t node = nearestNode(organ_.arcs_m, arc_m);
  grip.node = static_cast<int>(node);
  grip.axis = axisOf(pose, grip.node, hand.position_m);
  GripStiffness stiffness;
  if (task_.axis == GripAxis::kOwn) {
    stiffness.place_N_per_m = 0.0;
  }
  grip.jaw = gripAt(rod_, pose, grip.node, 0.5 * organ_.radii_m[node], hand, stiffness);
  return grip;
}

Pose RodOrgan::handAfter(const OrganGrip& grip, const Pose& closed, const Pose& now,
                         double turn_rad) const noexcept {
  if (task_.axis == GripAxis::kInstrument) {
    return now;
  }
  return {.position_m = now.position_m,
          .orientation = axisAngle(grip.axis.tangent, turn_rad) * closed.orientation};
}

double RodOrgan::turn_rad(const OrganGrip& grip, const RodPose& pose, const RodCurve& curve,
                          double before_rad) const noexcept {
  if (task_.measured) {
    return landmarkTurn_rad(*task_.measured, marksOf(curve), before_rad);
  }
  const Quat& rest = rod_.rest().nodes[torsio::at(grip.node)].orientation;
  const Vec3 axis = task_.axis == GripAxis::kLine ? grip.axis.tangent : rotate(rest, {0, 0, 1});
  return sectionTurn_rad(rest, pose.nodes[torsio::at(grip.node)].orientation, axis, before_rad);
}

/// Turn of one section about the axis of the grip, or about its own, near `before_rad`.
double RodOrgan::nodeTurn_rad(const OrganGrip& grip, const RodPose& pose, std::size_t node,
                              double before_rad) const noexcept {
  const Quat& rest = rod_.rest().nodes[node].orientation;
  const Vec3 axis = task_.axis == GripAxis::kLine ? grip.axis.tangent : rotate(rest, {0, 0, 1});
  return sectionTurn_rad(rest, pose.nodes[node].orientation, axis, before_rad);
}

std::optional<double> RodOrgan::slippedBack_rad(const OrganGrip& grip, const RodPose& pose,
                                                double turn_rad) const noexcept {
  if (task_.measured || task_.axis == GripAxis::kInstrument || std::abs(turn_rad) < kLeastBeforeSlip_rad) {
    return std::nullopt;
  }
  double counted_rad = 0.0;
  for (std::size_t node = 0; node <= torsio::at(grip.node); ++node) {
    counted_rad = nodeTurn_rad(grip, pose, node, counted_rad);
  }
  return std::abs(counted_rad - turn_rad) > kPi ? std::optional(counted_rad) : std::nullopt;
}

/// Counts the turns of all sections on in time; tells whether they are others from section to section.
bool RodOrgan::losesTurns(const OrganGrip& grip, const RodPose& pose, std::vector<double>& turns_rad) const {
  if (task_.axis == GripAxis::kInstrument) {
    return false;
  }
  double counted_rad = 0.0;
  bool loses = false;
  for (std::size_t node = 0; node < turns_rad.size(); ++node) {
    turns_rad[node] = nodeTurn_rad(grip, pose, node, turns_rad[node]);
    counted_rad = nodeTurn_rad(grip, pose, node, counted_rad);
    loses = loses || std::abs(counted_rad - turns_rad[node]) > kPi;
  }
  return loses;
}

double RodOrgan::torque_Nm(const OrganGrip& grip, const GripLoad& load, const Pose& hand) noexcept {
  const Vec3 moment = load.torque_Nm + cross(hand.position_m - grip.axis.centre_m, load.force_N);
  return -dot(moment, grip.axis.tangent);
}

double RodOrgan::farthestFromRest_m(const RodPose& pose) const noexcept {
  double farthest2_m2 = 0.0;
  const RodPose& rest = rod_.rest();
  for (std::size_t i = 0; i < static_cast<std::size_t>(pose.count); ++i) {
    const Vec3 way = pose.nodes[i].position_m - rest.nodes[i].position_m;
    farthest2_m2 = std::max(farthest2_m2, dot(way, way));
  }
  return std::sqrt(farthest2_m2);
}

double RodOrgan::twistRateAt(double arc_m, const RodPose& pose) const noexcept {
  if (pose.count < 2) {
    return 0.0;
  }
  const auto after = std::upper_bound(organ_.arcs_m.begin() + 1, organ_.arcs_m.end() - 1, arc_m);
  const auto i = static_cast<std::size_t>(after - organ_.arcs_m.begin()) - 1;
  const RodElement& element = rod_.elements()[i];
  return rodStrain(element.length_m, pose.nodes[i], pose.nodes[i + 1]).curvature_per_m.z -
         element.restCurvature_per_m[2];
}

double RodOrgan::twist_rad(const TwistLaw& law, const RodPose& pose) const noexcept {
  double sum_rad = 0.0;
  for (std::size_t i = 0; i + 1 < organ_.arcs_m.size(); ++i) {
    const double middle_m = 0.5 * (organ_.arcs_m[i] + organ_.arcs_m[i + 1]);
    if (middle_m >= law.from_m && middle_m < law.to_m) {
      sum_rad += rod_.elements()[i].length_m * twistRateAt(middle_m, pose);
    }
  }
  return sum_rad;
}

Rod RodOrgan::asStiff(const std::array<double, 2>& shares) const {
  std::vector<RodElement> elements = organ_.elements;
  for (std::size_t k = 0; k < laws_.size(); ++k) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const double middle_m = 0.5 * (organ_.arcs_m[i] + organ_.arcs_m[i + 1]);
      if (middle_m >= laws_[k].from_m && middle_m < laws_[k].to_m) {
        elements[i].bend_Nm2[8] *= shares[k];
        for (const std::size_t withTwist : {std::size_t{2}, std::size_t{5}, std::size_t{8}}) {
          elements[i].coupling_Nm[withTwist] *= std::sqrt(shares[k]);  // so that the energy stays above 0
        }
      }
    }
  }
  return {std::move(elements), organ_.rest, organ_.radii_m, rod_.restraints(), rod_.settings()};
}

RodBalance RodOrgan::balance(const OrganGrip& grip, const Pose& hand, std::array<double, 2>& shares,
                             RodPose& pose) const {
  if (laws_.empty()) {
    return balanceRod(rod_, &grip.jaw, hand, {}, pose);
  }
  RodBalance found;
  for (int round = 0; round < kMaxRounds; ++round) {
    found = balanceRod(asStiff(shares), &grip.jaw, hand, {}, pose);
    double change = 0.0;
    for (std::size_t k = 0; k < laws_.size(); ++k) {
      const double twist = twist_rad(laws_[k], pose);
      double compliance = 0.0;
      for (std::size_t i = 0; i < organ_.elements.size(); ++i) {
        const double middle_m = 0.5 * (organ_.arcs_m[i] + organ_.arcs_m[i + 1]);
        if (middle_m >= laws_[k].from_m && middle_m < laws_[k].to_m) {
          compliance += organ_.elements[i].length_m / organ_.elements[i].bend_Nm2[8];
        }
      }
      const double wanted = twist == 0.0 ? 1.0
                                         : std::clamp(laws_[k].torque_Nm(twist) * compliance / twist,
                                                      kLeastShare, 1.0 / kLeastShare);
      change = std::max(change, std::abs(wanted - shares[k]) / wanted);
      shares[k] = 0.5 * (shares[k] + wanted);  // a wall that weakens would swing about its secant
    }
    if (change < kSameShare) {
      break;
    }
  }
  return found;
}

TaskPoint RodOrgan::pointAt(double angle_rad) const {
  return reaches(path_, angle_rad) ? atAngle(path_, angle_rad)
                                   : atAngle(follow(graspArc_, angle_rad), angle_rad);
}

std::vector<TaskPoint> RodOrgan::follow(double graspArc, double angle_rad, bool pastFolds,
                                        TurnEnd* end) const {
  const RodPose& rest = rod_.rest();
  const Pose closed = rest.nodes[nearestNode(organ_.arcs_m, graspArc * length_m_)];
  const OrganGrip grip = this->grip(rest, graspArc * length_m_, closed);
  std::vector<TaskPoint> path(1);
  path.front().pose = rest;
  const double direction = angle_rad < 0.0 ? -1.0 : 1.0;
  // At least some steps: of a small turn too the organ may stay behind the hand.
  const double farthest_rad = kMaxHandTurn * std::max(std::abs(angle_rad), kPathStep_rad);
  std::vector<double> turns_rad(static_cast<std::size_t>(rest.count), 0.0);
  std::array<double, 2> shares{1.0, 1.0};
  TurnEnd why = TurnEnd::kHandAlone;
  for (int step = 1; step * kPathStep_rad <= farthest_rad; ++step) {
    TaskPoint next = path.back();
    next.hand_rad = direction * step * kPathStep_rad;
    Pose now = closed;
    now.position_m = grip.axis.centre_m +
                     rotateAbout(closed.position_m - grip.axis.centre_m, grip.axis.tangent, next.hand_rad);
    now.orientation = axisAngle(grip.axis.tangent, next.hand_rad) * closed.orientation;
    const RodBalance balance = this->balance(grip, now, shares, next.pose);
    for (std::size_t k = 0; k < laws_.size(); ++k) {
      next.twist_rad[k] = twist_rad(laws_[k], next.pose);
    }
    const RodCurve curve = skin_.curveOf(next.pose);
    next.angle_rad = turn_rad(grip, next.pose, curve, path.back().angle_rad);
    next.torque_Nm = torque_Nm(grip, balance.load, now);
    next.force_N = norm(balance.load.force_N);
    const bool slips = losesTurns(grip, next.pose, turns_rad);
    const bool folds = !pastFolds && skin_.sharpestBend(curve) > kFoldingBend;
    if (!balance.converged || slips || folds) {
      why = !balance.converged ? TurnEnd::kNoBalance : slips ? TurnEnd::kSlipsBack : TurnEnd::kFolds;
      break;
    }
    path.push_back(next);
    if (direction * next.angle_rad >= std::abs(angle_rad)) {
      why = TurnEnd::kThere;
      break;
    }
  }
  if (end != nullptr) {
    *end = why;
  }
  return path;
}

}  // namespace torsio
