// SPDX-License-Identifier: GPL-3.0-or-later
// Each organ that comes twisted is untwisted in the window by mouse and keys alone, as a user would: vent
// gas, move the tip over the front of the held section, forwards to contact, close the jaw, turn as far as
// a hand turns, clip, open the jaw, back, and again. The test steps the servo, 16 ticks per frame. Twist
// model, finite elements and springs in the window, and the markers of the comparison.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMouseEvent>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTest>
#include <QWheelEvent>
#include <gtest/gtest.h>

#include "app/gui/base/figure_card.h"
#include "app/gui/practice/compare_page.h"
#include "app/gui/practice/marker_editor.h"
#include "app/gui/practice/model_comparison.h"
#include "app/gui/practice/simulator_window.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/scene/view_frame.h"
#include "app/gui/simulator/exercise_panel.h"
#include "app/gui/simulator/posed_states.h"
#include "app/gui/widgets/child.h"
#include "app/services/comparison/comparison_report.h"
#include "app/services/recording/recorded_run.h"
#include "assessment/metrics/detorsion.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/staged_turn.h"
#include "sim/scene/hollow_organ.h"
#include "sim/servo/exercise.h"
#include "sim/tissue/hollow/perfusion.h"
#include "tests/app/gui/support/administrator_desk.h"

namespace torsio::gui {

namespace {

constexpr double kFrame_s = 0.016;
constexpr std::int64_t kTicksAFrame = 16;
constexpr double kLongest_s = 300.0;

class Player {
 public:
  explicit Player(const std::string& id) : window_(setup()), view_(child<SceneView>(window_, "view")) {
    SceneRequest request;
    request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
    request.id = id;
    request.pattern = "detorse";
    window_.resize(1366, 768);
    window_.controller().setRealTime(false);
    LoadedScene loaded = loadSceneForView(request);
    scene_ = loaded.scene;
    window_.controller().adopt(request, std::move(loaded));
    window_.showNormal();
    pass(0.1);
    start_rad_ = angle_rad();
  }

  void play() {
    if (hollow().detorsion().wall.vent) {
      letGasOut();
    }
    int way = 1;  // determined by turning
    while (std::abs(angle_rad()) > radians(3.0) && now_s() < kLongest_s) {
      if (!grip()) {
        return;
      }
      if (clipped()) {
        click("clip");
      }
      way = turn(way);
      const bool done = std::abs(angle_rad()) <= radians(3.0);
      if (!done) {
        click("clip");
        regrips_ += 1;
        while (child<QLabel>(window_, "restText").isVisibleTo(&window_) && now_s() < kLongest_s) {
          pass(0.1);  // the organ needs a rest
        }
      }
      key(Qt::Key_G);
      pass(0.3);
      wheel(-6);
      pass(0.3);
    }
    pass(hollow().detorsion().limits.handsOff_s + 1.0);
  }

  [[nodiscard]] double now_s() const { return static_cast<double>(state_.time_us) * 1e-6; }
  [[nodiscard]] double angle_rad() const { return state_.response.angle_rad; }
  [[nodiscard]] double start_rad() const { return start_rad_; }
  [[nodiscard]] const StagedTurn& staged() const { return *staged_; }
  [[nodiscard]] int regrips() const { return regrips_; }
  [[nodiscard]] const HollowPose& pose() const { return state_.hollow; }
  [[nodiscard]] const HollowOrgan& hollow() const { return *scene_->hollow; }

 private:
  static WindowSetup setup() {
    WindowSetup setup;
    setup.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
    setup.remember = false;
    return setup;
  }

  void pass(double seconds) {
    for (double gone_s = 0.0; gone_s < seconds; gone_s += kFrame_s) {
      window_.frame(kFrame_s);
      window_.controller().run()->step(kTicksAFrame);
      state_ = window_.controller().state();
      if (!staged_) {
        staged_.emplace(hollow().detorsion().stages, hollow().detorsion().timeScale);
      }
      staged_->take(now_s(), angle_rad());
    }
  }
  [[nodiscard]] bool clipped() const { return state_.hollow.clipped; }
  [[nodiscard]] bool holds() const { return state_.phase == ExercisePhase::kTwisting; }

  void click(const char* button) {
    QTest::mouseClick(&child<QPushButton>(window_, button), Qt::LeftButton);
    pass(0.3);
  }
  void move(const QPointF& to) {
    QMouseEvent event(QEvent::MouseMove, to, to, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&view_, &event);
  }
  void wheel(int notches) {
    QWheelEvent event(mouse_, mouse_, {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&view_, &event);
  }
  void down(QEvent::Type type, int which) {
    QKeyEvent event(type, which, Qt::NoModifier);
    QApplication::sendEvent(&view_, &event);
  }
  void key(int which) {
    down(QEvent::KeyPress, which);
    down(QEvent::KeyRelease, which);
  }

  void letGasOut() {
    click("vent");
    const HollowWall& wall = hollow().detorsion().wall;
    while (pose().reading.pressure_Pa > wall.ventedPressure_Pa + 0.1 * wall.pressure_Pa &&
           now_s() < kLongest_s) {
      pass(0.1);
    }
  }

  /// Returns the pixel nearest to the viewer of the section that is to be held; `beside`: so many twentieths
  /// of the organ's length from there.
  [[nodiscard]] QPointF frontOfTheBand(int beside) const {
    const Scene& scene = *scene_;
    OrganState lies{{state_.response.graspArc_m, angle_rad()}, {}, state_.hollow};
    scene.hollow->lay(lies);
    const double arc_m = (scene.pattern.graspArc + 0.05 * beside) * scene.lattice().length_m();
    const auto pointAt = [&](double angle_deg) {
      return toView(
          scene.toDeformed_m(scene.lattice().surfacePoint({arc_m, radians(angle_deg)}).position_m, lies));
    };
    double found_deg = 0.0;
    for (int i = 1; i < 72; ++i) {
      found_deg = view_.camera().depth(pointAt(5.0 * i)) < view_.camera().depth(pointAt(found_deg))
                      ? 5.0 * i
                      : found_deg;
    }
    return view_.camera().pixel(pointAt(found_deg), QSizeF(view_.size()));
  }

  bool grip() {
    // Where the shaft rests against another part, the jaw does not arrive: one tries beside it.
    for (const int beside : {0, 0, -1, 1, -2, 2}) {
      mouse_ = frontOfTheBand(beside);
      move(mouse_);
      pass(0.4);
      for (int notch = 0; notch < 120 && (state_.contact & kContactJaw) == 0; ++notch) {
        wheel(1);
        pass(0.08);
      }
      key(Qt::Key_G);
      pass(0.5);
      if (holds()) {
        return true;
      }
      key(Qt::Key_G);
      pass(0.2);
      wheel(-4);
      pass(0.3);
    }
    return false;
  }

  /// Turns what is held as far as a hand turns, or until it is untwisted; returns the direction that untwists
  /// it.
  int turn(int way) {
    const double from_rad = angle_rad();
    double least_rad = from_rad;
    double most_rad = from_rad;
    bool turnedBack = false;
    down(QEvent::KeyPress, way > 0 ? Qt::Key_E : Qt::Key_Q);
    while (holds() && now_s() < kLongest_s) {
      pass(kFrame_s);
      least_rad = std::min(least_rad, angle_rad());
      most_rad = std::max(most_rad, angle_rad());
      const bool atItsEnd = most_rad - least_rad > kHandTurn_rad - radians(0.5);
      if (std::abs(angle_rad()) > std::abs(from_rad) + radians(10.0) && !turnedBack) {
        down(QEvent::KeyRelease, way > 0 ? Qt::Key_E : Qt::Key_Q);
        way = -way;
        turnedBack = true;
        down(QEvent::KeyPress, way > 0 ? Qt::Key_E : Qt::Key_Q);
      } else if (std::abs(angle_rad()) < radians(2.0) || atItsEnd) {
        break;
      }
    }
    down(QEvent::KeyRelease, way > 0 ? Qt::Key_E : Qt::Key_Q);
    pass(0.3);
    return way;
  }

  SimulatorWindow window_;
  SceneView& view_;
  std::shared_ptr<const Scene> scene_;
  LiveState state_;
  QPointF mouse_{400.0, 300.0};
  std::optional<StagedTurn> staged_;
  double start_rad_ = 0.0;
  int regrips_ = 0;
};

class UntwistingByHand : public ::testing::TestWithParam<const char*> {};

TEST_P(UntwistingByHand, MouseAndKeysUntwistIt) {
  Player player(GetParam());

  player.play();

  const HollowPose& pose = player.pose();
  const DetorsionLimits& limits = player.hollow().detorsion().limits;
  const auto torn = std::count_if(pose.marks.begin(), pose.marks.begin() + pose.markCount,
                                  [](const TissueMark& mark) { return mark.torn; });
  std::printf("%s: from %.0f degrees, %.1f s, %d re-grips of at least %.0f, dose %.3f, flow %.2f, %d marks\n",
              GetParam(), degrees(player.start_rad()), player.now_s(), player.regrips(),
              leastRegrips(player.start_rad()), pose.reading.dose, pose.reading.flow, pose.markCount);
  EXPECT_LE(std::abs(player.angle_rad()), limits.residual_rad);
  EXPECT_GE(pose.reading.patency, limits.patency);
  EXPECT_GE(pose.reading.flow, limits.flow);
  EXPECT_LT(pose.reading.dose, 1.0);
  EXPECT_EQ(torn, 0);
  EXPECT_LE(player.regrips(), leastRegrips(player.start_rad()) + 2.0);
  EXPECT_LT(player.now_s(), 180.0);
  const TurnStages& stages = player.hollow().detorsion().stages;
  if (stages.asked()) {
    EXPECT_LE(player.staged().longest_rad(), stages.turn_rad + kStageTolerance_rad);
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, UntwistingByHand,
                         ::testing::Values("small-bowel-loop", "gastric-organo-axial", "testis", "sigmoid",
                                           "gastric-mesentero-axial", "midgut"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

const std::filesystem::path kAssets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

// At 8 mmHg, the antrum of its former organ is squeezed to the packed radius with a fifth of its lumen open.
TEST(UntwistingStates, ClosedOnesAreShutAndIschaemicOnesHaveBeenTwistedLong) {
  SceneRequest request;
  request.assets = kAssets;
  request.id = "gastric-organo-axial";
  request.pattern = "detorse";
  request.former = true;
  const Scene scene = loadScene(request);
  const double pressure_Pa = scene.hollow->detorsion().wall.pressure_Pa;
  ASSERT_GT(scene.hollow->patency(scene.hollow->closing_rad(pressure_Pa), pressure_Pa), 0.1);

  const LiveState closed = untwistingState(scene, UntwistingState::kClosed);
  const LiveState ischaemic = untwistingState(scene, UntwistingState::kIschaemic);
  const LiveState recovered = untwistingState(scene, UntwistingState::kRecovered);

  EXPECT_LE(closed.hollow.reading.patency, kShutPatency);
  EXPECT_EQ(closed.hollow.scaled_s, 0.0);
  EXPECT_GT(ischaemic.hollow.scaled_s, 3600.0);
  EXPECT_GT(recovered.hollow.scaled_s, ischaemic.hollow.scaled_s);
}

// A stomach has four arteries and is rarely strangulated: at the largest twist of this scene, 77 % of the
// flow remain, which is enough, and nothing is lost. It is congested all the same, visibly.
TEST(UntwistingStates, ACongestedOrganIsDiscolouredLikeAnIschaemicOne) {
  for (const auto& [id, starves] : {std::pair{"gastric-mesentero-axial", false}, std::pair{"midgut", true}}) {
    SceneRequest request;
    request.assets = kAssets;
    request.id = id;
    request.pattern = "detorse";
    const Scene scene = loadScene(request);

    const HollowPose pose = untwistingState(scene, UntwistingState::kIschaemic).hollow;

    const TissueColour colour = colourOf({.flow = pose.reading.flow,
                                          .congestion = pose.congestion,
                                          .dose = pose.reading.dose,
                                          .saturation = pose.saturation});
    EXPECT_GT(std::hypot(colour.red - kSerosaPink.red, colour.green - kSerosaPink.green,
                         colour.blue - kSerosaPink.blue),
              0.28)
        << id;
    EXPECT_EQ(pose.reading.flow < scene.hollow->detorsion().vessels.enoughFlow, starves) << id;
    EXPECT_EQ(pose.reading.dose > 0.0, starves) << id;
  }
}

TEST(ExerciseBoxes, ShowFullNamesOfAnOrganInASmallWindow) {
  WindowSetup setup;
  setup.assets = kAssets;
  setup.remember = false;
  SimulatorWindow window(setup);
  window.resize(1280, 800);
  window.showNormal();
  const auto* panel = window.findChild<ExercisePanel*>();
  ASSERT_NE(panel, nullptr);
  const auto* box = panel->findChild<QComboBox*>();
  ASSERT_NE(box, nullptr);
  ASSERT_GE(box->count(), 9);

  QStyleOptionComboBox option;
  option.initFrom(box);
  option.editable = false;
  const int room =
      box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box).width();
  for (int i = 0; i < box->count(); ++i) {
    EXPECT_LE(box->fontMetrics().horizontalAdvance(box->itemText(i)), room) << box->itemText(i).toStdString();
  }
}

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
  EXPECT_EQ(cards, 6);
  const auto* limits = models.findChild<QLabel*>(QStringLiteral("limits"));
  ASSERT_NE(limits, nullptr);
  for (const Text& sentence : comparisonLimits()) {
    EXPECT_TRUE(limits->text().contains(QString::fromStdString(sentence.str()))) << sentence;
  }
  const fs::path folder = freshFolder("report");
  models.saveReport(folder);
  for (const char* name :
       {"comparison.pdf", "comparison.json", "models.csv", "meshes.csv", "markers.csv", "course.csv"}) {
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
