// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of other equipment: the same motion from each layout, errors with lines, no partial imports.
#include "app/connectors/foreign/foreign_import.h"

#include <cstdlib>
#include <functional>
#include <sstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/connectors/foreign/foreign_motion.h"
#include "app/outputs/dataset/cohort_exchange.h"
#include "app/outputs/dataset/trajectory.h"
#include "assessment/attempt/foreign_measures.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/results/cohort_report.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/foreign_recording.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "sim/scene/scene.h"
#include "tests/app/connectors/foreign/foreign_samples.h"
#include "tests/app/outputs/dataset/foreign_readers.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using ::testing::HasSubstr;
using testing::OwnFolder;

std::vector<ForeignPose> posesOf(const fs::path& map, ForeignLayout layout) {
  const ForeignMap read = readForeignMap(map, layout);
  std::vector<ForeignPose> poses;
  readForeignMotion(read, layout, read.recordings.front(),
                    [&](const ForeignPose& pose, std::size_t) { poses.push_back(pose); });
  return poses;
}

/// Returns the error for a study with a changed map or first recording.
std::string refusalOf(StudyCentre& centre, const std::string& layout,
                      const std::function<void(ordered_json& map, std::string& text)>& spoil) {
  const OwnFolder own;
  const fs::path map = writeForeignStudy(own.path(), layout);
  ordered_json content = ordered_json::parse(readFile(map));
  std::string text = readFile(own.path() / "S_B1.txt");
  spoil(content, text);
  writeFileAtomically(map, content.dump());
  writeFileAtomically(own.path() / "S_C2.txt", text);  // the last one: everything before it is valid
  try {
    importForeign(centre.as("administrator"), foreignLayout(layout), map, "");
  } catch (const Error& error) {
    return error.happened() + " | " + error.where();
  }
  return "imported";
}

std::string replacedOnce(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// Returns where line `number` (from 1) begins.
std::size_t lineAt(const std::string& text, std::size_t number) {
  std::size_t begin = 0;
  for (std::size_t i = 1; i < number; ++i) {
    begin = text.find('\n', begin) + 1;
  }
  return begin;
}

/// Replaces line `number` (from 1).
void spoilLine(std::string& text, std::size_t number, const std::string& line) {
  const std::size_t begin = lineAt(text, number);
  text.replace(begin, text.find('\n', begin) - begin, line);
}

TEST(ForeignMotion, IsTheSameFromEachLayout) {
  for (const char* layout : {"jigsaws", "rosma", "perktutor", "csv"}) {
    const OwnFolder own;
    const fs::path map = writeForeignStudy(own.path(), layout);
    const std::vector<ForeignPose> poses = posesOf(map, foreignLayout(layout));
    ASSERT_EQ(poses.size(), kForeignLines) << layout;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const Pose expected = foreignPose(i);
      ASSERT_EQ(poses[i].time_us, static_cast<std::int64_t>(20'000 * i)) << layout;
      ASSERT_NEAR(norm(poses[i].pose.position_m - expected.position_m), 0.0, 1e-12) << layout << i;
      const Quat& q = poses[i].pose.orientation;
      const Quat& e = expected.orientation;
      ASSERT_NEAR(std::abs(q.w * e.w + q.x * e.x + q.y * e.y + q.z * e.z), 1.0, 1e-12) << layout << i;
      ASSERT_GE(q.z * e.z, 0.0) << layout << i;  // the same rotation, not its inverse
      const bool jaw = std::string(layout) != "perktutor";
      ASSERT_NEAR(poses[i].grip, jaw ? foreignJaw(i) : 0.0, 1e-12) << layout << i;
    }
  }
}

TEST(ForeignMotion, RotatesTheOtherWayIfTheOtherFormIsNamed) {
  const OwnFolder own;
  const fs::path map = writeForeignStudy(own.path(), "jigsaws");
  const std::vector<ForeignPose> rows = posesOf(map, ForeignLayout::kJigsaws);
  writeFileAtomically(map, replacedOnce(readFile(map), "matrix rows", "matrix columns"));
  const std::vector<ForeignPose> columns = posesOf(map, ForeignLayout::kJigsaws);
  EXPECT_NEAR(rows.back().pose.orientation.z, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(columns.back().pose.orientation.z * columns.back().pose.orientation.w, -0.5, 1e-12);
}

/// Each arm's numbers in ROSMA are "nan" or empty until its topic publishes.
TEST(ForeignMotion, SkipsLinesWithoutAPoseIfTheMapAllowsIt) {
  const OwnFolder own;
  const fs::path map = writeForeignStudy(own.path(), "rosma");
  for (const auto& entry : fs::directory_iterator(own.path())) {
    if (entry.path().extension() != ".txt" && entry.path().extension() != ".csv") {
      continue;
    }
    std::string text = readFile(entry.path());
    const auto columns = std::count(text.begin(), text.begin() + static_cast<long>(text.find('\n')), ',');
    std::string empty;
    for (long i = 0; i < columns; ++i) {
      empty += i % 2 == 0 ? "nan, " : ", ";
    }
    spoilLine(text, 2, empty);
    spoilLine(text, 100, empty + "NaN");
    writeFileAtomically(entry.path(), text);
  }
  EXPECT_THROW(posesOf(map, ForeignLayout::kRosma), Error);

  writeFileAtomically(map, replacedOnce(readFile(map), "\"frame\"", "\"gaps\": \"leave out\", \"frame\""));
  const std::vector<ForeignPose> poses = posesOf(map, ForeignLayout::kRosma);

  ASSERT_EQ(poses.size(), kForeignLines - 2);
  EXPECT_EQ(poses.front().place, 1);
  EXPECT_EQ(poses.front().time_us, 20'000);
  EXPECT_EQ(poses[97].place, 99);  // the 98th pose is missing
  EXPECT_NEAR(norm(poses[97].pose.position_m - foreignPose(99).position_m), 0.0, 1e-12);
}

TEST(ForeignImport, IsStoredAsACohortWithRecordingsAndMarks) {
  StudyCentre centre;
  const OwnFolder own;
  const fs::path map = writeForeignStudy(own.path(), "jigsaws", true);
  const ForeignOutcome done =
      importForeign(centre.as("administrator"), ForeignLayout::kJigsaws, map, "to compare");
  EXPECT_EQ(done.trials, 4U);
  EXPECT_EQ(done.samples, static_cast<std::int64_t>(4 * kForeignLines));
  EXPECT_EQ(done.marks, 8U);
  EXPECT_EQ(done.landed.codes.at("B"), "T-01");
  EXPECT_EQ(done.landed.codes.at("GRS 2"), "R-02");
  const AuditEntry entry = AuditRepository(centre.connection()).entries({.limit = 1}).at(0);
  EXPECT_EQ(entry.action, "trial.import");
  EXPECT_EQ(entry.reason, "to compare");
  EXPECT_THAT(entry.newJson, HasSubstr(done.contentHash));

  TrialRepository trials(centre.connection());
  const std::vector<TrialId> ids = StudyRepository(centre.connection()).trialIds(done.landed.cohortId);
  ASSERT_EQ(ids.size(), 4U);
  const Trial trial = trials.load(ids.front());
  EXPECT_TRUE(isForeign(trial.header.sceneId));
  EXPECT_EQ(trial.header.patternId.text(), "suturing");
  EXPECT_EQ(trial.header.deviceModel, "JIGSAWS, slave right");
  EXPECT_EQ(trial.header.tickPeriod_us, 20'000);
  EXPECT_EQ(trial.header.startedUtc_us, 1'583'055'000'000'000);  // 2020-03-01 09:30
  EXPECT_THAT(trial.header.parametersJson, HasSubstr("base of the robot"));
  EXPECT_NO_THROW(verifyContent(trial));
  const std::vector<Sample> samples = decodeTrial(trial);
  ASSERT_EQ(samples.size(), kForeignLines);
  EXPECT_NEAR(toolState(samples[100].device).pose.position_m.x, foreignPose(100).position_m.x,
              kPositionStep_m);
  EXPECT_TRUE(verifyAuditTrail(centre.connection()).empty());
  EXPECT_THAT(testing::refusal([&] { (void)sceneRequestFor(trial.header.parametersJson); }).happened(),
              HasSubstr("other equipment made this recording"));
}

TEST(ForeignImport, IsSupportedByMetricsReportAndTables) {
  StudyCentre centre;
  const OwnFolder own;
  const fs::path map = writeForeignStudy(own.path(), "csv", true);
  // One more person per group, with equal marks.
  ordered_json content = ordered_json::parse(readFile(map));
  std::string marks = readFile(own.path() / "marks.csv");
  for (const auto& [person, other] : {std::pair("B", "D"), std::pair("C", "E")}) {
    content["people"].push_back({{"name", other}, {"group", *person == 'B' ? "N" : "E"}});
    for (const char* trial : {"1", "2"}) {
      const std::string name = "S_" + std::string(other) + trial + ".txt";
      ordered_json recording = content["recordings"][(*person == 'B' ? 0 : 2) + (*trial - '1')];
      fs::copy_file(own.path() / recording["file"].get<std::string>(), own.path() / name);
      recording["file"] = name;
      recording["person"] = other;
      content["recordings"].push_back(recording);
      const std::string score = *trial == '1' ? "21" : *person == 'B' ? "25" : "28";
      marks += name + ",GRS 1," + score + "\n" + name + ",GRS 2," + score + "\n";
    }
  }
  std::string torn = readFile(own.path() / "S_E2.txt");  // three poses of the last run are missing
  for (int i = 0; i < 3; ++i) {
    const std::size_t from = lineAt(torn, 100);
    torn.erase(from, torn.find('\n', from) + 1 - from);
  }
  writeFileAtomically(own.path() / "S_E2.txt", torn);
  writeFileAtomically(own.path() / "marks.csv", marks);
  writeFileAtomically(map, content.dump());
  const ForeignOutcome done = importForeign(centre.as("administrator"), ForeignLayout::kCsv, map, "");
  TrialDigests digests(centre.assets());
  const ExchangeData data =
      exchangeData(centre.as("statistician"), {.cohortId = done.landed.cohortId}, digests);

  ASSERT_EQ(data.inputs.trials.size(), 8U);
  double torns = 0.0;
  for (const TrialSummaryRow& trial : data.inputs.trials) {
    EXPECT_EQ(trial.model, kForeignModel);
    EXPECT_NEAR(trial.detorsion.at("time.total"), 4.0, 1e-9);
    const double lost_s = trial.detorsion.at("view.lost");
    torns += trial.detorsion.at("view.times_lost");
    EXPECT_NEAR(lost_s, 0.08 * trial.detorsion.at("view.times_lost"), 1e-9);
    EXPECT_NEAR(trial.detorsion.at("tip.path"), 0.2 - 0.05 * lost_s, 1e-4) << "does not jump over a gap";
    EXPECT_EQ(trial.detorsion.at("tip.idle"), 0.0);
    EXPECT_EQ(trial.detorsion.size(), 6U);
    EXPECT_FALSE(trial.peakForce_N);
  }
  EXPECT_EQ(torns, 1.0);
  // B has 12 and 13 at trial 1, 13 and 14 at trial 2; C has nine more.
  ASSERT_EQ(data.inputs.occasions.size(), 2U);
  std::vector<double> scores;
  for (const TraineeScore& score : data.inputs.scores) {
    scores.push_back(score.score);
  }
  EXPECT_THAT(scores, ::testing::UnorderedElementsAre(12.5, 13.5, 21.5, 22.5, 21.0, 25.0, 21.0, 28.0));
  EXPECT_EQ(data.inputs.trainingMarks.size(), 16U);
  EXPECT_FALSE(data.set.comparison.rows.empty());
  EXPECT_FALSE(data.set.agreement.rows.empty());
  const ExportTable& trials = data.set.trials;
  std::size_t motion = 0;
  for (std::size_t c = 0; c < trials.columns.size(); ++c) {
    const std::string& name = trials.columns[c].name;
    const bool empty = std::holds_alternative<std::monostate>(trials.rows.at(0)[c]);
    motion += name == "tip_path" && !empty ? 1 : 0;
    EXPECT_TRUE(empty || (name.find("peak") == std::string::npos && name.find("twist") == std::string::npos))
        << name;
  }
  EXPECT_EQ(motion, 1U);

  std::size_t tables = 0;
  for (const ReportSection& section : cohortReport(data.inputs).sections) {
    for (const ReportTable& table : section.tables) {
      EXPECT_NE(table.id, "table-untwistings");
      if (table.id == "table-foreign") {
        ++tables;
        ASSERT_EQ(table.rows.size(), 4U);    // two groups, two trials
        EXPECT_EQ(table.rows[0][4], "200");  // mm
        EXPECT_EQ(table.rows[0][6], "0");
        EXPECT_EQ(table.rows[3][4], "198");  // of 200 and 196
        EXPECT_EQ(table.rows[3][6], "1");    // runs, seconds, share of 8 s
        EXPECT_EQ(table.rows[3][7], "0.08");
        EXPECT_EQ(table.rows[3][8], "1.0");
      }
      tables += table.id == "table-foreign-learning" ? 1 : 0;
    }
  }
  EXPECT_EQ(tables, 2U);

  const Trial trial = TrialRepository(centre.connection())
                          .load(StudyRepository(centre.connection()).trialIds(done.landed.cohortId).front());
  const Outcome<TrialMetrics> metrics = measureForeign(trial.header, decodeTrial(trial));
  ASSERT_TRUE(metrics);
  for (const Quantity quantity : {Quantity::kPeakForce, Quantity::kMeanTorque, Quantity::kAngularPath,
                                  Quantity::kWorkDelivered, Quantity::kSparc}) {
    EXPECT_EQ(metrics->at(quantity).reason(), "not applicable: foreign recording") << idOf(quantity);
  }
  std::ostringstream out;
  EXPECT_EQ(writeTrajectory(trial, 1, TrajectoryForm::kCsv, out), static_cast<std::int64_t>(kForeignLines));
  const std::string text = out.str();
  EXPECT_THAT(text.substr(text.find('\n') + 1, text.find('\n', 900)), HasSubstr(",,,,,,,,,,,"));
}

TEST(ForeignImport, ReadsTheGlobalRatingOfJigsaws) {
  StudyCentre centre;
  const OwnFolder own;
  const fs::path map = writeForeignStudy(own.path(), "jigsaws");
  writeFileAtomically(own.path() / "meta.txt",
                      "S_B1\tN\t\t15\t3 2 3 2 2 3\n\nS_B2 N 16\nS_C1 E 24\nS_D1 E 29\nS_C2 E 25\n");
  ordered_json content = ordered_json::parse(readFile(map));
  content["raters"] = {{{"name", "GRS"}, {"class", "chief"}}};
  content["marks"] = {
      {"meta_file", "meta.txt"}, {"rater", "GRS"}, {"lowest", 6}, {"highest", 30}, {"steps_per_point", 1}};
  writeFileAtomically(map, content.dump());
  const ForeignMap read = readForeignMap(map, ForeignLayout::kJigsaws);
  ASSERT_EQ(read.marks.size(), 4U);
  EXPECT_EQ(read.marks[0].steps, 15);
  EXPECT_EQ(read.marks[3].recording, "S_C2.txt");
  writeFileAtomically(own.path() / "meta.txt", "S_B1 N 15\nS_B2 N 31\n");
  EXPECT_THAT(testing::refusal([&] { (void)readForeignMap(map, ForeignLayout::kJigsaws); }).where(),
              HasSubstr("meta.txt, line 2"))
      << "31 is beyond the scale";
}

/// Published sets may not be distributed: TORSIO_PUBLISHED_SETS names a folder with one folder per layout,
/// containing files as published and a map (*.json) for each recording.
TEST(ForeignImport, ReadsPublishedSetsIfAvailable) {
  const char* sets = std::getenv("TORSIO_PUBLISHED_SETS");
  if (sets == nullptr) {
    GTEST_SKIP() << "TORSIO_PUBLISHED_SETS names no folder";
  }
  StudyCentre centre;
  int maps = 0;
  for (const char* layout : {"jigsaws", "rosma", "perktutor", "csv"}) {
    const fs::path folder = fs::path(sets) / layout;
    if (!fs::exists(folder)) {
      continue;
    }
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".json") {
        const ForeignOutcome done =
            importForeign(centre.as("administrator"), foreignLayout(layout), entry.path(), "");
        EXPECT_GE(done.trials, 1) << entry.path();
        ++maps;
      }
    }
  }
  EXPECT_GT(maps, 0);
}

TEST(ForeignImport, ReportsErrorsByLineAndStoresNothing) {
  StudyCentre centre;
  (void)centre.as("administrator");
  const auto before = centre.rowCounts();
  using Spoil = std::function<void(ordered_json&, std::string&)>;
  struct Case {
    const char* layout;
    const char* said;
    Spoil spoil;
  };
  const std::vector<Case> cases = {
      {"jigsaws", "not 76 | S_C2.txt, line 7", [](auto&, auto& text) { spoilLine(text, 7, "1 2 3"); }},
      {"jigsaws", "'nan' is not a number | S_C2.txt, line 3, column 1",
       [](auto&, auto& text) { spoilLine(text, 3, "nan 2 3"); }},
      {"jigsaws", "no instrument 'left'", [](auto& map, auto&) { map["instrument"] = "left"; }},
      {"jigsaws", "these files have no time",
       [](auto& map, auto&) {
         map.erase("rate_Hz");
         map["time"] = {{"column", "t"}, {"unit", "s"}};
       }},
      {"rosma", "quaternions, x y z w", [](auto& map, auto&) { map["rotation"] = "quaternion wxyz"; }},
      {"rosma", "PSM3 has not one column", [](auto& map, auto&) { map["instrument"] = "PSM3"; }},
      {"rosma", "the line has 1 value and the header 10 | S_C2.txt, line 5",
       [](auto&, auto& text) { spoilLine(text, 5, "0.1"); }},
      {"perktutor", "fewer than two lines", [](auto& map, auto&) { map["instrument"] = "Nothing"; }},
      {"perktutor", "the time does not rise | S_C2.txt, line 4",
       [](auto&, auto& text) { spoilLine(text, 4, text.substr(text.find("  <log"), text.find("/>") - 20)); }},
      {"csv", "not a rotation | S_C2.txt, line 3",
       [](auto&, auto& text) { spoilLine(text, 3, "520,0,0,0,1,1,0,0,0.1\r"); }},
      {"csv", "not a rotation | S_C2.txt, line 2",
       [](auto& map, auto& text) {
         map["rotation"] = "quaternion xyzw";
         spoilLine(text, 2, "500,0,0,0,0.5,0,0,0,0.1\r");
       }},
      {"csv", "the time does not rise | S_C2.txt, line 9",
       [](auto&, auto& text) { spoilLine(text, 9, "500,0,0,0,1,0,0,0,0.1\r"); }},
      {"csv", "'1;5' is not a number",
       [](auto&, auto& text) { spoilLine(text, 3, "520,0,0,0,1,0,0,0,1;5\r"); }},
      {"csv", "more than 200 m away | S_C2.txt, line 4",
       [](auto&, auto& text) { spoilLine(text, 4, "540,300,0,0,1,0,0,0,0.1\r"); }},
      {"csv", "there must be exactly one column 'px'", [](auto& map, auto&) { map["position"][0] = "px"; }},
      {"csv", "the map must say this | map.json, \"frame\"", [](auto& map, auto&) { map.erase("frame"); }},
      {"csv", "the map must say this | map.json, \"unit\"", [](auto& map, auto&) { map.erase("unit"); }},
      {"csv", "must be one of: m, cm, mm", [](auto& map, auto&) { map["unit"] = "inch"; }},
      {"csv", "no hand does that", [](auto& map, auto&) { map["unit"] = "mm"; }},
      {"perktutor", "more than 200 m away", [](auto& map, auto&) { map["unit"] = "m"; }},
      {"csv", "the poses would be 20 s apart", [](auto& map, auto&) { map["time"]["unit"] = "s"; }},
      {"csv", "the poses would be 2e-05 s apart", [](auto& map, auto&) { map["time"]["unit"] = "us"; }},
      {"csv", "neither true nor false", [](auto& map, auto&) { map["unit_confirmed"] = "yes"; }},
      {"csv", "an unknown field | map.json, \"rate_hz\"", [](auto& map, auto&) { map["rate_hz"] = 30; }},
      {"csv", "lists no person 'Z' | map.json, \"recordings\" 2, \"person\"",
       [](auto& map, auto&) { map["recordings"][1]["person"] = "Z"; }},
      {"csv", "not a valid time",
       [](auto& map, auto&) { map["recordings"][0]["started"] = "2020-02-30T00:00:00Z"; }},
      {"csv", "no such file", [](auto& map, auto&) { map["recordings"][3]["file"] = "S_C9.txt"; }},
  };
  for (const Case& one : cases) {
    EXPECT_THAT(refusalOf(centre, one.layout, one.spoil), HasSubstr(one.said)) << one.layout;
  }
  EXPECT_EQ(centre.rowCounts(), before);
}

TEST(ForeignImport, AConfirmedUnitIsRecorded) {
  StudyCentre centre;
  const OwnFolder own;
  const fs::path map = writeForeignStudy(own.path(), "csv");
  ordered_json content = ordered_json::parse(readFile(map));
  content["unit"] = "mm";
  content["unit_confirmed"] = true;
  writeFileAtomically(map, content.dump());
  const ForeignOutcome outcome = importForeign(centre.as("administrator"), ForeignLayout::kCsv, map, "");
  Statement rows = centre.session().connectionWithoutRight().prepare("SELECT parameters_json FROM trial");
  rows.execute();
  ASSERT_TRUE(rows.step());
  const std::string parameters = rows.text(0);
  EXPECT_THAT(parameters, HasSubstr("\"unit_confirmed\":true"));
  const std::vector<Text> told = recordedConfirmations(parameters);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(told.front().str(), HasSubstr("unit of the positions"));
  const std::vector<std::string> warned =
      TrialRepository(centre.session().connectionWithoutRight()).warnedParameters(outcome.landed.cohortId);
  EXPECT_FALSE(warned.empty());
}

TEST(ForeignImport, ScoresOnASmallerScaleThanTheMapSaysAreRefusedOrConfirmed) {
  const OwnFolder own;
  const fs::path map = writeForeignStudy(own.path(), "csv", true);
  ordered_json content = ordered_json::parse(readFile(map));
  content["raters"].push_back({{"name", "GRS 3"}, {"class", "chief"}});
  std::string table = "recording,rater,score\n";
  int score = 1;
  for (const auto& recording : content["recordings"]) {
    for (const auto& rater : content["raters"]) {
      table += recording["file"].get<std::string>() + "," + rater["name"].get<std::string>() + "," +
               std::to_string(1 + score++ % 8) + "\n";
    }
  }
  content["marks"]["lowest"] = 0;
  content["marks"]["highest"] = 100;
  writeFileAtomically(own.path() / "marks.csv", table);
  writeFileAtomically(map, content.dump());
  EXPECT_THAT(testing::refusal([&] { return readForeignMap(map, ForeignLayout::kCsv); }).what(),
              HasSubstr("the highest of 12 scores is 8 on a scale from 0 to 100"));
  content["marks"]["scale_confirmed"] = true;
  writeFileAtomically(map, content.dump());
  EXPECT_TRUE(readForeignMap(map, ForeignLayout::kCsv).scaleConfirmed);
}

TEST(ForeignImport, StoresNothingIfCancelledOrRejectedAtTheEnd) {
  StudyCentre centre;
  const OwnFolder own;
  const fs::path map = writeForeignStudy(own.path(), "csv", true);
  (void)centre.as("administrator");
  const auto before = centre.rowCounts();
  const auto givenUp = [](const Progress& progress) {
    if (progress.step.str() == "Storing recording 4 of 4") {
      throw Error(ErrorCode::kUsage, Text::verbatim("given up"), "", "");
    }
  };
  EXPECT_THROW(importForeign(centre.as("administrator"), ForeignLayout::kCsv, map, "", givenUp), Error);
  EXPECT_EQ(centre.rowCounts(), before);
  writeFileAtomically(map, replacedOnce(readFile(map), "\"chief\"", "\"nobody\""));
  EXPECT_THROW(importForeign(centre.as("administrator"), ForeignLayout::kCsv, map, ""), Error);
  EXPECT_EQ(centre.rowCounts(), before);
  EXPECT_THROW(importForeign(centre.as("statistician"), ForeignLayout::kCsv, map, ""), Error);
}

TEST(ForeignImport, RefusesNamesThatLookAlikeAndLabelsThatCannotBeRead) {
  StudyCentre centre;
  const auto before = centre.rowCounts();
  const auto refused = [&](const std::function<void(ordered_json&)>& spoil) {
    return refusalOf(centre, "csv", [&](ordered_json& map, std::string&) { spoil(map); });
  };
  EXPECT_THAT(
      refused([](ordered_json& map) {
        map["people"][1]["name"] = map["people"][0]["name"].get<std::string>() + "\u00A0";
      }),
      ::testing::AllOf(HasSubstr("looks like"), HasSubstr("\"people\" 1"), HasSubstr("\"people\" 2")));
  EXPECT_THAT(refused([](ordered_json& map) { map["groups"][0]["label"] = "one\x1B[2J"; }),
              HasSubstr("invisible character U+001B"));
  EXPECT_THAT(refused([](ordered_json& map) { map["cohort"] = "Spring\u202E"; }),
              HasSubstr("invisible character U+202E"));
  EXPECT_EQ(centre.rowCounts(), before);
}

TEST(ForeignMeasures, AreUndefinedIfTheyWouldBeMisleading) {
  TrialHeader header;
  header.sceneId = std::string(kForeignScene);
  header.tickPeriod_us = 20'000;
  std::vector<Sample> samples(100);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].tick = static_cast<std::int64_t>(i);
    const Pose pose{{1e-4 * static_cast<double>(i), 0.0, 0.0}, {}};
    samples[i].device = quantize({.time_us = static_cast<std::int64_t>(20'000 * i), .pose = pose}, {});
  }
  EXPECT_TRUE(measureForeign(header, samples));
  for (std::size_t i = 50; i < samples.size(); ++i) {
    samples[i].device.time_us += 70'000;
  }
  EXPECT_NEAR(*measureForeign(header, samples)->at(Quantity::kTime), 2.05, 1e-9);
  for (std::size_t i = 50; i < samples.size(); ++i) {
    samples[i].device.time_us += 30'000;
  }
  EXPECT_EQ(measureForeign(header, samples).reason(), "the instrument was seen for 94 % of the time only");
  const QuantityValues lost = foreignAttempt(header, samples).values;
  EXPECT_EQ(lost.size(), 4U);
  EXPECT_EQ(lost.at(Quantity::kTimesUnseen), 1.0);
  EXPECT_NEAR(lost.at(Quantity::kUnseen), 0.12, 1e-9);
  EXPECT_EQ(
      foreignSentences(lost),
      (std::vector<Text>{
          Text::verbatim("The instrument was out of view 1 time, for 0.12 s in all (5.7 % of the time)."),
          Text::verbatim(
              "Path and idle time are not measured: too few poses came, or too much is missing.")}));
  EXPECT_NEAR(foreignAttempt(header, samples).values.at(Quantity::kTime), 2.1, 1e-9);
  header.tickPeriod_us = 66'667;
  EXPECT_EQ(measureForeign(header, samples).reason(), "fewer than 20 samples a second were recorded");
}

/// Trackers that lose an instrument repeat its last pose.
TEST(ForeignMeasures, ARepeatedPoseIsNoIdleHand) {
  TrialHeader header;
  header.sceneId = std::string(kForeignScene);
  header.tickPeriod_us = 20'000;
  const auto recorded = [](std::size_t repeated) {
    std::vector<Sample> samples(1'000);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const std::size_t shown = i >= 500 && i < 500 + repeated ? 500 : i;
      const Pose pose{{1e-6 * static_cast<double>(shown), 0.0, 0.0}, {}};  // slow: idle all the time
      samples[i].tick = static_cast<std::int64_t>(i);
      samples[i].device = quantize({.time_us = static_cast<std::int64_t>(20'000 * i), .pose = pose}, {});
    }
    return samples;
  };
  EXPECT_NEAR(*measureForeign(header, recorded(10))->at(Quantity::kIdleTime), 19.98, 0.01);
  EXPECT_NEAR(*measureForeign(header, recorded(41))->at(Quantity::kIdleTime), 19.98 - 0.82, 0.05);
  const std::vector<Unseen> gaps = unseenStretches(header, recorded(41));
  ASSERT_EQ(gaps.size(), 1U);
  EXPECT_EQ(gaps[0].from_us, 10'000'000);
  EXPECT_EQ(gaps[0].to_us, 10'820'000);
  EXPECT_EQ(foreignSentences(foreignAttempt(header, recorded(10)).values).back(),
            "The instrument was in view all the time.");
  EXPECT_EQ(foreignSentences({}).size(), 1U);
  EXPECT_EQ(measureForeign(header, recorded(101)).reason(),
            "the instrument was seen for 90 % of the time only");
}

}  // namespace
}  // namespace torsio
