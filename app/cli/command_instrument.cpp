// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/progress_line.h"
#include "sim/base/error.h"
#include "sim/base/short_number.h"
#include "sim/imaging/apart/scan_process.h"
#include "sim/imaging/surface/scan_steps.h"
#include "sim/scene/instrument_file.h"

namespace torsio::cli {

namespace {

struct InstrumentArguments {
  std::string source;
  std::string out;
  ToolRequest tool;
  std::vector<double> seed;
  std::vector<double> tip;
  std::vector<double> shaft;
  std::vector<double> jawAxis;
  InstrumentFacts facts;
  bool json = false;
};

std::optional<Vec3> placeOf(const std::vector<double>& xyz) {
  return xyz.empty() ? std::nullopt : std::optional(Vec3{xyz[0], xyz[1], xyz[2]});
}

nlohmann::ordered_json numbersOf(const Vec3& v) {
  return {v.x, v.y, v.z};
}

nlohmann::ordered_json instrumentJson(const ToolSurface& tool, const std::string& out) {
  nlohmann::ordered_json json;
  json["length_mm"] = tool.length_mm;
  json["shaft_radius_mm"] = tool.shaftRadius_mm;
  json["tip_radius_mm"] = tool.tipRadius_mm;
  json["pivot_mm"] = tool.pivot_mm;
  json["tip_in_scan_mm"] = numbersOf(tool.tip_mm);
  json["shaft_in_scan"] = numbersOf(tool.axes[2]);
  json["jaw_axis_in_scan"] = numbersOf(tool.axes[0]);
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

void runInstrument(InstrumentArguments& arguments) {
  if (!arguments.out.ends_with(".json")) {
    throw Error(ErrorCode::kUsage, Text::verbatim("an instrument's file ends with .json"),
                "--out " + arguments.out, Text::verbatim("Name it so"));
  }
  arguments.tool.source = arguments.source;
  arguments.tool.seed_mm = placeOf(arguments.seed);
  arguments.tool.tip_mm = placeOf(arguments.tip);
  arguments.tool.shaft = placeOf(arguments.shaft);
  arguments.tool.jawAxis = placeOf(arguments.jawAxis);
  ToolSurface tool;
  {
    ProgressLine line;
    tool = toolApart(arguments.tool, [&line](ScanStep step, double fraction) {
      const ScanStepShare share = shareOf(step);
      line.show({share.words, share.at(fraction), -1.0});
    });
  }
  writeInstrument(arguments.out, tool, arguments.facts);
  if (arguments.json) {
    std::cout << instrumentJson(tool, arguments.out).dump(2) << '\n';
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

}  // namespace

void addInstrument(CLI::App& program) {
  CLI::App* instrument = program.add_subcommand("instrument", "Instruments of your own");
  instrument->require_subcommand(1);
  auto arguments = std::make_shared<InstrumentArguments>();
  CLI::App* command = instrument->add_subcommand(
      "reconstruct", "Make an instrument of its scan: a folder of DICOM files, or NIfTI (.nii, .nii.gz)");
  command->add_option("SOURCE", arguments->source, "Folder or file of the scan")->required();
  command->add_option("--out", arguments->out, "Instrument to write, NAME.json, with its meshes beside it")
      ->required();
  command->add_option("--threshold", arguments->tool.threshold_HU, "Denser than so many HU is the instrument")
      ->capture_default_str();
  const auto vector = [command](const char* name, std::vector<double>& xyz, const char* meaning) {
    command->add_option(name, xyz, meaning)->delimiter(',')->expected(3);
  };
  vector("--seed", arguments->seed, "x,y,z of a point in it, mm: left, back, up; else the largest piece");
  vector("--tip", arguments->tip, "x,y,z near its tip, mm; else the narrower end");
  vector("--shaft", arguments->shaft, "x,y,z: direction from the tip to the hand; else found");
  vector("--jaw-axis", arguments->jawAxis, "x,y,z: direction of the hinge; else along the jaws' broad side");
  command->add_option("--pivot", arguments->tool.pivot_mm, "From the tip to the hinge of the jaws, mm")
      ->capture_default_str();
  command->add_option("--opening", arguments->facts.opening_deg, "How far each jaw opens, degrees")
      ->check(CLI::Range(0.0, 90.0))
      ->capture_default_str();
  command->add_option("--grip-reach", arguments->facts.gripReach_mm, "How far a closed jaw holds tissue, mm")
      ->capture_default_str();
  command->add_option("--tip-radius", arguments->facts.tipRadius_mm,
                      "Of the ball that touches, mm; else measured");
  command->add_option("--title", arguments->facts.title, "Its name for people");
  command
      ->add_option("--series", arguments->tool.series, "Which of several series, by its number in the list")
      ->check(CLI::Range(1, 100'000));
  command->add_flag("--resample", arguments->tool.resample, "Take slices at uneven distances");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { runInstrument(*arguments); });
}

}  // namespace torsio::cli
