// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a trainee's first run easy: the guide, the expert in slow motion, the sound, the session's
// story.
#include <algorithm>
#include <cmath>
#include <memory>

#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <gtest/gtest.h>

#include "app/gui/base/language.h"
#include "app/gui/trainee/live_scene.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/trainee/twist_guide.h"
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
  EXPECT_TRUE(guide.findChild<QLabel*>(QStringLiteral("movement"))
                  ->text()
                  .startsWith(QStringLiteral("The tissue slipped")));
  EXPECT_EQ(after(ExercisePhase::kContact), Step::kClose);
  EXPECT_EQ(after(ExercisePhase::kTwisting, true, 0.9), Step::kHold);
  EXPECT_EQ(after(ExercisePhase::kTwisting, true, 1.0), Step::kLetGo);
  EXPECT_EQ(after(ExercisePhase::kReleased), Step::kDone);
  EXPECT_EQ(after(ExercisePhase::kContact), Step::kDone);

  EXPECT_TRUE(over.rect().contains(guide.geometry()));
  guide.findChild<QPushButton*>(QStringLiteral("skipGuide"))->click();
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
  EXPECT_FALSE(scene->findChild<QLabel*>(QStringLiteral("waitingForOrgan"))->isHidden())
      << "not a black picture";
  ASSERT_TRUE(testing::eventually([&] { return scene->controller().playback() != nullptr; }));
  scene->frame(0.04);
  EXPECT_TRUE(scene->findChild<QLabel*>(QStringLiteral("waitingForOrgan"))->isHidden());
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

}  // namespace
}  // namespace torsio::gui
