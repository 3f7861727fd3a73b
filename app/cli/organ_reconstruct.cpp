// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/organ_reconstruct.h"

#include <array>
#include <charconv>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/organ_result.h"
#include "app/cli/progress_line.h"
#include "app/services/base/assets.h"
#include "sim/core/error.h"
#include "sim/imaging/surface/scan_steps.h"
#include "sim/imaging/surface/scan_surface.h"
#include "sim/scene/organ_reconstruction.h"

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
  throw Error(ErrorCode::kUsage, Text::verbatim("no such tissue"), Text::verbatim("--tissue"),
              Text::verbatim("Name skin, gas-lumen, wall or label N"));
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

}  // namespace

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

}  // namespace torsio::cli
