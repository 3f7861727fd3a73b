// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/grasped_organ.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sim/baseline/corotational_frames.h"
#include "sim/baseline/equilibrium.h"
#include "sim/baseline/spring_lattice.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr double kSmallGraspTurn_rad = 0.01;  // at which the slope at rest is found
constexpr double kNearRest_rad = 0.02;        // up to here it is the slope
constexpr int kGraspSubsteps = 10;            // of XPBD, a frame's, as in a comparison

class GraspedTwist final : public GraspedOrgan {
 public:
  explicit GraspedTwist(const Grasp& grasp)
      : grasp_(grasp), points_(*grasp.mesh, *grasp.lattice), vertices_m_(grasp.mesh->vertices_m) {}

  void turnTo(double angle_rad) override {
    state_ = {grasp_.arc_m, angle_rad};
    grasp_.model->deform(state_, vertices_m_);
  }
  [[nodiscard]] double angle_rad() const override { return state_.graspAngle_rad; }
  [[nodiscard]] double torque_Nm() const override { return grasp_.model->torque_Nm(state_); }
  [[nodiscard]] double slope_Nm_per_rad() const override {
    const double angle_rad = std::max(kSmallGraspTurn_rad, std::abs(state_.graspAngle_rad));
    return grasp_.model->torque_Nm({grasp_.arc_m, angle_rad}) / angle_rad;
  }
  [[nodiscard]] LatticePlaces surface() const override { return points_.at(*grasp_.mesh, vertices_m_); }

 private:
  Grasp grasp_;
  CarriedKeyPoints points_;
  std::vector<Vec3> vertices_m_;
  TwistState state_;
};

/// A body in motion whose jaw is led: frames of its own kind.
template <class Frames>
class GraspedBody final : public GraspedOrgan {
 public:
  GraspedBody(SweptSolid solid, Frames frames) : solid_(std::move(solid)), frames_(std::move(frames)) {
    Equilibrium newton(frames_.body(), frames_.ends(), solid_.points_m);
    TwistPose pose{solid_.points_m};
    turnEnd(frames_.ends(), solid_.points_m, kSmallGraspTurn_rad, pose);
    slopeAtRest_ = newton.keepAngle(pose).torque_Nm / kSmallGraspTurn_rad;
  }

  void turnTo(double angle_rad) override {
    const double now_rad = frames_.pose().angle_rad;
    frames_.stepTo(now_rad + std::clamp(angle_rad - now_rad, -kMaxTurn_rad, kMaxTurn_rad));
    torque_Nm_ = turningMoment_Nm(frames_.body(), frames_.ends(), frames_.pose());
  }
  [[nodiscard]] double angle_rad() const override { return frames_.pose().angle_rad; }
  [[nodiscard]] double torque_Nm() const override { return torque_Nm_; }
  [[nodiscard]] double slope_Nm_per_rad() const override {
    const double angle_rad = frames_.pose().angle_rad;
    return std::abs(angle_rad) < kNearRest_rad ? slopeAtRest_ : torque_Nm_ / angle_rad;
  }
  [[nodiscard]] LatticePlaces surface() const override {
    LatticePlaces places{solid_.ridges, solid_.sections, {}};
    for (int j = 0; j < solid_.sections; ++j) {
      for (int k = 0; k < solid_.ridges; ++k) {
        places.places_m.push_back(
            frames_.pose().places_m[static_cast<std::size_t>(solid_.point(j, solid_.rings, k))]);
      }
    }
    return places;
  }

 private:
  SweptSolid solid_;
  Frames frames_;
  double slopeAtRest_ = 0.0;
  double torque_Nm_ = 0.0;
};

/// The ends of the organ in its exercise; the jaw turns its section in its place.
TwistEnds graspedEnds(const SweptSolid& solid, const Grasp& grasp) {
  const double share = std::clamp(grasp.arc_m / grasp.lattice->length_m(), 0.0, 1.0);
  TwistEnds ends = twistEnds(solid, {.grasp = share});
  ends.placeFree = false;
  if (grasp.model->options().ends == EndCondition::kBothHeld) {
    const int last = (solid.sections - 1) * solid.pointsPerSection();
    if (ends.turned.back() >= last) {
      refuseParameter(Text::verbatim("What is turned would reach the held end"), Text::verbatim("grasp"),
                      Text::verbatim("Grip further away from it"));
    }
    for (int i = last; i < solid.sections * solid.pointsPerSection(); ++i) {
      ends.held.push_back(i);
    }
  }
  return ends;
}

/// Springs are calibrated by the twist of the organ with a free end, however its exercise holds it.
SpringLattice springsOf(const SweptSolid& solid, const Grasp& grasp, const ElasticConstants& constants) {
  if (grasp.model->options().ends == EndCondition::kClampedFree) {
    return calibratedSprings(solid, *grasp.lattice, constants, *grasp.model, Calibration::kAffine);
  }
  const TwistModel free(*grasp.mesh, *grasp.lattice, grasp.model->material(), TwistModelOptions{});
  return calibratedSprings(solid, *grasp.lattice, constants, free, Calibration::kAffine);
}

}  // namespace

double turningMoment_Nm(const ElasticBody& body, const TwistEnds& ends, const TwistPose& pose) {
  std::vector<char> turned(pose.places_m.size(), 0);
  for (const int node : ends.turned) {
    turned[static_cast<std::size_t>(node)] = 1;
  }
  double moment_Nm = 0.0;
  double energy_J = 0.0;
  std::array<Vec3, kMaxElementNodes> forces_N;
  for (std::size_t e = 0; e < body.elements(); ++e) {
    const std::span<const int> nodes = body.elementNodes(e);
    const auto isTurned = [&turned](int node) { return turned[static_cast<std::size_t>(node)] != 0; };
    if (std::none_of(nodes.begin(), nodes.end(), isTurned)) {
      continue;
    }
    static_cast<void>(
        body.elementForces(e, pose.places_m, energy_J, std::span<Vec3>(forces_N).first(nodes.size())));
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      if (isTurned(nodes[k])) {
        moment_Nm += dot(forces_N[k], turningOf(ends, pose, nodes[k]));
      }
    }
  }
  return moment_Nm;
}

std::unique_ptr<GraspedOrgan> graspedOrgan(TissueModel model, const Grasp& grasp) {
  if (model == TissueModel::kTwist) {
    return std::make_unique<GraspedTwist>(grasp);
  }
  SweptSolid solid = sweptSolid(*grasp.lattice, kGraspedRings);
  TwistEnds ends = graspedEnds(solid, grasp);
  const ElasticConstants constants{grasp.model->material().shearModulus_Pa, kGraspedPoisson};
  DynamicsOptions dynamics;
  dynamics.drag_per_s = criticalDrag_per_s(constants, dynamics.density_kg_per_m3, grasp.lattice->length_m());
  if (model == TissueModel::kFiniteElements) {
    CorotationalFrames frames(solid, std::move(ends), constants, dynamics);
    return std::make_unique<GraspedBody<CorotationalFrames>>(std::move(solid), std::move(frames));
  }
  XpbdFrames frames(solid, std::move(ends), springsOf(solid, grasp, constants), dynamics, kGraspSubsteps);
  return std::make_unique<GraspedBody<XpbdFrames>>(std::move(solid), std::move(frames));
}

}  // namespace torsio
