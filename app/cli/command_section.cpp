// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "sim/tissue/section/outline_file.h"
#include "sim/tissue/section/section_solver.h"

namespace torsio::cli {

namespace {

struct SectionArguments {
  std::string file;
  std::string method = "auto";
  std::vector<std::string> holes;
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

void runSection(const SectionArguments& arguments) {
  const auto outline = readOutline(arguments.file);
  std::vector<std::vector<std::array<double, 2>>> holes;
  for (const std::string& hole : arguments.holes) {
    holes.push_back(readOutline(hole));
  }
  SectionSolverOptions options;
  options.method = methodOf(arguments.method);
  const SectionProperties section = solveSection(outline, options, holes);
  nlohmann::ordered_json result;
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
  if (arguments.json) {
    std::cout << result.dump(2) << '\n';
    return;
  }
  for (const auto& [key, value] : result.items()) {
    std::cout << key << " = " << value.dump() << '\n';
  }
}

}  // namespace

void addSection(CLI::App& program) {
  auto arguments = std::make_shared<SectionArguments>();
  CLI::App* command = program.add_subcommand(
      "section", "Torsion properties of one cross-section by the membrane analogy (G = 1, unit twist rate)");
  command->add_option("FILE", arguments->file, "Outline: one x,y a line, any unit")->required();
  command->add_option("--hole", arguments->holes, "Outline of a hole; may be repeated");
  command->add_option("--method", arguments->method, "Solver: auto, fem or bem")
      ->check(CLI::IsMember({"auto", "fem", "bem"}));
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { runSection(*arguments); });
}

}  // namespace torsio::cli
