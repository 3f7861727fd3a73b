// SPDX-License-Identifier: GPL-3.0-or-later
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
#include "app/cli/progress_line.h"
#include "sim/core/error.h"
#include "sim/core/short_number.h"
#include "sim/geometry/mesh/mesh_file_check.h"
#include "sim/geometry/mesh/mesh_space.h"
#include "sim/imaging/apart/scan_process.h"
#include "sim/imaging/surface/scan_surface.h"
#include "sim/scene/instrument_file.h"
#include "sim/scene/instrument_import.h"

namespace torsio::cli {

namespace {

/// Options common to reconstruct and import.
struct InstrumentArguments {
  std::string source;
  std::string out;
  ToolRequest tool;             // of a scan; for a mesh, only the positions
  std::optional<double> scale;  // for a mesh: millimetres per file unit
  std::string unit;             // empty: not given
  double drawnOpen_deg = 0.0;
  std::vector<double> seed;
  std::vector<double> tip;
  std::vector<double> shaft;
  std::vector<double> jawAxis;
  InstrumentFacts facts;
  bool json = false;
};

constexpr double kToolUnit_m = 1e-3;

std::optional<Vec3> placeOf(const std::vector<double>& xyz) {
  return xyz.empty() ? std::nullopt : std::optional(Vec3{xyz[0], xyz[1], xyz[2]});
}

nlohmann::ordered_json numbersOf(const Vec3& v) {
  return {v.x, v.y, v.z};
}

/// `origin`: "scan" or "file", whose axes apply to the positions.
nlohmann::ordered_json instrumentJson(const ToolSurface& tool, const std::string& origin,
                                      const std::string& out) {
  nlohmann::ordered_json json;
  json["length_mm"] = tool.length_mm;
  json["shaft_radius_mm"] = tool.shaftRadius_mm;
  json["tip_radius_mm"] = tool.tipRadius_mm;
  json["pivot_mm"] = tool.pivot_mm;
  json["tip_in_" + origin + "_mm"] = numbersOf(tool.tip_mm);
  json["shaft_in_" + origin] = numbersOf(tool.axes[2]);
  json["jaw_axis_in_" + origin] = numbersOf(tool.axes[0]);
  json["triangles"] = {tool.shaft.triangles.size(), tool.upperJaw.triangles.size(),
                       tool.lowerJaw.triangles.size()};
  json["findings"] = nlohmann::ordered_json::array();
  for (const ScanRemark& remark : tool.remarks) {
    json["findings"].push_back({{"code", remark.code},
                                {"weight", remark.warning ? "warning" : "note"},
                                {"what", remark.what.str()},
                                {"remedy", remark.remedy.str()}});
  }
  json["out"] = out;
  return json;
}

/// Checks the output name and converts the positions, given in units of `unit_mm` and the file's axes.
void takePlaces(InstrumentArguments& arguments, double unit_mm, const MeshSpace& space = {}) {
  if (lowerExtension(arguments.out) != "json") {
    refuseUsage("an instrument's file ends with .json", "--out " + arguments.out, "Name it so");
  }
  arguments.tool.seed_mm = placeOf(arguments.seed);
  arguments.tool.tip_mm = placeOf(arguments.tip);
  if (arguments.tool.tip_mm) {
    *arguments.tool.tip_mm = unit_mm * *arguments.tool.tip_mm;
  }
  arguments.tool.shaft = placeOf(arguments.shaft);
  arguments.tool.jawAxis = placeOf(arguments.jawAxis);
  for (std::optional<Vec3>* const place :
       {&arguments.tool.tip_mm, &arguments.tool.shaft, &arguments.tool.jawAxis}) {
    if (*place) {
      *place = space.toLps(**place);
    }
  }
}

void finishInstrument(const InstrumentArguments& arguments, const ToolSurface& tool,
                      const std::string& origin) {
  writeInstrument(arguments.out, tool, arguments.facts);
  if (arguments.json) {
    std::cout << jsonText(instrumentJson(tool, origin, arguments.out)) << '\n';
    return;
  }
  std::cout << arguments.out << ": " << shortNumber(tool.length_mm) << " mm long, shaft "
            << shortNumber(2.0 * tool.shaftRadius_mm) << " mm wide, jaws " << shortNumber(tool.pivot_mm)
            << " mm\n";
  for (const ScanRemark& remark : tool.remarks) {
    std::cout << "  " << (remark.warning ? "warning " : "note ") << remark.code << ' ' << remark.what.str()
              << (remark.remedy.empty() ? "" : ". " + remark.remedy.str()) << '\n';
  }
}

void runReconstruct(InstrumentArguments& arguments) {
  takePlaces(arguments, 1.0);
  arguments.tool.source = arguments.source;
  ToolSurface tool;
  {
    ProgressLine line;
    tool = toolApart(arguments.tool, [&line](ScanStep step, double fraction) {
      const ScanStepShare share = shareOf(step);
      line.show({share.words, share.at(fraction), -1.0});
    });
  }
  finishInstrument(arguments, tool, "scan");
}

void runImport(InstrumentArguments& arguments) {
  InstrumentImportRequest request;
  request.file = arguments.source;
  request.scale_m = arguments.scale ? meshUnit_m(request.file, *arguments.scale * kToolUnit_m)
                                    : unitOf_m(arguments.source, arguments.unit);
  takePlaces(arguments, request.scale_m / kToolUnit_m, meshSpaceOf(request.file));
  const ToolPlaces& places = arguments.tool;
  static_cast<ToolPlaces&>(request) = places;
  request.drawnOpen_deg = arguments.drawnOpen_deg;
  arguments.facts.provenance = kInstrumentOfMesh;
  finishInstrument(arguments, importInstrument(request), "file");
}

/// Adds the options of an instrument of any source; `unit`: unit of its positions.
void addPlaces(CLI::App& command, InstrumentArguments& arguments, const std::string& unit) {
  command.add_option("--out", arguments.out, "Instrument to write, NAME.json, with its meshes beside it")
      ->required();
  const auto vector = [&command](const char* name, std::vector<double>& xyz, const std::string& meaning) {
    command.add_option(name, xyz, meaning)->delimiter(',')->expected(3);
  };
  vector("--tip", arguments.tip, "x,y,z near its tip, " + unit + "; default: the narrower end");
  vector("--shaft", arguments.shaft,
         "x,y,z: direction from the tip to the hand; default: found from the shape");
  vector("--jaw-axis", arguments.jawAxis,
         "x,y,z: direction of the hinge; default: along the jaws' broad side");
  addDefaulted(command, "--pivot", arguments.tool.pivot_mm,
               "Distance from the tip to the hinge of the jaws, mm");
  addDefaulted(command, "--opening", arguments.facts.opening_deg, "How far each jaw opens, degrees",
               CLI::Range(0.0, 90.0));
  addDefaulted(command, "--grip-reach", arguments.facts.gripReach_mm,
               "How far a closed jaw holds tissue, mm");
  command.add_option("--tip-radius", arguments.facts.tipRadius_mm,
                     "Radius of the ball that touches, mm; default: measured");
  command.add_option("--title", arguments.facts.title, "Display name");
  command.add_flag("--json", arguments.json, "Print JSON");
}

void addReconstruct(CLI::App& instrument) {
  auto arguments = std::make_shared<InstrumentArguments>();
  CLI::App* command = instrument.add_subcommand(
      "reconstruct", "Make an instrument from its scan: a folder of DICOM files, or NIfTI (.nii, .nii.gz)");
  command->add_option("SOURCE", arguments->source, "Folder or file of the scan")->required();
  addDefaulted(*command, "--threshold", arguments->tool.threshold_HU,
               "Threshold in HU above which the scan shows the instrument");
  command
      ->add_option("--seed", arguments->seed,
                   "x,y,z of a point in it, mm: left, back, up; default: the largest piece")
      ->delimiter(',')
      ->expected(3);
  addPlaces(*command, *arguments, "mm");
  command
      ->add_option("--series", arguments->tool.series, "Which of several series, by its number in the list")
      ->check(CLI::Range(1, 100'000));
  command->add_flag("--resample", arguments->tool.resample, "Accept unevenly spaced slices");
  command->callback([arguments] { runReconstruct(*arguments); });
}

void addImport(CLI::App& instrument) {
  auto arguments = std::make_shared<InstrumentArguments>();
  CLI::App* command = instrument.add_subcommand(
      "import", "Make an instrument from a mesh: obj, stl, ply, off, glb, gltf or dae");
  command->add_option("FILE", arguments->source, "Mesh file")->required();
  CLI::Option* scale =
      command->add_option("--scale", arguments->scale, "Millimetres in one unit of the file, such as 25.4");
  addUnitOption(*command, arguments->unit)->excludes(scale);
  addDefaulted(*command, "--drawn-open", arguments->drawnOpen_deg,
               "How far each jaw is open in the file, degrees", CLI::Range(0.0, 90.0));
  addPlaces(*command, *arguments, "the file's unit");
  command->callback([arguments] { runImport(*arguments); });
}

}  // namespace

void addInstrument(CLI::App& program) {
  CLI::App* instrument = program.add_subcommand("instrument", "Instruments of your own");
  instrument->require_subcommand(1);
  addReconstruct(*instrument);
  addImport(*instrument);
}

}  // namespace torsio::cli
