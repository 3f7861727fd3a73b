// SPDX-License-Identifier: GPL-3.0-or-later
// The window's widgets, on a platform that cannot draw scenes.
#include <algorithm>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QToolBar>
#include <QToolButton>
#include <gtest/gtest.h>

#include "app/gui/base/translated_text.h"
#include "app/gui/practice/engineer_panel.h"
#include "app/gui/practice/simulator_window.h"
#include "app/gui/program/screenshot.h"
#include "app/gui/simulator/exercise_panel.h"
#include "app/gui/simulator/readout_panel.h"
#include "app/gui/widgets/gauges.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/picture.h"
#include "sim/core/error.h"
#include "tests/app/gui/support/bar_view.h"
#include "tests/app/gui/support/hands.h"

namespace torsio::gui {
namespace {

WindowSetup setup(ThemeKind kind = ThemeKind::kLight) {
  WindowSetup setup;
  setup.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  setup.loader = testing::loadBar;
  setup.recording.open = [](const RecordingSpec&) { return std::unique_ptr<TrialSink>(); };
  setup.recording.list = [] { return std::vector<RecordedTrial>(); };
  setup.theme = kind;
  setup.remember = false;
  return setup;
}

class Window : public ::testing::Test {
 protected:
  std::vector<SceneRequest> loaded_;  // requested from the loader, in its thread
  SimulatorWindow window_{[this] {
    WindowSetup noted = setup();
    noted.loader = [this](const SceneRequest& request) {
      loaded_.push_back(request);
      return testing::loadBar(request);
    };
    return noted;
  }()};

  void SetUp() override {
    window_.controller().setRealTime(false);
    window_.controller().adopt(testing::requestFor("bar"), testing::loadBar(testing::requestFor("bar")));
    window_.show();
    QApplication::processEvents();
  }
};

TEST_F(Window, OpensAtItsSizeAndNamesTheOrgan) {
  EXPECT_EQ(window_.size(), QSize(1280, 800));
  EXPECT_TRUE(window_.windowTitle().contains(QStringLiteral("Straight bar")));
}

TEST_F(Window, OffersEveryShippedOrgan) {
  const auto boxes = window_.findChildren<QComboBox*>();
  const auto organ = std::find_if(boxes.begin(), boxes.end(), [](const QComboBox* box) {
    return box->accessibleName() == QStringLiteral("Organ");
  });
  ASSERT_NE(organ, boxes.end());
  EXPECT_GE((*organ)->findData(QStringLiteral("forearm")), 0);
  EXPECT_GE((*organ)->findData(QStringLiteral("stomach")), 0);
}

TEST_F(Window, NamesAUsersMeshInsteadOfTheOrganItReplaces) {
  SceneRequest request = testing::requestFor("forearm");
  request.organFile = "mine.obj";
  LoadedScene loaded = testing::loadBar(request);
  window_.controller().adopt(request, loaded);

  const auto boxes = window_.findChildren<QComboBox*>();
  const auto organ = std::find_if(boxes.begin(), boxes.end(), [](const QComboBox* box) {
    return box->accessibleName() == QStringLiteral("Organ");
  });
  EXPECT_EQ((*organ)->currentText(), QStringLiteral("Straight bar"));
  const int items = (*organ)->count();
  window_.controller().adopt(testing::requestFor("forearm"),
                             testing::loadBar(testing::requestFor("forearm")));
  EXPECT_EQ((*organ)->count(), items - 1);
  EXPECT_EQ((*organ)->currentData().toString(), QStringLiteral("forearm"));
}

TEST_F(Window, EverythingFocusableHasANameForScreenReaders) {
  int checked = 0;
  for (QWidget* widget : window_.findChildren<QWidget*>()) {
    const bool reachable = (widget->focusPolicy() & Qt::TabFocus) != 0 && widget->isVisible();
    if (!reachable || qobject_cast<QToolButton*>(widget) != nullptr) {
      continue;
    }
    // A spin box's line edit uses the name of the box.
    if (widget->parentWidget() != nullptr &&
        qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) != nullptr) {
      continue;
    }
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->metaObject()->className();
    ++checked;
  }
  EXPECT_GE(checked, 5);
}

TEST_F(Window, EveryCommandHasTextAndEveryToolAShortcut) {
  const auto bars = window_.findChildren<QToolBar*>();
  ASSERT_EQ(bars.size(), 1);
  for (const QAction* action : bars.front()->actions()) {
    if (action->isSeparator() || action->text().isEmpty()) {
      continue;
    }
    EXPECT_FALSE(action->shortcut().isEmpty()) << action->text().toStdString();
    EXPECT_FALSE(action->statusTip().isEmpty()) << action->text().toStdString();
  }
}

TEST_F(Window, ShortcutsAreUnique) {
  QMap<QString, QString> owners;
  for (const QAction* action : window_.findChildren<QAction*>()) {
    const QString keys = action->shortcut().toString();
    if (keys.isEmpty()) {
      continue;
    }
    EXPECT_FALSE(owners.contains(keys)) << keys.toStdString() << " belongs to " << owners[keys].toStdString();
    owners[keys] = action->text();
  }
  EXPECT_GE(owners.size(), 14);
}

TEST_F(Window, ChoosingAFormulationLoadsTheSceneWithIt) {
  auto* panel = window_.findChild<ExercisePanel*>();
  ASSERT_NE(panel, nullptr);

  Q_EMIT panel->formulationChosen(Formulation::kPaper);
  EXPECT_TRUE(window_.controller().loading());
  ASSERT_TRUE(testing::eventually([this] { return !window_.controller().loading(); }));

  ASSERT_EQ(loaded_.size(), 1U);
  EXPECT_EQ(loaded_.front().id, "bar");
  EXPECT_EQ(loaded_.front().formulation, Formulation::kPaper);
}

TEST_F(Window, TheRateOfAnAsynchronousModelIsShownInWords) {
  auto* panel = window_.findChild<ExercisePanel*>();
  auto* said = window_.findChild<QLabel*>(QStringLiteral("beside"));
  ASSERT_NE(said, nullptr);
  EXPECT_TRUE(said->isHidden());

  Q_EMIT panel->tissueChosen(TissueModel::kFiniteElements);
  ASSERT_TRUE(testing::eventually([this] { return !window_.controller().loading(); }));
  window_.frame(1.0);
  EXPECT_TRUE(said->text().contains(QStringLiteral("begins with the first grip")))
      << said->text().toStdString();
  window_.controller().run()->step(100);
  window_.frame(1.0);

  EXPECT_EQ(loaded_.back().tissue, TissueModel::kFiniteElements);
  EXPECT_EQ(window_.controller().run()->header().model, TissueModel::kFiniteElements);
  EXPECT_FALSE(said->isHidden());
  const QRegularExpression words(
      QStringLiteral("^Finite elements: [0-9,]+ times a second beside the force at 1,000$"));
  EXPECT_TRUE(words.match(said->text()).hasMatch()) << said->text().toStdString();
  EXPECT_NE(window_.controller().run()->asyncModel()->framesPerSecond(), 0.0);
}

TEST_F(Window, AnEngineersModelIsRequestedFromTheLoaderAndNeverRecorded) {
  auto* panel = window_.findChild<EngineerPanel*>();
  ASSERT_NE(panel, nullptr);
  const auto command = [this](const QString& text) {
    const auto actions = window_.findChildren<QAction*>();
    return *std::find_if(actions.begin(), actions.end(), [&](QAction* a) { return a->text() == text; });
  };
  EXPECT_TRUE(command(QStringLiteral("Record"))->isEnabled());
  panel->setFolded(false);

  const auto boxes = panel->findChildren<QCheckBox*>();
  (*std::find_if(boxes.begin(), boxes.end(), [](const QCheckBox* box) {
    return box->text() == QStringLiteral("Taper correction");
  }))->setChecked(true);
  testing::press(*panel, QStringLiteral("Apply"));
  ASSERT_TRUE(testing::eventually([this] { return !window_.controller().loading(); }));

  ASSERT_EQ(loaded_.size(), 1U);
  EXPECT_TRUE(loaded_.front().model.taper);
  EXPECT_FALSE(loaded_.front().model.poynting);
  EXPECT_FALSE(command(QStringLiteral("Record"))->isEnabled());

  testing::press(*panel, QStringLiteral("As in the scene"));
  ASSERT_TRUE(testing::eventually([this] { return !window_.controller().loading(); }));
  EXPECT_FALSE(loaded_.back().model.any());
  EXPECT_TRUE(command(QStringLiteral("Record"))->isEnabled());
}

TEST_F(Window, TheEngineersPanelOffersThePartsOfTheFormulation) {
  EngineerPanel panel;
  const auto offered = [&panel](const QString& text) {
    const auto boxes = panel.findChildren<QCheckBox*>();
    return (*std::find_if(boxes.begin(), boxes.end(),
                          [&](const QCheckBox* box) { return box->text() == text; }))
        ->isEnabled();
  };
  TwistModelOptions options;
  ModelChoice everything;
  everything.taper = true;
  everything.clampLift = true;

  options.corrections.taper = true;
  panel.showModel(options, {}, everything, true);
  EXPECT_TRUE(offered(QStringLiteral("Taper correction")));
  EXPECT_FALSE(offered(QStringLiteral("Lift clamp (Eq. 23)")));
  EXPECT_TRUE(panel.choice().taper);

  options.formulation = Formulation::kPaper;
  panel.showModel(options, {}, everything, true);
  EXPECT_FALSE(offered(QStringLiteral("Taper correction")));
  EXPECT_TRUE(offered(QStringLiteral("Lift clamp (Eq. 23)")));
  EXPECT_FALSE(panel.choice().taper);
}

TEST_F(Window, ComparesTheOrganShownWithOtherModels) {
  std::string wanted;
  QObject::connect(&window_, &SimulatorWindow::comparisonWanted,
                   [&wanted](const SceneRequest& organ) { wanted = organ.id; });
  const auto actions = window_.findChildren<QAction*>();
  const auto compare = std::find_if(actions.begin(), actions.end(), [](const QAction* action) {
    return action->text() == QStringLiteral("Compare models");
  });
  ASSERT_NE(compare, actions.end());

  (*compare)->trigger();

  EXPECT_EQ(wanted, "bar");
}

TEST_F(Window, ReadoutsFollowTheState) {
  auto* readout = window_.findChild<ReadoutPanel*>();
  auto* dial = window_.findChild<AngleDial*>();
  ASSERT_NE(readout, nullptr);
  ASSERT_NE(dial, nullptr);
  LiveState state;
  state.response.angle_rad = 1.0;
  state.response.torque_Nm = 0.123;
  state.targetAngle_rad = 1.0;
  state.phase = ExercisePhase::kTwisting;
  readout->setLimits({.tolerance_rad = 0.05, .force_N = 3.3, .torque_Nm = 0.5});

  readout->show(state, 31.0);

  EXPECT_TRUE(dial->onTarget());
  EXPECT_TRUE(dial->accessibleDescription().contains(QStringLiteral("57.3")));
  bool torque = false;
  for (const LevelBar* bar : window_.findChildren<LevelBar*>()) {
    torque = torque || bar->accessibleDescription().contains(QStringLiteral("0.123"));
  }
  EXPECT_TRUE(torque);
  bool phase = false;
  for (const QLabel* label : readout->findChildren<QLabel*>()) {
    phase = phase || label->text().contains(ReadoutPanel::phaseName(ExercisePhase::kTwisting));
  }
  EXPECT_TRUE(phase);

  // A tool pressed into tissue is held at the surface, and the user is warned before a limit is reached.
  const auto tells = [readout](const LiveState& shown) {
    readout->show(shown, 31.0);
    const QList<QLabel*> labels = readout->findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->text().contains(QStringLiteral("pressing too deep"));
    });
  };
  state.response.depth_m = 0.006;
  EXPECT_FALSE(tells(state)) << "what is held may lie deep";
  state.phase = ExercisePhase::kContact;
  state.response.force_N = {0.0, 0.0, 0.5};
  EXPECT_TRUE(tells(state));
  state.response.depth_m = 0.004;
  EXPECT_FALSE(tells(state));
}

TEST_F(Window, ReadoutsOfATwistedOrganLeaveNoRoomForTheDial) {
  ReadoutPanel panel;
  panel.resize(290, 900);
  panel.setVisible(true);
  LiveState state;
  state.hollow.present = true;
  panel.show(state, 31.0);
  QCoreApplication::processEvents();

  for (const Card* card : panel.findChildren<Card*>()) {
    EXPECT_LE(card->height(), card->sizeHint().height()) << card->accessibleName().toStdString();
  }
}

TEST_F(Window, SaysWhyTheOrganWasReleased) {
  LiveState state;
  state.phase = ExercisePhase::kReleased;
  state.times.released_us = 3'000'000;
  const QString opened = ReadoutPanel::releaseText(state);
  state.times.slipped_us = 1'000'000;  // of an earlier grip
  EXPECT_EQ(ReadoutPanel::releaseText(state), opened);

  state.times.slipped_us = state.times.released_us;
  const QString slipped = ReadoutPanel::releaseText(state);
  state.times.slipped_us = 1'000'000;
  state.times.folded_us = state.times.released_us;
  const QString folded = ReadoutPanel::releaseText(state);

  EXPECT_TRUE(slipped.contains(QStringLiteral("slipped")));
  EXPECT_TRUE(folded.contains(QStringLiteral("folded")));
  EXPECT_NE(opened, folded);
}

TEST_F(Window, FreezingShowsASingleState) {
  LiveState state;
  state.response.angle_rad = 0.5;
  window_.controller().freeze(state);

  window_.frame(0.1);

  EXPECT_TRUE(window_.findChild<AngleDial*>()->accessibleDescription().contains(QStringLiteral("28.6")));
}

TEST_F(Window, TheThemeSwitchChangesTheWholeWindow) {
  const QColor light = window_.palette().color(QPalette::Window);

  window_.setThemeKind(ThemeKind::kDark);

  EXPECT_LT(window_.palette().color(QPalette::Window).lightness(), light.lightness());
  EXPECT_EQ(window_.themeKind(), ThemeKind::kDark);
  window_.setThemeKind(ThemeKind::kLight);
}

TEST_F(Window, FitsTheSmallestSupportedScreen) {
  window_.resize(1366, 768);
  QApplication::processEvents();
  EXPECT_LE(window_.minimumSizeHint().width(), 1366);
  EXPECT_LE(window_.minimumSizeHint().height(), 768);
}

TEST(Picture, AScreenshotWithoutOpenGlExplainsAndWritesNothing) {
  const QTemporaryDir folder;
  ScreenshotRequest request;
  request.file = (folder.path() + QStringLiteral("/picture.png")).toStdString();
  try {
    takeScreenshot(setup(), request);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kDevice);
    EXPECT_NE(error.where().find("offscreen"), std::string::npos);
    EXPECT_NE(error.remedy().find("xvfb-run"), std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(request.file));
}

TEST(Picture, IsWrittenCompletelyOrNotAtAll) {
  const QTemporaryDir folder;
  const std::filesystem::path file = (folder.path() + QStringLiteral("/a.png")).toStdString();
  QImage picture(8, 8, QImage::Format_RGB32);
  picture.fill(Qt::red);

  writePicture(picture, file);

  EXPECT_EQ(QImage(toQString(file)).pixelColor(3, 3), QColor(Qt::red));
  EXPECT_THROW(writePicture(QImage(), file), Error);
  EXPECT_THROW(writePicture(picture, toPath(folder.path()) / "none" / "a.png"), Error);
}

}  // namespace
}  // namespace torsio::gui
