// SPDX-License-Identifier: GPL-3.0-or-later
// The station's pages with a module whose organ comes twisted.
#include <filesystem>

#include <QLabel>
#include <QWidget>
#include <gtest/gtest.h>

#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/debrief_page.h"
#include "app/gui/trainee/debrief_plot.h"
#include "app/gui/trainee/detorsion_card.h"
#include "app/services/recording/recorded_run.h"
#include "db/repository/base/id_source.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/scene/scene_file.h"
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
}  // namespace torsio::gui
