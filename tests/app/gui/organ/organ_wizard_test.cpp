// SPDX-License-Identifier: GPL-3.0-or-later
// Importing an organ in the window: a mesh is judged, inspected, named, saved and opened.
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
#include <QRadioButton>
#include <QSignalSpy>
#include <QSlider>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/gui/organ/organ_picture.h"
#include "app/gui/organ/organ_sources.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/scene/view_frame.h"
#include "app/gui/widgets/child.h"
#include "app/services/organs/person_arm.h"
#include "sim/core/angle.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/organ_file.h"
#include "sim/scene/scene.h"
#include "tests/app/gui/organ/organ_desk.h"
#include "tests/support/procedural_mesh.h"

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

TEST(OrganWizard, TurnsAPackedBowelOnItsStalkInATrialTwist) {
  OrganImportRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.file = request.assets / "organs" / "midgut.ply";
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

}  // namespace
}  // namespace torsio::gui
