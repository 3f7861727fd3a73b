// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a cohort's numbers.
#include "assessment/results/cohort_csv.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/results/cohort_report.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {
namespace {

using testing::csvCount;
using testing::demonstrationCohort;
using testing::losing;
using testing::withUntwistings;

std::size_t rowsOf(const CohortInputs& in, const std::string& section, const std::string& statistic) {
  const std::vector<CohortCsvRow> rows = cohortCsvRows(in);
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [&](const CohortCsvRow& row) {
    return row.section == section && row.statistic == statistic;
  }));
}

TEST(CohortCsv, ContainsEveryMarkByCriterionAnchorsRevisionAndProgram) {
  CohortInputs in = demonstrationCohort();
  in.programHash = std::string(64, 'e');

  EXPECT_EQ(rowsOf(in, "criterion", "criterion_mark"), 1800U);
  EXPECT_EQ(rowsOf(in, "criterion", "criterion_mean"), 2U * (9 + 90));
  EXPECT_EQ(rowsOf(in, "scoring_sheet", "anchor_10"), 1U);
  EXPECT_EQ(rowsOf(in, "record", "file_blake2b"), 1U);
  const std::vector<CohortCsvRow> rows = cohortCsvRows(in);
  const auto mark = std::find_if(rows.begin(), rows.end(), [](const CohortCsvRow& row) {
    return row.statistic == "criterion_mark" && row.item == "x101" && row.index == "R101";
  });
  ASSERT_NE(mark, rows.end());
  EXPECT_EQ(mark->model, "Arm sheet, revision 2: time");
  in.singleMarks = false;
  EXPECT_EQ(rowsOf(in, "criterion", "criterion_mark"), 0U) << "a single mark is nobody's business";
  in.sheetsAsked = 900;
  in.sheetsPresent = 899;
  EXPECT_EQ(rowsOf(in, "criterion", "criterion_mean"), 0U) << "nothing before the set is complete";
}

TEST(CohortCsv, HidesAMeanOfTwoMarksOfACriterionWithoutTheRightToSeeMarks) {
  CohortInputs in = demonstrationCohort();
  in.singleMarks = false;
  std::size_t kept = 0;
  for (CriterionMark& mark : in.criterionMarks) {  // all but two are not assessable
    if (mark.trainee == "x101" && mark.occasion == 0 && mark.criterion == 0 && ++kept > 2) {
      mark.points.reset();
    }
  }
  for (const CohortCsvRow& row : cohortCsvRows(in)) {
    if (row.section == "criterion" && row.item == "x101" && row.occasion == "before" &&
        row.model.ends_with("time")) {
      EXPECT_EQ(row.value, "");
    }
  }
}

TEST(CohortCsv, ContainsARowForEachMetricOfAnUntwisting) {
  const std::vector<CohortCsvRow> rows = cohortCsvRows(withUntwistings());

  const auto count = [&rows](const std::string& statistic) {
    return std::count_if(rows.begin(), rows.end(),
                         [&](const CohortCsvRow& row) { return row.statistic == statistic; });
  };
  EXPECT_EQ(count("detorse.done"), 3);
  EXPECT_EQ(count("detorse.time_to_flow"), 2);
  const auto twists = std::count_if(rows.begin(), rows.end(), [](const CohortCsvRow& row) {
    return row.statistic == "twists" && row.occasion == "volvulus";
  });
  EXPECT_EQ(twists, 0);  // not applicable to an untwisting
}

TEST(CohortCsv, IsTidyCompleteAndReproducible) {
  const CohortInputs in = demonstrationCohort();
  const std::vector<CohortCsvRow> rows = cohortCsvRows(in);
  const std::string text = cohortCsvText(rows);

  EXPECT_EQ(text, cohortCsvText(cohortCsvRows(demonstrationCohort())));
  EXPECT_THAT(text,
              ::testing::StartsWith("section,item,group,model,index,occasion,statistic,value,n,flags\r\n"));
  const auto count = [&](const char* statistic) {
    return std::count_if(rows.begin(), rows.end(),
                         [&](const CohortCsvRow& row) { return row.statistic == statistic; });
  };
  EXPECT_EQ(count("mark"), 1080);  // 40 raters, nine indices, three models
  EXPECT_EQ(count("composite"), 120);
  EXPECT_EQ(count("score"), 90);
  EXPECT_EQ(count("N_eq27"), 3);
  for (const CohortCsvRow& row : rows) {
    EXPECT_THAT(row.flags, ::testing::HasSubstr("demonstration data"));
  }
  const auto n27 = std::find_if(rows.begin(), rows.end(),
                                [](const CohortCsvRow& row) { return row.statistic == "N_eq27"; });
  EXPECT_EQ(std::stod(n27->value), in.evaluations[0].n27);
}

TEST(CohortCsv, ContainsTheTablesOfTheStudy) {
  CohortInputs in = demonstrationCohort();
  in.equivalenceMargin = 1.0;
  // Agreement: three occasions, and within each of three groups.
  EXPECT_EQ(csvCount(in, "sem_of_mean"), 12);
  EXPECT_EQ(csvCount(in, "icc_2_k_lower_95"), 9);
  EXPECT_EQ(csvCount(in, "dependability_of_all_raters_lower_95"), 3);
  EXPECT_EQ(csvCount(in, "limit_of_agreement_upper"), 10);
  EXPECT_EQ(csvCount(in, "mean_lower_95"), 9);
  EXPECT_EQ(csvCount(in, "adjusted_difference_simultaneous_lower_95"), 3);
  EXPECT_EQ(csvCount(in, "equivalence_margin"), 1);
  EXPECT_EQ(csvCount(in, "equivalence_p"), 3);
  EXPECT_EQ(csvCount(in, "ancova_residual"), 30);
  EXPECT_EQ(csvCount(in, "ancova_normal_quantile"), 30);
  EXPECT_EQ(csvCount(in, "reml_mean"), 0);
  const auto wordOf = [](const CohortInputs& of, const std::string& statistic) {
    for (const CohortCsvRow& row : cohortCsvRows(of)) {
      if (row.section == "comparison" && row.statistic == statistic) {
        return row.value;
      }
    }
    return std::string();
  };
  EXPECT_EQ(wordOf(in, "planned_analysis"), "analysis of covariance");
  EXPECT_EQ(wordOf(in, "primary_analysis"), "analysis of covariance, HC3");
  EXPECT_EQ(wordOf(in, "marks_missing"), "0");

  const TrainingMark lost = in.trainingMarks.back();
  const CohortInputs holed = losing([&](const TrainingMark& mark) {
    return mark.trainee == lost.trainee && mark.rater == lost.rater && mark.occasion == 2;
  });
  EXPECT_EQ(wordOf(holed, "planned_analysis"), "none in the record");
  EXPECT_EQ(wordOf(holed, "primary_analysis"), "linear mixed model");
  EXPECT_EQ(wordOf(holed, "marks_missing"), "1");
  EXPECT_EQ(csvCount(holed, "reml_mean"), 1);
  EXPECT_EQ(csvCount(holed, "bound_worst_lower_95"), 3);

  in.identity = ReportIdentity::kAggregated;
  EXPECT_EQ(csvCount(in, "ancova_residual"), 0);
  EXPECT_EQ(csvCount(in, "limit_of_agreement_upper"), 0);
}

TEST(CohortCsvText, QuotesFieldsWithCommasAndQuotes) {
  CohortCsvRow row;
  row.item = "a,b";
  row.flags = "say \"so\"";
  EXPECT_THAT(cohortCsvText({row}), ::testing::EndsWith("\r\n,\"a,b\",,,,,,,,\"say \"\"so\"\"\"\r\n"));
}

}  // namespace
}  // namespace torsio
