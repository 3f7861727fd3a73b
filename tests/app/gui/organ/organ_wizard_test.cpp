// SPDX-License-Identifier: GPL-3.0-or-later
// Importing an organ in the window: a mesh is judged, inspected, named, saved and opened. Importing an
// organ from a scan in the window: slices, segmentation, brush, surface. An instrument from its scan in the
// window: found, its tip and hinge placed on the picture, saved.

#include "app/gui/organ/organ_wizard.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QRadioButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/gui/organ/instrument_panel.h"
#include "app/gui/organ/instrument_view.h"
#include "app/gui/organ/organ_picture.h"
#include "app/gui/organ/organ_sources.h"
#include "app/gui/organ/scan_panel.h"
#include "app/gui/organ/slice_view.h"
#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/scene/view_frame.h"
#include "app/gui/widgets/child.h"
#include "app/services/organs/person_arm.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/organ_file.h"
#include "sim/scene/scene.h"
#include "tests/app/gui/organ/organ_desk.h"
#include "tests/support/mesh_formats.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/scan_files.h"

namespace torsio::gui {

namespace {

using ::testing::HasSubstr;
using testing::OrganDesk;
using testing::readable;
using testing::wizardButton;
using testing::wizardFile;

/// A user's mesh file: a straight bar of 200 ml, millimetres.
std::filesystem::path barFile() {
  const std::filesystem::path file = wizardFile("bar.ply");
  TriangleMesh bar = torsio::testing::capsule(0.02, 0.14, 32, 40);
  writePly(file, bar);
  return file;
}

TEST(OrganWizard, JudgesAMeshShowsItsAxisAndSavesItAsAnOrganFile) {
  OrganDesk desk;
  desk.judge(barFile());
  ASSERT_TRUE(desk.wizard.trial().has_value());
  const OrganTrial& trial = *desk.wizard.trial();
  EXPECT_TRUE(trial.import.accepted);
  EXPECT_THAT(readable(desk.wizard), HasSubstr("Accepted"));
  ASSERT_FALSE(trial.axis_m.empty());
  EXPECT_NEAR(norm(trial.axis_m.back() - trial.axis_m.front()), trial.import.measures.length_m, 1e-3);

  const std::filesystem::path file = wizardFile("bar.organ");
  desk.wizard.save(file);
  const QSignalSpy opened(&desk.wizard, &OrganWizard::opened);
  wizardButton(desk.wizard, QStringLiteral("Open in the simulator")).click();
  ASSERT_EQ(opened.count(), 1);
  SceneRequest request;
  request.assets = desk.wizard.assets();
  request.organFile = opened.first().first().toString().toStdString();
  EXPECT_EQ(loadScene(request).organHash, contentHash(trial.import.organ.mesh));
}

TEST(OrganWizard, ShowsItsSourcesSideBySideAndCentredOnAWideScreen) {
  testing::OrganDesk desk;
  desk.wizard.show();
  for (const int width : {1160, 3600}) {
    desk.wizard.resize(width, 900);
    QApplication::processEvents();
    const auto edges = [&desk](const QString& button) {
      const QWidget& card = *testing::wizardButton(desk.wizard, button).parentWidget();
      return std::pair(card.mapTo(&desk.wizard, QPoint()).x(),
                       card.mapTo(&desk.wizard, QPoint(card.width(), 0)).x());
    };

    const auto [left, leftEnd] = edges(QStringLiteral("Choose a mesh\u2026"));
    const auto [right, rightEnd] = edges(QStringLiteral("Draw the arm"));

    EXPECT_NEAR(right - leftEnd, 2 * kSpace, 1) << width;
    EXPECT_NEAR(left, width - rightEnd, 3 * kSpace) << width;
  }
}

/// The pictures of all patterns, in their order.
std::vector<QImage> patternPictures(const OrganWizard& wizard) {
  std::vector<QImage> pictures;
  for (const QLabel* label : wizard.findChildren<QLabel*>(QStringLiteral("patternPicture"))) {
    pictures.push_back(label->pixmap().toImage());
  }
  return pictures;
}

TEST(OrganWizard, ShowsEveryPatternAtRestHalfWayAndAtItsTarget) {
  OrganDesk desk;
  desk.judge(barFile());

  const std::vector<PatternJudgement>& patterns = desk.wizard.trial()->import.patterns;
  ASSERT_FALSE(patterns.empty());
  const std::vector<QImage> pictures = patternPictures(desk.wizard);
  ASSERT_EQ(pictures.size(), 3 * patterns.size());
  EXPECT_EQ(desk.wizard.findChildren<QLabel*>(QStringLiteral("patternHead")).size(),
            static_cast<qsizetype>(patterns.size()));
  EXPECT_THAT(readable(desk.wizard), HasSubstr("offered"));
  EXPECT_THAT(readable(desk.wizard), HasSubstr("at rest"));
  for (std::size_t i = 0; i < pictures.size(); i += 3) {
    ASSERT_FALSE(pictures[i].isNull());
    EXPECT_EQ(pictures[i].size(), pictures[i + 2].size());
    EXPECT_NE(pictures[i].pixelColor(pictures[i].rect().center()), pictures[i].pixelColor(0, 0));
  }
}

TEST(OrganWizard, JudgesAMeshAgainInAnotherUnit) {
  OrganDesk desk;
  desk.judge(barFile());
  const double volume_ml = *desk.wizard.trial()->import.volume_ml;
  auto& unit = child<QComboBox>(desk.wizard, "organUnit");
  ASSERT_EQ(unit.count(), 5);
  EXPECT_TRUE(unit.isEnabled());

  unit.setCurrentIndex(1);  // centimetres
  Q_EMIT unit.activated(1);
  desk.again();

  EXPECT_NEAR(*desk.wizard.trial()->import.volume_ml / volume_ml, 1000.0, 0.01);
}

TEST(OrganWizard, TakesTheUnitThatAFileStatesAndOffersNoOther) {
  OrganDesk desk;
  const std::filesystem::path file = wizardFile("bar.dae");
  std::string text = torsio::testing::daeText(torsio::testing::capsule(0.02, 0.14, 32, 40));
  const std::string millimetres = "meter=\"0.001\"";
  writeFileAtomically(file, text.replace(text.find(millimetres), millimetres.size(), "meter=\"0.01\""));
  desk.judge(file);

  const auto& unit = child<QComboBox>(desk.wizard, "organUnit");
  EXPECT_FALSE(unit.isEnabled());
  EXPECT_EQ(unit.currentText(), QStringLiteral("centimetres"));
  EXPECT_GT(*desk.wizard.trial()->import.volume_ml, 100'000.0);
  EXPECT_LT(*desk.wizard.trial()->import.volume_ml, 300'000.0);
}

TEST(OrganWizard, SaysWhyAPatternIsLeftOutAndHowFarItGoes) {
  OrganDesk desk;
  const std::filesystem::path file = wizardFile("arch.ply");
  writePly(file, torsio::testing::bentTube(0.03, 0.045, 2.6, 40, 60));  // bends so sharply that turns fold it
  desk.judge(file);

  const OrganImport& import = desk.wizard.trial()->import;
  int out = 0;
  for (const PatternJudgement& pattern : import.patterns) {
    out += pattern.accepted ? 0 : 1;
    if (!pattern.accepted) {
      EXPECT_THAT(readable(desk.wizard), HasSubstr(pattern.reason.str().substr(1)));
      EXPECT_EQ(pattern.shapes.size(), 2U);
    }
  }
  EXPECT_GT(out, 0);
  EXPECT_THAT(readable(desk.wizard), HasSubstr("left out"));
}

TEST(OrganWizard, TurnsAPackedBowelOnItsStalkInATrialTwist) {
  OrganImportRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.file = request.assets / "organs" / "former" / "midgut.ply";  // a pack with one stalk
  request.anatomy = "midgut";
  const OrganTrial trial = trialOf(importOrgan(request), request.assets);
  ASSERT_TRUE(trial.import.accepted);
  ASSERT_NE(trial.scene, nullptr);
  ASSERT_NE(trial.scene->hollow, nullptr);

  std::vector<Vec3> turned_m(trial.scene->mesh.vertices_m.size());
  trial.view.deform(trial.scene->hollow->stateAt(radians(60.0)), turned_m);

  // The front of the pack keeps its shape and rotates.
  const std::vector<Vec3>& rest_m = trial.scene->mesh.vertices_m;
  const auto front =
      std::min_element(rest_m.begin(), rest_m.end(), [](const Vec3& a, const Vec3& b) { return a.y < b.y; });
  const auto side =
      std::max_element(rest_m.begin(), rest_m.end(), [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
  const Vec3& frontNow_m = turned_m[static_cast<std::size_t>(front - rest_m.begin())];
  const Vec3& sideNow_m = turned_m[static_cast<std::size_t>(side - rest_m.begin())];
  EXPECT_NEAR(norm(sideNow_m - frontNow_m), norm(*side - *front), 1e-4);
  EXPECT_GT(norm(sideNow_m - *side), 0.04);
}

TEST(OrganWizard, UsesTheJudgedTwistForTheTrial) {
  OrganDesk desk;
  desk.judge(barFile());
  const OrganTrial& trial = *desk.wizard.trial();
  child<QSlider>(desk.wizard, "trialTwist").setValue(60);

  // The middle of a symmetric bar turns by half the angle.
  std::vector<Vec3> turned(trial.shown->vertices_m.size());
  const double length_m = trial.scene->lattice().length_m();
  trial.view.deform({{length_m, radians(60.0)}, {}}, turned);
  std::size_t seen = 0;
  for (std::size_t v = 0; v < turned.size(); ++v) {
    const Vec3& rest_m = trial.shown->vertices_m[v];
    const double share = trial.scene->lattice().nearestArc_m(rest_m) / length_m;
    if (std::abs(share - 0.5) < 0.02) {
      const double away_m = std::hypot(rest_m.x, rest_m.y);
      EXPECT_NEAR(norm(turned[v] - rest_m), 2.0 * away_m * std::sin(radians(15.0)), 5e-4);
      ++seen;
    }
  }
  EXPECT_GT(seen, 10U);
}

TEST(OrganWizard, SaysWhyAnOrganIsRefusedAndAcceptsItWithMoreInformation) {
  OrganDesk desk;
  desk.judge(barFile());
  // There is no testis of 200 ml.
  auto& anatomy = child<QComboBox>(desk.wizard, "anatomy");
  anatomy.setCurrentIndex(anatomy.findData(QStringLiteral("testis")));
  EXPECT_FALSE(wizardButton(desk.wizard, QStringLiteral("Save organ\u2026")).isEnabled());  // judged again
  desk.again();
  ASSERT_FALSE(desk.wizard.trial()->import.accepted);
  const std::string said = readable(desk.wizard);
  EXPECT_THAT(said, HasSubstr("Refused"));
  EXPECT_THAT(said, HasSubstr("M09"));
  EXPECT_THAT(said, HasSubstr(" ml; such an organ holds "));
  EXPECT_THAT(said, Not(HasSubstr("Measured: "))) << "a number without its unit";
  EXPECT_THAT(said, HasSubstr("Check the unit of the file"));
  EXPECT_FALSE(wizardButton(desk.wizard, QStringLiteral("Save organ\u2026")).isEnabled());
  EXPECT_FALSE(wizardButton(desk.wizard, QStringLiteral("Open in the simulator")).isEnabled());

  anatomy.setCurrentIndex(anatomy.findData(QStringLiteral("sigmoid")));
  desk.again();
  EXPECT_TRUE(desk.wizard.trial()->import.accepted);
  EXPECT_EQ(desk.wizard.trial()->import.organ.anatomy, "sigmoid");
}

TEST(OrganWizard, UsesTheEndsThatAreClicked) {
  OrganDesk desk;
  desk.judge(barFile());
  desk.wizard.show();
  QApplication::processEvents();
  child<QRadioButton>(desk.wizard, "endsGiven").setChecked(true);
  wizardButton(desk.wizard, QStringLiteral("Click")).setChecked(true);  // the fixed end; the free end is next
  SceneView& view = desk.wizard.picture().view();
  const auto click = [&](const Vec3& place_m) {
    return desk.wizard.picture().pickAt(view.camera().pixel(toView(place_m), QSizeF(view.size())));
  };
  ASSERT_TRUE(click({0, -0.02, 0.12}));  // seen from the front
  ASSERT_TRUE(click({0, -0.02, 0.02}));
  EXPECT_FALSE(click({0.5, 0, 0}));
  desk.again();
  const OrganEnds& ends = desk.wizard.trial()->import.organ.ends;
  ASSERT_TRUE(ends.fixedEnd_m && ends.freeEnd_m);
  EXPECT_NEAR(norm(*ends.fixedEnd_m - Vec3{0, -0.02, 0.12}), 0.0, 0.002);
  EXPECT_NEAR(norm(*ends.freeEnd_m - Vec3{0, -0.02, 0.02}), 0.0, 0.002);
}

TEST(ArmForm, ReturnsTheInputAndNoWristWidthIfUntouched) {
  ArmForm form;
  EXPECT_FALSE(form.person().wristWidth_mm.has_value());
  EXPECT_EQ(form.person().fingers_mm, PersonArm().fingers_mm);

  child<QDoubleSpinBox>(form, "wristThickness").setValue(40.0);
  child<QDoubleSpinBox>(form, "palmLength").setValue(108.0);
  child<QDoubleSpinBox>(form, "littleFinger").setValue(53.0);

  const PersonArm person = form.person();
  EXPECT_EQ(person.wristWidth_mm, kWristWidth.man_mm);
  EXPECT_EQ(person.wristThickness_mm, 40.0);
  EXPECT_EQ(person.palmLength_mm, 108.0);
  EXPECT_EQ(person.fingers_mm[4], 53.0);
  EXPECT_EQ(person.fingers_mm[0], PersonArm().fingers_mm[0]);
}

TEST(OrganWizard, GeneratesAnArmFromAPersonsMeasurements) {
  OrganDesk desk;
  child<QDoubleSpinBox>(desk.wizard, "wristWidth").setValue(56.0);
  child<QDoubleSpinBox>(desk.wizard, "wristThickness").setValue(40.0);
  child<QDoubleSpinBox>(desk.wizard, "middleFinger").setValue(66.0);
  desk.makeArm();

  const OrganTrial& trial = *desk.wizard.trial();
  ASSERT_TRUE(trial.import.accepted);
  EXPECT_EQ(trial.import.organ.anatomy, "forearm");
  // A man's arm has 1 523 ml; girths scaled by 0.86 give about three quarters.
  EXPECT_GT(*trial.import.volume_ml, 900.0);
  EXPECT_LT(*trial.import.volume_ml, 1300.0);
  const std::filesystem::path file = wizardFile("arm.organ");
  desk.wizard.save(file);
  EXPECT_EQ(contentHash(readOrganFile(file).mesh), contentHash(trial.import.organ.mesh));
  EXPECT_TRUE(std::filesystem::exists(file.parent_path() / (file.stem().string() + "_markers.json")));
}

TEST(OrganWizard, ReportsAFileThatIsNoSurfaceWithoutAPicture) {
  OrganDesk desk;
  const std::filesystem::path file = wizardFile("nonsense.stl");
  std::ofstream(file) << "this is no mesh at all, however long it may be";
  desk.judge(file);
  ASSERT_TRUE(desk.wizard.trial().has_value());
  EXPECT_FALSE(desk.wizard.trial()->import.accepted);
  EXPECT_EQ(desk.wizard.trial()->shown, nullptr);
  EXPECT_THAT(readable(desk.wizard), HasSubstr("No picture"));
}

/// A horizontal bar of tissue in air, like a CT: 40 mm thick, 200 mm long along the patient's left and right.
std::filesystem::path barScan() {
  const std::filesystem::path file = wizardFile("patient-name.nii.gz");
  const TriangleMesh bar = torsio::testing::shifted(
      torsio::testing::turned(torsio::testing::capsule(0.02, 0.16, 24, 24), {0, 1, 0}, 1.5707963267948966),
      {-0.08, 0, 0});
  ScanVolume scan = torsio::testing::blankScanAround(bar, {3, 3, 4}, 20.0);
  torsio::testing::fillWith(scan, bar, 40);
  writeFileAtomically(file, torsio::testing::gzipped(torsio::testing::niftiBytes(scan)));
  return file;
}

/// A visible wizard at the bar's slices, so that they can be clicked.
void openBar(OrganDesk& desk) {
  desk.wizard.show();
  desk.openScan(barScan());
  QApplication::processEvents();
}

SliceView& sliceOf(const ScanPanel& panel, SlicePlane plane) {
  return *panel.findChild<SliceView*>(sliceName(plane));
}

QPoint pixelAt(const ScanPanel& panel, SlicePlane plane, const Vec3& place_mm) {
  const Vec3 at = panel.state().preview.volume.voxelAt(place_mm);
  const PreviewVoxel voxel{static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y)),
                           static_cast<int>(std::lround(at.z))};
  return sliceOf(panel, plane).pixelOf(voxel).toPoint();
}

void chooseTool(OrganDesk& desk, const QString& name) {
  for (QAbstractButton* tool : desk.wizard.scanPanel().findChildren<QAbstractButton*>()) {
    if (tool->text().startsWith(name)) {
      tool->click();
      return;
    }
  }
  ADD_FAILURE() << "no tool " << name.toStdString();
}

TEST(OrganScan, ShowsSlicesAlongThePatientsAxes) {
  OrganDesk desk;
  openBar(desk);
  const ScanPanel& panel = desk.wizard.scanPanel();
  ASSERT_FALSE(panel.state().empty());
  // The bar extends from left to right: wide on the axial slice, round on the sagittal one.
  const ScanVolume& volume = panel.state().preview.volume;
  EXPECT_GT(volume.step_mm[0].x, 0.0);
  EXPECT_GT(volume.step_mm[1].y, 0.0);
  EXPECT_GT(volume.step_mm[2].z, 0.0);
  const QPoint here = pixelAt(panel, SlicePlane::kAxial, {60, 0, 0});
  const QPoint middle = pixelAt(panel, SlicePlane::kAxial, {0, 0, 0});
  EXPECT_GT(here.x(), middle.x());  // the patient's left is on the right
  EXPECT_GT(pixelAt(panel, SlicePlane::kAxial, {0, 15, 0}).y(), middle.y());  // the back is below
  EXPECT_LT(pixelAt(panel, SlicePlane::kCoronal, {0, 0, 15}).y(),
            pixelAt(panel, SlicePlane::kCoronal, {0, 0, 0}).y());  // the head is above
  const QImage shown = sliceOf(panel, SlicePlane::kAxial).grab().toImage();
  EXPECT_GT(qGray(shown.pixel(here)), 100);                                            // tissue
  EXPECT_LT(qGray(shown.pixel(pixelAt(panel, SlicePlane::kAxial, {60, 35, 0}))), 30);  // air
}

TEST(OrganScan, FindsTheOrganFromASeedAndABoxAndMakesASurface) {
  OrganDesk desk;
  openBar(desk);
  ScanPanel& panel = desk.wizard.scanPanel();
  chooseTool(desk, QStringLiteral("Seed"));
  QTest::mouseClick(&sliceOf(panel, SlicePlane::kAxial), Qt::LeftButton, {},
                    pixelAt(panel, SlicePlane::kAxial, {30, 0, 0}));
  ASSERT_TRUE(panel.request(false).seed_mm.has_value());
  EXPECT_NEAR(norm(*panel.request(false).seed_mm - Vec3{30, 0, 0}), 0.0, 5.0);

  desk.find();
  ASSERT_TRUE(panel.state().volume_ml().has_value()) << desk.failures.join(QLatin1Char('\n')).toStdString();
  const double whole_ml = *panel.state().volume_ml();
  EXPECT_NEAR(whole_ml, 235.0, 10.0);  // 0.02^2 pi 0.16 + 4/3 0.02^3 pi

  // A box around the half on the patient's left.
  chooseTool(desk, QStringLiteral("Box"));
  SliceView& axial = sliceOf(panel, SlicePlane::kAxial);
  QTest::mousePress(&axial, Qt::LeftButton, {}, pixelAt(panel, SlicePlane::kAxial, {0, -35, 0}));
  QTest::mouseMove(&axial, pixelAt(panel, SlicePlane::kAxial, {112, 35, 0}));
  QTest::mouseRelease(&axial, Qt::LeftButton, {}, pixelAt(panel, SlicePlane::kAxial, {112, 35, 0}));
  ASSERT_TRUE(panel.request(false).box_mm.has_value());
  desk.find();
  EXPECT_NEAR(*panel.state().volume_ml(), 0.5 * whole_ml, 0.06 * whole_ml);

  chooseTool(desk, QStringLiteral("Clear"));
  desk.find();
  desk.makeSurface();
  ASSERT_TRUE(desk.wizard.trial().has_value());
  const OrganImport& made = desk.wizard.trial()->import;
  EXPECT_TRUE(made.accepted);
  EXPECT_NEAR(made.volume_ml.value(), 235.0, 5.0);
  EXPECT_EQ(made.organ.source, "NIfTI, skin");  // without the file name
}

TEST(OrganScan, CorrectsTheMaskWithABrushThatCanBeUndone) {
  OrganDesk desk;
  openBar(desk);
  ScanPanel& panel = desk.wizard.scanPanel();
  desk.find();
  ASSERT_TRUE(panel.state().volume_ml().has_value()) << desk.failures.join(QLatin1Char('\n')).toStdString();
  const double whole_ml = panel.state().volume_ml().value();
  const auto strokeAlong = [&](const Vec3& from_mm, const Vec3& to_mm) {
    SliceView& axial = sliceOf(panel, SlicePlane::kAxial);
    panel.lookAt(from_mm);
    QTest::mousePress(&axial, Qt::LeftButton, {}, pixelAt(panel, SlicePlane::kAxial, from_mm));
    QTest::mouseMove(&axial, pixelAt(panel, SlicePlane::kAxial, to_mm));
    QTest::mouseRelease(&axial, Qt::LeftButton, {}, pixelAt(panel, SlicePlane::kAxial, to_mm));
  };
  chooseTool(desk, QStringLiteral("Brush: erase"));
  // Three strokes across the bar: the part beyond the cut is lost.
  for (const double z : {-14.0, 0.0, 14.0}) {
    strokeAlong({50, -26, z}, {50, 26, z});
  }
  const double cut_ml = panel.state().volume_ml().value();
  EXPECT_LT(cut_ml, whole_ml - 10.0);
  chooseTool(desk, QStringLiteral("Brush: add"));
  strokeAlong({0, 22, 0}, {20, 22, 0});
  const double added_ml = panel.state().volume_ml().value();
  EXPECT_GT(added_ml, cut_ml + 1.0);
  chooseTool(desk, QStringLiteral("Undo stroke"));
  EXPECT_DOUBLE_EQ(panel.state().volume_ml().value(), cut_ml);

  desk.makeSurface();
  ASSERT_TRUE(desk.wizard.trial().has_value());
  const OrganImport& made = desk.wizard.trial()->import;
  // The larger piece: from -100 to 42 mm.
  EXPECT_NEAR(made.volume_ml.value(), 168.0, 12.0);
  EXPECT_THAT(testing::readable(desk.wizard), HasSubstr("D19"));
}

TEST(OrganScan, KeepsItsDisplayIfTheOrganIsNotThere) {
  OrganDesk desk;
  openBar(desk);
  auto& tissue = child<QComboBox>(desk.wizard, "tissue");
  tissue.setCurrentIndex(static_cast<int>(ScanTissue::kGasLumen));
  desk.find();
  EXPECT_THAT(desk.failures.join(QLatin1Char('\n')).toStdString(), HasSubstr("no gas is enclosed"));
  EXPECT_FALSE(desk.wizard.scanPanel().state().empty());
}

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
