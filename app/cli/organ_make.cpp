// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/organ_make.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/organ_result.h"
#include "app/services/base/assets.h"
#include "app/services/organs/person_arm.h"
#include "sim/scene/organ_import.h"

namespace torsio::cli {

namespace {

struct ArmArguments {
  PersonArm person;
  double wristWidth_mm = kWristWidth.man_mm;
  double wristThickness_mm = kWristThickness.man_mm;
  std::vector<double> fingers_mm;
  OrganResultOptions result;
};

void runMakeArm(const CLI::App& command, ArmArguments& arguments) {
  PersonArm person = arguments.person;
  if (command.count("--wrist-width") + command.count("--wrist-thickness") > 0) {
    person.wristWidth_mm = arguments.wristWidth_mm;
    person.wristThickness_mm = arguments.wristThickness_mm;
  }
  if (!arguments.fingers_mm.empty()) {
    std::copy(arguments.fingers_mm.begin(), arguments.fingers_mm.end(), person.fingers_mm.begin());
  }
  OrganImportRequest named;
  applyOrganResultOptions(arguments.result, 1.0, named);  // rejects a name that is not an organ file's
  const JudgedArm arm = importArm(person, assetsFolder());
  finishOrgan(arm.import, arguments.result, "arm", organJson(arm.import, arguments.result.out));
  if (!arguments.result.out.empty()) {
    writeArmMarkers(arguments.result.out, *arm.drawn);
  }
}

}  // namespace

void addOrganMake(CLI::App& organ) {
  CLI::App* make = organ.add_subcommand("make", "Make an organ with a person's measurements");
  make->require_subcommand(1);
  CLI::App* command = make->add_subcommand("arm", "Forearm and hand; default measurements: a man's");
  auto arguments = std::make_shared<ArmArguments>();
  PersonArm& person = arguments->person;
  const auto length = [command](const char* name, double& value_mm, const PersonLength& range,
                                const char* what) {
    command->add_option(name, value_mm, std::string(what) + ", mm")
        ->check(CLI::Range(range.least_mm, range.most_mm))
        ->capture_default_str();
  };
  length("--wrist-width", arguments->wristWidth_mm, kWristWidth, "Width of the wrist");
  length("--wrist-thickness", arguments->wristThickness_mm, kWristThickness, "Thickness of the wrist");
  length("--forearm-length", person.forearmLength_mm, kForearmLength, "Elbow crease to wrist crease");
  length("--palm-length", person.palmLength_mm, kPalmLength, "Wrist crease to crease of the middle finger");
  length("--hand-breadth", person.handBreadth_mm, kHandBreadth, "Breadth of the hand at the knuckles");
  length("--hand-thickness", person.handThickness_mm, kHandThickness, "Thickness of the hand");
  command->add_option("--fingers", arguments->fingers_mm, "Lengths of thumb to little finger, mm")
      ->expected(5)
      ->check(CLI::Range(kFingers[0].least_mm, kFingers[0].most_mm));
  command->add_option("--out", arguments->result.out,
                      "Organ file to write when accepted, NAME.organ, with NAME_markers.json");
  command->add_flag("--json", arguments->result.json, "Print JSON");
  command->callback([command, arguments] { runMakeArm(*command, *arguments); });
}

}  // namespace torsio::cli
