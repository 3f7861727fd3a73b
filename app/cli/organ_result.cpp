// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/organ_result.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <optional>

#include <CLI/CLI.hpp>

#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/short_number.h"
#include "sim/scene/organ_file.h"

namespace torsio::cli {

namespace {

constexpr std::array kWeights{"note", "warning", "refusal"};

/// Returns a finding's sentence without its code, which starts the reader's refusals.
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
  json["weight"] = wordOf(finding.weight, kWeights);
  json["what"] = sentenceOf(finding);
  json["where"] = finding.where.str();
  json["value"] = numberOrNull(finding.value);
  json["remedy"] = finding.remedy.str();
  return json;
}

void printForPeople(const OrganImport& import, const std::string& file) {
  std::cout << file << ": " << (import.accepted ? "accepted" : "refused");
  if (import.measures.length_m > 0.0) {
    std::cout << ", " << import.organ.mesh.triangles.size() << " triangles, "
              << shortNumber(import.volume_ml.value_or(0.0)) << " ml, axis "
              << shortNumber(1000.0 * import.measures.length_m) << " mm";
  }
  std::cout << '\n';
  for (const PatternJudgement& pattern : import.patterns) {
    std::cout << "  pattern " << pattern.id << (pattern.accepted ? " accepted" : " refused")
              << ", least det F " << shortNumber(pattern.leastDeterminant) << ", " << pattern.crossings
              << " crossings, volume " << shortNumber(pattern.volumeRatio) << '\n';
  }
  for (const OrganFinding& finding : import.findings) {
    std::cout << "  " << wordOf(finding.weight, kWeights) << ' ' << finding.code << ' '
              << sentenceOf(finding);
    std::cout << (finding.remedy.empty() ? "" : ". " + finding.remedy.str()) << '\n';
  }
  if (const std::string repairs = import.repairs.text(); !repairs.empty()) {
    std::cout << "  repaired: " << repairs << '\n';
  }
}

nlohmann::ordered_json patternJson(const PatternJudgement& pattern) {
  nlohmann::ordered_json json;
  json["id"] = pattern.id;
  json["accepted"] = pattern.accepted;
  json["det_f_min"] = pattern.leastDeterminant;
  json["crossings"] = pattern.crossings;
  json["volume_ratio"] = pattern.volumeRatio;
  if (!pattern.reason.empty()) {
    json["reason"] = pattern.reason.str();
    json["angle_deg"] = pattern.brokenAt_rad ? nlohmann::ordered_json(degrees(*pattern.brokenAt_rad))
                                             : nlohmann::ordered_json(nullptr);
  }
  return json;
}

Vec3 vectorFrom(const std::vector<double>& xyz) {
  return {xyz[0], xyz[1], xyz[2]};
}

}  // namespace

nlohmann::ordered_json organJson(const OrganImport& import, const std::string& out) {
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
  json["det_f_min_60"] = nullptr;
  json["patterns"] = nlohmann::ordered_json::array();
  for (const PatternJudgement& pattern : import.patterns) {
    json["patterns"].push_back(patternJson(pattern));
    const nlohmann::ordered_json& least = json["det_f_min_60"];
    json["det_f_min_60"] = least.is_null() ? pattern.leastDeterminant60
                                           : std::min(least.get<double>(), pattern.leastDeterminant60);
  }
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
  json["crossings_at_rest"] = m.crossingsAtRest;
  json["anatomy"] = import.organ.anatomy;
  if (m.stalkWidth > 0.0) {
    json["stalk_width"] = m.stalkWidth;
  }
  if (const auto& map = import.organ.wallMap) {
    nlohmann::ordered_json thickness_mm = nlohmann::ordered_json::array();
    for (const double thickness_m : map->thickness_m) {
      thickness_mm.push_back(1000.0 * thickness_m);
    }
    json["wall_map"] = {{"bands", map->bands},
                        {"ridges", map->ridges},
                        {"seen", map->seenPatches()},
                        {"thickness_mm", thickness_mm}};
  }
  if (import.accepted && !out.empty()) {
    json["out"] = out;
  }
  return json;
}

void addOrganResultOptions(CLI::App& command, OrganResultOptions& options, const std::string& unit) {
  command.add_option("--out", options.out, "Organ file to write when accepted, NAME.organ");
  const auto point = [&command](const char* name, std::vector<double>& xyz, const std::string& meaning) {
    return command.add_option(name, xyz, meaning)->expected(3);
  };
  point("--fixed-end", options.fixedEnd,
        "x y z of the held end, in " + unit + "; default: found from the shape");
  point("--free-end", options.freeEnd, "x y z of the other end");
  point("--fixed-cut", options.fixedCut, "Outward direction of a cut through the held end")
      ->needs(command.get_option("--fixed-end"));
  point("--free-cut", options.freeCut,
        "Outward direction of a cut through the free end; the part beyond follows rigidly")
      ->needs(command.get_option("--free-end"));
  command.add_option("--wall", options.wall_mm, "Thickness of its wall in millimetres");
  command.add_option("--anatomy", options.anatomy,
                     "Scene whose patterns suit it, such as stomach; default: twists about its own axis");
  command.add_flag("--json", options.json, "Print JSON");
}

void applyOrganResultOptions(const OrganResultOptions& options, double unit_m, OrganImportRequest& request,
                             const MeshSpace& space) {
  constexpr double kWallUnit_m = 1e-3;
  if (!options.out.empty() && !isOrganFile(options.out)) {
    refuseUsage("an organ file ends with .organ", "--out " + options.out, "Name it so");
  }
  if (options.fixedEnd.empty() != options.freeEnd.empty()) {
    refuseUsage("one end alone is not enough", "--fixed-end, --free-end", "Give both");
  }
  if (!options.fixedEnd.empty()) {
    request.ends.fixedEnd_m = space.toLps(vectorFrom(options.fixedEnd) * unit_m);
    request.ends.freeEnd_m = space.toLps(vectorFrom(options.freeEnd) * unit_m);
  }
  if (!options.fixedCut.empty()) {
    request.ends.fixedCut = space.toLps(vectorFrom(options.fixedCut));
  }
  if (!options.freeCut.empty()) {
    request.ends.freeCut = space.toLps(vectorFrom(options.freeCut));
  }
  request.anatomy = options.anatomy;
  if (options.wall_mm) {
    request.wall_m = *options.wall_mm * kWallUnit_m;
  }
}

void finishOrgan(const OrganImport& import, const OrganResultOptions& options, const std::string& file,
                 const nlohmann::ordered_json& json) {
  if (import.accepted && !options.out.empty()) {
    writeOrganFile(options.out, import.organ);
  }
  if (options.json) {
    std::cout << jsonText(json) << '\n';
  } else {
    printForPeople(import, file);
  }
  if (!import.accepted) {
    throw refusalOf(import.findings.front(), file);
  }
}

}  // namespace torsio::cli
