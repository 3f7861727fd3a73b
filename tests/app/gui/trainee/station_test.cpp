// SPDX-License-Identifier: GPL-3.0-or-later
// A trainee's way through the station with real widgets: from a locked module to the trend, on the offscreen
// platform.
#include <cmath>
#include <map>
#include <memory>
#include <vector>

#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QTest>
#include <QTextBrowser>
#include <gtest/gtest.h>

#include "app/gui/base/language.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/debrief_page.h"
#include "app/gui/trainee/debrief_plot.h"
#include "app/gui/trainee/debrief_replay.h"
#include "app/gui/trainee/live_scene.h"
#include "app/gui/trainee/run_page.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/trainee/transcript_page.h"
#include "app/gui/trainee/trend_page.h"
#include "app/gui/widgets/gauges.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/people/consent_service.h"
#include "app/services/recording/station_writer.h"
#include "app/services/training/run_session.h"
#include "db/repository/people/retention_repository.h"
#include "db/repository/trial/station_repository.h"
#include "tests/app/gui/support/trainee_station.h"
#include "tests/app/support/training_centre.h"
#include "tests/support/stored_rows.h"

namespace torsio::gui {
namespace {

using torsio::testing::deviceWith;
using torsio::testing::kMinute_us;
using torsio::testing::kSecond_us;
using torsio::testing::TrainingCentre;

/// Beside a level stand its rule and how often chance decides; the error rates are hidden until somebody
/// asks.
void expectExplainedLevel(const QLabel& beside, FoldedText& folded) {
  for (const char* part :
       {"Competent once the LC-CUSUM of the runs",
        "About 1 in 41 trainees who fail 30.0\u00A0% of their runs are declared competent by "
        "chance, and about 1 in 12 who fail only 5.0\u00A0% are not."}) {
    EXPECT_TRUE(beside.text().contains(QString::fromUtf8(part))) << part;
  }
  EXPECT_EQ(folded.findChild<FoldLine*>()->label()->text(), QStringLiteral("How often is this wrong?"));
  const auto* rates = folded.findChild<QLabel*>(QStringLiteral("folded"));
  EXPECT_TRUE(rates->text().contains(QStringLiteral("are declared competent within the")));
  const auto shown = [&folded, rates] { return rates->isVisibleTo(&folded); };
  EXPECT_FALSE(shown());
  folded.findChild<QPushButton*>(QStringLiteral("unfold"))->click();
  EXPECT_TRUE(shown());
}

/// A station at its first page.
class AtTheStation : public ::testing::Test {
 protected:
  TrainingCentre centre;
  Station station{centre};
};

TEST_F(AtTheStation, TheResultOfTheDeviceCheckIsOnTheBoardOfTheDay) {
  StationWriter line({centre.locator(), "station 1", centre.session().actor()});
  station.shell().setLine(&line);
  station.light = Light::kRed;

  station.open(PageId::kDeviceCheck);

  ASSERT_TRUE(line.settled(std::chrono::seconds(20)));
  const StationDevice shown = storedDevice(torsio::stationOnBoard(centre.connection(), "station 1").value());
  EXPECT_EQ(shown.device.str(), "Scripted hand");
  EXPECT_EQ(shown.light, Light::kRed);
  EXPECT_EQ(shown.problem.str(), "scripted");
  EXPECT_EQ(shown.checkedUtc_us, centre.session().now_us());
  station.shell().setLine(nullptr);
}

TEST(StationPages, TheRingFillsWhileTheTargetIsHeldAndEmptiesOffTarget) {
  TrainingCentre centre({.hold_us = kSecond_us});
  Station station(centre);
  station.open(PageId::kNextStep);
  station.press("begin");
  station.press("goOn");
  station.press("start");
  ASSERT_EQ(station.pageId, PageId::kRun);
  ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
  auto* dial = station.page->findChild<AngleDial*>();
  auto* scene = station.page->findChild<LiveScene*>();
  ASSERT_NE(dial, nullptr);
  ASSERT_NE(scene, nullptr);
  const auto heldAfter = [&](double seconds, double angle_rad, ExercisePhase phase) {
    LiveState state;
    state.time_us = static_cast<std::int64_t>(seconds * 1e6);
    state.phase = phase;
    state.response.angle_rad = angle_rad;
    Q_EMIT scene->shown(state);
    return dial->held();
  };
  const double target = torsio::testing::trainingBar().pattern.targetAngle_rad;

  EXPECT_DOUBLE_EQ(heldAfter(1.0, 0.5 * target, ExercisePhase::kTwisting), 0.0);
  EXPECT_DOUBLE_EQ(heldAfter(2.0, target, ExercisePhase::kTwisting), 0.0);
  EXPECT_DOUBLE_EQ(heldAfter(2.5, target, ExercisePhase::kTwisting), 0.5);
  EXPECT_DOUBLE_EQ(heldAfter(9.0, target, ExercisePhase::kTwisting), 1.0);
  EXPECT_DOUBLE_EQ(heldAfter(9.1, 1.3 * target, ExercisePhase::kTwisting), 0.0);
  EXPECT_DOUBLE_EQ(heldAfter(9.2, target, ExercisePhase::kTwisting), 0.0);  // restarts
  EXPECT_DOUBLE_EQ(heldAfter(9.4, target, ExercisePhase::kTwisting), 0.2);
  EXPECT_DOUBLE_EQ(heldAfter(9.5, target, ExercisePhase::kReleased), 0.0);
}

TEST(StationPages, TheLastResultIsShownInOneLineBesideItsModule) {
  TrainingCentre centre(TrainingCentre::Setup{});
  centre.attempt("first", "practice", 1.0);
  Station station(centre);
  station.open(PageId::kNextStep);
  station.page->resize(1160, 700);
  station.page->show();
  QCoreApplication::processEvents();

  int told = 0;
  for (const QLabel* label : station.page->findChildren<QLabel*>()) {
    if (label->text().startsWith(QStringLiteral("Last time:"))) {
      ++told;
      EXPECT_LT(label->height(), 2 * label->fontMetrics().height()) << label->text().toStdString();
      EXPECT_GE(label->width(), label->fontMetrics().horizontalAdvance(label->text()));
    }
  }
  EXPECT_EQ(told, 1);
}

TEST(StationPages, AGradedRunFromTheLockedModuleToTheTrend) {
  TrainingCentre centre(
      {.phases = {{.kind = PhaseKind::kVirtual, .label = "virtual 40 s", .duration_us = 40 * kSecond_us}}});
  for (int i = 0; i < 2; ++i) {
    centre.attempt("first", "practice", 1.0);
  }
  Station station(centre);

  station.open(PageId::kNextStep);
  EXPECT_TRUE(station.allText().contains(QStringLiteral("Master first: Quarter turn, second")));
  EXPECT_TRUE(station.allText().contains(QStringLiteral("Mastered")));
  bool told = false;  // what the level means, where the pointer rests on it
  for (const QLabel* why : station.page->findChildren<QLabel*>(QStringLiteral("why"))) {
    told = told || why->toolTip().contains(QStringLiteral("are declared competent within the"));
  }
  EXPECT_TRUE(told);
  station.page->applyTheme(theme(ThemeKind::kDark));                           // rebuilds the buttons
  EXPECT_EQ(station.page->focusWidget(), station.find<QPushButton>("begin"));  // Enter starts
  station.press("begin");

  ASSERT_EQ(station.pageId, PageId::kDeviceCheck);
  EXPECT_EQ(station.find<QLabel>("verdict")->text(), QStringLiteral("Ready"));
  station.press("goOn");

  ASSERT_EQ(station.pageId, PageId::kBriefing);
  station.press("start");

  ASSERT_EQ(station.pageId, PageId::kRun);
  ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
  EXPECT_TRUE(station.run().runSession()->graded());
  EXPECT_EQ(station.find<QLabel>("countdown")->text(), QStringLiteral("0:40"));
  EXPECT_EQ(station.find<QProgressBar>("timeLeft")->value(), 1000);
  EXPECT_FALSE(station.find<QLabel>("cue")->isVisibleTo(station.page.get()));  // no help in a graded run
  EXPECT_FALSE(station.page->leave());
  station.train(15 * kSecond_us);
  EXPECT_EQ(station.find<QLabel>("countdown")->text(), QStringLiteral("0:25"));
  EXPECT_NEAR(station.find<QProgressBar>("timeLeft")->value(), 1000 * 25 / 40, 2);  // of the remaining time
  station.train(kMinute_us);                                                        // hard stop

  ASSERT_EQ(station.pageId, PageId::kDebrief);
  auto& debrief = static_cast<DebriefPage&>(*station.page);
  EXPECT_FALSE(debrief.debrief().twists.empty());
  EXPECT_EQ(debrief.debrief().mode, AttemptMode::kGraded);
  EXPECT_NEAR(debrief.debrief().duration_s, 40.0, 0.1);
  EXPECT_EQ(debrief.debrief().moduleTitle, "Quarter turn, second");
  EXPECT_FALSE(station.find<QLabel>("verdict")->text().isEmpty());
  EXPECT_TRUE(station.find<QLabel>("competence")
                  ->text()
                  .startsWith(QStringLiteral("Your level (all runs): not shown yet; 37 more runs needed.")));
  expectExplainedLevel(*station.find<QLabel>("competence"), *station.find<FoldedText>("rates"));
  station.press("trend");

  ASSERT_EQ(station.pageId, PageId::kTrend);
  EXPECT_EQ(static_cast<TrendPage&>(*station.page).trend().points.size(), 1U);
  EXPECT_TRUE(station.find<QLabel>("level")->text().startsWith(QStringLiteral("Not shown yet; ")));
  expectExplainedLevel(*station.find<QLabel>("competence"), *station.find<FoldedText>("rates"));
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
}

TEST(StationPages, NothingIsRecordedBeforeTheTraineeConsents) {
  TrainingCentre centre({.consent = false});
  Station station(centre);
  station.open(PageId::kNextStep);
  station.press("begin");

  ASSERT_EQ(station.pageId, PageId::kConsent);
  EXPECT_FALSE(station.find<QPushButton>("agree")->isEnabled());
  station.find<QCheckBox>("understood")->setChecked(true);
  station.find<QCheckBox>("video")->setChecked(true);
  station.press("agree");

  EXPECT_EQ(station.pageId, PageId::kDeviceCheck);
  std::map<std::string, bool> decided;
  for (const ConsentDecision& one : ownConsents(centre.session())) {
    decided[one.purpose] = one.granted;
    EXPECT_EQ(one.form, ConsentForm::kScreen);
    EXPECT_EQ(one.textVersion, shippedConsent(TORSIO_SOURCE_DIR "/assets").id);
  }
  const std::map<std::string, bool> expected{{"training_record", true},
                                             {"video", true},
                                             {"research", false},
                                             {"xapi_export", false},
                                             {"teaching", false}};
  EXPECT_EQ(decided, expected) << "each purpose is a decision of its own";
}

TEST_F(AtTheStation, ConsentIsStoredWithoutAskingTwiceAndWithdrawnOnlyForTheRecord) {
  station.open(PageId::kConsent);
  const std::size_t before = ownConsents(centre.session()).size();
  ASSERT_EQ(before, 1U) << "the training record alone was decided about";
  station.find<QCheckBox>("teaching")->setChecked(true);
  station.find<QCheckBox>("understood")->setChecked(true);
  station.press("agree");
  const auto rows = [&] {
    Statement count = centre.connection().prepare("SELECT count(*) FROM consent");
    count.execute();
    return count.step() ? count.int64(0) : 0;
  };
  const std::int64_t kept = rows();

  station.open(PageId::kConsent);
  EXPECT_TRUE(station.find<QCheckBox>("teaching")->isChecked());
  EXPECT_FALSE(station.find<QCheckBox>("research")->isChecked());
  station.find<QCheckBox>("understood")->setChecked(true);
  station.press("agree");
  EXPECT_EQ(rows(), kept) << "nothing new was decided";
  station.open(PageId::kConsent);
  station.press("decline");

  EXPECT_EQ(rows(), kept + 1);
  for (const ConsentDecision& one : ownConsents(centre.session())) {
    EXPECT_EQ(one.granted, one.purpose == "teaching") << one.purpose;
  }
}

TEST_F(AtTheStation, ATraineeRequestsACopyOfTheRecordAndReadsTheAnswer) {
  station.open(PageId::kConsent);
  station.press("askCopy");

  EXPECT_FALSE(station.find<QPushButton>("askCopy")->isEnabled()) << "it waits";
  EXPECT_TRUE(station.find<QLabel>("ownRequests")->text().contains(QStringLiteral("a copy of everything")));
  std::vector<PersonRequest> own = ownRequests(centre.session());
  ASSERT_EQ(own.size(), 1U);
  RequestRepository(centre.connection()).answer(own[0].id, PersonRequestAnswer::kDone, "at the desk", 1);
  station.open(PageId::kConsent);
  EXPECT_TRUE(station.find<QLabel>("ownRequests")->text().contains(QStringLiteral("done. at the desk")))
      << station.find<QLabel>("ownRequests")->text().toStdString();
  EXPECT_TRUE(station.find<QPushButton>("askCopy")->isEnabled());
  station.press("askCopy");
  station.press("takeBackRequest");
  EXPECT_TRUE(station.find<QPushButton>("askCopy")->isEnabled());
}

TEST(StationPages, AmberAllowsOnlyPracticeAndRedNothing) {
  TrainingCentre centre;
  for (int i = 0; i < 2; ++i) {
    centre.attempt("first", "practice", 1.0);
  }
  Station station(centre);
  station.light = Light::kAmber;
  station.open(PageId::kNextStep);
  station.press("begin");
  EXPECT_FALSE(station.find<QPushButton>("goOn")->isEnabled());
  station.press("practise");
  EXPECT_EQ(station.pageId, PageId::kBriefing);
  EXPECT_FALSE(station.desk().graded);

  station.light = Light::kRed;
  station.open(PageId::kDeviceCheck);
  EXPECT_FALSE(station.find<QPushButton>("goOn")->isEnabled());
  EXPECT_EQ(station.find<QLabel>("verdict")->text(), QStringLiteral("Not ready"));
}

TEST(StationPages, RestStopsTheClockAndTheRealArmFollowsAutomatically) {
  TrainingCentre centre(
      {.phases = {{.kind = PhaseKind::kVirtual, .label = "virtual 1 min", .duration_us = kMinute_us},
                  {.kind = PhaseKind::kReal, .label = "real 1 min", .duration_us = kMinute_us}},
       .restAllowance_us = 30 * kSecond_us});
  Station station(centre);
  station.openRun(false, station.desk().openDevice);
  ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
  station.train(20 * kSecond_us);
  EXPECT_TRUE(station.find<QLabel>("cue")->isVisibleTo(station.page.get()));  // practice has help

  station.press("rest");
  EXPECT_EQ(station.run().runSession()->run().state(), RunState::kResting);
  station.train(10 * kSecond_us);
  EXPECT_EQ(station.find<QLabel>("countdown")->text(), QStringLiteral("0:40"));
  station.press("goOn");
  EXPECT_FALSE(station.find<QPushButton>("rest")->isEnabled());  // a single rest, not divisible
  station.train(40 * kSecond_us);
  EXPECT_EQ(station.run().runSession()->run().state(), RunState::kHandOver);
  station.press("goOn");
  EXPECT_TRUE(station.allText().contains(QStringLiteral("Train on the real arm")));
  station.train(2 * kMinute_us);

  EXPECT_EQ(station.pageId, PageId::kDebrief);
  const NextSteps steps = nextSteps(centre.session(), centre.person());
  EXPECT_TRUE(steps.allPhasesDone);
  EXPECT_EQ(attemptsOf(centre.session(), centre.person()).size(), 2U);  // the rest split the recording
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
}

// A hasty second click ends neither the rest nor the run.
TEST(StationPages, ADoubleClickOnRestStartsASingleRest) {
  TrainingCentre centre(
      {.phases = {{.kind = PhaseKind::kVirtual, .label = "virtual 1 min", .duration_us = kMinute_us}},
       .restAllowance_us = 30 * kSecond_us});
  Station station(centre);
  station.openRun(false, station.desk().openDevice);
  station.page->resize(1176, 652);
  station.page->show();
  ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
  station.train(5 * kSecond_us);
  auto* rest = station.find<QPushButton>("rest");
  QPoint at;
  ASSERT_TRUE(testing::eventually([&] {
    at = rest->mapTo(station.page.get(), rest->rect().center());
    return rest->isEnabled() && station.page->childAt(at) == rest;
  }));

  for (int click = 0; click < 2; ++click) {  // each on the button then present
    QWidget* under = station.page->childAt(at);
    ASSERT_NE(under, nullptr);
    QTest::mouseClick(under, Qt::LeftButton, {}, under->mapFrom(station.page.get(), at));
    QApplication::processEvents();
    EXPECT_EQ(station.run().runSession()->run().state(), RunState::kResting) << click;
  }

  EXPECT_EQ(station.pageId, PageId::kRun);
  station.press("goOn");
  EXPECT_EQ(station.run().runSession()->run().state(), RunState::kRunning);
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
}

TEST(StationPages, TheRunFitsTheSmallestScreenWithoutScrolling) {
  TrainingCentre centre(
      {.phases = {{.kind = PhaseKind::kVirtual, .label = "virtual 40 s", .duration_us = 40 * kSecond_us},
                  {.kind = PhaseKind::kReal, .label = "real 40 s", .duration_us = 40 * kSecond_us}},
       .restAllowance_us = 20 * kSecond_us});
  Station station(centre);
  applyTheme(*qApp, theme(ThemeKind::kLight));

  station.openRun(false, station.desk().openDevice);
  ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
  station.page->resize(1146, 650);  // 1366 x 768 without navigation and bars
  station.page->show();
  station.find<QLabel>("cue")->setText(QStringLiteral("Nearly there. Slow down."));
  QApplication::processEvents();

  EXPECT_EQ(station.page->size(), QSize(1146, 650));
  EXPECT_TRUE(station.find<QLabel>("cue")->isVisible());
  EXPECT_EQ(station.page->findChild<QScrollArea*>()->verticalScrollBar()->maximum(), 0);
}

// With a visitor's bar, the page is even lower, with a feedback of two lines below.
TEST(StationPages, AWarningIsFullyVisibleInTheSmallestWindow) {
  TrainingCentre centre({.leastTwists = 2});
  Station station(centre);
  applyTheme(*qApp, theme(ThemeKind::kLight));
  station.openRun(false, nullptr);
  ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
  station.page->resize(1146, 602);
  station.page->show();
  auto* scene = station.find<LiveScene>("scene");
  scene->hide();  // stops its timer: the test sets the state
  const auto show = [&](ExercisePhase phase, double angle_rad, double depth_m, std::int64_t released_us) {
    LiveState state;
    state.phase = phase;
    state.response.angle_rad = angle_rad;
    state.response.depth_m = depth_m;
    state.response.force_N = {0.0, 0.0, depth_m > 0.0 ? 0.5 : 0.0};
    state.times.released_us = released_us;
    Q_EMIT scene->shown(state);
    QApplication::processEvents();
  };
  const auto whole = [](const QWidget* widget) {
    return widget->isVisible() && widget->visibleRegion().boundingRect() == widget->rect();
  };
  auto* warning = station.find<QLabel>("warning");
  auto* verdict = station.find<QLabel>("verdict");
  show(ExercisePhase::kTwisting, 0.2, 0.0, -1);
  show(ExercisePhase::kReleased, 0.2, 0.0, 900'000);
  EXPECT_TRUE(whole(verdict)) << verdict->text().toStdString();
  EXPECT_GT(verdict->height(), 2 * verdict->fontMetrics().height() - 2) << "two lines";

  show(ExercisePhase::kContact, 0.0, 0.006, 900'000);
  EXPECT_TRUE(whole(warning)) << warning->text().toStdString();
  for (const LevelBar* bar : station.page->findChildren<LevelBar*>()) {
    EXPECT_TRUE(whole(bar)) << "the gauge that it speaks of";
  }
  show(ExercisePhase::kContact, 0.0, 0.001, 900'000);
  EXPECT_FALSE(warning->isVisible());
  EXPECT_TRUE(whole(verdict));

  station.page->resize(1700, 960);
  show(ExercisePhase::kContact, 0.0, 0.006, 900'000);
  int lowest = 0;
  for (const LevelBar* bar : station.page->findChildren<LevelBar*>()) {
    lowest = std::max(lowest, bar->mapTo(station.page.get(), QPoint(0, bar->height())).y());
  }
  const int below = warning->mapTo(station.page.get(), QPoint()).y() - lowest;
  EXPECT_GE(below, 0);
  EXPECT_LT(below, 6 * kSpace) << "close to the gauge that it speaks of";
}

TEST(StationPages, AnAbortedRunIsShownAsInterrupted) {
  TrainingCentre centre;
  {
    Station station(centre);
    station.openRun(false, station.desk().openDevice);
    ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
    station.train(5 * kSecond_us);
    // Destroys everything without notice, like a power failure; tests/app/services/training kills a real
    // program.
  }
  centre.passTime_us(utcNow_us() - torsio::testing::kCentreTime_us + kMinute_us);
  Station station(centre);

  station.open(PageId::kNextStep);

  EXPECT_TRUE(station.allText().contains(QStringLiteral("was interrupted")))
      << station.allText().toStdString();
  EXPECT_EQ(nextSteps(centre.session(), centre.person()).interrupted.size(), 1U);
}

TEST_F(AtTheStation, TheDebriefMentionsATwistInterruptedByTheEnd) {
  const auto unfinishedIn = [&](const std::string& trial) {
    return torsio::debrief(centre.session(), trial, {}, &torsio::testing::trainingBar()).unfinishedTwists;
  };
  // The hand twists repeatedly: one of these ends is during a twist, another is not.
  std::string cutOff;
  std::string whole;
  for (double end_s = 12.0; end_s < 24.0 && (cutOff.empty() || whole.empty()); end_s += 1.0) {
    const std::string trial = centre.attempt("first", "practice", 1.0, end_s, "", 60.0);
    (unfinishedIn(trial) == 1 ? cutOff : whole) = trial;
  }
  ASSERT_FALSE(cutOff.empty());
  ASSERT_FALSE(whole.empty());

  const LanguageSwitch english;  // for its plurals
  station.open(PageId::kDebrief, toQString(cutOff));

  EXPECT_TRUE(station.allText().contains(QStringLiteral("One twist was not completed and is not counted.")))
      << station.allText().toStdString();
  station.open(PageId::kDebrief, toQString(whole));
  EXPECT_FALSE(station.allText().contains(QStringLiteral("not completed")));
}

TEST(StationPages, AWeaknessLeadsToItsSeconds) {
  TrainingCentre centre;
  const std::string trial = centre.attempt("first", "practice", 0.1, 30.0);
  const Debrief told = torsio::debrief(centre.session(), trial, {}, &torsio::testing::trainingBar());
  ASSERT_FALSE(told.weaknesses.empty());
  DebriefPlot plot;
  plot.setDebrief(told);
  const Seconds all = plot.range();

  plot.show(told.weaknesses[0].when);

  EXPECT_LT(plot.range().to_s - plot.range().from_s, all.to_s - all.from_s);
  EXPECT_LE(plot.range().from_s, told.weaknesses[0].when.from_s);
  EXPECT_GE(plot.range().to_s, told.weaknesses[0].when.to_s - 1e-9);
  plot.showAll();
  EXPECT_DOUBLE_EQ(plot.range().to_s, told.duration_s);
}

TEST(StationPages, TheDebriefShowsTheRunIn3dWithTheExpertsGhost) {
  TrainingCentre centre;
  const std::string trial = centre.attempt("first", "practice", 0.3, 20.0);
  Station station(centre);
  station.desk().lastScene = borrowed(torsio::testing::trainingBar());
  station.open(PageId::kDebrief, QString::fromStdString(trial));
  auto& page = static_cast<DebriefPage&>(*station.page);
  auto* replay = station.find<DebriefReplay>("replay");
  auto* plot = station.find<DebriefPlot>("plot");
  auto* slider = station.find<QSlider>("slider");
  ASSERT_FALSE(page.debrief().twists.empty());
  const TwistResult& twist = page.debrief().twists.front();
  const double middle_s = 0.5 * (twist.when.from_s + twist.when.to_s);

  // A question is about the moment shown by replay and plot, whatever range the plot shows.
  auto* ask = station.find<QPushButton>("ask");
  EXPECT_TRUE(ask->text().endsWith(clockTenths(0.0))) << ask->text().toStdString();
  plot->show(twist.when);
  EXPECT_TRUE(ask->text().endsWith(clockTenths(0.0))) << ask->text().toStdString();
  QTest::keyClick(plot, Qt::Key_Return);
  const double shown_s = 0.5 * (plot->range().from_s + plot->range().to_s);
  EXPECT_NEAR(replay->position_s(), shown_s, 0.02);
  EXPECT_TRUE(ask->text().endsWith(clockTenths(replay->position_s()))) << ask->text().toStdString();
  EXPECT_TRUE(plot->reading().startsWith(clockTenths(replay->position_s())));

  slider->setValue(0);
  EXPECT_FALSE(replay->ghostShown());
  const QString before = plot->reading();
  slider->setValue(static_cast<int>(100.0 * middle_s));

  // One slider for both, with the values of that moment beside the playhead.
  EXPECT_NEAR(replay->position_s(), middle_s, 0.02);
  EXPECT_TRUE(replay->ghostShown());
  EXPECT_NE(plot->reading(), before);
  EXPECT_TRUE(ask->text().endsWith(clockTenths(replay->position_s())));
  station.find<QCheckBox>("expert")->setChecked(false);
  EXPECT_FALSE(replay->ghostShown());
  replay->togglePlay();
  replay->frame(0.5);
  EXPECT_NEAR(replay->position_s(), middle_s + 0.5, 0.02);
}

TEST_F(AtTheStation, ALateEnterNeverDecidesConsent) {
  station.open(PageId::kConsent);
  station.page->show();
  QApplication::processEvents();

  ASSERT_NE(station.page->focusWidget(), nullptr);
  EXPECT_EQ(qobject_cast<QPushButton*>(station.page->focusWidget()), nullptr);
}

TEST(StationPages, TheRunCountsItsTwists) {
  TrainingCentre centre({.leastTwists = 3});
  const LanguageSwitch english;  // for its plurals
  Station station(centre);
  station.openRun(false, [](const Scene& scene, double target_rad) -> std::unique_ptr<HapticDevice> {
    return std::make_unique<ScriptedHand>(practised(scene, target_rad));
  });
  ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
  auto* count = station.find<QLabel>("twistCount");
  EXPECT_EQ(count->text(), QStringLiteral("0 of 3 twists"));
  for (int i = 0; i < 40 && !count->text().startsWith(QLatin1Char('2')); ++i) {
    station.train(kSecond_us);
    station.find<LiveScene>("scene")->frame(0.04);
  }
  EXPECT_EQ(count->text(), QStringLiteral("2 of 3 twists"));
  auto* cue = station.find<QLabel>("cue");
  EXPECT_FALSE(cue->text().startsWith(QStringLiteral("All twists are done"))) << cue->text().toStdString();
  for (int i = 0; i < 40 && !cue->text().startsWith(QStringLiteral("All twists are done")); ++i) {
    station.train(kSecond_us);
    station.find<LiveScene>("scene")->frame(0.04);
  }
  EXPECT_EQ(cue->text(), QStringLiteral("All twists are done. End the run, or twist again."));
  EXPECT_EQ(count->text(), QStringLiteral("3 of 3 twists"));
  for (int i = 0; i < 40 && !count->text().startsWith(QLatin1Char('4')); ++i) {
    station.train(kSecond_us);
    station.find<LiveScene>("scene")->frame(0.04);
  }
  EXPECT_EQ(count->text(), QStringLiteral("4 twists, at least 3 asked for"));

  auto* warning = station.find<QLabel>("warning");
  LiveState pressing;
  pressing.phase = ExercisePhase::kContact;
  pressing.response.depth_m = 0.006;
  Q_EMIT station.find<LiveScene>("scene")->shown(pressing);
  EXPECT_TRUE(warning->text().isEmpty()) << "whoever has let go presses nothing";
  pressing.response.force_N = {0.0, 0.0, 0.5};
  Q_EMIT station.find<LiveScene>("scene")->shown(pressing);
  EXPECT_TRUE(warning->text().contains(QStringLiteral("pressing too deep")));
  pressing.response.depth_m = 0.004;
  Q_EMIT station.find<LiveScene>("scene")->shown(pressing);
  EXPECT_TRUE(warning->text().isEmpty());
}

// Text below the checks wraps; cards grow with it, even if the page is already visible.
TEST(StationPages, TheDebriefShowsEverySentenceCompletely) {
  TrainingCentre centre;
  applyTheme(*qApp, theme(ThemeKind::kLight));
  const TrialId run = centre.attempt("first", "practice", 1.0);
  Station station(centre);
  station.open(PageId::kDebrief);
  station.page->resize(1176, 652);
  station.page->show();
  QApplication::processEvents();
  for (int look = 0; look < 3; ++look) {
    if (look == 0) {
      station.page->enter(toQString(run));
      station.shell().waitForJobs();
    } else {
      station.page->applyTheme(theme(look == 1 ? ThemeKind::kDark : ThemeKind::kLight));
    }
    for (int i = 0; i < 5; ++i) {
      QApplication::processEvents();
    }
    int sentences = 0;
    for (const QLabel* label : station.page->findChildren<QLabel*>()) {
      if (label->isVisible() && label->wordWrap()) {
        ++sentences;
        EXPECT_GE(label->height(), label->heightForWidth(label->width()))
            << look << ": " << label->text().toStdString();
      }
    }
    EXPECT_GT(sentences, 5);
  }
}

/// Returns the scroll area of a page.
QScrollArea& scrolledOf(QWidget& page) {
  auto* area = page.findChild<QScrollArea*>();
  EXPECT_NE(area, nullptr);
  return *area;
}

// In a window of 1000 x 600, nothing extends beyond the right edge; in a wide one, both views of the run are
// side by side.
TEST(StationPages, TheDebriefFitsTheWidthOfASmallWindow) {
  TrainingCentre centre;
  applyTheme(*qApp, theme(ThemeKind::kLight));
  const TrialId run = centre.attempt("first", "practice", 1.0);
  Station station(centre);
  station.desk().lastScene = borrowed(torsio::testing::trainingBar());
  station.open(PageId::kDebrief, toQString(run));
  station.page->resize(1176, 652);
  station.page->show();
  const auto& replay = child<QWidget>(*station.page, "replay");
  const auto& plot = child<QWidget>(*station.page, "plot");
  ASSERT_TRUE(testing::eventually([&] { return replay.isVisible() && plot.isVisible(); }));
  const auto topOf = [&](const QWidget& part) { return part.mapTo(station.page.get(), QPoint()).y(); };
  const auto below = [&] { return topOf(plot) > topOf(replay) + replay.height(); };
  EXPECT_FALSE(below());

  for (const QSize& size : {QSize(810, 500), QSize(700, 500), QSize(1176, 652), QSize(1700, 900)}) {
    station.page->resize(size);
    const QScrollArea& area = scrolledOf(*station.page);

    EXPECT_TRUE(testing::eventually([&] { return area.widget()->width() <= area.viewport()->width(); }))
        << size.width() << ": " << area.widget()->width() - area.viewport()->width() << " too wide";
    EXPECT_TRUE(testing::eventually([&] { return below() == (size.width() < 900); })) << size.width();
  }
}

TEST(TrendPlot, CountsHaveOnlyWholeMarks) {
  const auto marksOf = [](Quantity quantity, double most) {
    Trend trend{.quantity = quantity};
    for (const double value : {0.0, most}) {
      trend.points.emplace_back().value = value;
    }
    TrendPlot plot;
    plot.setTrend(trend);
    return plot.marks();
  };
  for (const double most : {0.0, 1.0, 2.0, 7.0, 40.0}) {
    const std::vector<double> marks = marksOf(Quantity::kForceViolations, most);
    ASSERT_FALSE(marks.empty());
    for (const double mark : marks) {
      EXPECT_EQ(mark, std::round(mark)) << "up to " << most;
    }
  }
  const std::vector<double> angles = marksOf(Quantity::kMeanForce, 0.01);
  EXPECT_GT(angles.size(), 2U);
}

TEST(StationPages, TheTranscriptExplainsOnceHowCompetenceIsJudged) {
  TrainingCentre centre;
  centre.attempt("first", "practice", 1.0);
  Station station(centre);
  station.open(PageId::kTranscript);

  const QString all = station.page->findChild<QTextBrowser*>()->toPlainText();

  EXPECT_EQ(all.count(QStringLiteral("are declared competent within the")), 1) << all.toStdString();
  EXPECT_GE(all.count(QStringLiteral("Competence is judged as in \u201c")), 1) << all.toStdString();
}

TEST(StationPages, TheTrendOfAQuantityWithoutAThresholdShowsADashForTheDistance) {
  TrainingCentre centre;
  centre.attempt("first", "practice", 1.0);
  Station station(centre);
  station.open(PageId::kTrend, QString::fromStdString(centre.module("first")));
  static_cast<TrendPage&>(*station.page).chooseQuantity(Quantity::kSparc);

  const QStringList all = station.allText().split(QLatin1Char('\n'));

  EXPECT_TRUE(all.contains(QStringLiteral("\u2013"))) << all.join(u'|').toStdString();
  EXPECT_TRUE(all.contains(QStringLiteral("This quantity has no threshold in this module.")));
  EXPECT_TRUE(all.contains(QStringLiteral("Trend")));
}

TEST(StationPages, TheTranscriptIsAPdf) {
  TrainingCentre centre;
  centre.attempt("first", "practice", 1.0);
  Station station(centre);
  station.open(PageId::kTranscript);
  const std::filesystem::path file = centre.folder() / "transcript.pdf";

  static_cast<TranscriptPage&>(*station.page).writePdf(file);

  EXPECT_GT(std::filesystem::file_size(file), 2'000U);
}

TEST_F(AtTheStation, EveryPageCanBeEnteredByABeginner) {
  for (const PageId id : {PageId::kNextStep, PageId::kDebrief, PageId::kTrend, PageId::kRemarks,
                          PageId::kTranscript, PageId::kDeviceCheck, PageId::kConsent}) {
    station.open(id);
    EXPECT_TRUE(station.problems.empty())
        << pageText(id).toStdString() << ": " << station.problems.join('\n').toStdString();
  }
}

TEST(StationLabels, RoundCountdownsUpSoThatZeroIsTheEnd) {
  EXPECT_EQ(clockTimeLeft(0), QStringLiteral("0:00"));
  EXPECT_EQ(clockTimeLeft(1), QStringLiteral("0:01"));
  EXPECT_EQ(clockTimeLeft(20 * kMinute_us), QStringLiteral("20:00"));
}

}  // namespace
}  // namespace torsio::gui
