// SPDX-License-Identifier: GPL-3.0-or-later
// Nobody can be identified in pseudonymised data.
#include "app/outputs/tables/pseudonyms.h"

#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/outputs/tables/export_set.h"
#include "app/outputs/tables/table_files.h"
#include "assessment/results/analysed_cohort.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"
#include "tests/app/outputs/dataset/foreign_readers.h"

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

TEST(Pseudonyms, AreTheSameForOneKeyAndDifferForAnother) {
  const Pseudonyms one(kKey);
  EXPECT_EQ(one.of("P", "T-01"), Pseudonyms(kKey).of("P", "T-01"));
  EXPECT_NE(one.of("P", "T-01"), one.of("P", "T-02"));
  EXPECT_NE(one.of("P", "T-01").substr(2), one.of("R", "T-01").substr(2));
  EXPECT_NE(one.of("P", "T-01"), Pseudonyms(Pseudonyms::freshKey()).of("P", "T-01"));
  EXPECT_NE(Pseudonyms::freshKey(), Pseudonyms::freshKey());
  EXPECT_THROW(Pseudonyms("short"), Error);
}

TEST(Pseudonyms, ShiftTimesByWholeDaysForEachPersonAndNeverByZero) {
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
  std::map<std::string, std::set<std::int64_t>> moves;  // of each person's recordings
  for (const TrialSummaryRow& trial : hidden.before.trials) {
    const TrialId opaque(names.of("T", trial.trialId.text()));
    moves[trial.trainee].insert(hidden.starts.at(opaque) - hidden.startsBefore.at(trial.trialId));
  }
  for (const auto& [person, ofPerson] : moves) {
    EXPECT_EQ(ofPerson, std::set<std::int64_t>{names.shift_us(person)}) << person;  // intervals are preserved
  }
}

/// What somebody who knows the centre knows of a person, and what the data contain of one.
struct Trace {
  std::set<std::int64_t> days{};  ///< of recordings and deviations
  std::set<std::string> texts{};
  std::size_t recordings = 0;
  std::size_t marks = 0;
  std::size_t deviations = 0;

  [[nodiscard]] auto counts() const { return std::tuple(recordings, marks, deviations); }
};

std::map<std::string, Trace> tracesIn(const CohortInputs& in, const std::map<TrialId, std::int64_t>& starts) {
  std::map<std::string, Trace> traces;
  for (const CohortTrainee& trainee : in.trainees) {
    traces[trainee.code];
  }
  for (const TrialSummaryRow& trial : in.trials) {
    ++traces[trial.trainee].recordings;
    traces[trial.trainee].days.insert(starts.at(trial.trialId) / kDay_us);
  }
  for (const TrainingMark& mark : in.trainingMarks) {
    ++traces[mark.trainee].marks;
  }
  for (const CohortDeviation& one : in.deviations) {
    if (!one.trainee.empty()) {
      ++traces[one.trainee].deviations;
      traces[one.trainee].days.insert(one.happenedUtc_us / kDay_us);
      traces[one.trainee].texts.insert(one.description);
    }
  }
  return traces;
}

TEST(Pseudonyms, AnAttackByDatesCountsAndTextsIdentifiesNobody) {
  const Hidden hidden;
  const Pseudonyms names(kKey);
  const std::map<std::string, Trace> known = tracesIn(hidden.before, hidden.startsBefore);
  const std::map<std::string, Trace> found = tracesIn(hidden.after, hidden.starts);
  ASSERT_GT(known.at(hidden.before.deviations[0].trainee).deviations, 1U);  // nobody else has two
  for (const auto& [person, trace] : known) {
    std::size_t sameDays = 0;
    std::size_t sameCounts = 0;
    std::size_t sameTexts = 0;
    for (const auto& [opaque, other] : found) {
      sameDays += !trace.days.empty() && other.days == trace.days ? 1 : 0;
      sameCounts += other.counts() == trace.counts() ? 1 : 0;
      for (const std::string& text : trace.texts) {
        sameTexts += other.texts.contains(text) ? 1 : 0;
      }
    }
    EXPECT_EQ(sameDays, 0U) << person;
    EXPECT_EQ(sameTexts, 0U) << person;
    EXPECT_TRUE(sameCounts == 0 || sameCounts >= static_cast<std::size_t>(kSmallestCell))
        << person << " is one of " << sameCounts;
  }
  EXPECT_EQ(hidden.report.deviationsUnlinked, 3);
}

TEST(Pseudonyms, LeaveNoTraceOfTheCentreInAnyFile) {
  const Hidden hidden;
  const ExportSet set = exportSet(analysedCohort(hidden.after), hidden.starts);
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
  for (const CohortGroup& group : hidden.before.groups) {
    secrets.insert(group.protocol.str());
  }
  secrets.insert("2026-01-05");
  secrets.insert("2026-01-06");
  ASSERT_GT(secrets.size(), 60U);
  for (const std::string& secret : secrets) {
    EXPECT_EQ(all.find(secret), std::string::npos) << secret;
  }
}

TEST(Pseudonyms, PreserveEveryNumberAndEveryCount) {
  const Hidden hidden;
  const ExportSet before = exportSet(analysedCohort(hidden.before), {});
  const ExportSet after = exportSet(analysedCohort(hidden.after), hidden.starts);
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
  std::multiset<std::int64_t> leftBefore;  // of single trainees, ordered by code
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

TEST(Pseudonyms, HidePropertiesSharedByFewAndReportHowFew) {
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
