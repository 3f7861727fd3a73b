// SPDX-License-Identifier: GPL-3.0-or-later
// Importing an organ from a scan in the window: slices, segmentation, brush, surface.
#include <cmath>
#include <filesystem>

#include <QComboBox>
#include <QTest>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/gui/organ/organ_wizard.h"
#include "app/gui/organ/scan_panel.h"
#include "app/gui/organ/slice_view.h"
#include "app/gui/widgets/child.h"
#include "sim/core/file_io.h"
#include "tests/app/gui/organ/organ_desk.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/scan_files.h"

namespace torsio::gui {
namespace {

using ::testing::HasSubstr;
using testing::OrganDesk;
using testing::wizardFile;

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

}  // namespace
}  // namespace torsio::gui
