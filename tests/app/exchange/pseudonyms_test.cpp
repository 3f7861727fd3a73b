// SPDX-License-Identifier: GPL-3.0-or-later
// Nobody is found in what is pseudonymised.
#include "app/exchange/pseudonyms.h"

#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/exchange/export_set.h"
#include "app/exchange/table_files.h"
#include "assessment/report/cohort_csv.h"
#include "sim/base/error.h"
#include "sim/base/file_io.h"
#include "sim/base/time_units.h"
#include "tests/app/exchange/foreign_readers.h"

namespace torsio {
namespace {

using testing::awkwardCohort;
using testing::OwnFolder;

const std::string kKey(64, 'k');

struct Hidden {
  CohortInputs before = awkwardCohort();
  std::map<TrialId, std::int64_t> startsBefore;
  std::map<TrialId, std::int64_t> starts;
  PseudonymReport report;
  CohortInputs after;

  explicit Hidden(const std::string& key = kKey, bool withFreeText = false) {
    before.trainees.front().level = "professor";
    std::int64_t start_us = 1'767'600'000'000'000;
    for (const TrialSummaryRow& trial : before.trials) {
      startsBefore[trial.trialId] = start_us;
      start_us += 3'600'000'000;
    }
    starts = startsBefore;
    after = pseudonymised(before, starts, Pseudonyms(key), withFreeText, report);
  }
};

TEST(Pseudonyms, AreTheSameUnderOneKeyAndOthersUnderAnother) {
  const Pseudonyms one(kKey);
  EXPECT_EQ(one.of("P", "T-01"), Pseudonyms(kKey).of("P", "T-01"));
  EXPECT_NE(one.of("P", "T-01"), one.of("P", "T-02"));
  EXPECT_NE(one.of("P", "T-01").substr(2), one.of("R", "T-01").substr(2));
  EXPECT_NE(one.of("P", "T-01"), Pseudonyms(Pseudonyms::freshKey()).of("P", "T-01"));
  EXPECT_NE(Pseudonyms::freshKey(), Pseudonyms::freshKey());
  EXPECT_THROW(Pseudonyms("short"), Error);
}

TEST(Pseudonyms, MoveTimesByWholeDaysOfEachPersonAndNeverByNone) {
  const Pseudonyms names(kKey);
  std::set<std::int64_t> shifts;
  for (int i = 0; i < 1000; ++i) {
    const std::int64_t shift_us = names.shift_us("T-" + std::to_string(i));
    EXPECT_NE(shift_us, 0);
    EXPECT_EQ(shift_us % kDay_us, 0);
    EXPECT_LE(std::abs(shift_us), 182 * kDay_us);
    shifts.insert(shift_us);
  }
  EXPECT_GT(shifts.size(), 300U);

  const Hidden hidden;
  ASSERT_EQ(hidden.after.deviations.size(), 3U);
  std::map<std::string, std::vector<std::int64_t>> times;
  for (const CohortDeviation& one : hidden.after.deviations) {
    times[one.trainee].push_back(one.happenedUtc_us);
  }
  const std::string first = names.of("P", hidden.before.trainees[0].code);
  EXPECT_EQ(times[first].at(1) - times[first].at(0), kDay_us);
}

TEST(Pseudonyms, LeaveNothingOfTheCentreInAnyFile) {
  const Hidden hidden;
  const ExportSet set = exportSet(hidden.after, cohortCsvRows(hidden.after), hidden.starts);
  const OwnFolder folder;
  std::string all;
  for (const TableFormat format : {TableFormat::kCsv, TableFormat::kSpss}) {
    for (const std::filesystem::path& file : writeTables(tablesOf(set), format, folder.path() / "out")) {
      all += readFile(file);
    }
  }
  std::set<std::string> secrets;
  for (const CohortTrainee& trainee : hidden.before.trainees) {
    secrets.insert(trainee.code);
  }
  for (const TrainingMark& mark : hidden.before.trainingMarks) {
    secrets.insert(mark.rater);
  }
  for (const ModelRatings& model : hidden.before.ratings) {
    for (const RaterSheet& sheet : model.sheets) {
      secrets.insert(sheet.rater);
    }
  }
  for (const TrialSummaryRow& trial : hidden.before.trials) {
    secrets.insert(trial.trialId.text());
    if (!trial.contentHash.empty()) {
      secrets.insert(trial.contentHash);
    }
  }
  for (const CohortDeviation& deviation : hidden.before.deviations) {
    secrets.insert(deviation.description);
  }
  secrets.insert("2026-01-05");
  secrets.insert("2026-01-06");
  ASSERT_GT(secrets.size(), 60U);
  for (const std::string& secret : secrets) {
    EXPECT_EQ(all.find(secret), std::string::npos) << secret;
  }
}

TEST(Pseudonyms, KeepEveryNumberAndEveryCount) {
  const Hidden hidden;
  const ExportSet before = exportSet(hidden.before, cohortCsvRows(hidden.before), {});
  const ExportSet after = exportSet(hidden.after, cohortCsvRows(hidden.after), hidden.starts);
  ASSERT_EQ(after.marks.rows.size(), before.marks.rows.size());
  std::multiset<double> marksBefore;
  std::multiset<double> marksAfter;
  for (std::size_t i = 0; i < before.marks.rows.size(); ++i) {
    marksBefore.insert(std::get<double>(before.marks.rows[i][5]));
    marksAfter.insert(std::get<double>(after.marks.rows[i][5]));
  }
  EXPECT_EQ(marksBefore, marksAfter);
  EXPECT_EQ(after.trials.rows.size(), before.trials.rows.size());
  ASSERT_EQ(after.comparison.rows.size(), before.comparison.rows.size());
  std::multiset<std::int64_t> leftBefore;  // of single trainees, who stand in the order of their codes
  std::multiset<std::int64_t> leftAfter;
  const auto rounded = [](double value) { return std::llround(value * 1e6); };
  for (std::size_t i = 0; i < before.comparison.rows.size(); ++i) {
    const auto* value = std::get_if<double>(&before.comparison.rows[i][6]);
    if (value == nullptr) {
      continue;
    }
    const double now = std::get<double>(after.comparison.rows[i][6]);
    if (before.comparison.rows[i][0] == ExportCell("all")) {
      EXPECT_NEAR(now, *value, 1e-9 * (1.0 + std::abs(*value)));
    } else {
      leftBefore.insert(rounded(*value));
      leftAfter.insert(rounded(now));
    }
  }
  EXPECT_EQ(leftBefore, leftAfter);
}

TEST(Pseudonyms, LeaveOutPropertiesThatFewShareAndSayHowFew) {
  Hidden hidden;
  EXPECT_LT(hidden.report.smallestBefore, kSmallestCell);
  EXPECT_GE(hidden.report.smallestAfter, kSmallestCell);
  EXPECT_GT(hidden.report.levelsHidden, 0);
  EXPECT_EQ(hidden.report.textsLeftOut, 3);
  const Hidden told(kKey, true);
  EXPECT_EQ(told.report.textsLeftOut, 0);
  EXPECT_EQ(told.after.deviations.size(), 3U);
}

}  // namespace
}  // namespace torsio
