// SPDX-License-Identifier: GPL-3.0-or-later
// Pages other than the queue: evaluation, calibration, severity, discrepancies, own record, boards.
#include <string>

#include <gtest/gtest.h>

#include "app/services/recording/recorded_run.h"
#include "app/services/review/rater_calibration.h"
#include "db/connection/row_reader.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "tests/app/web/served_desk.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio::web {
namespace {

using nlohmann::json;

TEST(WebPages, AnEvaluationIsScoredAndSubmittedUnderItsLetters) {
  ServedDesk served;
  served.centre.addTwoModels(true);
  WebClient client = served.physician(0);

  const DeskAnswer asked = client.get("/api/evaluation");
  const json form = asked.json().at("forms").at(0);
  ASSERT_EQ(form.at("models").size(), 2U) << asked.body;
  EXPECT_EQ(form.at("models").at(0).at("label"), "M") << "in the own order";
  EXPECT_EQ(form.at("rubric").at("rows").size(), 9U);
  EXPECT_FALSE(form.at("rubric").at("rows").at(0).at("description").get<std::string>().empty());
  for (const char* secret : {"proposed", "finite", "\"PM\"", "\"FEM\"", "campaign"}) {
    EXPECT_EQ(asked.body.find(secret), std::string::npos) << secret;
  }
  const std::string path = "/api/evaluation/" + form.at("form").get<std::string>() + "/M";
  EXPECT_EQ(client.get(path + "/recording").status, 200);
  for (int index = 1; index < 9; ++index) {
    EXPECT_EQ(client.send("PUT", path, {{"index", index}, {"score_steps", 73}}).status, 200);
  }
  EXPECT_EQ(client.send("POST", path + "/submit", json::object()).status, 400) << "one is open";
  EXPECT_EQ(client.send("PUT", path, {{"index", 9}, {"score_steps", 101}}).status, 400);
  const json scored = client.send("PUT", path, {{"index", 9}, {"score_steps", 100}}).json();
  EXPECT_TRUE(scored.at("check").at("watched_too_little"));
  EXPECT_EQ(client.send("POST", path + "/submit", json::object()).status, 400) << "nobody has watched it";
  const auto watch = [&](double speed) {
    return client.send(
        "POST", path + "/viewing",
        {{"played", {{{"from_us", 0}, {"to_us", 600'000}, {"speed", speed}}}}, {"open", true}});
  };
  EXPECT_EQ(watch(3.0).status, 400) << "a speed that the centre does not allow";
  const DeskAnswer watched = watch(1.0);
  ASSERT_EQ(watched.status, 200) << watched.body;
  EXPECT_FALSE(watched.json().at("check").at("watched_too_little")) << watched.body;
  const DeskAnswer sealed = client.send("POST", path + "/submit", json::object());
  ASSERT_EQ(sealed.status, 200) << sealed.body;
  EXPECT_TRUE(sealed.json().at("forms").at(0).at("models").at(0).at("submitted"));
  EXPECT_EQ(client.send("PUT", path, {{"index", 1}, {"score_steps", 10}}).status, 400) << "sealed";

  WebClient other = served.physician(1);
  EXPECT_TRUE(other.get("/api/evaluation").json().at("forms").empty());
  EXPECT_EQ(other.get(path + "/recording").status, 403);
}

TEST(WebPages, CalibrationShowsThePanelsMarkAfterOnesOwn) {
  ServedDesk served;
  addReferenceRuns(*served.centre.administrator(),
                   {{served.centre.trialIds()[0], served.centre.rubricRevisionId(), 6.2, 8, false}});
  WebClient client = served.physician(0);

  const json before = client.get("/api/calibration").json();
  ASSERT_EQ(before.at("runs").size(), 1U);
  EXPECT_TRUE(before.at("runs").at(0).at("panel_points").is_null());
  EXPECT_EQ(client.get("/api/calibration/1/recording").status, 200);
  EXPECT_EQ(client.get("/api/calibration/2/recording").status, 400);
  EXPECT_EQ(client.get("/api/calibration/0x1/recording").status, 400);
  EXPECT_EQ(client.send("PUT", "/api/calibration/1", {{"score_steps", 1000}}).status, 400);

  const DeskAnswer scored = client.send("PUT", "/api/calibration/1", {{"score_steps", 70}});
  ASSERT_EQ(scored.status, 200) << scored.body;
  EXPECT_NEAR(scored.json().at("runs").at(0).at("offset_points").get<double>(), 0.8, 1e-9);
  EXPECT_TRUE(scored.json().at("complete"));
}

/// Submits a physician's first case with the same mark everywhere.
void sealFirst(const ServedDesk& served, int physician, int steps) {
  WebClient client = served.physician(physician);
  const std::string path = "/api/cases/" + firstCase(client);
  (void)client.get(path);
  (void)client.send("POST", path + "/viewing",
                    {{"played", {{{"from_us", 0}, {"to_us", 500'000}, {"speed", 1.0}}}}});
  const DeskAnswer sealed =
      client.send("POST", path + "/submit", {{"sheet", sheetBody(0, steps, steps, steps)}});
  EXPECT_EQ(sealed.status, 200) << sealed.body;
}

TEST(WebPages, DiscrepanciesAndSeverityOpenWhenAllHaveSubmitted) {
  const ServedDesk served({.raters = 2, .trainees = 1, .trial_s = 0.5});
  sealFirst(served, 0, 20);
  WebClient client = served.physician(0);
  EXPECT_TRUE(client.get("/api/discrepancies").json().at("cases").empty());
  EXPECT_TRUE(client.get("/api/severity").json().at("cases").empty());
  sealFirst(served, 1, 80);

  const json apart = client.get("/api/discrepancies").json().at("cases");
  ASSERT_EQ(apart.size(), 1U);
  EXPECT_EQ(apart.at(0).at("rows").back().at("mean"), 8.0);
  EXPECT_TRUE(apart.at(0).at("decision").is_null());
  const json severity = client.get("/api/severity").json();
  EXPECT_EQ(severity.at("difference_points"), -6.0);
  const std::string path = "/api/discrepancies/" + apart.at(0).at("case").get<std::string>();
  EXPECT_EQ(client.send("POST", path + "/third", {{"reason", ""}}).status, 400) << "needs a reason";
  const DeskAnswer kept = client.send("POST", path + "/keep", {{"reason", "the hold was short"}});
  ASSERT_EQ(kept.status, 200) << kept.body;
  EXPECT_EQ(kept.json().at("cases").at(0).at("decision"), "keep");
  WebClient other = served.physician(1);
  EXPECT_EQ(other.send("POST", path + "/keep", {{"reason", "mine"}}).status, 403) << "another one's handle";
}

TEST(WebPages, TraineesReadOnlyTheirOwnRecord) {
  ServedDesk served;
  Connection& connection = served.centre.connection();
  AccessRepository access(connection, PasswordCost::kTest);
  const std::vector<std::string> trainees =
      selectAll(connection, "SELECT person_id FROM trainee ORDER BY person_id", {},
                [](RowReader& row) { return row.text(); });
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string login = "trainee" + std::to_string(i);
    access.addUser({.id = "u-" + login, .login = login, .personId = trainees[i], .roles = {"trainee"}},
                   kWebPassword);
    access.setPassword("u-" + login, access.sealPassword(login, kWebPassword), false);
  }
  WebClient one = served.client();
  WebClient two = served.client();
  ASSERT_TRUE(one.signIn("trainee0", kWebPassword));
  ASSERT_TRUE(two.signIn("trainee1", kWebPassword));

  const json own = one.get("/api/own").json();
  ASSERT_EQ(own.at("runs").size(), 1U) << own.dump();
  const std::string path = "/api/own/runs/" + own.at("runs").at(0).at("run").get<std::string>();
  const DeskAnswer run = one.get(path);
  ASSERT_EQ(run.status, 200) << run.body;
  EXPECT_TRUE(run.json().at("twists").is_array());
  EXPECT_TRUE(run.json().at("verdict").is_null()) << "of no exercise: nobody is held to be able by it";
  const json told = run.json().at("told");
  EXPECT_FALSE(told.at("checks").empty());
  EXPECT_NE(told.at("checks").at(0).at("text"), "");
  EXPECT_EQ(one.get(path + "/recording").status, 200);
  EXPECT_EQ(two.get(path).status, 403);
  EXPECT_EQ(two.get(path + "/recording").status, 403);
  const DeskAnswer transcript = one.get("/api/own/transcript");
  EXPECT_EQ(transcript.status, 200);
  EXPECT_NE(transcript.body.find(own.at("code").get<std::string>()), std::string::npos);
  EXPECT_EQ(one.send("POST", "/api/own/remarks/x/reply", {{"text", "thank you"}}).status, 403);
}

/// Adds a run of the first trainee at the only module of a running curriculum.
void addRunAtAModule(ServedDesk& served) {
  Connection& connection = served.centre.connection();
  const Cohort cohort = StudyRepository(connection).cohorts().front();
  CurriculumVersion version;
  version.id = "version";
  version.curriculumId = "curriculum";
  version.createdUtc_us = cohort.createdUtc_us;
  TrainingModule module;
  module.id = "module";
  module.code = "first";
  module.title = "Quarter turn";
  module.sceneId = "bar";
  module.patternId = "bar";
  module.mode = AttemptMode::kPractice;
  module.tolerance_rad = 0.1;
  version.modules.push_back(module);
  StudyArm arm;  // of the only group
  arm.id = "arm";
  arm.code = "G1";
  arm.label = "virtual";
  version.arms.push_back(arm);
  CurriculumRepository curricula(connection);
  curricula.addCurriculum({version.curriculumId, "Twist basics", "", cohort.createdUtc_us, false});
  curricula.addVersion(version, "office");
  curricula.moveTo(version.id, CurriculumState::kRunning, "office", cohort.createdUtc_us);
  curricula.assign(cohort.id, version.id);
  const Enrolment enrolment = StudyRepository(connection).enrolments(cohort.id).front();
  ScriptedTrial trial;
  trial.recording = {.trialId = "run-at-a-module",
                     .traineeCode = enrolment.traineeCode,
                     .startedUtc_us = cohort.createdUtc_us + 1,
                     .context = {.station = "station-7",
                                 .enrolmentId = enrolment.id,
                                 .moduleId = module.id,
                                 .attemptMode = AttemptMode::kPractice}};
  trial.duration_s = 0.5;
  TrialRepository sink(connection, trial.recording.context);
  recordScriptedTrial(barScene(), trial, sink);
}

TEST(WebPages, PassedAndMasteredAreShownWithTheirErrorRates) {
  ServedDesk served;
  addRunAtAModule(served);
  Connection& connection = served.centre.connection();
  const Cohort cohort = StudyRepository(connection).cohorts().front();
  const Enrolment enrolment = StudyRepository(connection).enrolments(cohort.id).front();
  AccessRepository access(connection, PasswordCost::kTest);
  access.addUser({.id = "u-one", .login = "one", .personId = enrolment.traineeId, .roles = {"trainee"}},
                 kWebPassword);
  access.setPassword("u-one", access.sealPassword("one", kWebPassword), false);
  WebClient client = served.client();
  ASSERT_TRUE(client.signIn("one", kWebPassword));

  const json own = client.get("/api/own").json();
  const json transcript = client.get("/api/own/transcript").json();

  const auto hasRates = [](const json& verdict) {
    return verdict.at("errors").get<std::string>().find(
               "are declared competent within the 80 runs planned") != std::string::npos &&
           verdict.at("chance").get<std::string>().starts_with("About 1 in 41 trainees who fail ");
  };
  ASSERT_EQ(own.at("modules").size(), 1U) << own.dump();
  EXPECT_TRUE(hasRates(own.at("modules")[0].at("verdict")));
  EXPECT_TRUE(hasRates(transcript.at("modules")[0].at("verdict")));
  int atTheModule = 0;
  for (const json& listed : own.at("runs")) {
    const json run = client.get("/api/own/runs/" + listed.at("run").get<std::string>()).json();
    EXPECT_FALSE(run.at("outcome").at("sentence").get<std::string>().empty());
    if (listed.at("title") == "Quarter turn") {
      ++atTheModule;
      EXPECT_TRUE(hasRates(run.at("verdict"))) << run.at("verdict");
    }
  }
  EXPECT_EQ(atTheModule, 1);
}

TEST(WebPages, AdministratorsSeeTheBoardsOfTheDayAndOfMarks) {
  const ServedDesk served({.raters = 2, .trainees = 1, .trial_s = 0.5});
  sealFirst(served, 0, 20);
  WebClient office = served.client();
  ASSERT_TRUE(office.signIn("office", kWebPassword));

  const json cohorts = office.get("/api/cohorts").json();
  ASSERT_EQ(cohorts.at("cohorts").size(), 1U);
  const std::string path = "/api/cohorts/" + cohorts.at("cohorts").at(0).at("cohort").get<std::string>();
  const json board = office.get(path + "/board").json();
  EXPECT_EQ(board.at("rows").size(), 1U);
  EXPECT_EQ(board.at("alerts"), json{"Trainees without a group: 1. Draw them under Allocation."});
  const DeskAnswer scored = office.get(path + "/scored");
  ASSERT_EQ(scored.status, 200) << scored.body;
  EXPECT_EQ(scored.json().at("lines").at(0).at("cells"), (json{"submitted", "open"}));
  WebClient physician = served.physician(0);
  EXPECT_EQ(physician.get(path + "/board").status, 400) << "a handle of somebody else";
}

}  // namespace
}  // namespace torsio::web
