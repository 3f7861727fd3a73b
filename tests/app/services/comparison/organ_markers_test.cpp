// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/comparison/organ_markers.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/scene/organ_file.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

const fs::path kAssetFolder = fs::path(TORSIO_SOURCE_DIR) / "assets";

const Scene& forearm() {
  static const Scene kScene = [] {
    SceneRequest request;
    request.assets = kAssetFolder;
    request.ridges = 12;
    request.sections = 9;
    return loadScene(request);
  }();
  return kScene;
}

fs::path markerFile() {
  return fs::temp_directory_path() / "torsio_organ_markers_test.json";
}

/// Returns where a file of these bytes is rejected, without its folder; "" if it is not.
std::string markersRefusedAt(const std::string& bytes) {
  std::ofstream(markerFile()) << bytes;
  try {
    static_cast<void>(readMarkers(markerFile(), forearm()));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadData) << bytes;
    EXPECT_FALSE(error.remedy().empty()) << bytes;
    return fs::path(error.where()).filename().string();
  }
  return "";
}

std::string oneMarker(const std::string& fields) {
  return R"({"markers": [{)" + fields + "}]}";
}

TEST(OrganMarkers, OfTheForearmAreTenPointsOfItsSurface) {
  const std::vector<OrganMarker> markers = readOrganMarkers(kAssetFolder, forearm());

  ASSERT_EQ(markers.size(), 10U);
  EXPECT_EQ(markers[7].number, 8);
  EXPECT_EQ(markers[7].name, "second knuckle (index metacarpal head)");
  // assets/organs/forearm_markers.json has hundredths of a millimetre.
  EXPECT_NEAR(norm(markers[7].position_m - Vec3{0.03626, 0.01493, 0.35160}), 0.0, 1e-4);
}

TEST(OrganMarkers, AreSharedOnlyByTheScenesOfOneOrgan) {
  SceneRequest request;
  request.assets = kAssetFolder;
  request.id = "small-bowel-loop";
  const Scene loop = loadScene(request);
  EXPECT_EQ(readOrganMarkers(kAssetFolder, loop).size(), 10U);
  request.former = true;
  EXPECT_TRUE(readOrganMarkers(kAssetFolder, loadScene(request)).empty());

  // A user's organ with the forearm's patterns is not the forearm.
  OrganFile organ;
  organ.source = "arm.ply";
  organ.mesh = forearm().mesh;
  organ.anatomy = "forearm";
  organ.ends = {.fixedEnd_m = Vec3{}, .freeEnd_m = Vec3{0, 0, 0.262}, .fixedCut = {}, .freeCut = {0, 0, 1}};
  const fs::path file = fs::temp_directory_path() / "torsio_organ_markers_test.organ";
  writeOrganFile(file, organ);
  SceneRequest own;
  own.assets = kAssetFolder;
  own.organFile = file;
  EXPECT_TRUE(readOrganMarkers(kAssetFolder, loadScene(own)).empty());
}

TEST(OrganMarkers, AreReadAsTheyWereWritten) {
  const std::vector<OrganMarker> before = spreadMarkers(forearm());

  writeMarkers(markerFile(), before, forearm());
  const std::vector<OrganMarker> after = readMarkers(markerFile(), forearm());

  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(after[i].name, before[i].name);
    EXPECT_EQ(after[i].face, before[i].face);
    EXPECT_EQ(after[i].barycentric, before[i].barycentric);
    EXPECT_EQ(norm(after[i].position_m - before[i].position_m), 0.0);
  }
}

TEST(OrganMarkers, OfAnOrganWithoutAnyAreTenDifferentPoints) {
  const std::vector<OrganMarker> markers = spreadMarkers(forearm());

  ASSERT_EQ(markers.size(), 10U);
  std::set<std::string> names;
  for (const OrganMarker& marker : markers) {
    names.insert(marker.name);
  }
  EXPECT_EQ(names.size(), 10U);
  // At 0.1, 0.3 ... of about 262 mm between elbow and wrist; the two ridges are on opposite sides.
  EXPECT_NEAR(markers[0].position_m.z, 0.1 * 0.262, 1e-3);
  EXPECT_GT(markers[0].position_m.x, 0.02);
  EXPECT_LT(markers[1].position_m.x, -0.02);
}

TEST(OrganMarkers, ReportInvalidFilesWithTheirPlace) {
  const std::string file = "torsio_organ_markers_test.json";
  const std::string place = R"("face": 0, "barycentric": [0.2, 0.3, 0.5])";

  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": "a", )" + place)), "");
  EXPECT_EQ(markersRefusedAt("{"), file);
  EXPECT_EQ(markersRefusedAt("[1]"), file);
  EXPECT_EQ(markersRefusedAt(R"({"markers": []})"), file);
  EXPECT_EQ(markersRefusedAt(R"({"organ_hash": "another", "markers": []})"), file);
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 2, "name": "a", )" + place)),
            file + ", marker 1, field \"number\"");
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": " ", )" + place)),
            file + ", marker 1, field \"name\"");
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": "a", "face": -1, "barycentric": [1, 0, 0])")),
            file + ", marker 1, field \"face\"");
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": "a", "face": 0)")),
            file + ", marker 1, field \"barycentric\"");
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": "a", "face": 0, "barycentric": [1, 0.1, 0])")),
            file + ", marker 1, field \"barycentric\"");
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": "a", "face": 0, "barycentric": [1, "b", 0])")),
            file + ", marker 1, field \"barycentric\"");
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": "a", "position_mm": [0, 0, 100])")),
            file + ", marker 1, field \"position_mm\"")
      << "on the axis";
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": "a")")),
            file + ", marker 1, field \"position_mm\"");
  EXPECT_EQ(markersRefusedAt(R"({"markers": [{"number": 1, "name": "a", )" + place +
                             R"(}, {"number": 2, "name": "a", )" + place + "}]}"),
            file + ", marker 2, field \"name\"");
}

}  // namespace
}  // namespace torsio
