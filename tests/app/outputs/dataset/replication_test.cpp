// SPDX-License-Identifier: GPL-3.0-or-later
// A study's numbers are computed again in R, from a folder that Torsio wrote.
#include "app/outputs/dataset/replication.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/outputs/dataset/cohort_exchange.h"
#include "assessment/results/analysed_cohort.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/app/outputs/dataset/foreign_readers.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/demonstration_cohort.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

using testing::hasProgram;
using ::testing::HasSubstr;
using testing::OwnFolder;
using testing::refusalCode;
using testing::StudyCentre;

/// The demonstration's cohort as that of several centres, "C1/..."; two of its trainees recorded twists.
CohortInputs ofCentres(std::size_t centres) {
  CohortInputs in = testing::demonstrationCohort();
  std::map<std::string, std::string> qualified;
  for (std::size_t i = 0; i < in.trainees.size(); ++i) {
    CohortTrainee& trainee = in.trainees[i];
    trainee.site = "C" + std::to_string(1 + i % 10 * centres / 10);
    const std::string code = trainee.site + "/" + trainee.code;
    qualified[std::exchange(trainee.code, code)] = code;
  }
  for (std::size_t s = 1; s <= centres; ++s) {
    in.sites.push_back("C" + std::to_string(s));
  }
  in.trials.resize(2, in.trials.front());
  for (std::size_t i = 0; i < in.trials.size(); ++i) {
    TrialSummaryRow& trial = in.trials[i];
    trial.trialId = "t" + std::to_string(i + 1);
    trial.trainee = in.trainees[i].code;
    trial.attempts = {{12.0 + static_cast<double>(i), false}, {5.0, true}, {4.0, true}, {2.0, true}};
    trial.meanAbsoluteError_deg = (23.0 + static_cast<double>(i)) / 4.0;
    trial.twistsOnTarget = 3;
  }
  for (TrainingMark& mark : in.trainingMarks) {
    mark.trainee = qualified.at(mark.trainee);
  }
  for (auto& mark : in.criterionMarks) {
    mark.trainee = qualified.at(mark.trainee);
  }
  return testing::scored(std::move(in));
}

class Replication : public ::testing::Test {
 protected:
  std::vector<std::string> write(CohortInputs inputs) {
    ExchangeData data{};
    data.request.cohortId = cohort_;
    data.inputs = std::move(inputs);
    data.analysed = analysedCohort(data.inputs);
    std::vector<std::string> names;
    for (const std::filesystem::path& file :
         exportReplication(centre_.as("administrator"), data, folder_).files) {
      names.push_back(file.filename().string());
    }
    return names;
  }
  void change(const char* file, const std::string& from, const std::string& to) {
    std::string text = readFile(folder_ / file);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    writeFileAtomically(folder_ / file, text.replace(at, from.size(), to));
  }

  StudyCentre centre_;
  CohortId cohort_ = centre_.addStudy(2, 2).cohortId;
  OwnFolder place_;
  std::filesystem::path folder_ = place_.path() / "package";
};

TEST_F(Replication, ContainsMarksMeasuresScriptAndHashesOfAllFiles) {
  EXPECT_THAT(write(testing::demonstrationCohort()),
              ::testing::IsSupersetOf({"marks.csv", "evaluation_marks.csv", "measures.csv", "given.csv",
                                       "expected.csv", "validity.csv", "analysis.R", "codebook.csv",
                                       "README.txt", "manifest.csv"}));
  const std::string marks = readFile(folder_ / "marks.csv");
  EXPECT_EQ(std::count(marks.begin(), marks.end(), '\n'), 901);
  EXPECT_THAT(readFile(folder_ / "README.txt"), HasSubstr("Simulated"));
  EXPECT_EQ(centre_.audited("report.export_coded"), 1);
  EXPECT_EQ(refusalCode([&] { write(testing::demonstrationCohort()); }), ErrorCode::kFileUnwritable);
}

TEST_F(Replication, IsRefusedWhileSingleMarksMayNotBeSeen) {
  CohortInputs inputs = testing::demonstrationCohort();
  inputs.singleMarks = false;
  EXPECT_EQ(refusalCode([&] { write(inputs); }), ErrorCode::kBadParameter);
  EXPECT_FALSE(std::filesystem::exists(folder_));
  EXPECT_EQ(refusalCode([&] { (void)checkReplication(place_.path()); }), ErrorCode::kFileMissing);
}

TEST_F(Replication, RFindsTheSameNumbersAndAChangedMarkIsFound) {
  if (!hasProgram("Rscript")) {
    GTEST_SKIP() << "R is not installed";
  }
  write(testing::demonstrationCohort());
  const ReplicationCheck sound = checkReplication(folder_);
  EXPECT_TRUE(sound.same()) << sound.differences.front().str();
  EXPECT_GT(sound.recomputed, 1'000);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "recomputed.csv")) << "it changes nothing";

  std::string text = readFile(folder_ / "marks.csv");
  const std::size_t last = text.find_last_of("0123456789");
  text[last] = text[last] == '5' ? '4' : '5';
  writeFileAtomically(folder_ / "marks.csv", text);
  const ReplicationCheck changed = checkReplication(folder_);
  ASSERT_GT(changed.differences.size(), 3U);
  EXPECT_THAT(changed.differences.front().str(), HasSubstr("marks.csv was changed after it was written"));
  EXPECT_THAT(changed.differences.back().str(), HasSubstr("expected, R found"));
}

TEST_F(Replication, RFindsTheNumbersOfSeveralCentres) {
  if (!hasProgram("Rscript")) {
    GTEST_SKIP() << "R is not installed";
  }
  for (const std::size_t centres : {2U, 5U}) {  // fixed, random
    write(ofCentres(centres));
    const ReplicationCheck check = checkReplication(folder_);
    EXPECT_TRUE(check.same()) << centres << ": " << check.differences.front().str();
    std::filesystem::remove_all(folder_);
  }
}

TEST_F(Replication, FindsAMissingFile) {
  if (!hasProgram("Rscript")) {
    GTEST_SKIP() << "R is not installed";
  }
  write(testing::demonstrationCohort());
  std::filesystem::remove(folder_ / "codebook.csv");
  const ReplicationCheck check = checkReplication(folder_);
  ASSERT_EQ(check.differences.size(), 1U);
  EXPECT_EQ(check.differences.front().str(), "codebook.csv is missing");
}

TEST_F(Replication, NeverRunsAScriptThatCameWithTheFolder) {
  if (!hasProgram("Rscript")) {
    GTEST_SKIP() << "R is not installed";
  }
  write(testing::demonstrationCohort());
  const std::filesystem::path trace = place_.path() / "trace";
  writeFileAtomically(folder_ / "analysis.R", "file.create('" + trace.string() + "')\n");
  const ReplicationCheck check = checkReplication(folder_);
  EXPECT_FALSE(std::filesystem::exists(trace));
  EXPECT_FALSE(check.ownScript);
  EXPECT_GT(check.recomputed, 1'000);
  ASSERT_EQ(check.differences.size(), 1U);
  EXPECT_EQ(check.differences.front().str(), "analysis.R was changed after it was written");
}

TEST_F(Replication, AManifestMustNameEveryFileOnce) {
  write(testing::demonstrationCohort());
  const std::string whole = readFile(folder_ / "manifest.csv");
  writeFileAtomically(folder_ / "manifest.csv", whole + whole.substr(whole.find('\n') + 1));
  EXPECT_EQ(refusalCode([&] { (void)checkReplication(folder_); }), ErrorCode::kBadData);
  std::filesystem::remove(folder_ / "marks.csv");
  std::filesystem::create_symlink("/etc/hostname", folder_ / "marks.csv");
  writeFileAtomically(folder_ / "manifest.csv", whole);
  EXPECT_EQ(refusalCode([&] { (void)checkReplication(folder_); }), ErrorCode::kFileUnreadable);
}

}  // namespace
}  // namespace torsio
