// SPDX-License-Identifier: GPL-3.0-or-later
// Twist model, finite elements and springs in the window, and the markers of the comparison.

#include "app/gui/practice/model_comparison.h"

#include <cmath>
#include <ctime>
#include <filesystem>
#include <optional>

#include <QApplication>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QSpinBox>
#include <gtest/gtest.h>

#include "app/gui/base/figure_card.h"
#include "app/gui/practice/compare_page.h"
#include "app/gui/practice/marker_editor.h"
#include "app/gui/scene/scene_view.h"
#include "app/services/comparison/comparison_report.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/app/gui/support/administrator_desk.h"

namespace torsio::gui {

namespace {

namespace fs = std::filesystem;

/// So coarse that it takes only seconds.
ComparisonOptions coarse() {
  ComparisonOptions options;
  options.torque_Nm = -0.01;
  options.ramp_s = 0.1;
  options.rings = 1;
  options.springs.substeps = 3;
  return options;
}

SceneRequest forearm(testing::AdministratorDesk& office) {
  SceneRequest request;
  request.assets = office.shell().assets();
  request.id = "forearm";
  return request;
}

std::unique_ptr<ComparePage> openForearm(testing::AdministratorDesk& office) {
  return office.open<ComparePage>("trainee", QVariant::fromValue(forearm(office)));
}

fs::path freshFolder(const std::string& name) {
  const fs::path folder = fs::temp_directory_path() / ("torsio-model-comparison-" + name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

TEST(ModelComparison, ShowsThreeTimesTheReportsTablesAndSavesItsFiles) {
  testing::AdministratorDesk office;
  auto page = openForearm(office);
  ModelComparison& models = page->models();
  ASSERT_TRUE(models.loaded());

  models.compare(coarse());
  office.shell().waitForJobs();

  ASSERT_NE(models.result(), nullptr);
  EXPECT_EQ(models.result()->torque_Nm, -0.01);
  EXPECT_EQ(models.result()->markers.size(), 10U);
  int clocks = 0;
  for (const QLabel* label : models.findChildren<QLabel*>(QStringLiteral("clock"))) {
    EXPECT_TRUE(label->text().contains(QRegularExpression(QStringLiteral("^[0-9.]+ (\u00b5s|ms|s)$"))))
        << label->text().toStdString();
    ++clocks;
  }
  EXPECT_EQ(clocks, 3);
  int cards = 0;
  for (const FigureCard* card : models.findChildren<FigureCard*>()) {
    cards += card->isHidden() ? 0 : 1;
  }
  EXPECT_EQ(cards, 5);
  const auto* limits = models.findChild<QLabel*>(QStringLiteral("limits"));
  ASSERT_NE(limits, nullptr);
  for (const Text& sentence : comparisonLimits()) {
    EXPECT_TRUE(limits->text().contains(QString::fromStdString(sentence.str()))) << sentence;
  }
  const fs::path folder = freshFolder("report");
  models.saveReport(folder);
  for (const char* name : {"comparison.pdf", "comparison.json", "models.csv", "markers.csv", "course.csv"}) {
    EXPECT_GT(fs::file_size(folder / name), 100U) << name;
  }
  fs::remove_all(folder);
}

TEST(ModelComparison, IsCancelledWithinASecond) {
  testing::AdministratorDesk office;
  auto page = openForearm(office);
  ModelComparison& models = page->models();
  constexpr double kSecondOfTwoCores_s = 2.0;  // processor time: other programs do not count
  for (const double at : {0.0, 0.1, 0.6}) {    // twist model, reference, equilibrium
    std::optional<std::clock_t> asked;
    const auto watch = QObject::connect(&office.shell(), &ShellContext::jobMoved,
                                        [&](const QString&, double fraction, double) {
                                          if (fraction >= at && !asked) {
                                            asked = std::clock();
                                            office.shell().cancelJobs();
                                          }
                                        });
    ComparisonOptions whole;
    whole.ramp_s = 0.1;
    models.compare(whole);

    office.shell().waitForJobs();

    ASSERT_TRUE(asked);
    EXPECT_LT(static_cast<double>(std::clock() - *asked) / CLOCKS_PER_SEC, kSecondOfTwoCores_s) << at;
    EXPECT_EQ(models.result(), nullptr);
    QObject::disconnect(watch);
  }
}

TEST(MarkerEditor, MovesTheCurrentMarkerToWhereTheOrganIsClicked) {
  testing::AdministratorDesk office;
  auto page = openForearm(office);
  MarkerEditor& editor = page->markers();
  ASSERT_EQ(editor.markers().size(), 10U);
  const std::vector<OrganMarker> before = editor.markers();

  // The view is along +y of the world, from the front: marker 2 is on the palm, in front.
  editor.findChild<QListWidget*>()->setCurrentRow(8);
  ASSERT_TRUE(editor.placeAt(editor.findChild<MarkerLabels*>()->pixelOf(before[1])));

  EXPECT_LT(norm(editor.markers()[8].position_m - before[1].position_m), 0.5e-3);
  EXPECT_EQ(editor.markers()[8].name, before[8].name);
  EXPECT_EQ(norm(editor.markers()[1].position_m - before[1].position_m), 0.0);
  EXPECT_FALSE(editor.placeAt({1.0, 1.0})) << "beside the organ";
}

TEST(MarkerEditor, ShowsLongNamesCompletelyAndNoMarkersWithoutAPicture) {
  testing::AdministratorDesk office;
  auto page = openForearm(office);
  page->resize(1160, 700);
  static_cast<QWidget&>(*page).show();
  page->showMarkers();
  QApplication::processEvents();
  MarkerEditor& editor = page->markers();
  auto& name = *editor.findChild<QLineEdit*>();
  const QString longest = QStringLiteral("foot towards the descending colon, mesenteric border");

  EXPECT_GE(name.width() - 2 * kSpace, name.fontMetrics().horizontalAdvance(longest));

  auto& view = *editor.findChild<SceneView*>();
  ASSERT_FALSE(view.draws());
  const QImage withLabels = view.grab().toImage();
  editor.findChild<MarkerLabels*>()->hide();
  EXPECT_EQ(view.grab().toImage(), withLabels);
}

TEST(MarkerEditor, PlacesByRidgeAndSectionWithoutTheMouse) {
  testing::AdministratorDesk office;
  auto page = openForearm(office);
  MarkerEditor& editor = page->markers();
  const Scene& scene = *page->models().organ().loaded.scene;
  const auto boxes = editor.findChildren<QSpinBox*>();
  ASSERT_EQ(boxes.size(), 2);

  editor.findChild<QListWidget*>()->setCurrentRow(0);
  boxes[0]->setValue(19);
  boxes[1]->setValue(10);

  EXPECT_LT(norm(editor.markers()[0].position_m - scene.lattice().keyPoint_m(9, 18)), 1e-6);
}

TEST(MarkerEditor, SavesMarkersInAFileForTheComparison) {
  testing::AdministratorDesk office;
  auto page = openForearm(office);
  MarkerEditor& editor = page->markers();
  const fs::path file = freshFolder("markers") / "markers.json";
  auto* name = editor.findChild<QLineEdit*>();
  ASSERT_NE(name, nullptr);

  editor.findChild<QListWidget*>()->setCurrentRow(2);
  name->setText(QStringLiteral("my point"));
  Q_EMIT name->textEdited(name->text());
  editor.save(file);
  testing::press(editor, QStringLiteral("Reset"));
  EXPECT_EQ(editor.markers()[2].name, "radial styloid");
  editor.open(file);
  page->models().compare(coarse());
  office.shell().waitForJobs();

  EXPECT_EQ(editor.markers()[2].name, "my point");
  ASSERT_NE(page->models().result(), nullptr);
  EXPECT_EQ(page->models().result()->markers[2].name, "my point");
  writeFileAtomically(file, "{}");
  EXPECT_THROW(editor.open(file), Error);
  EXPECT_EQ(editor.markers()[2].name, "my point") << "a broken file changes nothing";
  fs::remove_all(file.parent_path());
}

/// Returns the numbers behind `word` on the page, the left model's first.
std::vector<double> numbersOf(const ComparePage& page, const QString& word) {
  const QRegularExpression line(QStringLiteral("^%1\\s+(-?[0-9.,]+)").arg(word));
  std::vector<double> numbers;
  for (const QLabel* label : page.findChildren<QLabel*>()) {
    if (const auto found = line.match(label->text()); found.hasMatch()) {
      numbers.push_back(QLocale(QLocale::C).toDouble(found.captured(1)));
    }
  }
  return numbers;
}

TEST(ComparePage, AnswersOneTorqueWithTwoModelsAndTheirTimes) {
  testing::AdministratorDesk office;
  auto page = office.open<ComparePage>("trainee");
  ASSERT_TRUE(page->loaded());

  page->setTorque(0.02);
  const std::vector<double> small_deg = numbersOf(*page, QStringLiteral("Angle"));
  page->setTorque(0.04);
  const std::vector<double> large_deg = numbersOf(*page, QStringLiteral("Angle"));

  ASSERT_EQ(small_deg.size(), 2U);
  ASSERT_EQ(large_deg.size(), 2U);
  constexpr double kShown_deg = 0.15;  // one decimal is displayed, and twice the small value is compared
  for (std::size_t side = 0; side < 2; ++side) {
    EXPECT_GT(std::abs(small_deg[side]), 1.0);
    EXPECT_NEAR(large_deg[side], 2.0 * small_deg[side], kShown_deg);  // both models are linear in the torque
  }
  EXPECT_GT(std::abs(large_deg[0] - large_deg[1]), 0.1 * std::abs(large_deg[1]));  // two models, two answers
  const std::vector<double> shear_kPa = numbersOf(*page, QStringLiteral("Largest shear"));
  ASSERT_EQ(shear_kPa.size(), 2U);
  EXPECT_GT(shear_kPa[0], 0.0);
  EXPECT_GT(shear_kPa[1], 0.0);
  const std::vector<double> time_us = numbersOf(*page, QStringLiteral("Computed in"));
  ASSERT_EQ(time_us.size(), 2U);
  EXPECT_GT(time_us[0], 0.0);
  EXPECT_GT(time_us[1], 0.0);
}

}  // namespace

}  // namespace torsio::gui
