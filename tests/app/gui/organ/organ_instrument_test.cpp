// SPDX-License-Identifier: GPL-3.0-or-later
// An instrument from its scan in the window: found, its tip and hinge placed on the picture, saved.
#include <algorithm>
#include <filesystem>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/gui/organ/instrument_panel.h"
#include "app/gui/organ/instrument_view.h"
#include "app/gui/organ/organ_wizard.h"
#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/widgets/child.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "tests/app/gui/organ/organ_desk.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/scan_files.h"

namespace torsio::gui {
namespace {

using testing::OrganDesk;
using testing::wizardButton;
using testing::wizardFile;

/// The shipped grasper, its shaft cut at 90 mm, along the patient's length; denser than metal in a CT.
std::filesystem::path grasperScan() {
  const std::filesystem::path folder = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets/instruments";
  TriangleMesh all;
  ScanVolume scan;
  std::vector<TriangleMesh> parts;
  for (const char* name : {"shaft", "jaw_upper", "jaw_lower"}) {
    parts.push_back(importMesh(folder / (std::string("grasper_") + name + ".ply"), {.organ = false}));
    for (Vec3& v : parts.back().vertices_m) {
      v.z = std::min(v.z, 0.09);
      all.vertices_m.push_back(v);
    }
  }
  scan = torsio::testing::blankScanAround(all, {0.7, 0.7, 0.7}, 6.0);
  for (const TriangleMesh& part : parts) {
    torsio::testing::fillWith(scan, part, 3000);
  }
  const std::filesystem::path file = wizardFile("tool.nii");
  writeFileAtomically(file, torsio::testing::niftiBytes(scan));
  return file;
}

TEST(OrganInstrument, IsFoundPlacedByClicksAndSaved) {
  OrganDesk desk;
  desk.openInstrument(grasperScan());
  ASSERT_TRUE(desk.failures.isEmpty()) << desk.failures.join(' ').toStdString();
  InstrumentPanel& panel = desk.wizard.instrument();
  ASSERT_NEAR(panel.tool().length_mm, 90.0, 1.5);
  EXPECT_NEAR(panel.tool().tip_mm.z, 0.0, 1.5);

  // The hinge is 20 mm behind the tip until it is placed by a click.
  EXPECT_NEAR(panel.tool().pivot_mm, 20.0, 1e-6);
  panel.view().resize(600, 480);
  panel.view().pickAt(panel.view().placeOf(1, 25.0));
  EXPECT_FALSE(wizardButton(desk.wizard, QStringLiteral("Save instrument\u2026")).isEnabled());
  desk.findInstrument();
  EXPECT_NEAR(panel.tool().pivot_mm, 25.0, 0.1);

  // A click on the other half makes its end the tip, another click reverts it.
  panel.view().pickAt(panel.view().placeOf(0, 80.0));
  desk.settle();
  EXPECT_NEAR(panel.tool().tip_mm.z, 90.0, 1.5);
  panel.view().pickAt(panel.view().placeOf(0, 80.0));
  desk.settle();
  EXPECT_NEAR(panel.tool().tip_mm.z, 0.0, 1.5);

  child<QDoubleSpinBox>(desk.wizard, "toolOpening").setValue(30.0);
  const std::filesystem::path file = wizardFile("tool.json");
  desk.wizard.saveInstrument(file);
  const auto saved = nlohmann::json::parse(readFile(file));
  EXPECT_NEAR(saved.at("jaws").at("pivot_mm").at(2).get<double>(), 25.0, 0.1);
  EXPECT_NEAR(saved.at("jaws").at("opening_deg").get<double>(), 30.0, 1e-6);
  for (const auto& mesh : saved.at("meshes")) {
    EXPECT_TRUE(std::filesystem::exists(file.parent_path() / mesh.get<std::string>())) << mesh;
  }
}

/// Returns whether a line of pixels is empty.
bool isBare(const QImage& picture, int y) {
  const QColor backdrop = theme(ThemeKind::kLight).backdrop;
  for (int x = 0; x < picture.width(); ++x) {
    if (picture.pixelColor(x, y) != backdrop) {
      return false;
    }
  }
  return true;
}

// In a wide and low window, rows are much wider than high.
TEST(OrganInstrument, IsNotClippedHoweverWideItsView) {
  ToolSurface tool;
  tool.length_mm = 250.0;
  tool.pivot_mm = 20.0;
  tool.shaftRadius_mm = 2.5;
  tool.upperJaw = torsio::testing::capsule(0.002, 0.016, 16, 8);
  tool.lowerJaw = tool.upperJaw;
  tool.shaft = torsio::testing::capsule(0.0025, 0.2, 16, 8);
  InstrumentView view;
  for (const double opening_deg : {0.0, 25.0, 80.0}) {
    view.setTool(tool, 0.0);
    view.setOpening(opening_deg);
    for (const QSize& size : {QSize(320, 300), QSize(1500, 360), QSize(600, 900)}) {
      view.resize(size);
      const QImage seen = view.grab().toImage();
      for (int row = 0; row < 3; ++row) {
        const int middle = qRound(view.placeOf(row, 0.0).y());
        const int edge = (row + 1) * size.height() / 3;
        EXPECT_FALSE(isBare(seen, middle));
        EXPECT_TRUE(isBare(seen, edge - 1)) << row << ' ' << opening_deg << ' ' << size.width();
        EXPECT_TRUE(isBare(seen, 2 * middle - edge + 1)) << row << ' ' << opening_deg << ' ' << size.width();
        EXPECT_GE(view.placeOf(row, 0.0).x(), 0.0);
        EXPECT_LE(view.placeOf(row, row == 0 ? tool.length_mm : tool.pivot_mm).x(), size.width());
      }
    }
  }
}

TEST(OrganInstrument, FromAMeshIsFoundPlacedAndSaved) {
  const std::filesystem::path file = wizardFile("tool.ply");
  writePly(file, torsio::testing::capsule(0.004, 0.16, 32, 40));
  OrganDesk desk;
  desk.wizard.openToolMesh(file);
  desk.settle();
  ASSERT_TRUE(desk.failures.isEmpty()) << desk.failures.join(' ').toStdString();
  InstrumentPanel& panel = desk.wizard.instrument();
  EXPECT_NEAR(panel.tool().length_mm, 168.0, 0.5);
  EXPECT_FALSE(child<QDoubleSpinBox>(desk.wizard, "toolThreshold").isVisibleTo(&panel));  // for scans only
  EXPECT_TRUE(child<QComboBox>(desk.wizard, "toolUnit").isVisibleTo(&panel));

  child<QDoubleSpinBox>(desk.wizard, "toolHinge").setValue(30.0);
  EXPECT_FALSE(wizardButton(desk.wizard, QStringLiteral("Save instrument\u2026")).isEnabled());
  desk.findInstrument();
  EXPECT_NEAR(panel.tool().pivot_mm, 30.0, 1e-6);
  const std::filesystem::path saved = wizardFile("mesh-tool.json");
  desk.wizard.saveInstrument(saved);
  EXPECT_EQ(nlohmann::json::parse(readFile(saved)).at("provenance"), kInstrumentOfMesh);

  // A wrong unit is refused with a reason, and nothing can be saved.
  child<QComboBox>(desk.wizard, "toolUnit").setCurrentIndex(2);
  desk.findInstrument();
  EXPECT_EQ(desk.failures.size(), 1);
  EXPECT_FALSE(wizardButton(desk.wizard, QStringLiteral("Save instrument\u2026")).isEnabled());

  // A scan afterwards has its own settings again.
  desk.failures.clear();
  desk.openInstrument(grasperScan());
  EXPECT_TRUE(child<QDoubleSpinBox>(desk.wizard, "toolThreshold").isVisibleTo(&panel));
  EXPECT_NEAR(panel.tool().length_mm, 90.0, 1.5);
}

TEST(OrganInstrument, OfACentreIsReadBesideItsFileAndNowhereElse) {
  const std::filesystem::path shipped = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets/instruments";
  const std::filesystem::path folder = wizardFile("own");
  std::filesystem::create_directories(folder);
  std::string json = readFile(shipped / "grasper.json");
  for (const char* name :
       {"grasper_shaft.ply", "grasper_jaw_upper.ply", "grasper_jaw_lower.ply", "gloved_hand.ply"}) {
    std::filesystem::copy_file(shipped / name, folder / name,
                               std::filesystem::copy_options::overwrite_existing);
  }
  writeFileAtomically(folder / "mine.json", json);

  const InstrumentParts mine = loadInstrument(folder / "mine.json");

  EXPECT_EQ(mine.upperJaw.triangles.size(), 1092U);
  EXPECT_EQ(mine.jawPivot_mm, QVector3D(0, 0, 20));
  EXPECT_FALSE(mine.hand.triangles.empty());

  const std::string inside = "\"grasper_shaft.ply\"";
  json.replace(json.find(inside), inside.size(), "\"../grasper_shaft.ply\"");
  writeFileAtomically(folder / "mine.json", json);
  EXPECT_THROW(static_cast<void>(loadInstrument(folder / "mine.json")), Error);
}

}  // namespace
}  // namespace torsio::gui
