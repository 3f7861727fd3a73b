// SPDX-License-Identifier: GPL-3.0-or-later
// The station's pages with a module whose organ comes twisted.

#include <filesystem>

#include <QComboBox>
#include <QWidget>
#include <gtest/gtest.h>

#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/debrief_page.h"
#include "app/gui/trainee/trend_page.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/recording/recorded_run.h"
#include "assessment/catalogue/quantity.h"
#include "db/repository/base/id_source.h"
#include "db/repository/trial/trial_repository.h"
#include "tests/app/gui/support/trainee_station.h"
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
       {"A loop of small bowel is twisted", "The organ came twisted by 180° to 360°. Untwist it.",
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

}  // namespace

namespace {

using torsio::testing::TrainingCentre;

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

}  // namespace

}  // namespace torsio::gui
