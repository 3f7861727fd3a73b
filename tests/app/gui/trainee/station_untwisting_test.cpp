// SPDX-License-Identifier: GPL-3.0-or-later
// The station's pages with a module whose organ comes twisted.

#include <filesystem>
#include <set>

#include <QComboBox>
#include <QWidget>
#include <gtest/gtest.h>

#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/debrief_page.h"
#include "app/gui/trainee/detorsion_card.h"
#include "app/gui/trainee/trend_page.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/recording/recorded_run.h"
#include "app/services/training/detorsion_story.h"
#include "assessment/catalogue/quantity.h"
#include "db/repository/base/id_source.h"
#include "db/repository/trial/trial_repository.h"
#include "tests/app/gui/support/trainee_station.h"
#include "tests/app/gui/support/visible_texts.h"
#include "tests/app/support/training_centre.h"

namespace torsio::gui {

namespace {

using torsio::testing::TrainingCentre;

TrainingCentre::Setup loopOfSmallBowel() {
  TrainingCentre::Setup setup;
  setup.sceneId = "small-bowel-loop";
  setup.patternId = "detorse";
  return setup;
}

/// A run on the shipped loop by a scripted hand, until hands are off.
TrialId undoneRun(TrainingCentre& centre) {
  SceneRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.id = "small-bowel-loop";
  request.pattern = "detorse";
  ScriptedTrial trial;
  trial.recording = {.trialId = SystemIdSource().newUuid(),
                     .traineeCode = centre.session().actor().login,
                     .startedUtc_us = centre.session().now_us(),
                     .context = {.station = "station 1",
                                 .enrolmentId = centre.enrolment(),
                                 .moduleId = centre.module("first"),
                                 .attemptMode = AttemptMode::kPractice}};
  TrialRepository repository(centre.connection(), trial.recording.context);
  recordScriptedTrial(loadScene(request), trial, repository);
  return trial.recording.trialId;
}

TEST(StationOfAnUntwisting, TheBriefingDescribesTheTwistItsTreatmentAndTheGoal) {
  TrainingCentre centre(loopOfSmallBowel());
  Station station(centre);
  station.desk().moduleId = centre.module("first");

  station.open(PageId::kBriefing);

  const QString text = station.allText();
  for (const char* said :
       {"A loop of small bowel is twisted", "The organ came twisted by 180° to 210°. Untwist it.",
        "with hands off.", "The lumen must be open to", "The jaw bruises the wall from",
        "Meanwhile 60 s of the tissue pass each second.", "C: clip.", "An expert untwists the same organ"}) {
    EXPECT_TRUE(text.contains(QString::fromUtf8(said))) << said << " in " << text.toStdString();
  }
  EXPECT_FALSE(text.contains(QStringLiteral("release within")));  // no target
}

TEST(StationOfAnUntwisting, TheBriefingOfATwistShowsItsTargetAndNoTissueTime) {
  TrainingCentre centre;
  Station station(centre);
  station.desk().moduleId = centre.module("first");

  station.open(PageId::kBriefing);

  const QString text = station.allText();
  EXPECT_TRUE(text.contains(QStringLiteral("Twist to 90° and release within 5°."))) << text.toStdString();
  EXPECT_FALSE(text.contains(QStringLiteral("of the tissue")));
}

TEST(StationOfAnUntwisting, TheDebriefSwitchesBetweenATwistAndAnUntwisting) {
  TrainingCentre centre(loopOfSmallBowel());
  const TrialId twisted = centre.attempt("first", "practice", 1.0);
  const TrialId undone = undoneRun(centre);
  Station station(centre);
  const auto shows = [&station](const char* name) {
    return station.find<QWidget>(name)->isVisibleTo(station.page.get());
  };

  station.open(PageId::kDebrief, toQString(undone));
  const Debrief told = static_cast<DebriefPage&>(*station.page).debrief();
  const bool untwistingFirst = shows("untwisting");
  const bool plotFirst = shows("plot");
  station.page->enter(toQString(twisted));
  station.shell().waitForJobs();

  EXPECT_TRUE(untwistingFirst);
  EXPECT_FALSE(plotFirst);
  EXPECT_FALSE(shows("untwisting"));
  EXPECT_TRUE(shows("plot"));
  ASSERT_TRUE(told.detorsion);
  EXPECT_TRUE(told.detorsion->mishapsKnown);
  EXPECT_FALSE(told.detorsion->events.empty());
  EXPECT_TRUE(told.expert.empty());
}

TrainingCentre::Setup untwistings() {
  TrainingCentre::Setup setup;
  setup.sceneId = "testis";
  setup.patternId = "detorse";
  setup.mastery = {{.metric = "detorse.done", .threshold = 1.0, .unit = "1"},
                   {.metric = "detorse.dose", .comparison = "at_most", .threshold = 0.9, .unit = "1"},
                   {.metric = "detorse.relapse", .comparison = "at_most", .threshold = 0.0, .unit = "1"}};
  return setup;
}

TEST(UntwistingPages, TheTrendShowsTheQuantitiesOfAnUntwisting) {
  TrainingCentre centre(untwistings());
  centre.untwist("first", "practice");
  centre.untwist("first", "practice", 1);
  Station station(centre);

  station.open(PageId::kTrend, QString::fromStdString(centre.module("first")));
  auto& page = static_cast<TrendPage&>(*station.page);
  const auto* table = page.findChild<DataTable*>();
  ASSERT_NE(table, nullptr);

  EXPECT_TRUE(table->asText().contains(QStringLiteral("Ischaemic dose")));
  EXPECT_TRUE(table->asText().contains(QStringLiteral("Not passed")));
  EXPECT_FALSE(table->asText().contains(QStringLiteral("not measured")));
  for (const QComboBox* box : page.findChildren<QComboBox*>()) {
    EXPECT_LT(box->findText(QStringLiteral("Twists on target")), 0);
  }
  page.chooseQuantity(Quantity::kUntwisted);
  EXPECT_TRUE(table->asText().contains(QStringLiteral("yes")));
  EXPECT_TRUE(station.allText().contains(QStringLiteral("Not reached")));
  EXPECT_TRUE(station.allText().contains(QStringLiteral("A yes or no has no learning curve.")));
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
}

TEST(UntwistingPages, TheNextStepShowsAYesOrNoRuleInWords) {
  TrainingCentre centre(untwistings());
  centre.untwist("first", "practice", 1);
  Station station(centre);

  station.open(PageId::kNextStep);
  const QString all = station.allText();

  EXPECT_TRUE(all.contains(QStringLiteral("Untwisted: yes"))) << all.toStdString();
  EXPECT_TRUE(all.contains(QStringLiteral("Relapse: no"))) << all.toStdString();
  EXPECT_TRUE(all.contains(QStringLiteral("Last time: not untwisted, ischaemic dose"))) << all.toStdString();
  EXPECT_FALSE(all.contains(QStringLiteral("Twists on target"))) << all.toStdString();
}

TEST(DetorsionCard, ListsTheTimeSpentLongestFirst) {
  DetorsionStory story;
  story.spent_s = {2.0, 6.0, 0.0, 0.0, 2.0};  // searching, turning, clip, checking, waiting: 10 s in total

  const QStringList text = DetorsionCard::secondsText(story);

  ASSERT_EQ(text.size(), 3);
  EXPECT_EQ(text[0], QStringLiteral("Turning in the jaw: 0:06.0 (60 %)"));
  EXPECT_EQ(text[1], QStringLiteral("Searching, not holding: 0:02.0 (20 %)"));
  EXPECT_EQ(text[2], QStringLiteral("Waiting with hands off: 0:02.0 (20 %)"));
}

/// Ten seconds in which an organ is untwisted; its content has a pressure of 12 mmHg.
DetorsionStory tenSeconds() {
  DetorsionStory story;
  for (int i = 0; i <= 10; ++i) {
    story.time_s.push_back(i);
    story.angle_rad.push_back(3.0 - 0.3 * i);
    story.flow.push_back(0.1 * i);
    story.dose.push_back(0.02 * i);
    story.pressure_Pa.push_back(12.0 * kPascalsPerMmHg);
  }
  story.mishapsKnown = true;
  return story;
}

/// The plot of a story, wide enough for every symbol.
class PlotOf {
 public:
  explicit PlotOf(const DetorsionStory& story) {
    plot.resize(1000, 420);
    plot.setStory(story);
  }
  [[nodiscard]] QString painted() { return paintedWordsOf(plot).join(QLatin1Char(' ')); }

  DetorsionPlot plot;
};

TEST(DetorsionPlot, MarksMishapsWithTheirOwnSymbolAndALegend) {
  DetorsionStory story = tenSeconds();
  story.events = {{1.0, DetorsionMoment::kGrip},
                  {2.0, DetorsionMoment::kBruise},
                  {2.0, DetorsionMoment::kTear},
                  {5.0, DetorsionMoment::kSlip},
                  {5.5, DetorsionMoment::kRelapse}};
  PlotOf drawn(story);

  const QString painted = drawn.painted();

  for (const DetorsionMoment what : {DetorsionMoment::kBruise, DetorsionMoment::kTear, DetorsionMoment::kSlip,
                                     DetorsionMoment::kRelapse}) {
    // On the time line and in the legend.
    EXPECT_GE(painted.count(DetorsionPlot::momentSign(what)), 2) << static_cast<int>(what);
    EXPECT_TRUE(painted.contains(DetorsionPlot::momentName(what))) << static_cast<int>(what);
  }
  EXPECT_FALSE(painted.contains(QStringLiteral("gas out")));
}

/// Counts the pixels of `colour` in a picture below `top`.
int pixelsOf(const QImage& picture, const QColor& colour, int top) {
  int found = 0;
  for (int y = top; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      found += picture.pixelColor(x, y) == colour ? 1 : 0;
    }
  }
  return found;
}

TEST(DetorsionPlot, SymbolsInTheLegendHaveTheColoursOfTheTimeLine) {
  DetorsionStory story = tenSeconds();
  const QColor caution = theme(ThemeKind::kLight).caution;
  story.events = {{1.0, DetorsionMoment::kGrip}};
  constexpr int kBelowLanes = 420 - 34;
  EXPECT_EQ(pixelsOf(PlotOf(story).plot.grab().toImage(), caution, kBelowLanes), 0);

  story.events.push_back({2.0, DetorsionMoment::kBruise});
  EXPECT_GT(pixelsOf(PlotOf(story).plot.grab().toImage(), caution, kBelowLanes), 5);
}

TEST(DetorsionPlot, UsesADifferentSymbolForEachInstant) {
  std::set<QString> signs;
  std::set<QString> names;
  for (int what = 0; what <= static_cast<int>(DetorsionMoment::kRelapse); ++what) {
    signs.insert(DetorsionPlot::momentSign(static_cast<DetorsionMoment>(what)));
    names.insert(DetorsionPlot::momentName(static_cast<DetorsionMoment>(what)));
  }

  EXPECT_EQ(signs.size(), 11U);
  EXPECT_EQ(names.size(), 11U);
  EXPECT_EQ(signs.count(QString()) + names.count(QString()), 0U);
}

TEST(DetorsionPlot, ShowsTheInstantAtThePointerWithBothTimes) {
  DetorsionStory story = tenSeconds();
  story.events = {{5.0, DetorsionMoment::kTear}};
  PlotOf drawn(story);

  // The time axis starts 52 pixels from the left and ends 16 from the right: 5 of 10 s are at 52 + 932 / 2.
  const QString there = drawn.plot.tipAt(518.0);
  const QString beside = drawn.plot.tipAt(530.0);

  EXPECT_EQ(there, QStringLiteral("tear at 0:05.0 (0:05 h of the tissue)"));
  EXPECT_TRUE(beside.isEmpty());
  EXPECT_TRUE(drawn.plot.accessibleDescription().contains(there));
}

TEST(DetorsionPlot, HasNeitherSymbolsNorLegendForARunWithoutInstants) {
  PlotOf drawn(tenSeconds());

  const QString painted = drawn.painted();

  for (int what = 0; what <= static_cast<int>(DetorsionMoment::kRelapse); ++what) {
    EXPECT_FALSE(painted.contains(DetorsionPlot::momentName(static_cast<DetorsionMoment>(what)))) << what;
  }
  EXPECT_FALSE(painted.contains(DetorsionPlot::momentSign(DetorsionMoment::kBruise)));
}

TEST(DetorsionPlot, DrawsThePressureOfAnOrganWhoseContentHasOne) {
  DetorsionStory solid = tenSeconds();
  solid.pressure_Pa.assign(solid.pressure_Pa.size(), 0.0);
  PlotOf hollow(tenSeconds());
  PlotOf cord(solid);

  EXPECT_TRUE(hollow.painted().contains(QStringLiteral("Pressure of the content in mmHg")));
  EXPECT_TRUE(hollow.painted().contains(QStringLiteral("15")));  // 12 mmHg on a scale with steps of 5
  EXPECT_TRUE(
      hollow.plot.accessibleDescription().contains(QStringLiteral("Pressure from 12.0 to 12.0 mmHg.")));
  EXPECT_FALSE(cord.painted().contains(QStringLiteral("Pressure")));
  EXPECT_FALSE(cord.plot.accessibleDescription().contains(QStringLiteral("Pressure")));
}

TEST(DetorsionCard, ShowsTheFindingsOfTheStoryInTheirWords) {
  DetorsionStory story = tenSeconds();
  story.events = {{1.0, DetorsionMoment::kBruise}};

  const QStringList text = DetorsionCard::findings(story);

  ASSERT_EQ(static_cast<std::size_t>(text.size()), findingsOf(story).size());
  EXPECT_TRUE(text.join(QLatin1Char('\n')).contains(QStringLiteral("Bruises from the jaw: 1.")));
}

}  // namespace

}  // namespace torsio::gui
