// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/rod_twist.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "sim/baseline/reference_solid.h"
#include "sim/baseline/twist_simulation.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/short_number.h"
#include "sim/tissue/hollow/wrung_organ.h"
#include "sim/tissue/rod/rod.h"
#include "sim/tissue/rod/rod_sections.h"
#include "sim/tissue/rod/rod_skin.h"
#include "sim/tissue/rod/rod_solve.h"

namespace torsio::cli {

namespace {

// Rotation along the rod, cubic between nodes. The twist rate jumps at the turned section, beyond which
// nothing transmits torque, so the two sides are interpolated separately.
class NodeTurns {
 public:
  NodeTurns(std::span<const double> arcs_m, std::span<const double> turns_rad, std::size_t jump)
      : arcs_(arcs_m), turns_(turns_rad), jump_(jump) {}

  [[nodiscard]] double at(double arc_m) const {
    const auto after = std::upper_bound(arcs_.begin() + 1, arcs_.end() - 1, arc_m);
    const auto i = static_cast<std::size_t>(after - arcs_.begin()) - 1;
    const double h = arcs_[i + 1] - arcs_[i];
    const double w = std::clamp((arc_m - arcs_[i]) / h, 0.0, 1.0);
    const double rise = turns_[i + 1] - turns_[i];
    const double from = h * slope(i, i) - rise;
    const double to = rise - h * slope(i + 1, i);
    return turns_[i] + w * rise + w * (1.0 - w) * ((1.0 - w) * from + w * to);
  }

 private:
  // Slope at a node of the parabola through it and its neighbours, on the `side` of an element.
  [[nodiscard]] double slope(std::size_t node, std::size_t side) const {
    const std::size_t first = side >= jump_ ? jump_ : 0;
    const std::size_t last = side >= jump_ ? arcs_.size() - 1 : std::min(jump_, arcs_.size() - 1);
    const auto rate = [this](std::size_t i) {
      return (turns_[i + 1] - turns_[i]) / (arcs_[i + 1] - arcs_[i]);
    };
    if (last - first < 2) {
      return rate(first);
    }
    const std::size_t middle = std::clamp(node, first + 1, last - 1);
    const double bend =
        (rate(middle) - rate(middle - 1)) / (arcs_[middle + 1] - arcs_[middle - 1]);  // half the curvature
    return rate(middle - 1) + bend * (2.0 * arcs_[node] - arcs_[middle - 1] - arcs_[middle]);
  }

  std::span<const double> arcs_;
  std::span<const double> turns_;
  std::size_t jump_;
};

std::size_t nearestNode(std::span<const double> arcs_m, double arc_m) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < arcs_m.size(); ++i) {
    if (std::abs(arcs_m[i] - arc_m) < std::abs(arcs_m[nearest] - arc_m)) {
      nearest = i;
    }
  }
  return std::max<std::size_t>(nearest, 1);  // the first section is clamped
}

// The twist of an element is only known modulo a turn: more than half a turn appears as less in the other
// direction.
Text gatheredTwist(const RodPose& pose, std::span<const double> arcs_m, std::span<const double> turns_rad) {
  for (std::size_t i = 0; i + 1 < arcs_m.size(); ++i) {
    const double length_m = arcs_m[i + 1] - arcs_m[i];
    const double own_rad = length_m * rodStrain(length_m, pose.nodes[i], pose.nodes[i + 1]).curvature_per_m.z;
    if (std::abs(turns_rad[i + 1] - turns_rad[i] - own_rad) > kPi) {
      return Text::verbatim("the twist gathers in one place: more than half a turn within %1 mm",
                            shortNumber(1000.0 * length_m));
    }
  }
  return {};
}

// Turns the rod; where it finds no pose at rest on the way, to the last angle at which it does.
TurnedRod turnedAsFarAsItGoes(const Rod& rod, RodTurn turn, RodTwistResult& result) {
  TurnedRod solved = solveTurned(rod, turn);
  result.angle_rad = turn.angle_rad;
  if (!solved.balance.converged) {
    result.angle_rad = turn.angle_rad = solved.balanced_rad;
    result.beyond = Text::verbatim("the turn ends at %1 degrees: beyond it the rod finds no pose at rest",
                                   shortNumber(degrees(turn.angle_rad)));
    solved = solveTurned(rod, turn);
  }
  return solved;
}

TwistReference turnedReference(const SectionLattice& lattice, const RodTwistRequest& request,
                               std::span<const double> arcs_m) {
  constexpr int kRings = 2;
  const double length_m = lattice.length_m();
  TwistHold hold{{arcs_m.front() / length_m, std::min(1.0, arcs_m.back() / length_m)}};
  if (request.ends == RodEnds::kClampedFree) {
    hold.grasp = request.grasp;
  }
  ReferenceSolid solid(sweptSolid(lattice, kRings), {request.shearModulus_Pa, request.poisson}, hold, {},
                       request.referenceElements);
  solid.turnTo(request.angle_rad);
  TwistReference reference;
  reference.elements = request.referenceElements;
  reference.torque_Nm = solid.torque_Nm();
  reference.energy_J = solid.energy_J();
  reference.unknowns = solid.unknowns();
  reference.turn_rad = sectionTurns_rad(solid.solid(), solid.pose().places_m);
  return reference;
}

}  // namespace

RodTwistResult rodTwist(const Scene& scene, const RodTwistRequest& request) {
  const SectionLattice& lattice = scene.lattice();
  const SolvedSections sections = solvedSections(lattice, scene.model.options());
  const bool free = request.ends == RodEnds::kClampedFree;
  const double grasp_m = free ? request.grasp * lattice.length_m() : lattice.length_m();
  const OrganRod organ = rodOfOrgan(lattice, sections,
                                    {.shearModulus_Pa = request.shearModulus_Pa,
                                     .poisson = request.poisson,
                                     .wall = request.wall,
                                     .corrections = {.taper = true, .restrainedEnds = true},
                                     .ends = free ? EndCondition::kClampedFree : EndCondition::kBothHeld},
                                    {.elements = request.reference ? rodElementsOn(lattice) : kRodElements,
                                     .node_m = free ? grasp_m : -1.0});
  const Rod rod(organ.elements, organ.rest, organ.radii_m);
  const std::size_t turned = nearestNode(organ.arcs_m, grasp_m);
  const double halfWidth_m = request.jaw ? 0.5 * organ.radii_m[turned] : 0.0;
  if (organ.arcs_m[turned] - halfWidth_m <= organ.arcs_m[0]) {
    refuseParameter(Text::verbatim("the jaw would reach the clamped face"),
                    "--grasp " + std::to_string(request.grasp), Text::verbatim("Grip further away from it."));
  }
  RodTwistResult result;
  const TurnedRod solved = turnedAsFarAsItGoes(rod,
                                               {.angle_rad = request.angle_rad,
                                                .node = static_cast<int>(turned),
                                                .holdsPlace = !free,
                                                .halfWidth_m = halfWidth_m},
                                               result);
  if (result.beyond.empty()) {
    result.beyond = gatheredTwist(solved.pose, organ.arcs_m, solved.turn_rad);
  }
  result.nodeArcs_m = organ.arcs_m;
  const NodeRange jaw = nodesAround(organ.elements, organ.arcs_m[turned] - organ.arcs_m[0], halfWidth_m,
                                    static_cast<int>(organ.arcs_m.size()));
  const NodeTurns turns(organ.arcs_m, solved.turn_rad, static_cast<std::size_t>(jaw.first));
  for (int j = 0; j < lattice.sections(); ++j) {
    result.arcs_m.push_back(lattice.sectionArc_m(j));
    result.turn_rad.push_back(turns.at(result.arcs_m.back()));
  }
  result.torque_Nm = solved.torque_Nm;
  result.energy_J = solved.balance.energy_J;
  result.elements = static_cast<int>(organ.elements.size());
  const RodSkin skin(organ, lattice, sections, scene.mesh);
  const RodCurve curve = skin.curveOf(solved.pose);
  result.vertices_m.resize(scene.mesh.vertices_m.size());
  skin.deform(curve, result.vertices_m);
  for (const Vec3& rest_m : scene.mesh.vertices_m) {
    const Vec3 back_m = skin.toRest_m(skin.toDeformed_m(rest_m, curve), curve);
    result.inverse_m = std::max(result.inverse_m, norm(back_m - rest_m));
  }
  result.fold = FoldCheck(scene.mesh, lattice).judge(result.vertices_m, [&](const Vec3& rest_m) {
    return skin.toDeformed_m(rest_m, curve);
  });
  if (result.beyond.empty()) {
    result.beyond = result.fold.reason();
  }
  if (request.reference) {
    RodTwistRequest reached = request;
    reached.angle_rad = result.angle_rad;
    result.reference = turnedReference(lattice, reached, organ.arcs_m);
  }
  return result;
}

nlohmann::ordered_json angleProfile(const TwistModel& model, const TwistState& state) {
  nlohmann::ordered_json profile = nlohmann::ordered_json::array();
  for (int j = 0; j < model.lattice().sections(); ++j) {
    const double arc_m = model.lattice().sectionArc_m(j);
    profile.push_back({{"s_m", arc_m},
                       {"phi_rad", model.angleAt(arc_m, state)},
                       {"rate_rad_per_m", model.twistRateAt(arc_m, state)}});
  }
  return profile;
}

nlohmann::ordered_json twistProfile(const Scene& scene, const RodPose& pose) {
  nlohmann::ordered_json profile = nlohmann::ordered_json::array();
  const SectionLattice& lattice = scene.lattice();
  for (int j = 0; j < lattice.sections(); ++j) {
    const double arc_m = lattice.sectionArc_m(j);
    profile.push_back({{"s_m", arc_m}, {"rate_rad_per_m", scene.rod->twistRateAt(arc_m, pose)}});
  }
  return profile;
}

nlohmann::ordered_json turnProfile(const RodTwistResult& twist) {
  nlohmann::ordered_json profile = nlohmann::ordered_json::array();
  for (std::size_t j = 0; j < twist.arcs_m.size(); ++j) {
    nlohmann::ordered_json section{{"s_m", twist.arcs_m[j]}, {"phi_rad", twist.turn_rad[j]}};
    if (twist.reference) {
      section["reference_phi_rad"] = twist.reference->turn_rad[j];
    }
    profile.push_back(std::move(section));
  }
  return profile;
}

nlohmann::ordered_json hollowProfile(const Scene& scene, const OrganState& state) {
  nlohmann::ordered_json profile = nlohmann::ordered_json::array();
  for (int j = 0; j < scene.lattice().sections(); ++j) {
    const double arc_m = scene.lattice().sectionArc_m(j);
    const HollowOrgan::Section section = scene.hollow->sectionAt(arc_m, state);
    profile.push_back({{"s_m", arc_m}, {"phi_rad", section.turn_rad}, {"radius", section.radius}});
  }
  return profile;
}

nlohmann::ordered_json modelResult(const Scene& scene, const TwistState& state) {
  const TwistSummary summary = scene.model.summary(state);
  nlohmann::ordered_json result;
  result["angle_rad"] = state.graspAngle_rad;
  result["torque_nm"] = summary.torque_Nm;
  result["compliance_rad_per_nm"] = scene.model.graspCompliance(state.graspArc_m);
  result["max_displacement_m"] = summary.maxDisplacement_m;
  result["radius_change"] = summary.maxRadiusGrowth;
  return result;
}

nlohmann::ordered_json taskResult(const Scene& scene, const TaskPoint& point) {
  static constexpr std::array kAxes{"own", "line", "instrument"};
  nlohmann::ordered_json result;
  result["axis"] = kAxes.at(static_cast<std::size_t>(scene.rod->task().axis));
  result["angle_rad"] = point.angle_rad;
  result["hand_rad"] = point.hand_rad;
  result["torque_nm"] = point.torque_Nm;
  result["force_n"] = point.force_N;
  result["sharpest_bend"] = scene.rod->skin().sharpestBend(scene.rod->skin().curveOf(point.pose));
  return result;
}

nlohmann::ordered_json hollowResult(const HollowOrgan& organ, const OrganState& state) {
  const HollowReading& reading = state.hollow.reading;
  const double angle_rad = state.twist.graspAngle_rad;
  nlohmann::ordered_json result;
  result["angle_rad"] = angle_rad;
  result["torque_nm"] = organ.torque_Nm(angle_rad, reading.pressure_Pa);
  result["peak_torque_nm"] = organ.peakTorque_Nm(reading.pressure_Pa);
  result["pressure_mmhg"] = reading.pressure_Pa / kPascalsPerMmHg;
  result["patency"] = reading.patency;
  result["flow"] = reading.flow;
  if (organ.tube(0) != nullptr) {
    result["waist_mm"] = 1000.0 * organ.waist_m(angle_rad, reading.pressure_Pa);
    result["onset_deg"] = degrees(organ.onset_rad(reading.pressure_Pa));
    result["closing_deg"] = degrees(organ.closing_rad(reading.pressure_Pa));
  }
  return result;
}

}  // namespace torsio::cli
