// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/organ_make.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/base/assets.h"
#include "app/cli/organ_result.h"
#include "sim/scene/organ_import.h"
#include "tools/organs/forearm.h"

namespace torsio::cli {

namespace {

struct ArmArguments {
  ArmMeasures measures;
  double wristWidth_mm = 65.0;
  double wristThickness_mm = 46.0;
  std::vector<double> fingers_mm;
  OrganResultOptions result;
};

void runMakeArm(const CLI::App& command, ArmArguments& arguments) {
  ArmMeasures measures = arguments.measures;
  if (command.count("--wrist-width") + command.count("--wrist-thickness") > 0) {
    setWrist(measures, arguments.wristWidth_mm, arguments.wristThickness_mm);
  }
  if (!arguments.fingers_mm.empty()) {
    std::copy(arguments.fingers_mm.begin(), arguments.fingers_mm.end(), measures.fingerLength_mm.begin());
  }
  const Arm arm = makeArm(measures);
  OrganImportRequest request;
  request.assets = assetsFolder();
  request.file = "arm.ply";
  applyOrganResultOptions(arguments.result, 1.0, request);
  // The patterns of the shipped forearm: the elbow is held, the hand follows the wrist.
  request.anatomy = "forearm";
  request.ends = {
      .fixedEnd_m = arm.fixedEnd_m, .freeEnd_m = arm.wrist_m, .fixedCut = {}, .freeCut = {0.0, 0.0, 1.0}};
  const OrganImport import =
      importOrgan(request, [&arm] { return RawMesh{.mesh = arm.surface, .ignored = {}}; });
  finishOrgan(import, arguments.result, "arm", organJson(import, arguments.result.out));
}

}  // namespace

void addOrganMake(CLI::App& organ) {
  CLI::App* make = organ.add_subcommand("make", "Draw an organ with the measures of a person");
  make->require_subcommand(1);
  CLI::App* command = make->add_subcommand("arm", "Forearm and hand; what is not given is that of a man");
  auto arguments = std::make_shared<ArmArguments>();
  ArmMeasures& m = arguments->measures;
  const auto length = [command](const char* name, double& value_mm, double least, double most,
                                const char* what) {
    command->add_option(name, value_mm, std::string(what) + ", mm")
        ->check(CLI::Range(least, most))
        ->capture_default_str();
  };
  length("--wrist-width", arguments->wristWidth_mm, 40.0, 90.0, "Width of the wrist");
  length("--wrist-thickness", arguments->wristThickness_mm, 28.0, 70.0, "Thickness of the wrist");
  length("--forearm-length", m.forearmLength_mm, 150.0, 350.0, "Elbow crease to wrist crease");
  length("--palm-length", m.palmLength_mm, 70.0, 150.0, "Wrist crease to crease of the middle finger");
  length("--hand-breadth", m.handBreadth_mm, 60.0, 110.0, "Breadth of the hand at the knuckles");
  length("--hand-thickness", m.handThickness_mm, 20.0, 42.0, "Thickness of the hand");
  command->add_option("--fingers", arguments->fingers_mm, "Lengths of thumb to little finger, mm")
      ->expected(5)
      ->check(CLI::Range(30.0, 110.0));
  command->add_option("--out", arguments->result.out, "Organ file to write when accepted, NAME.organ");
  command->add_flag("--json", arguments->result.json, "Print JSON");
  command->callback([command, arguments] { runMakeArm(*command, *arguments); });
}

}  // namespace torsio::cli
