// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/twist_simulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/baseline/corotational_frames.h"
#include "sim/baseline/equilibrium.h"
#include "sim/baseline/reference_solid.h"
#include "sim/baseline/spring_lattice.h"
#include "sim/baseline/xpbd_frames.h"
#include "sim/core/error.h"
#include "sim/tissue/twist/twist_model_view.h"

namespace torsio {

namespace {

LatticePlaces outlinesOf(const SweptSolid& solid, std::span<const Vec3> places_m) {
  LatticePlaces places{solid.ridges, solid.sections, {}};
  for (int j = 0; j < solid.sections; ++j) {
    for (int k = 0; k < solid.ridges; ++k) {
      places.places_m.push_back(places_m[static_cast<std::size_t>(solid.point(j, solid.rings, k))]);
    }
  }
  return places;
}

class TwistModelRun final : public TwistSimulation {
 public:
  TwistModelRun(const ComparedOrgan& organ, const TwistModel& model)
      : organ_(organ),
        model_(model),
        view_(model),
        xyz_(3 * organ.mesh->vertices_m.size()),
        points_(*organ.mesh, *organ.lattice) {}

  void step(double torque_Nm) override {
    settle(torque_Nm);
    view_.update(state_, xyz_);
  }
  void settle(double torque_Nm) override {
    torque_Nm_ = torque_Nm;
    state_ = model_.stateForTorque(organ_.graspArc_m(), torque_Nm);
  }
  [[nodiscard]] double angle_rad() const override { return model_.angleAt(organ_.graspArc_m(), state_); }
  [[nodiscard]] double energy_J() const override { return 0.5 * torque_Nm_ * angle_rad(); }
  [[nodiscard]] LatticePlaces surface() const override {
    std::vector<Vec3> vertices(organ_.mesh->vertices_m.size());
    model_.deform(state_, vertices);
    return points_.at(*organ_.mesh, vertices);
  }
  [[nodiscard]] int unknowns() const override { return organ_.lattice->sections() - 1; }

 private:
  ComparedOrgan organ_;
  const TwistModel& model_;
  TwistView view_;
  std::vector<float> xyz_;
  CarriedKeyPoints points_;
  TwistState state_;
  double torque_Nm_ = 0.0;
};

/// Finds the equilibrium under a torque that grows from nothing.
EquilibriumReport equilibriumFromRest(Equilibrium& newton, const SweptSolid& solid, const TwistEnds& ends,
                                      double torque_Nm, TwistPose& pose) {
  constexpr int kSteps = 8;
  pose = {solid.points_m};
  double share = kFirstShare;
  EquilibriumReport report = newton.solve(share * torque_Nm, pose);
  for (int step = 1; step <= kSteps; ++step) {
    const double next = static_cast<double>(step) / kSteps;
    pose = turnedOn(solid, ends, pose, next / share);
    report = newton.solve(next * torque_Nm, pose);
    share = next;
  }
  return report;
}

/// A model in motion: frames of its own kind, and Newton's method when it is to come to rest.
template <class Frames>
class MovingRun final : public TwistSimulation {
 public:
  MovingRun(SweptSolid solid, Frames frames, std::function<void()> check)
      : solid_(std::move(solid)),
        frames_(std::move(frames)),
        check_(std::move(check)),
        pose_(frames_.pose()) {}

  void step(double torque_Nm) override {
    frames_.step(torque_Nm);
    pose_ = frames_.pose();
    settled_ = false;
  }
  void settle(double torque_Nm) override {
    Equilibrium newton(frames_.body(), frames_.ends(), solid_.points_m, check_);
    try {
      pose_ = nearestTo(torque_Nm);
      energy_J_ = newton.solve(torque_Nm, pose_).energy_J;
    } catch (const Error&) {  // the frames have torn it: springs with few substeps do
      energy_J_ = equilibriumFromRest(newton, solid_, frames_.ends(), torque_Nm, pose_).energy_J;
    }
    settled_ = true;
  }
  [[nodiscard]] double angle_rad() const override { return pose_.angle_rad; }
  [[nodiscard]] double energy_J() const override {
    return settled_ ? energy_J_ : elasticEnergy_J(frames_.body(), pose_.places_m);
  }
  [[nodiscard]] LatticePlaces surface() const override { return outlinesOf(solid_, pose_.places_m); }
  [[nodiscard]] int unknowns() const override { return freeUnknowns(solid_, frames_.ends()); }

 private:
  /// The pose, turned on or back as a whole, of least potential energy: golden section between half and half
  /// as much again.
  [[nodiscard]] TwistPose nearestTo(double torque_Nm) const {
    constexpr double kGolden = 0.61803398874989485;
    constexpr int kCuts = 14;
    const auto potential_J = [&](double ratio) {
      const TwistPose turned = turnedOn(solid_, frames_.ends(), frames_.pose(), ratio);
      return elasticEnergy_J(frames_.body(), turned.places_m) - torque_Nm * turned.angle_rad;
    };
    double low = 0.5;
    double high = 1.5;
    for (int cut = 0; cut < kCuts; ++cut) {
      const double width = high - low;
      const double a = high - kGolden * width;
      const double b = low + kGolden * width;
      if (potential_J(a) < potential_J(b)) {
        high = b;
      } else {
        low = a;
      }
    }
    const double ratio = 0.5 * (low + high);
    return potential_J(ratio) < potential_J(1.0) ? turnedOn(solid_, frames_.ends(), frames_.pose(), ratio)
                                                 : frames_.pose();
  }

  SweptSolid solid_;
  Frames frames_;
  std::function<void()> check_;
  TwistPose pose_;
  bool settled_ = false;
  double energy_J_ = 0.0;
};

class ReferenceRun final : public TwistSimulation {
 public:
  ReferenceRun(const ComparedOrgan& organ, int rings)
      : reference_(sweptSolid(*organ.lattice, rings), organ.constants, organ.hold, organ.check) {}

  void step(double torque_Nm) override { settle(torque_Nm); }
  void settle(double torque_Nm) override { reference_.load(torque_Nm); }
  [[nodiscard]] double angle_rad() const override { return reference_.pose().angle_rad; }
  [[nodiscard]] double energy_J() const override { return reference_.energy_J(); }
  [[nodiscard]] LatticePlaces surface() const override {
    return outlinesOf(reference_.solid(), reference_.pose().places_m);
  }
  [[nodiscard]] int unknowns() const override { return reference_.unknowns(); }

 private:
  ReferenceSolid reference_;
};

}  // namespace

std::unique_ptr<TwistSimulation> twistModelSimulation(const ComparedOrgan& organ, const TwistModel& model) {
  return std::make_unique<TwistModelRun>(organ, model);
}

std::unique_ptr<TwistSimulation> finiteElementSimulation(const ComparedOrgan& organ, int rings) {
  SweptSolid solid = sweptSolid(*organ.lattice, rings);
  CorotationalFrames frames(solid, twistEnds(solid, organ.hold), organ.constants, organ.dynamics);
  return std::make_unique<MovingRun<CorotationalFrames>>(std::move(solid), std::move(frames), organ.check);
}

std::unique_ptr<TwistSimulation> massSpringSimulation(const ComparedOrgan& organ, const TwistModel& model,
                                                      int rings, const MassSpringOptions& options) {
  SweptSolid solid = sweptSolid(*organ.lattice, rings);
  SpringLattice springs =
      calibratedSprings(solid, *organ.lattice, organ.constants, model, options.calibration, organ.check);
  XpbdFrames frames(solid, twistEnds(solid, organ.hold), std::move(springs), organ.dynamics,
                    options.substeps);
  return std::make_unique<MovingRun<XpbdFrames>>(std::move(solid), std::move(frames), organ.check);
}

std::unique_ptr<TwistSimulation> referenceSimulation(const ComparedOrgan& organ, int rings) {
  return std::make_unique<ReferenceRun>(organ, rings);
}

}  // namespace torsio
