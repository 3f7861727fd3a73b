// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/organ_make.h"
#include "app/cli/organ_reconstruct.h"
#include "app/cli/organ_result.h"
#include "app/services/base/assets.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/scene/organ_import.h"

namespace torsio::cli {

namespace {

constexpr double kMetresPerMillimetre = 1e-3;

struct OrganImportArguments {
  std::string file;
  OrganResultOptions result;
  std::optional<double> scale;  // millimetres per file unit
  std::string unit = "mm";
  bool closeHoles = false;
};

void runOrganImport(const OrganImportArguments& arguments) {
  OrganImportRequest request;
  request.assets = assetsFolder();
  request.file = arguments.file;
  request.scale_m = arguments.scale ? *arguments.scale * kMetresPerMillimetre : lengthUnit_m(arguments.unit);
  request.closeHoles = arguments.closeHoles;
  applyOrganResultOptions(arguments.result, request.scale_m, request);
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
  command->add_option("--organ-unit", arguments->unit, "Unit of the file: m, cm, mm or um")
      ->check(CLI::IsMember({"m", "cm", "mm", "um"}))
      ->excludes(scale)
      ->capture_default_str();
  command->add_flag("--close-holes", arguments->closeHoles,
                    "Close gaps of the surface, and the open ends of a tube");
  command->callback([arguments] { runOrganImport(*arguments); });
  addOrganReconstruct(*organ);
  addOrganMake(*organ);
}

}  // namespace torsio::cli
