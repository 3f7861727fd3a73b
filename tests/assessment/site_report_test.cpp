// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a pooled record: the comparison within the centres, and how it differs between them.
#include <array>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/results/cohort_csv.h"
#include "assessment/results/cohort_report.h"
#include "assessment/results/study_analysis.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::tableNamed;

/// Distributes each group over the centres, so that every centre has trainees of each.
CohortInputs pooled(std::size_t sites) {
  CohortInputs in = testing::demonstrationCohort();
  for (std::size_t s = 0; s < sites; ++s) {
    in.sites.push_back("C" + std::to_string(s + 1));
  }
  for (std::size_t i = 0; i < in.trainees.size(); ++i) {
    in.trainees[i].site = in.sites[i % 10 * sites / 10];
  }
  return in;
}

TEST(SiteReport, OneCentreHasNoTableOfCentres) {
  const ReportModel report = cohortReport(testing::demonstrationCohort());
  for (const char* id :
       {"table-centres", "table-heterogeneity", "table-centre-by-centre", "table-flow-centres"}) {
    EXPECT_EQ(tableNamed(report, id), nullptr) << id;
  }
}

TEST(SiteReport, CentresAreFixedBelowFiveAndRandomFromThere) {
  for (const std::size_t sites : {2U, 5U}) {
    const CohortInputs in = pooled(sites);
    const ReportModel report = cohortReport(in);
    const ReportTable* within = tableNamed(report, "table-centres");
    ASSERT_NE(within, nullptr);
    EXPECT_EQ(within->rows.size(), 3U);
    EXPECT_THAT(within->notes.at(0).str(), HasSubstr(sites < 5 ? "fixed, as there are fewer than five"
                                                               : "random, as there are five or more"));
    EXPECT_EQ(within->notes.size(), sites < 5 ? 1U : 2U)
        << "a variance of the centres only where it is estimated";
    const ReportTable* spread = tableNamed(report, "table-heterogeneity");
    ASSERT_NE(spread, nullptr);
    EXPECT_EQ(spread->rows.size(), 3U);
    EXPECT_EQ(spread->rows[0][1].str(), std::to_string(sites));
    const ReportTable* each = tableNamed(report, "table-centre-by-centre");
    ASSERT_NE(each, nullptr);
    EXPECT_EQ(each->rows.size(), 3U * sites);
    const ReportTable* flow = tableNamed(report, "table-flow-centres");
    ASSERT_NE(flow, nullptr);
    EXPECT_EQ(flow->rows.size(), 3U * sites);
    EXPECT_THAT(testing::firstPageOf(report), HasSubstr("centres were pooled (C1, C2"));
    EXPECT_THAT(testing::firstPageOf(report), HasSubstr("The answer has the centre in its model ("));
    EXPECT_THAT(testing::firstPageOf(report), Not(HasSubstr("No analysis takes account")));
    EXPECT_EQ(testing::rowsNamed(in, "difference_without_centre").size(), sites > 2 ? 3U * sites : 0U)
        << "one centre alone is no comparison within centres";
    testing::expectWellSaid(in);
  }
}

TEST(SiteReport, TheAnswerHasTheCentreInItsModel) {
  for (const std::size_t sites : {2U, 5U}) {
    const CohortInputs in = pooled(sites);
    const ReportModel report = cohortReport(in);
    const ReportFigure* answer = testing::figureNamed(report, "figure-answer");
    ASSERT_NE(answer, nullptr);
    ASSERT_EQ(answer->series.at(0).keys.size(), 3U);
    for (const auto& key : answer->series[0].keys) {
      EXPECT_EQ(key->statistic, "centre_difference");
    }
    EXPECT_THAT(answer->provenance.formula.str(),
                HasSubstr(sites < 5 ? "the centre as a fixed factor" : "the centre as a random effect"));
    EXPECT_EQ(testing::rowsNamed(in, "primary_analysis").at(0).value,
              "analysis of covariance within centres");
    const auto difference = testing::rowsNamed(in, "centre_difference");
    EXPECT_NEAR(std::stod(difference.at(0).value), answer->series[0].y.at(0).value(), 1e-12);
  }
}

TEST(SiteReport, AnEffectThatDiffersFromCentreToCentreIsReportedOnTheFirstPage) {
  CohortInputs in = pooled(5);
  for (TrainingMark& mark : in.trainingMarks) {
    const bool odd = (mark.trainee.back() - '0') % 10 >= 7 || mark.trainee.back() == '0';
    mark.steps += mark.group == 2 && mark.occasion == 2 && odd ? 20 : 0;
  }
  in = testing::scored(std::move(in));
  const std::string said = testing::firstPageOf(cohortReport(in));
  EXPECT_THAT(said, HasSubstr("The differences vary from centre to centre"));
  EXPECT_THAT(said, Not(HasSubstr("was not shown; few centres")));
  EXPECT_THAT(testing::firstPageOf(cohortReport(pooled(5))), Not(HasSubstr("The differences vary")));
}

TEST(SiteReport, ReadersWhoMaySeeNoIndividualsSeeNoCentre) {
  CohortInputs in = pooled(5);
  in.identity = ReportIdentity::kAggregated;
  const ReportModel report = cohortReport(in);
  EXPECT_NE(tableNamed(report, "table-centres"), nullptr);
  EXPECT_EQ(tableNamed(report, "table-centre-by-centre"), nullptr);
  EXPECT_EQ(tableNamed(report, "table-flow-centres"), nullptr);
  for (const char* one : {"difference_at_centre", "difference_without_centre", "centre_allocated"}) {
    EXPECT_TRUE(testing::rowsNamed(in, one).empty()) << one;
  }
  in.identity = ReportIdentity::kCoded;
  in.singleMarks = false;  // two trainees of a group at each centre
  EXPECT_TRUE(testing::rowsNamed(in, "difference_at_centre").empty());
}

TEST(SiteReport, DeviceAndStationAreFurtherFactorsWhereTheyDiffer) {
  CohortInputs in = pooled(2);
  in.trials.clear();
  for (std::size_t i = 0; i < in.trainees.size(); ++i) {
    TrialSummaryRow run;
    run.trainee = in.trainees[i].code;
    run.group = in.trainees[i].group;
    run.trialId = "run-" + std::to_string(i);
    run.phase = Text::verbatim("virtual 0-20 min");
    run.contentHash = std::string(64, 'a');
    run.device = i % 3 == 0 ? "Omni" : "Touch";
    run.station = "one";
    in.trials.push_back(run);
  }
  const ReportModel report = cohortReport(in);
  const ReportTable* equipment = tableNamed(report, "table-equipment");
  ASSERT_NE(equipment, nullptr);
  ASSERT_EQ(equipment->rows.size(), 3U);
  EXPECT_THAT(equipment->rows[0][1].str(), HasSubstr("["));
  EXPECT_EQ(equipment->rows[0][2].str(), "does not apply");  // there is one station
  for (TrialSummaryRow& run : in.trials) {
    run.device = run.group == 0 ? "Omni" : "Touch";
  }
  EXPECT_EQ(tableNamed(cohortReport(in), "table-equipment"), nullptr) << "the device is the group";
}

TEST(SiteReport, SaysWhyNothingIsComparedWithinTheCentres) {
  CohortInputs in = pooled(2);
  for (CohortTrainee& trainee : in.trainees) {
    trainee.site = in.sites.front();
  }
  EXPECT_THAT(testing::firstPageOf(cohortReport(in)),
              HasSubstr("No analysis takes account of the centre: fewer than two centres have scores"));
}

}  // namespace
}  // namespace torsio
