// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a trainee's first run easy: the guide, the expert in slow motion, the sound, the session's
// story. From the first page to a passed exercise with mouse and keys, every action performed on real
// widgets and counted: each click, key press, key release and wheel step. The test steps the servo, 16
// ticks per frame; an action takes the time of the keystroke-level model (Card, Moran and Newell 1980):
// decide 1.35 s, point 1.1 s, press 0.28 s.

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <gtest/gtest.h>

#include "app/gui/base/language.h"
#include "app/gui/simulator/readout_panel.h"
#include "app/gui/trainee/debrief_page.h"
#include "app/gui/trainee/live_scene.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/trainee/twist_guide.h"
#include "app/gui/widgets/child.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/angle.h"
#include "tests/app/gui/support/trainee_station.h"
#include "tests/app/support/training_centre.h"

namespace torsio::gui {

namespace {

using torsio::testing::kSecond_us;
using torsio::testing::TrainingCentre;
using Step = TwistGuide::Step;

LiveState inPhase(ExercisePhase phase) {
  LiveState state;
  state.phase = phase;
  return state;
}

TEST(TwistGuide, WaitsForEachMovementAndRestartsWhenTheTissueIsLost) {
  QWidget over;
  over.resize(900, 600);
  TwistGuide guide(&over);
  guide.follow(inPhase(ExercisePhase::kTwisting), true, 1.0);
  EXPECT_FALSE(guide.going());  // not requested
  guide.begin(false, true);
  const auto after = [&](ExercisePhase phase, bool onTarget = false, double held = 0.0) {
    guide.follow(inPhase(phase), onTarget, held);
    return guide.step();
  };

  EXPECT_EQ(after(ExercisePhase::kTracking), Step::kReach);
  EXPECT_EQ(after(ExercisePhase::kContact), Step::kClose);
  EXPECT_EQ(after(ExercisePhase::kTracking), Step::kReach);
  EXPECT_EQ(after(ExercisePhase::kContact), Step::kClose);
  EXPECT_EQ(after(ExercisePhase::kTwisting), Step::kTurn);
  EXPECT_EQ(after(ExercisePhase::kTwisting, true, 0.2), Step::kHold);
  EXPECT_EQ(after(ExercisePhase::kTwisting, false), Step::kTurn);
  EXPECT_EQ(after(ExercisePhase::kReleased), Step::kReach);
  EXPECT_TRUE(child<QLabel>(guide, "movement").text().startsWith(QStringLiteral("The tissue slipped")));
  EXPECT_EQ(after(ExercisePhase::kContact), Step::kClose);
  EXPECT_EQ(after(ExercisePhase::kTwisting, true, 0.9), Step::kHold);
  EXPECT_EQ(after(ExercisePhase::kTwisting, true, 1.0), Step::kLetGo);
  EXPECT_EQ(after(ExercisePhase::kReleased), Step::kDone);
  EXPECT_EQ(after(ExercisePhase::kContact), Step::kDone);

  EXPECT_TRUE(over.rect().contains(guide.geometry()));
  child<QPushButton>(guide, "skipGuide").click();
  EXPECT_FALSE(guide.going());
}

TEST(TwistGuide, ReleasesImmediatelyWithoutHolding) {
  QWidget over;
  TwistGuide guide(&over);
  guide.begin(true, false);
  auto said = [&over] {
    QStringList texts;
    for (const QLabel* label : over.findChildren<QLabel*>()) {
      texts << label->text();
    }
    return texts.join(QLatin1Char('\n'));
  };
  EXPECT_TRUE(said().contains(QStringLiteral("movement 1 of 4"))) << said().toStdString();
  guide.follow(inPhase(ExercisePhase::kTwisting), true, 0.0);
  EXPECT_EQ(guide.step(), Step::kLetGo);
  EXPECT_TRUE(said().contains(QStringLiteral("movement 4 of 4"))) << said().toStdString();
}

TEST(TwistCoach, SaysWhetherTheJawHoldsAnything) {
  TwistCoach coach;
  TrainingModule module;
  module.leastTwists = 3;
  coach.begin(module, radians(90.0), false);
  LiveState state = inPhase(ExercisePhase::kTracking);

  EXPECT_EQ(TwistCoach::jaw(state), QStringLiteral("Jaw: open"));
  EXPECT_TRUE(coach.cue(state).startsWith(QStringLiteral("Bring the jaw to the marked band.")));
  state.grip = 1.0;
  EXPECT_EQ(TwistCoach::jaw(state), QStringLiteral("Jaw: closed, nothing in it"));
  EXPECT_TRUE(coach.cue(state).startsWith(QStringLiteral("The jaw closed without tissue.")));
  state.phase = ExercisePhase::kContact;
  EXPECT_TRUE(coach.cue(state).startsWith(QStringLiteral("The jaw closed without tissue.")))
      << "a jaw that arrives closed grips nothing";
  state.phase = ExercisePhase::kTwisting;
  EXPECT_EQ(TwistCoach::jaw(state), QStringLiteral("Jaw: holds the tissue"));
  state.phase = ExercisePhase::kReleased;
  EXPECT_TRUE(coach.cue(state).endsWith(QStringLiteral("Draw back before the next twist.")));
}

TEST(TwistCoach, WarnsOfDepthOnlyWhileThereIsForce) {
  LiveState state = inPhase(ExercisePhase::kReleased);
  state.response.depth_m = 0.02;
  state.response.force_N = {0.004, 0.0, 0.0};  // shown as 0.00 N

  EXPECT_FALSE(ReadoutPanel::pressesTooDeep(state));
  state.response.force_N = {0.8, 0.0, 0.0};
  EXPECT_TRUE(ReadoutPanel::pressesTooDeep(state));
}

TEST(FirstTwist, IsGuidedInTheFirstPracticeAndOnRequestLater) {
  TrainingCentre centre;
  Station station(centre);
  const auto hand = [](const Scene& scene, double target_rad) -> std::unique_ptr<HapticDevice> {
    return std::make_unique<ScriptedHand>(practised(scene, target_rad));
  };
  station.openRun(false, hand);
  ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
  auto* guide = station.find<TwistGuide>("guide");
  EXPECT_TRUE(guide->going());
  Step farthest = Step::kReach;
  for (int i = 0; i < 400 && guide->step() != Step::kDone; ++i) {
    child<LiveScene>(station.run(), "scene").controller().run()->step(ticksIn(0.05));
    station.find<LiveScene>("scene")->frame(0.04);
    farthest = std::max(farthest, guide->step());
  }
  EXPECT_EQ(farthest, Step::kDone) << static_cast<int>(farthest);

  centre.attempt("first", "practice", 1.0);
  station.desk().moduleId = centre.module("first");
  Station later(centre);
  later.openRun(false, hand);
  ASSERT_TRUE(testing::eventually([&] { return later.run().busy(); }));
  EXPECT_FALSE(later.find<TwistGuide>("guide")->going());
  later.press("guideMe");
  EXPECT_TRUE(later.find<TwistGuide>("guide")->going());
}

TEST(FirstTwist, AVisitorStartsWithTheFirstExerciseWhateverTheSimulatedTraineeHasMastered) {
  for (const bool simulated : {false, true}) {
    TrainingCentre centre({.simulated = simulated});
    centre.attempt("first", "practice", 1.0);
    centre.attempt("first", "practice", 1.0);
    Station station(centre);
    station.desk().openDevice = nullptr;
    station.desk().probe = nullptr;
    station.open(PageId::kNextStep);
    const NextSteps steps = nextSteps(centre.session(), centre.person());
    ASSERT_TRUE(steps.next);
    EXPECT_EQ(steps.modules[*steps.next].module.id, centre.module("second"))
        << "the record goes by its rules";
    EXPECT_EQ(station.find<QWidget>("visitor")->isVisibleTo(station.page.get()), simulated);
    EXPECT_EQ(station.page->focusWidget(), station.find<QPushButton>(simulated ? "tryTwist" : "begin"));
    if (!simulated) {
      continue;
    }

    station.press("tryTwist");
    EXPECT_EQ(station.desk().moduleId, centre.module("first"));
    station.press("goOn");
    station.press("start");
    ASSERT_EQ(station.pageId, PageId::kRun);
    ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
    EXPECT_FALSE(station.run().runSession()->graded());
    EXPECT_TRUE(station.find<TwistGuide>("guide")->going());
  }
}

TEST(FirstTwist, TheBriefingDescribesTheExpertsActionsAndSlowsDown) {
  TrainingCentre centre;
  Station station(centre);
  station.desk().moduleId = centre.module("first");
  station.open(PageId::kBriefing);
  auto* scene = station.find<LiveScene>("scene");
  EXPECT_FALSE(scene->pictured());
  EXPECT_FALSE(child<QLabel>(*scene, "waitingForOrgan").isHidden()) << "not a black picture";
  ASSERT_TRUE(testing::eventually([&] { return scene->controller().playback() != nullptr; }));
  scene->frame(0.04);
  EXPECT_TRUE(child<QLabel>(*scene, "waitingForOrgan").isHidden());
  auto* caption = station.find<QLabel>("caption");
  const auto saidWhile = [&](ExercisePhase phase, double angle_rad = 0.0) {
    LiveState state = inPhase(phase);
    state.response.angle_rad = angle_rad;
    Q_EMIT scene->shown(state);
    return caption->text();
  };

  EXPECT_TRUE(saidWhile(ExercisePhase::kTracking).contains(QStringLiteral("the marked band")));
  EXPECT_TRUE(saidWhile(ExercisePhase::kTwisting).contains(QStringLiteral("one even turn")));
  EXPECT_TRUE(saidWhile(ExercisePhase::kTwisting, torsio::testing::trainingBar().pattern.targetAngle_rad)
                  .contains(QStringLiteral("holds still")));
  EXPECT_TRUE(saidWhile(ExercisePhase::kReleased).contains(QStringLiteral("opens gently")));
  LiveState drawsBack = inPhase(ExercisePhase::kTracking);
  drawsBack.times.released_us = kSecond_us;
  Q_EMIT scene->shown(drawsBack);
  EXPECT_TRUE(caption->text().contains(QStringLiteral("draws back"))) << caption->text().toStdString();
  EXPECT_DOUBLE_EQ(scene->controller().playback()->speed(), 1.0);
  station.press("slow");
  (void)saidWhile(ExercisePhase::kContact);
  TrialPlayback* expert = scene->controller().playback();
  EXPECT_DOUBLE_EQ(expert->speed(), 0.25);
  expert->seek_us(expert->duration_us());
  expert->setPlaying(false);
  EXPECT_TRUE(saidWhile(ExercisePhase::kReleased).contains(QStringLiteral("it is over")));
  station.press("again");
  EXPECT_EQ(scene->controller().playback(), expert) << "at once, from the beginning";
  EXPECT_EQ(expert->position_us(), 0);
  EXPECT_TRUE(expert->playing());

  station.press("slow");
  expert->seek_us(expert->duration_us());
  expert->setPlaying(false);
  station.press("slow");
  EXPECT_EQ(expert->position_us(), 0) << "whoever asks for slow motion afterwards sees it";
  EXPECT_TRUE(expert->playing());
}

TEST(FirstTwist, ASoundPlaysOnceAtALimitIfTheCentreWantsIt) {
  for (const bool wanted : {false, true}) {
    TrainingCentre centre;
    SettingRepository(centre.connection()).set("sound_at_limit", wanted ? "yes" : "no", 0);
    Station station(centre);
    int sounds = 0;
    station.desk().sound = [&sounds] { ++sounds; };
    station.openRun(false, {});
    ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
    auto* scene = station.find<LiveScene>("scene");
    for (const double force_N : {0.1, 99.0, 99.0, 0.1, 99.0}) {
      LiveState state = inPhase(ExercisePhase::kTwisting);
      state.response.force_N.x = force_N;
      Q_EMIT scene->shown(state);
    }
    EXPECT_EQ(sounds, wanted ? 2 : 0);
  }
}

Debrief toldRun(const TrialId& id, std::int64_t started_us, std::initializer_list<double> errors_deg) {
  Debrief told{.trialId = id, .startedUtc_us = started_us};
  for (const double error_deg : errors_deg) {
    TwistResult twist{.target_rad = radians(90.0),
                      .released_rad = radians(90.0 + error_deg),
                      .passed = std::abs(error_deg) <= 3.0};
    told.twists.push_back(twist);
  }
  return told;
}

TEST(SessionStory, KnowsTheBestTwistSinceSignIn) {
  SessionStory story;
  story.begin(1'000);
  story.begin(9'000);  // of the same session

  EXPECT_FALSE(story.add(toldRun("yesterday", 999, {0.1})));
  EXPECT_FALSE(story.add(toldRun("far off", 2'000, {20.0})));
  EXPECT_TRUE(story.add(toldRun("good", 3'000, {2.0, -1.0, 2.5})));
  EXPECT_FALSE(story.add(toldRun("good", 3'000, {0.1})));  // viewed again
  EXPECT_FALSE(story.add(toldRun("worse", 4'000, {-1.5})));

  EXPECT_EQ(story.runs(), 3U);
  EXPECT_EQ(story.twists(), 5U);
  EXPECT_EQ(story.onTarget(), 4U);
  ASSERT_TRUE(story.best());
  EXPECT_EQ(story.best()->trialId, "good");
  EXPECT_NEAR(degrees(story.best()->error_rad), 1.0, 1e-9);
}

TEST(SessionStory, IsOnTheFirstPageAfterARun) {
  TrainingCentre centre;
  const LanguageSwitch english;  // for its plurals
  Station station(centre);
  station.open(PageId::kNextStep);
  EXPECT_FALSE(station.find<QWidget>("session")->isVisibleTo(station.page.get()));
  centre.passTime_us(kSecond_us);
  station.desk().lastScene = borrowed(torsio::testing::trainingBar());
  station.open(PageId::kDebrief, QString::fromStdString(centre.attempt("first", "practice", 1.0)));

  station.open(PageId::kNextStep);

  EXPECT_TRUE(station.find<QWidget>("session")->isVisibleTo(station.page.get()));
  const QString words = station.find<QLabel>("sessionWords")->text();
  EXPECT_TRUE(words.startsWith(QStringLiteral("One run"))) << words.toStdString();
  EXPECT_TRUE(words.contains(QStringLiteral("Your best twist"))) << words.toStdString();

  // Its picture, taken by the debrief if scenes are drawn, is beside the text in its own aspect ratio.
  auto* picture = station.find<QLabel>("bestPicture");
  EXPECT_FALSE(picture->isVisibleTo(station.page.get()));
  QImage taken(900, 600, QImage::Format_RGB32);
  taken.fill(Qt::darkRed);
  station.desk().story.setPicture(taken);
  station.open(PageId::kNextStep);
  picture = station.find<QLabel>("bestPicture");
  EXPECT_TRUE(picture->isVisibleTo(station.page.get()));
  EXPECT_EQ(picture->pixmap(Qt::ReturnByValue).size(), QSize(225, 150));
  EXPECT_FALSE(picture->accessibleName().isEmpty());
}

using torsio::testing::kMinute_us;

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
