// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/organ_option.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include <CLI/CLI.hpp>

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
  command.add_option("--organ", arguments.organ, "Scene (arm, stomach, intestine) or mesh file")
      ->capture_default_str();
  command.add_option("--organ-unit", arguments.unit, "Unit of the mesh file: mm, cm or m")
      ->check(CLI::IsMember({"mm", "cm", "m"}))
      ->capture_default_str();
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
    throw Error(ErrorCode::kUsage, Text::verbatim("no such organ"), "--organ " + arguments.organ,
                "Choose one of " + names + ", or give a mesh file with its ending");
  }
  const auto point_m = [&request](const std::vector<double>& xyz) {
    return Vec3{xyz[0], xyz[1], xyz[2]} * request.organScale_m;
  };
  if (!arguments.fixedEnd.empty() && !arguments.freeEnd.empty()) {
    request.fixedEnd_m = point_m(arguments.fixedEnd);
    request.freeEnd_m = point_m(arguments.freeEnd);
  } else if (!arguments.fixedEnd.empty()) {
    throw Error(ErrorCode::kUsage, Text::verbatim("one end alone is not enough"),
                Text::verbatim("--fixed-end"), Text::verbatim("Give --free-end too"));
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

}  // namespace torsio::cli
