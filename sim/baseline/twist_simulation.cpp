// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/twist_simulation.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "sim/baseline/corotational_frames.h"
#include "sim/baseline/equilibrium.h"
#include "sim/baseline/reference_solid.h"
#include "sim/baseline/spring_lattice.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/tissue/rod/rod_energy.h"
#include "sim/tissue/rod/rod_sections.h"
#include "sim/tissue/rod/rod_skin.h"
#include "sim/tissue/rod/rod_solve.h"
#include "sim/tissue/rod/rod_step.h"
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
  TwistModelRun(const ComparedOrgan& organ, const TwistModel& model, Isa isa)
      : organ_(organ),
        model_(model),
        view_(model, isa),
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

constexpr double kRodTick_s = 1e-3;

/// How the rod is held in motion: the first section whole; the turned one upright, free to turn about its
/// tangent, and in its place unless a jaw has it.
RodRestraints heldSections(int turned, bool jaw) {
  RodRestraints restraints;
  restraints.held.push_back({.node = 0});
  restraints.held.push_back({.node = turned, .freedoms = {!jaw, !jaw, !jaw, true, true, false}});
  return restraints;
}

class RodRun final : public TwistSimulation {
 public:
  RodRun(const ComparedOrgan& organ, const TwistModel& model)
      : RodRun(organ, solvedSections(*organ.lattice, model.options())) {}

  void step(double torque_Nm) override {
    elapsed_s_ += organ_.dynamics.frame_s;
    for (; ticks_ * kRodTick_s < elapsed_s_; ++ticks_) {
      hand_rad_ += (torque_Nm - torqueOfHand_Nm_) / againstHand_Nm_per_rad_;
      const Pose hand{middle_.position_m, axisAngle(axis_, hand_rad_)};
      const RodStepResult tick = stepRod(rod_, &grip_, hand, kRodTick_s, pose_, *work_);
      torqueOfHand_Nm_ = -dot(tick.load.torque_Nm, axis_);
    }
    const auto node = static_cast<std::size_t>(node_);
    angle_rad_ = sectionTurn_rad(middle_.orientation, pose_.nodes[node].orientation, axis_, angle_rad_);
    draw();
  }

  void settle(double torque_Nm) override {
    // Secant on the angle: the torque of a rod rises smoothly with it.
    constexpr int kMaxTries = 25;
    constexpr double kTorqueTolerance = 1e-10;
    constexpr double kMaxTurn_rad = 10.0 * kTurn;
    double before_rad = 0.0;
    double before_Nm = 0.0;
    double angle_rad = torque_Nm * kSmallRodTurn_rad / turnedBy(kSmallRodTurn_rad).torque_Nm;
    for (int i = 0; i < kMaxTries && std::abs(angle_rad) <= kMaxTurn_rad; ++i) {
      const TurnedRod turned = turnedBy(angle_rad);
      const double error_Nm = turned.torque_Nm - torque_Nm;
      if (std::abs(error_Nm) <= kTorqueTolerance * std::abs(torque_Nm)) {
        pose_ = turned.pose;
        angle_rad_ = angle_rad;
        draw();
        return;
      }
      const double next_rad =
          angle_rad - error_Nm * (angle_rad - before_rad) / (turned.torque_Nm - before_Nm);
      before_rad = angle_rad;
      before_Nm = turned.torque_Nm;
      angle_rad = next_rad;
    }
    refuseNone();
  }

  [[nodiscard]] double angle_rad() const override { return angle_rad_; }
  [[nodiscard]] double energy_J() const override { return storedEnergy_J(rod_, pose_, nullptr, {}); }
  [[nodiscard]] LatticePlaces surface() const override { return points_.at(*organ_.mesh, vertices_m_); }
  [[nodiscard]] int unknowns() const override {
    return 6 * static_cast<int>(parts_.elements.size()) - (organ_.hold.grasp ? 2 : 5);
  }

 private:
  static constexpr double kSmallRodTurn_rad = 0.01;

  RodRun(const ComparedOrgan& organ, const SolvedSections& sections)
      : organ_(organ),
        parts_(rodOfOrgan(*organ.lattice, sections,
                          {.shearModulus_Pa = organ.constants.shearModulus_Pa,
                           .poisson = organ.constants.poissonRatio,
                           .corrections = {.taper = true, .restrainedEnds = true},
                           .ends = organ.hold.grasp ? EndCondition::kClampedFree : EndCondition::kBothHeld},
                          {.elements = rodElementsOn(*organ.lattice),
                           .node_m = organ.hold.grasp ? organ.graspArc_m() : -1.0})),
        rod_(parts_.elements, parts_.rest, parts_.radii_m,
             heldSections(turnedNode(parts_, organ), organ.hold.grasp.has_value())),
        skin_(parts_, *organ.lattice, sections, *organ.mesh),
        points_(*organ.mesh, *organ.lattice),
        node_(turnedNode(parts_, organ)),
        halfWidth_m_(organ.hold.grasp ? 0.5 * parts_.radii_m[static_cast<std::size_t>(node_)] : 0.0),
        middle_(parts_.rest.nodes[static_cast<std::size_t>(node_)]),
        axis_(rotate(middle_.orientation, {0, 0, 1})),
        pose_(parts_.rest),
        vertices_m_(organ.mesh->vertices_m) {
    if (parts_.arcs_m[static_cast<std::size_t>(node_)] - halfWidth_m_ <= parts_.arcs_m.front()) {
      refuseParameter(Text::verbatim("The jaw would reach the held end"), Text::verbatim("grasp"),
                      Text::verbatim("Grip further away from it"));
    }
    // A stiff coupling makes the jaw a rigid body. A tick meets the rod's stiffness and its damping: a hand
    // that closes the gap of the torque by their sum never overshoots.
    constexpr double kCouplingOverRod = 200.0;
    const double stiffness_Nm_per_rad = turnedBy(kSmallRodTurn_rad).torque_Nm / kSmallRodTurn_rad;
    againstHand_Nm_per_rad_ = stiffness_Nm_per_rad * (1.0 + rod_.settings().damping_s / kRodTick_s);
    const GripStiffness turning{.place_N_per_m = 0.0,
                                .turn_Nm_per_rad = kCouplingOverRod * stiffness_Nm_per_rad};
    grip_ = gripAt(rod_, pose_, node_, halfWidth_m_, {middle_.position_m, Quat{}}, turning);
  }

  static int turnedNode(const OrganRod& parts, const ComparedOrgan& organ) {
    if (!organ.hold.grasp) {
      return static_cast<int>(parts.elements.size());
    }
    const auto nearer = [&](double a, double b) {
      return std::abs(a - organ.graspArc_m()) < std::abs(b - organ.graspArc_m());
    };
    return static_cast<int>(std::min_element(parts.arcs_m.begin(), parts.arcs_m.end(), nearer) -
                            parts.arcs_m.begin());
  }

  [[noreturn]] static void refuseNone() {
    refuseParameter(Text::verbatim("The rod finds no pose at rest under this torque"),
                    Text::verbatim("torque"), Text::verbatim("Give a smaller one"));
  }

  [[nodiscard]] TurnedRod turnedBy(double angle_rad) const {
    TurnedRod turned = solveTurned(rod_, {.angle_rad = angle_rad,
                                          .node = node_,
                                          .holdsPlace = !organ_.hold.grasp.has_value(),
                                          .halfWidth_m = halfWidth_m_});
    if (!turned.balance.converged) {
      refuseNone();
    }
    return turned;
  }

  void draw() { skin_.deform(skin_.curveOf(pose_), vertices_m_); }

  ComparedOrgan organ_;
  OrganRod parts_;
  Rod rod_;
  RodSkin skin_;
  CarriedKeyPoints points_;
  int node_ = 0;
  double halfWidth_m_ = 0.0;
  Pose middle_;
  Vec3 axis_;
  RodGrip grip_;
  RodPose pose_;
  std::unique_ptr<RodWorkspace> work_ = std::make_unique<RodWorkspace>();
  std::vector<Vec3> vertices_m_;
  double elapsed_s_ = 0.0;
  int ticks_ = 0;
  double hand_rad_ = 0.0;
  double againstHand_Nm_per_rad_ = 1.0;
  double torqueOfHand_Nm_ = 0.0;
  double angle_rad_ = 0.0;
};

}  // namespace

std::unique_ptr<TwistSimulation> twistModelSimulation(const ComparedOrgan& organ, const TwistModel& model,
                                                      Isa isa) {
  return std::make_unique<TwistModelRun>(organ, model, isa);
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

int rodElementsOn(const SectionLattice& lattice) {
  return std::clamp(lattice.sections() - 1, kRodElements, kMaxRodNodes - 1);
}

std::array<double, 2> rodSpan(const SectionLattice& lattice, const TwistModel& model) {
  const OrganRod parts = rodOfOrgan(lattice, solvedSections(lattice, model.options()),
                                    {.shearModulus_Pa = model.material().shearModulus_Pa});
  return {parts.arcs_m.front() / lattice.length_m(), std::min(1.0, parts.arcs_m.back() / lattice.length_m())};
}

std::unique_ptr<TwistSimulation> rodSimulation(const ComparedOrgan& organ, const TwistModel& model) {
  return std::make_unique<RodRun>(organ, model);
}

}  // namespace torsio
