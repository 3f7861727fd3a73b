// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/organ_result.h"
#include "app/cli/progress_line.h"
#include "app/services/base/assets.h"
#include "app/services/organs/person_arm.h"
#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_space.h"
#include "sim/imaging/surface/scan_surface.h"
#include "sim/scene/organ_import.h"

namespace torsio::cli {

namespace {

constexpr double kScanUnit_m = 1e-3;

struct ReconstructArguments {
  std::string source;
  std::vector<std::string> tissue;
  std::vector<double> seed;
  std::vector<double> box;
  int series = 0;
  bool resample = false;
  bool fluid = false;
  OrganResultOptions result;
};

ScanTissue tissueNamed(const std::vector<std::string>& words, int& label) {
  constexpr std::array<std::pair<const char*, ScanTissue>, 3> kNames{
      {{"skin", ScanTissue::kSkin}, {"gas-lumen", ScanTissue::kGasLumen}, {"wall", ScanTissue::kWall}}};
  for (const auto& [name, tissue] : kNames) {
    if (words.size() == 1 && words[0] == name) {
      return tissue;
    }
  }
  if (words.size() == 2 && words[0] == "label") {
    const std::string& number = words[1];
    const auto read = std::from_chars(number.data(), number.data() + number.size(), label);
    if (read.ec == std::errc() && read.ptr == number.data() + number.size()) {
      return ScanTissue::kLabel;
    }
  }
  refuseUsage("no such tissue", "--tissue", "Name skin, gas-lumen, wall or label N");
}

ScanRequest scanRequest(const ReconstructArguments& arguments) {
  ScanRequest scan;
  scan.source = arguments.source;
  scan.tissue = tissueNamed(arguments.tissue, scan.label);
  if (const auto& seed = arguments.seed; !seed.empty()) {
    scan.seed_mm = Vec3{seed[0], seed[1], seed[2]};
  }
  if (const auto& box = arguments.box; !box.empty()) {
    scan.box_mm = ScanBox{Vec3{box[0], box[1], box[2]}, Vec3{box[3], box[4], box[5]}};
  }
  scan.series = arguments.series;
  scan.resample = arguments.resample;
  scan.fluid = arguments.fluid;
  scan.wall_mm = arguments.result.wall_mm;
  return scan;
}

nlohmann::ordered_json reconstructJson(const OrganReconstruction& made, const std::string& out) {
  nlohmann::ordered_json json = organJson(made.import, out);
  json["euler"] = made.euler;
  json["seconds"] = made.processor_s;
  json["peak_mb"] = made.peak_MB;
  const ScanSurface& scan = made.scan;
  json["scan"] = scan.kind;
  json["voxels"] = scan.count;
  json["voxel_mm"] = {scan.voxel_mm.x, scan.voxel_mm.y, scan.voxel_mm.z};
  json["drawn_at_mm"] = scan.step_mm;
  json["triangles_drawn"] = scan.rawTriangles;
  json["level_hu"] = scan.level_HU ? nlohmann::ordered_json(*scan.level_HU) : nlohmann::ordered_json(nullptr);
  if (const auto& wall = scan.wall) {
    json["wall"] = {{"median_mm", wall->median_mm},
                    {"p10_mm", wall->tenth_mm},
                    {"p90_mm", wall->ninety_mm},
                    {"seen", wall->seen}};
  } else {
    json["wall"] = nullptr;
  }
  return json;
}

void runReconstruct(const ReconstructArguments& arguments) {
  OrganImportRequest request;
  request.assets = assetsFolder();
  applyOrganResultOptions(arguments.result, kScanUnit_m, request);
  const ScanRequest scan = scanRequest(arguments);
  OrganReconstruction made;
  {
    ProgressLine line;
    made = reconstructOrgan(std::move(request), scan, [&line](ScanStep step, double fraction) {
      const ScanStepShare share = shareOf(step);
      line.show({share.words, share.at(fraction), -1.0});
    });
  }
  finishOrgan(made.import, arguments.result, arguments.source, reconstructJson(made, arguments.result.out));
}

void addOrganReconstruct(CLI::App& organ) {
  auto arguments = std::make_shared<ReconstructArguments>();
  CLI::App* command = organ.add_subcommand(
      "reconstruct", "Make an organ from a scan: a folder of DICOM files, or NIfTI (.nii, .nii.gz)");
  command->add_option("SOURCE", arguments->source, "Folder or file of the scan")->required();
  command->add_option("--tissue", arguments->tissue, "skin, gas-lumen, wall, or label N of a label mask")
      ->required()
      ->expected(1, 2);
  command->add_option("--seed", arguments->seed, "x,y,z of a point inside, mm: left, back, up")
      ->delimiter(',')
      ->expected(3);
  command->add_option("--box", arguments->box, "x,y,z,x,y,z: two corners of the region to use, mm")
      ->delimiter(',')
      ->expected(6);
  command->add_option("--series", arguments->series, "Which of several series, by its number in the list")
      ->check(CLI::Range(1, 100'000));
  command->add_flag("--fluid", arguments->fluid,
                    "With gas-lumen or wall: include the fluid below the gas, down to the wall");
  command->add_flag("--resample", arguments->resample, "Accept unevenly spaced slices");
  addOrganResultOptions(*command, arguments->result, "mm");
  command->callback([arguments] { runReconstruct(*arguments); });
}

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

/// Adds `make arm`: an arm with a person's measurements.
void addOrganMake(CLI::App& organ) {
  CLI::App* make = organ.add_subcommand("make", "Make an organ with a person's measurements");
  make->require_subcommand(1);
  CLI::App* command = make->add_subcommand("arm", "Forearm and hand; default measurements: a man's");
  auto arguments = std::make_shared<ArmArguments>();
  PersonArm& person = arguments->person;
  const auto length = [command](const char* name, double& value_mm, const PersonLength& range,
                                const char* what) {
    addDefaulted(*command, name, value_mm, std::string(what) + ", mm",
                 CLI::Range(range.least_mm, range.most_mm));
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

constexpr double kMetresPerMillimetre = 1e-3;

struct OrganImportArguments {
  std::string file;
  OrganResultOptions result;
  std::optional<double> scale;  // millimetres per file unit
  std::string unit;             // empty: not given
  bool closeHoles = false;
};

void runOrganImport(const OrganImportArguments& arguments) {
  OrganImportRequest request;
  request.assets = assetsFolder();
  request.file = arguments.file;
  request.scale_m = arguments.scale ? meshUnit_m(request.file, *arguments.scale * kMetresPerMillimetre)
                                    : unitOf_m(arguments.file, arguments.unit);
  request.closeHoles = arguments.closeHoles;
  applyOrganResultOptions(arguments.result, request.scale_m, request, meshSpaceOf(request.file));
  const OrganImport import = importOrgan(request);
  finishOrgan(import, arguments.result, arguments.file, organJson(import, arguments.result.out));
}

}  // namespace

void addOrgan(CLI::App& program) {
  CLI::App* organ = program.add_subcommand("organ", "Organs of your own");
  organ->require_subcommand(1);
  auto arguments = std::make_shared<OrganImportArguments>();
  CLI::App* command = organ->add_subcommand(
      "import", "Check, repair and judge a mesh (obj, stl, ply, off, glb, gltf, dae) as an organ");
  command->add_option("FILE", arguments->file, "Mesh file")->required();
  addOrganResultOptions(*command, arguments->result, "the file's unit");
  CLI::Option* scale =
      command->add_option("--scale", arguments->scale, "Millimetres in one unit of the file, such as 1000");
  addUnitOption(*command, arguments->unit)->excludes(scale);
  command->add_flag("--close-holes", arguments->closeHoles,
                    "Close gaps of the surface, and the open ends of a tube");
  command->callback([arguments] { runOrganImport(*arguments); });
  addOrganReconstruct(*organ);
  addOrganMake(*organ);
}

}  // namespace torsio::cli
