// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "sim/core/error.h"
#include "sim/core/short_number.h"
#include "sim/tissue/section/polygon.h"
#include "sim/tissue/section/section_solver.h"
#include "sim/tissue/section/wall_section.h"

namespace torsio::cli {

namespace {

struct SectionArguments {
  std::string file;
  std::string method = "auto";
  std::vector<std::string> holes;
  std::vector<std::array<double, 2>> points;
  std::vector<double> wall;  // wall thickness: one value, or one per point of the outline; empty: solid
  bool json = false;
};

SectionMethod methodOf(const std::string& name) {
  if (name == "fem") {
    return SectionMethod::kFiniteElements;
  }
  if (name == "bem") {
    return SectionMethod::kBoundaryElements;
  }
  return SectionMethod::kAutomatic;
}

/// Membrane, warping and stress at the requested points.
nlohmann::ordered_json fieldAt(const SectionField& field, const std::vector<std::array<double, 2>>& points) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const std::array<double, 2>& point : points) {
    const std::optional<SectionField::Value> value = field.at(point);
    if (!value) {
      refuseParameter(field.elements.empty()
                          ? Text::verbatim("boundary elements compute nothing inside the section")
                          : Text::verbatim("the point is outside the section"),
                      "--at " + std::to_string(point[0]) + "," + std::to_string(point[1]),
                      field.elements.empty() ? Text::verbatim("Use --method fem")
                                             : Text::verbatim("Give a point in the material"));
    }
    all.push_back({{"x", point[0]},
                   {"y", point[1]},
                   {"membrane", value->membrane},
                   {"warping", value->warping},
                   {"tau_xz", value->shear[0]},
                   {"tau_yz", value->shear[1]}});
  }
  return all;
}

void printSection(const nlohmann::ordered_json& result, bool json) {
  if (json) {
    std::cout << jsonText(result) << '\n';
    return;
  }
  for (const auto& [key, value] : result.items()) {
    std::cout << key << " = " << jsonText(value, -1) << '\n';
  }
}

/// Solves a closed wall by Bredt's formula: without a field inside, so without points or choice of a solver.
void runWall(const SectionArguments& arguments) {
  if (!arguments.holes.empty() || !arguments.points.empty() || arguments.method != "auto") {
    refuseUsage("a wall is computed in closed form, without holes, points or a solver", "--wall",
                "Leave out --hole, --at and --method, or --wall");
  }
  const WallSection wall = wallSection(readOutline(arguments.file), arguments.wall);
  if (wall.thickest > wall.mostThickness) {
    std::cerr << "The inner side of the wall crosses itself where it is thicker than "
              << shortNumber(wall.mostThickness) << "; its middle line, by which J is computed, does not.\n";
  }
  nlohmann::ordered_json result;
  result["method"] = "wall";
  result["area"] = wall.area;
  result["J"] = wall.torsionConstant;
  result["volume"] = 0.25 * wall.torsionConstant;
  result["max_shear"] = wall.maxShear;
  result["area_mid"] = wall.areaMid;
  result["perimeter_mid"] = wall.perimeterMid;
  result["radius"] = wall.radius;
  result["wall"] = wall.thickest;
  result["wall_most"] = wall.mostThickness;
  printSection(result, arguments.json);
}

void runSection(const SectionArguments& arguments) {
  if (!arguments.wall.empty()) {
    runWall(arguments);
    return;
  }
  const auto outline = readOutline(arguments.file);
  std::vector<std::vector<std::array<double, 2>>> holes;
  for (const std::string& hole : arguments.holes) {
    holes.push_back(readOutline(hole));
  }
  SectionSolverOptions options;
  options.method = methodOf(arguments.method);
  SectionField field;
  const SectionProperties section = arguments.points.empty()
                                        ? solveSection(outline, options, holes)
                                        : SectionSolver(options).solve(outline, holes, &field);
  const bool rigorous = section.methodUsed == SectionMethod::kFiniteElements;
  nlohmann::ordered_json result;
  result["method"] = rigorous ? "fem" : "bem";
  result["bracket"] = rigorous ? "bounds" : "estimate";
  result["area"] = section.area;
  result["centroid"] = section.centroid;
  result["polar_moment"] = section.polarMoment;
  result["J"] = section.torsionConstant;
  result["J_lower"] = section.torsionLower;
  result["J_upper"] = section.torsionUpper;
  result["sag"] = section.sag;
  result["volume"] = section.volume;
  result["max_shear"] = section.maxShear;
  result["psi_min"] = section.warpingMin;
  result["psi_max"] = section.warpingMax;
  if (!arguments.points.empty()) {
    result["points"] = fieldAt(field, arguments.points);
  }
  printSection(result, arguments.json);
}

}  // namespace

void addSection(CLI::App& program) {
  auto arguments = std::make_shared<SectionArguments>();
  CLI::App* command = program.add_subcommand(
      "section", "Torsion properties of one cross-section by the membrane analogy (G = 1, unit twist rate)");
  command->add_option("FILE", arguments->file, "Outline: one x,y a line, any unit")->required();
  command->add_option("--hole", arguments->holes, "Outline of a hole; may be repeated");
  command
      ->add_option("--at", arguments->points,
                   "Point x,y: membrane, warping and stress there; may be repeated")
      ->delimiter(',');
  command
      ->add_option("--wall", arguments->wall,
                   "Thickness of a wall inside the outline, in its unit: one value, or one per point")
      ->delimiter(',')
      ->expected(1, -1);
  command->add_option("--method", arguments->method, "Solver: auto, fem or bem")
      ->check(CLI::IsMember({"auto", "fem", "bem"}));
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { runSection(*arguments); });
}

}  // namespace torsio::cli
