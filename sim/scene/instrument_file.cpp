// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/instrument_file.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/short_number.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/scene/scene_file.h"

namespace torsio {

namespace {

double hundredths_mm(double mm) {
  return std::round(100.0 * mm) / 100.0;
}

void requireMeasure(double value, const InstrumentRange& range, const Text& what,
                    const std::filesystem::path& file) {
  if (!(value >= range.least && value <= range.most)) {
    throw Error(ErrorCode::kBadParameter,
                Text::tr("%1 is %2 mm; an instrument has %3 to %4 mm", what, shortNumber(value),
                         shortNumber(range.least), shortNumber(range.most)),
                file.string(), Text::tr("Check threshold, tip and hinge of the instrument"));
  }
}

}  // namespace

void writeInstrument(const std::filesystem::path& file, const ToolSurface& tool,
                     const InstrumentFacts& facts) {
  const std::string id = file.stem().string();
  const double tip_mm = facts.tipRadius_mm > 0.0 ? facts.tipRadius_mm : tool.tipRadius_mm;
  requireMeasure(tool.length_mm, instrumentLength_mm(), Text::tr("its length"), file);
  requireMeasure(tip_mm, kInstrumentTip_mm, Text::tr("the radius of its tip"), file);
  requireMeasure(facts.gripReach_mm, kInstrumentReach_mm, Text::tr("the reach of its grip"), file);
  nlohmann::ordered_json json;
  json["id"] = id;
  json["title"] = facts.title.empty() ? id : facts.title;
  json["provenance"] = facts.provenance;
  json["licence"] = "not stated";
  json["frame"] =
      "tip at the origin, shaft along +z towards the hand; the upper jaw (y > 0) opens by +angle about the "
      "axis through the pivot, the lower by -angle";
  json["tip_mm"] = {0.0, 0.0, 0.0};
  json["shaft_axis"] = {0.0, 0.0, 1.0};
  json["shaft_length_mm"] = hundredths_mm(tool.length_mm);
  json["shaft_radius_mm"] = hundredths_mm(tool.shaftRadius_mm);
  json["tip_radius_mm"] = hundredths_mm(tip_mm);
  json["grip_reach_mm"] = hundredths_mm(facts.gripReach_mm);
  json["jaws"] = {{"pivot_mm", {0.0, 0.0, hundredths_mm(tool.pivot_mm)}},
                  {"axis", {1.0, 0.0, 0.0}},
                  {"opening_deg", facts.opening_deg}};
  nlohmann::ordered_json meshes;
  const auto write = [&](const char* key, const std::string& name, const TriangleMesh& mesh) {
    const std::string part = id + "_" + name + ".ply";
    MeshExportOptions options;
    options.comments = {"Torsio: " + name + " of " + id};
    writePly(file.parent_path() / part, mesh, options);
    meshes[key] = part;
  };
  write("shaft", "shaft", tool.shaft);
  write("upper_jaw", "jaw_upper", tool.upperJaw);
  write("lower_jaw", "jaw_lower", tool.lowerJaw);
  json["meshes"] = meshes;
  writeFileAtomically(file, json.dump(2) + "\n");
}

}  // namespace torsio
