// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/twist_json.h"

#include <array>
#include <cstddef>
#include <utility>

#include "sim/core/angle.h"
#include "sim/tissue/hollow/wrung_organ.h"

namespace torsio::cli {

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
