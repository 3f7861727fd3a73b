// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/organ_option.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include <CLI/CLI.hpp>

#include "app/cli/options.h"
#include "app/services/base/assets.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

const std::map<std::string, double>& unitsInMetres() {
  static const std::map<std::string, double> kUnits{{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}};
  return kUnits;
}

}  // namespace

void addOrganOptions(CLI::App& command, OrganArguments& arguments) {
  addDefaulted(command, "--organ", arguments.organ, "Scene (arm, stomach, intestine) or mesh file");
  addDefaulted(command, "--organ-unit", arguments.unit, "Unit of the mesh file: mm, cm or m",
               CLI::IsMember({"mm", "cm", "m"}));
  CLI::Option* fixedEnd =
      command
          .add_option("--fixed-end", arguments.fixedEnd,
                      "x y z of the mesh file's held end, in its unit; default: found from the shape")
          ->expected(3);
  command.add_option("--free-end", arguments.freeEnd, "x y z of its other end")->expected(3)->needs(fixedEnd);
  command.add_option("--material", arguments.material,
                     "Tissue of assets/scenes/materials.json; default: the scene's");
  command.add_option("--pattern", arguments.pattern, "Twist pattern of the scene; default: its first");
  command.add_option("--formulation", arguments.formulation, "saint-venant or paper")
      ->check(CLI::IsMember({"saint-venant", "paper"}));
  command.add_option("--ridges", arguments.ridges, "N, 3 to 360");
  command.add_option("--sections", arguments.sections, "M, 2 to 360");
}

SceneRequest sceneRequest(const OrganArguments& arguments) {
  SceneRequest request;
  request.assets = assetsFolder();
  const std::vector<std::string> known = sceneIds(request.assets);
  // Other names of scenes in use.
  static const std::map<std::string, std::string> kOtherNames{{"arm", "forearm"}, {"wrist", "forearm"}};
  const auto other = kOtherNames.find(arguments.organ);
  const std::string organ = other == kOtherNames.end() ? arguments.organ : other->second;
  if (std::find(known.begin(), known.end(), organ) != known.end()) {
    request.id = organ;
  } else if (arguments.organ.find_first_of("./\\") != std::string::npos) {
    request.organFile = std::filesystem::path(arguments.organ);
    request.organScale_m = unitsInMetres().at(arguments.unit);
  } else {
    std::string names;
    for (const std::string& id : known) {
      names += (names.empty() ? "" : ", ") + id;
    }
    refuseUsage("no such organ", "--organ " + arguments.organ,
                "Choose one of " + names + ", or give a mesh file with its ending");
  }
  const auto point_m = [&request](const std::vector<double>& xyz) {
    return Vec3{xyz[0], xyz[1], xyz[2]} * request.organScale_m;
  };
  if (!arguments.fixedEnd.empty() && !arguments.freeEnd.empty()) {
    request.fixedEnd_m = point_m(arguments.fixedEnd);
    request.freeEnd_m = point_m(arguments.freeEnd);
  } else if (!arguments.fixedEnd.empty()) {
    refuseUsage("one end alone is not enough", "--fixed-end", "Give --free-end too");
  }
  request.material = arguments.material;
  request.pattern = arguments.pattern;
  if (!arguments.formulation.empty()) {
    request.formulation = arguments.formulation == "paper" ? Formulation::kPaper : Formulation::kSaintVenant;
  }
  request.ridges = arguments.ridges;
  request.sections = arguments.sections;
  return request;
}

void addModelOptions(CLI::App& command, ModelArguments& arguments) {
  command
      .add_option("--interpolation", arguments.interpolation,
                  "With --formulation paper: angle, or components (dX, dY, dZ along each ridge, Eq. 15)")
      ->check(CLI::IsMember({"angle", "components"}));
  command.add_option("--drift", arguments.drift, "Drift of kriging: constant (Eq. 16 as printed) or linear")
      ->check(CLI::IsMember({"constant", "linear"}));
  command.add_option("--beta", arguments.choice.beta,
                     "With --formulation paper: beta of Eq. 18, in sections; default: infinite");
  command.add_flag("--clamp-lift", arguments.choice.clampLift,
                   "With --formulation paper: dZ of Eq. 23 at the clamp too, as printed");
  command.add_flag("--poynting", arguments.choice.poynting, "A twisted bar with a free end grows longer");
  command.add_flag("--restrained-ends", arguments.choice.restrainedEnds,
                   "Clamped ends keep their sections flat");
  command.add_flag("--taper", arguments.choice.taper, "Correct the compliance of a tapering organ");
  command.add_flag("--shear-centre", arguments.choice.shearCentre, "Sections turn about their shear centres");
  command.add_option("--foundation", arguments.choice.foundationLengths,
                     "Elastic foundation: sqrt(G J / k) in organ lengths, such as 0.5");
  command.add_option("--stiffening", arguments.choice.stiffeningStrain,
                     "Shear strain at which the torque has doubled against the linear law");
}

ModelChoice modelChoice(const ModelArguments& arguments) {
  ModelChoice choice = arguments.choice;
  if (!arguments.interpolation.empty()) {
    choice.interpolation = arguments.interpolation == "components" ? PaperInterpolation::kComponents
                                                                   : PaperInterpolation::kAngle;
  }
  if (!arguments.drift.empty()) {
    choice.drift = arguments.drift == "constant" ? Drift::kConstant : Drift::kLinear;
  }
  return choice;
}

}  // namespace torsio::cli
