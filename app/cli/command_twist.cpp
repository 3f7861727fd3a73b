// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/organ_option.h"
#include "sim/base/angle.h"
#include "sim/base/error.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/scene/scene.h"

namespace torsio::cli {

namespace {

using SteadyClock = std::chrono::steady_clock;

struct TwistArguments {
  OrganArguments organ;
  std::optional<double> angle_deg;
  std::optional<double> grasp;
  std::string out;
  bool json = false;
};

double millisecondsSince(SteadyClock::time_point start) {
  return std::chrono::duration<double, std::milli>(SteadyClock::now() - start).count();
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

void runTwist(const TwistArguments& arguments) {
  const auto started = SteadyClock::now();
  const Scene scene = loadScene(sceneRequest(arguments.organ));
  const double setUp_ms = millisecondsSince(started);
  const double length_m = scene.lattice().length_m();
  const double grasp = arguments.grasp.value_or(scene.pattern.graspArc);
  if (!(grasp > 0.0 && grasp <= 1.0)) {
    throw Error(ErrorCode::kBadParameter,
                Text::verbatim("the grasp must lie in (0, 1], as a fraction of the organ's length"),
                "--grasp " + std::to_string(grasp), Text::verbatim("Give a fraction such as 0.8"));
  }
  const double angle_rad =
      arguments.angle_deg ? radians(*arguments.angle_deg) : scene.pattern.targetAngle_rad;
  constexpr double kLargestAngle_deg = 3600.0;
  if (!(std::abs(angle_rad) <= radians(kLargestAngle_deg))) {
    throw Error(ErrorCode::kBadParameter, Text::verbatim("the angle must lie within 3600 degrees"),
                "--angle " + std::to_string(arguments.angle_deg.value_or(0.0)),
                Text::verbatim("Give the angle in degrees"));
  }
  const TwistState state{grasp * length_m, angle_rad};

  const auto deforming = SteadyClock::now();
  TriangleMesh twisted = scene.mesh;
  scene.model.deform(state, twisted.vertices_m);
  const double deform_ms = millisecondsSince(deforming);
  const TwistSummary summary = scene.model.summary(state);
  if (!arguments.out.empty()) {
    const std::filesystem::path out = arguments.out;
    out.extension() == ".obj" ? writeObj(out, twisted) : writePly(out, twisted);
  }

  nlohmann::ordered_json result;
  result["organ"] = arguments.organ.organ;
  if (scene.repairs.any()) {
    result["repairs"] = scene.repairs.text();
  }
  result["pattern"] = scene.pattern.id;
  result["formulation"] = scene.model.options().formulation == Formulation::kPaper ? "paper" : "saint-venant";
  result["ridges"] = scene.lattice().ridges();
  result["sections"] = scene.lattice().sections();
  result["patches"] = scene.lattice().patches();
  result["length_m"] = length_m;
  result["grasp_s_m"] = state.graspArc_m;
  result["angle_rad"] = angle_rad;
  result["torque_nm"] = summary.torque_Nm;
  result["compliance_rad_per_nm"] = scene.model.graspCompliance(state.graspArc_m);
  result["max_displacement_m"] = summary.maxDisplacement_m;
  result["radius_change"] = summary.maxRadiusGrowth;
  result["det_f_min"] = summary.minDeterminant;
  result["det_f_max"] = summary.maxDeterminant;
  result["peak_shear_pa"] = summary.peakShear_Pa;
  result["set_up_ms"] = setUp_ms;
  result["deform_ms"] = deform_ms;
  if (!arguments.out.empty()) {
    result["out"] = arguments.out;
  }
  result["profile"] = angleProfile(scene.model, state);
  if (arguments.json) {
    std::cout << result.dump(2) << '\n';
    return;
  }
  for (const auto& [key, value] : result.items()) {
    if (!value.is_array()) {
      std::cout << key << " = " << value.dump() << '\n';
    }
  }
}

}  // namespace

void addTwist(CLI::App& program) {
  auto arguments = std::make_shared<TwistArguments>();
  CLI::App* command =
      program.add_subcommand("twist", "Twist an organ and say what it costs: angles, torque, volume");
  addOrganOptions(*command, arguments->organ);
  command->add_option("--angle", arguments->angle_deg,
                      "Angle at the grasp in degrees; default: the pattern's target");
  command->add_option("--grasp", arguments->grasp,
                      "Where it is gripped, fraction of the length from the fixed end");
  command->add_option("--out", arguments->out,
                      "Write the twisted surface as PLY or OBJ, by its ending (millimetres)");
  command->add_flag("--json", arguments->json, "Print JSON with the angle at every section");
  command->callback([arguments] { runTwist(*arguments); });
}

}  // namespace torsio::cli
