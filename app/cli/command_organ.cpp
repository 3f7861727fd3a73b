// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/base/assets.h"
#include "app/cli/commands.h"
#include "sim/base/error.h"
#include "sim/base/short_number.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/scene/organ_import.h"

namespace torsio::cli {

namespace {

constexpr double kMetresPerMillimetre = 1e-3;

struct OrganImportArguments {
  std::string file;
  std::string out;
  std::vector<double> fixedEnd;  // in the file's unit
  std::vector<double> freeEnd;
  std::vector<double> fixedCut;
  std::vector<double> freeCut;
  std::optional<double> scale;  // millimetres in one file unit
  std::string unit = "mm";
  std::optional<double> wall_mm;
  std::string anatomy;
  bool closeHoles = false;
  bool json = false;
};

Vec3 vectorFrom(const std::vector<double>& xyz) {
  return {xyz[0], xyz[1], xyz[2]};
}

OrganImportRequest importRequest(const OrganImportArguments& arguments) {
  OrganImportRequest request;
  request.assets = assetsFolder();
  request.file = arguments.file;
  request.scale_m = arguments.scale ? *arguments.scale * kMetresPerMillimetre : lengthUnit_m(arguments.unit);
  if (!arguments.fixedEnd.empty() && !arguments.freeEnd.empty()) {
    request.ends.fixedEnd_m = vectorFrom(arguments.fixedEnd) * request.scale_m;
    request.ends.freeEnd_m = vectorFrom(arguments.freeEnd) * request.scale_m;
  }
  if (!arguments.fixedCut.empty()) {
    request.ends.fixedCut = vectorFrom(arguments.fixedCut);
  }
  if (!arguments.freeCut.empty()) {
    request.ends.freeCut = vectorFrom(arguments.freeCut);
  }
  request.anatomy = arguments.anatomy;
  request.closeHoles = arguments.closeHoles;
  if (arguments.wall_mm) {
    request.wall_m = *arguments.wall_mm * kMetresPerMillimetre;
  }
  return request;
}

const char* weightName(FindingWeight weight) {
  switch (weight) {
    case FindingWeight::kRefusal:
      return "refusal";
    case FindingWeight::kWarning:
      return "warning";
    case FindingWeight::kNote:
      break;
  }
  return "note";
}

/// What was found, without its code, with which refusals of the reader begin.
std::string sentenceOf(const OrganFinding& finding) {
  const std::string sentence = finding.what.str();
  const std::string code = finding.code + " ";
  return sentence.starts_with(code) ? sentence.substr(code.size()) : sentence;
}

nlohmann::ordered_json numberOrNull(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json findingJson(const OrganFinding& finding) {
  nlohmann::ordered_json json;
  json["code"] = finding.code;
  json["weight"] = weightName(finding.weight);
  json["what"] = sentenceOf(finding);
  json["where"] = finding.where.str();
  json["value"] = numberOrNull(finding.value);
  json["remedy"] = finding.remedy.str();
  return json;
}

nlohmann::ordered_json importJson(const OrganImport& import, const OrganImportArguments& arguments) {
  nlohmann::ordered_json json;
  json["accepted"] = import.accepted;
  json["warnings"] = nlohmann::ordered_json::array();
  json["findings"] = nlohmann::ordered_json::array();
  json["repairs"] = nlohmann::ordered_json::array();
  for (const OrganFinding& finding : import.findings) {
    json["findings"].push_back(findingJson(finding));
    if (finding.weight == FindingWeight::kWarning) {
      json["warnings"].push_back(finding.code + " " + sentenceOf(finding));
    }
  }
  for (const std::string& repair : import.repairs.lines()) {
    json["repairs"].push_back(repair);
  }
  json["volume_ml"] = numberOrNull(import.volume_ml);
  json["det_f_min_60"] = numberOrNull(import.leastDeterminant60);
  json["triangles"] = import.organ.mesh.triangles.size();
  const OrganMeasures& m = import.measures;
  json["length_mm"] = 1000.0 * m.length_m;
  json["widest_mm"] = 1000.0 * m.widest_m;
  json["elongation"] = m.elongation;
  json["flatness"] = m.flatness;
  json["overlap"] = m.overlap;
  json["branch"] = m.branch;
  json["beyond_ends"] = m.beyond;
  json["width_ratio"] = m.widthRatio;
  json["crossings_60"] = m.crossings60;
  json["crossings_at_rest"] = m.crossingsAtRest;
  json["anatomy"] = import.organ.anatomy;
  if (import.accepted && !arguments.out.empty()) {
    json["out"] = arguments.out;
  }
  return json;
}

void printImport(const OrganImport& import, const OrganImportArguments& arguments) {
  if (arguments.json) {
    std::cout << importJson(import, arguments).dump(2) << '\n';
    return;
  }
  std::cout << arguments.file << ": " << (import.accepted ? "accepted" : "refused");
  if (import.measures.length_m > 0.0) {
    std::cout << ", " << import.organ.mesh.triangles.size() << " triangles, "
              << shortNumber(import.volume_ml.value_or(0.0)) << " ml, axis "
              << shortNumber(1000.0 * import.measures.length_m) << " mm, least det F at 60 degrees "
              << shortNumber(import.measures.leastDeterminant60);
  }
  std::cout << '\n';
  for (const OrganFinding& finding : import.findings) {
    std::cout << "  " << weightName(finding.weight) << ' ' << finding.code << ' ' << sentenceOf(finding);
    std::cout << (finding.remedy.empty() ? "" : ". " + finding.remedy.str()) << '\n';
  }
  if (const std::string repairs = import.repairs.text(); !repairs.empty()) {
    std::cout << "  repaired: " << repairs << '\n';
  }
}

void runOrganImport(const OrganImportArguments& arguments) {
  if (!arguments.out.empty() && !isOrganFile(arguments.out)) {
    throw Error(ErrorCode::kUsage, Text::verbatim("an organ file ends with .organ"), "--out " + arguments.out,
                Text::verbatim("Name it so"));
  }
  if (arguments.fixedEnd.empty() != arguments.freeEnd.empty()) {
    throw Error(ErrorCode::kUsage, Text::verbatim("one end alone decides nothing"),
                Text::verbatim("--fixed-end, --free-end"), Text::verbatim("Give both"));
  }
  const OrganImport import = importOrgan(importRequest(arguments));
  if (import.accepted && !arguments.out.empty()) {
    writeOrganFile(arguments.out, import.organ);
  }
  printImport(import, arguments);
  if (!import.accepted) {
    throw refusalOf(import.findings.front(), arguments.file);
  }
}

}  // namespace

void addOrgan(CLI::App& program) {
  CLI::App* organ = program.add_subcommand("organ", "Organs of your own");
  organ->require_subcommand(1);
  auto arguments = std::make_shared<OrganImportArguments>();
  CLI::App* command = organ->add_subcommand(
      "import", "Check, repair and judge a mesh (obj, stl, ply, off, glb, gltf, dae) as an organ");
  command->add_option("FILE", arguments->file, "Mesh file")->required();
  command->add_option("--out", arguments->out, "Organ file to write when accepted, NAME.organ");
  const auto point = [command](const char* name, std::vector<double>& xyz, const char* meaning) {
    return command->add_option(name, xyz, meaning)->expected(3);
  };
  point("--fixed-end", arguments->fixedEnd, "x y z of the held end, in the file's unit; else found");
  point("--free-end", arguments->freeEnd, "x y z of the other end");
  point("--fixed-cut", arguments->fixedCut, "Outward direction of a cut through the held end")
      ->needs(command->get_option("--fixed-end"));
  point("--free-cut", arguments->freeCut,
        "Outward direction of a cut through the free end: what lies beyond follows it as a whole")
      ->needs(command->get_option("--free-end"));
  CLI::Option* scale =
      command->add_option("--scale", arguments->scale, "Millimetres in one unit of the file, such as 1000");
  command->add_option("--organ-unit", arguments->unit, "Unit of the file: m, cm, mm or um")
      ->check(CLI::IsMember({"m", "cm", "mm", "um"}))
      ->excludes(scale)
      ->capture_default_str();
  command->add_option("--wall", arguments->wall_mm, "Thickness of its wall in millimetres");
  command->add_option("--anatomy", arguments->anatomy,
                      "Scene whose patterns suit it, such as stomach; without: twists about its own axis");
  command->add_flag("--close-holes", arguments->closeHoles,
                    "Close gaps of the surface, and the ends of a tube that was drawn open");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { runOrganImport(*arguments); });
}

}  // namespace torsio::cli
