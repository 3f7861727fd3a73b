// SPDX-License-Identifier: GPL-3.0-or-later
// From the first page to a passed exercise with mouse and keys, every action performed on real widgets and
// counted: each click, key press, key release and wheel step. The test steps the servo, 16 ticks per frame;
// an action takes the time of the keystroke-level model (Card, Moran and Newell 1980): decide 1.35 s, point
// 1.1 s, press 0.28 s.
#include <cmath>
#include <functional>

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QKeyEvent>
#include <QLabel>
#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <gtest/gtest.h>

#include "app/gui/trainee/debrief_page.h"
#include "app/gui/trainee/live_scene.h"
#include "sim/core/angle.h"
#include "tests/app/gui/support/trainee_station.h"
#include "tests/app/support/training_centre.h"

namespace torsio::gui {
namespace {

using torsio::testing::kMinute_us;
using torsio::testing::kSecond_us;
using torsio::testing::TrainingCentre;

constexpr double kAction_s = 1.35 + 1.1 + 0.28;
constexpr int kFrame_ms = 16;
constexpr int kMaxActions = 25;
constexpr double kFourMinutes_s = 240.0;
constexpr double kPatience_s = 120.0;  // of the run's own time

/// A new trainee, with mouse and keyboard.
class Newcomer {
 public:
  explicit Newcomer(TrainingCentre& centre) : centre_(centre), station_(centre) {
    station_.desk().probe = nullptr;
    station_.desk().openDevice = nullptr;
  }

  void click(const char* button) {
    ++actions_;
    QTest::mouseClick(station_.find<QPushButton>(button), Qt::LeftButton);
  }
  void tick(const char* box) {
    ++actions_;
    station_.find<QCheckBox>(box)->click();
  }
  /// Advances servo, window and clock.
  void pass(double seconds) {
    for (double gone_s = 0.0; gone_s < seconds; gone_s += kFrame_ms * 1e-3) {
      scene().frame(kFrame_ms * 1e-3);
      scene().controller().run()->step(kFrame_ms);
      station_.clock->advance_us(kFrame_ms * 1000);
      centre_.passTime_us(kFrame_ms * 1000);
      run_s_ += kFrame_ms * 1e-3;
    }
  }
  void hold(int key) { send(QEvent::KeyPress, key); }
  void release(int key) { send(QEvent::KeyRelease, key); }
  /// Turns the wheel until a condition is true.
  void wheelUntil(const std::function<bool()>& there) {
    while (!there() && run_s_ < kPatience_s) {
      ++actions_;
      const QPointF at(0.5 * view().width(), 0.5 * view().height());
      QWheelEvent event(at, at, {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
      QApplication::sendEvent(&view(), &event);
      pass(0.1);
    }
  }
  void waitUntil(const std::function<bool()>& there) {
    while (!there() && run_s_ < kPatience_s) {
      pass(kFrame_ms * 1e-3);
    }
  }
  /// Moves the jaw to the organ and closes it with `key`.
  void grip(int key) {
    pass(0.5);
    wheelUntil([this] { return state().phase == ExercisePhase::kContact; });
    hold(key);
    waitUntil([this] { return state().phase == ExercisePhase::kTwisting; });
  }
  [[nodiscard]] LiveState state() { return scene().controller().state(); }
  Station& station() { return station_; }
  [[nodiscard]] int actions() const { return actions_; }
  [[nodiscard]] double needed_s() const { return run_s_ + actions_ * kAction_s; }
  void countOne() { ++actions_; }

 private:
  LiveScene& scene() { return child<LiveScene>(station_.run(), "scene"); }
  SceneView& view() { return scene().view(); }
  void send(QEvent::Type type, int key) {
    ++actions_;
    QKeyEvent event(type, key, Qt::NoModifier);
    QApplication::sendEvent(&view(), &event);
  }

  TrainingCentre& centre_;
  Station station_;
  int actions_ = 0;
  double run_s_ = 0.0;
};

/// A trainee in a run of the first module, not graded.
class NewcomerInARun : public ::testing::Test {
 protected:
  void SetUp() override {
    station.openRun(false, nullptr);
    ASSERT_TRUE(testing::eventually([this] { return station.run().busy(); }));
  }
  TrainingCentre centre;
  Newcomer newcomer{centre};
  Station& station = newcomer.station();
};

TEST(FirstRunByHand, ReachesAPassedExerciseInFourMinutesAndTwentyFiveActions) {
  TrainingCentre centre({.consent = false});
  Newcomer newcomer(centre);
  Station& station = newcomer.station();
  station.open(PageId::kNextStep);
  newcomer.click("begin");
  ASSERT_EQ(station.pageId, PageId::kConsent);
  newcomer.tick("understood");
  newcomer.click("agree");
  ASSERT_EQ(station.pageId, PageId::kDeviceCheck);
  newcomer.click("goOn");
  ASSERT_EQ(station.pageId, PageId::kBriefing);
  newcomer.click("start");
  ASSERT_EQ(station.pageId, PageId::kRun);
  ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));

  const TrainingModule module = station.run().runSession()->module();
  const auto off_rad = [&] { return newcomer.state().response.angle_rad - module.targetAngle_rad; };
  newcomer.grip(Qt::Key_Space);
  const int way = off_rad() < 0.0 ? Qt::Key_E : Qt::Key_Q;
  newcomer.hold(way);
  newcomer.pass(0.1);
  const bool wrongWay = std::abs(off_rad()) > std::abs(module.targetAngle_rad);
  const int right = !wrongWay ? way : way == Qt::Key_E ? Qt::Key_Q : Qt::Key_E;
  if (wrongWay) {
    newcomer.release(way);
    newcomer.hold(right);
  }
  newcomer.waitUntil([&] { return std::abs(off_rad()) < 0.3 * module.tolerance_rad; });
  newcomer.release(right);
  newcomer.pass(1.0 + static_cast<double>(module.hold_us) * 1e-6);
  EXPECT_TRUE(station.find<QLabel>("goal")->text().startsWith(QStringLiteral("Within ")));
  EXPECT_TRUE(station.find<QLabel>("verdict")->isHidden());
  newcomer.release(Qt::Key_Space);
  newcomer.pass(2.0);
  EXPECT_TRUE(station.find<QLabel>("verdict")->text().contains(QStringLiteral("On target: 1 of 1")))
      << station.find<QLabel>("verdict")->text().toStdString();
  QTimer::singleShot(0, qApp, [] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(question, nullptr);
    for (QAbstractButton* button : question->buttons()) {
      if (question->buttonRole(button) == QMessageBox::AcceptRole) {
        button->click();
      }
    }
  });
  newcomer.countOne();  // the answer to the question
  newcomer.click("stop");
  station.shell().waitForJobs();

  ASSERT_EQ(station.pageId, PageId::kDebrief);
  const Debrief& told = static_cast<DebriefPage&>(*station.page).debrief();
  EXPECT_EQ(told.twists.size(), 1U);
  EXPECT_TRUE(told.verdict.passed());
  EXPECT_LE(newcomer.actions(), kMaxActions);
  EXPECT_LE(newcomer.needed_s(), kFourMinutes_s);
  RecordProperty("actions", newcomer.actions());
  RecordProperty("seconds", static_cast<int>(newcomer.needed_s()));
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
}

TEST_F(NewcomerInARun, HoldingEnterOnTheEndQuestionUsesNoAttempt) {
  bool asked = false;
  QTimer::singleShot(0, qApp, [&asked] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(question, nullptr);
    asked = true;
    QTest::keyPress(question, Qt::Key_Return);
  });

  newcomer.click("stop");

  EXPECT_TRUE(asked);
  EXPECT_EQ(station.pageId, PageId::kRun);
  EXPECT_TRUE(station.run().busy());
}

TEST_F(NewcomerInARun, ATwistReleasedTooFarIsReportedImmediately) {
  const TrainingModule module = station.run().runSession()->module();
  newcomer.grip(Qt::Key_Space);
  newcomer.hold(module.targetAngle_rad < 0.0 ? Qt::Key_Q : Qt::Key_E);
  newcomer.waitUntil([&] {
    return std::abs(newcomer.state().response.angle_rad) >
           std::abs(module.targetAngle_rad) + module.tolerance_rad + radians(5.0);
  });
  newcomer.release(Qt::Key_Space);
  newcomer.pass(2.0);

  const QString told = station.find<QLabel>("verdict")->text();
  EXPECT_TRUE(told.contains(QStringLiteral("too far"))) << told.toStdString();
  EXPECT_TRUE(told.contains(QStringLiteral("On target: 0 of 1"))) << told.toStdString();
}

TEST_F(NewcomerInARun, ATwistInTheWrongDirectionIsNamed) {
  const TrainingModule module = station.run().runSession()->module();
  newcomer.grip(Qt::Key_Space);
  newcomer.hold(module.targetAngle_rad < 0.0 ? Qt::Key_E : Qt::Key_Q);
  newcomer.waitUntil([&] {
    return std::abs(newcomer.state().response.angle_rad - module.targetAngle_rad) >
           std::abs(module.targetAngle_rad) + radians(30.0);
  });
  EXPECT_EQ(station.find<QLabel>("cue")->text(), QStringLiteral("Turn in the opposite direction."));
  newcomer.release(Qt::Key_Space);
  newcomer.pass(2.0);

  const QString told = station.find<QLabel>("verdict")->text();
  EXPECT_TRUE(told.startsWith(QStringLiteral("Turned the wrong way"))) << told.toStdString();
  EXPECT_TRUE(told.contains(QStringLiteral("On target: 0 of 1"))) << told.toStdString();
}

TEST_F(NewcomerInARun, TheTimerMovesNoButtonBetweenPressAndRelease) {
  station.page->show();
  QApplication::processEvents();
  auto* stop = station.find<QPushButton>("stop");
  const QRect place = stop->geometry();
  for (const int x : {3, stop->width() / 4, stop->width() - 3}) {
    const QPoint at(x, stop->height() / 2);
    bool asked = false;
    QTimer::singleShot(0, qApp, [&asked] {
      if (auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
        asked = true;
        question->reject();
      }
    });
    QMouseEvent press(QEvent::MouseButtonPress, at, stop->mapToGlobal(at), Qt::LeftButton, Qt::LeftButton,
                      {});
    QMouseEvent release(QEvent::MouseButtonRelease, at, stop->mapToGlobal(at), Qt::LeftButton, Qt::NoButton,
                        {});
    QApplication::sendEvent(stop, &press);
    station.run().tick();
    EXPECT_EQ(stop->geometry(), place);
    QApplication::sendEvent(stop, &release);
    EXPECT_TRUE(asked);
    station.run().tick();  // nor under a pointer about to press
    EXPECT_EQ(stop->geometry(), place);
  }
}

TEST_F(NewcomerInARun, AJawOpenedByALossOfFocusIsReportedAndTheMouseRestoresIt) {
  station.page->show();
  QApplication::setActiveWindow(station.page.get());
  SceneView& view = child<LiveScene>(station.run(), "scene").view();
  view.setFocus();
  station.notices.clear();
  newcomer.grip(Qt::Key_G);

  station.find<QPushButton>("stop")->setFocus();
  newcomer.pass(0.5);
  EXPECT_NE(newcomer.state().phase, ExercisePhase::kTwisting);
  EXPECT_EQ(station.notices, QStringList{QStringLiteral("The keyboard left the organ: the jaw has opened.")});

  QEnterEvent back(QPointF(5, 5), QPointF(5, 5), QPointF(5, 5));
  QApplication::sendEvent(&view, &back);
  EXPECT_EQ(station.page->focusWidget(), &view);
}

// The rest ends while "Go on now" is pressed: the button stays until it is released.
TEST(FirstRunByHand, TheTimerRemovesNoPressedButton) {
  TrainingCentre centre(
      {.phases = {{.kind = PhaseKind::kVirtual, .label = "virtual 1 min", .duration_us = kMinute_us}},
       .restAllowance_us = 30 * kSecond_us});
  Station station(centre);
  station.openRun(false, nullptr);
  ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
  station.page->show();
  station.press("rest");
  QApplication::processEvents();
  auto* goOn = station.find<QPushButton>("goOn");
  ASSERT_TRUE(goOn->isVisible());
  const QRect place = goOn->geometry();

  QTest::mousePress(goOn, Qt::LeftButton);
  for (int i = 0; i < 6; ++i) {
    station.clock->advance_us(6 * kSecond_us);
    station.run().tick();
    QApplication::processEvents();
    EXPECT_TRUE(goOn->isVisible()) << i;
    EXPECT_EQ(goOn->geometry(), place) << i;
  }
  EXPECT_EQ(station.run().runSession()->run().state(), RunState::kRunning) << "training went on by itself";
  QTest::mouseRelease(goOn, Qt::LeftButton);
  station.run().tick();

  EXPECT_FALSE(goOn->isVisible());
  EXPECT_EQ(station.run().runSession()->run().state(), RunState::kRunning);
}

TEST(FirstRunByHand, EnterOnTheFirstPageStartsAlthoughThePageIsAlreadyVisible) {
  TrainingCentre centre;
  Station station(centre);
  station.open(PageId::kNextStep);
  station.page->show();
  QApplication::processEvents();
  for (QPushButton* button : station.page->findChildren<QPushButton*>()) {
    if (button->text() == QStringLiteral("&Consent")) {
      button->setFocus();  // the first focusable widget has focus when the page is opened
    }
  }

  station.page->enter({});

  EXPECT_EQ(station.page->focusWidget(), station.find<QPushButton>("begin"));
}

}  // namespace
}  // namespace torsio::gui
