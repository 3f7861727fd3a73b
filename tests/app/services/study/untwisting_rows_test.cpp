// SPDX-License-Identifier: GPL-3.0-or-later
// Untwistings stored in a record of either engine come back as rows of the report.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/outputs/report/report_data.h"
#include "app/services/demonstration/demonstration.h"
#include "app/services/recording/trial_digests.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/cohort_report.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "tests/db/test_database.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {
namespace {

const std::filesystem::path kAssets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
constexpr std::int64_t kNow_us = 1'768'000'000'000'000;  // after the simulated date of the demonstration

/// A record with the demonstration, and a user who computes its results.
class UntwistingRows : public DatabaseTest {
 protected:
  void SetUp() override {
    DatabaseTest::SetUp();
    if (IsSkipped()) {
      return;
    }
    connection_ = std::make_unique<Connection>(openWithSchema());
    DemonstrationOptions options;
    options.shortening = 600;  // two seconds per phase; untwistings are not shortened
    options.training.assets = kAssets;
    options.example.assets = kAssets;
    options.example.id = "stomach";
    fillDemonstration(options, *connection_);
    AccessRepository access(*connection_, PasswordCost::kTest);
    access.addUser(
        {.id = "statistician", .login = "statistician", .createdUtc_us = kNow_us, .roles = {"statistician"}},
        "a long enough password");
    session_ = std::make_unique<SessionContext>(*connection_, ids_, SessionKey{locator(), "station 1", {}},
                                                [] { return kNow_us; });
    session_->setActor({"statistician", "statistician", "", {"statistician"}, false});
  }
  void TearDown() override {
    session_.reset();
    connection_.reset();
    DatabaseTest::TearDown();
  }

  void comeBackFromTheRecordWithTheirMetricsAndOutcomes();
  void areLinesOfTheTableOfUntwistingsAndOfTheCsvFile();
  void leaveTheStudyOfTheDemonstrationAsItIs();

  CohortInputs reported(const std::string& cohortName) {
    for (const Cohort& cohort : StudyRepository(*connection_).cohorts()) {
      if (cohort.name == cohortName) {
        session_->beginCall();
        return reportInputs(*session_, {.cohortId = cohort.id}, digests_);
      }
    }
    ADD_FAILURE() << "no cohort " << cohortName;
    return {};
  }

  SeededIdSource ids_{11};
  std::unique_ptr<Connection> connection_;
  std::unique_ptr<SessionContext> session_;
  TrialDigests digests_{kAssets};
};

const ReportTable* tableIn(const ReportModel& report, const std::string& id) {
  for (const ReportSection& section : report.sections) {
    for (const ReportTable& table : section.tables) {
      if (table.id == id) {
        return &table;
      }
    }
  }
  return nullptr;
}

std::vector<std::string> cellsOf(const std::vector<ReportCell>& row, std::size_t count) {
  std::vector<std::string> cells;
  for (std::size_t i = 0; i < count; ++i) {
    cells.push_back(row.at(i).str());
  }
  return cells;
}

void UntwistingRows::comeBackFromTheRecordWithTheirMetricsAndOutcomes() {
  const CohortInputs inputs = reported("Volvulus and torsion (demonstration)");

  EXPECT_EQ(digests_.measured(), 0U);  // each was measured when it was recorded
  ASSERT_EQ(inputs.trials.size(), 7U);
  std::vector<double> done;
  std::vector<double> jaw_Pa;
  for (const TrialSummaryRow& trial : inputs.trials) {
    EXPECT_EQ(trial.twists, 0);
    ASSERT_TRUE(trial.detorsion.contains("detorse.done")) << trial.trialId;
    EXPECT_TRUE(trial.detorsion.contains("detorse.dose"));
    done.push_back(trial.detorsion.at("detorse.done"));
    jaw_Pa.push_back(trial.detorsion.at("detorse.peak_jaw"));
  }
  // By design: the third and seventh stop one turn early, the fifth closes the jaw too tightly.
  EXPECT_THAT(done, ::testing::ElementsAre(1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 0.0));
  for (std::size_t i = 0; i < jaw_Pa.size(); ++i) {
    EXPECT_EQ(jaw_Pa[i] > 350e3, i == 4) << i;  // 6 N on 15 mm2 are 400 kPa
  }
  EXPECT_GT(inputs.trials[4].detorsion.at("detorse.overload_time"), 0.3);  // long enough for a bruise
  EXPECT_EQ(inputs.trials[3].detorsion.at("detorse.overload_time"), 0.0);  // a careful hand has none
}

void UntwistingRows::areLinesOfTheTableOfUntwistingsAndOfTheCsvFile() {
  const CohortInputs inputs = reported("Volvulus and torsion (demonstration)");
  const ReportModel report = cohortReport(inputs);
  const std::vector<CohortCsvRow> rows = cohortCsvRows(inputs);

  const ReportTable* table = tableIn(report, "table-untwistings");
  ASSERT_NE(table, nullptr);
  ASSERT_EQ(table->rows.size(), 2U);
  // Group, phase, trials, untwisted; relapses do not matter here; five of the loop, two of the stomach.
  EXPECT_THAT(cellsOf(table->rows[0], 4),
              ::testing::ElementsAre("Group 1", "Small-bowel loop: untwist it", "5", "4 of 5"));
  EXPECT_THAT(cellsOf(table->rows[1], 4),
              ::testing::ElementsAre("Group 1", "Stomach, organo-axial: untwist it", "2", "1 of 2"));
  EXPECT_EQ(tableIn(report, "table-trials"), nullptr);  // no twists
  const auto count = [&rows](const std::string& statistic) {
    return std::count_if(rows.begin(), rows.end(),
                         [&](const CohortCsvRow& row) { return row.statistic == statistic; });
  };
  EXPECT_EQ(count("detorse.done"), 7);
  EXPECT_EQ(count("twists"), 0);
}

void UntwistingRows::leaveTheStudyOfTheDemonstrationAsItIs() {
  std::size_t others = 0;
  for (const Cohort& cohort : StudyRepository(*connection_).cohorts()) {
    if (cohort.name != "Volvulus and torsion (demonstration)") {
      ++others;
      session_->beginCall();
      const CohortInputs inputs = reportInputs(*session_, {.cohortId = cohort.id}, digests_);
      EXPECT_EQ(inputs.trials.size(), 30U);  // 20 of group 1 in two phases, 10 of group 2
      EXPECT_EQ(tableIn(cohortReport(inputs), "table-untwistings"), nullptr);
    }
  }

  EXPECT_EQ(others, 1U);
}

// One test, because the demonstration takes most of its time.
TEST_F(UntwistingRows, AreTheSameInRecordTableAndFileAndDoNotChangeTheStudy) {
  comeBackFromTheRecordWithTheirMetricsAndOutcomes();
  areLinesOfTheTableOfUntwistingsAndOfTheCsvFile();
  leaveTheStudyOfTheDemonstrationAsItIs();
}

}  // namespace
}  // namespace torsio
