// SPDX-License-Identifier: GPL-3.0-or-later
// An instrument as a file: what is written reads as the shipped one does.
#include "sim/scene/instrument_file.h"

#include <filesystem>
#include <set>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/scene/scene_file.h"

namespace torsio {
namespace {

const std::filesystem::path kShippedAssets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

TriangleMesh shippedPart(const std::string& name) {
  return importMesh(kShippedAssets / "instruments" / ("grasper_" + name + ".ply"),
                    {.scale_m = 0.001, .organ = false});
}

/// The shipped grasper as if a scan had shown it.
ToolSurface shippedTool() {
  ToolSurface tool;
  tool.shaft = shippedPart("shaft");
  tool.upperJaw = shippedPart("jaw_upper");
  tool.lowerJaw = shippedPart("jaw_lower");
  tool.length_mm = 250.0;
  tool.pivot_mm = 20.0;
  tool.shaftRadius_mm = 2.5;
  tool.tipRadius_mm = 2.5;
  return tool;
}

/// Names of all fields, those within others after their own, without the hand, which no scan of a tool shows.
std::set<std::string> fieldsOf(const std::filesystem::path& file) {
  std::set<std::string> names;
  const nlohmann::json json = nlohmann::json::parse(readFile(file)).flatten();
  for (const auto& [name, value] : json.items()) {
    if (name != "/meshes/hand") {
      names.insert(name);
    }
  }
  return names;
}

TEST(InstrumentFile, ReadsAsTheShippedOneDoes) {
  const std::filesystem::path assets =
      std::filesystem::path(::testing::TempDir()) / ("instrument-" + std::to_string(getpid()));
  std::filesystem::create_directories(assets / "instruments");
  const std::filesystem::path file = assets / "instruments" / "mine.json";
  writeInstrument(file, shippedTool(), {});

  const Instrument mine = readInstrument(assets, "mine");
  const Instrument shipped = readInstrument(kShippedAssets, "grasper");
  EXPECT_EQ(mine.id, "mine");
  EXPECT_DOUBLE_EQ(mine.tipRadius_m, shipped.tipRadius_m);
  EXPECT_DOUBLE_EQ(mine.shaftLength_m, shipped.shaftLength_m);
  EXPECT_DOUBLE_EQ(mine.gripReach_m, shipped.gripReach_m);
  EXPECT_EQ(fieldsOf(file), fieldsOf(kShippedAssets / "instruments" / "grasper.json"));
  const TriangleMesh jaw =
      importMesh(assets / "instruments" / "mine_jaw_upper.ply", {.scale_m = 0.001, .organ = false});
  EXPECT_EQ(jaw.triangles.size(), shippedPart("jaw_upper").triangles.size());
}

TEST(InstrumentFile, RefusesMeasuresThatNoInstrumentHas) {
  ToolSurface tool = shippedTool();
  tool.length_mm = 5.0;
  EXPECT_THROW(writeInstrument("mine.json", tool, {}), Error);
  tool = shippedTool();
  EXPECT_THROW(writeInstrument("mine.json", tool, {.tipRadius_mm = 200.0}), Error);
  EXPECT_FALSE(std::filesystem::exists("mine.json"));
}

}  // namespace
}  // namespace torsio
