// SPDX-License-Identifier: GPL-3.0-or-later
// Report sections from the marks of the training study: agreement, comparison, missing marks.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/results/cohort_report.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/study_analysis.h"
#include "assessment/statistics/distributions.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {
namespace {

using testing::csvCount;
using testing::demonstrationCohort;
using testing::figureNamed;
using testing::losing;
using testing::paragraphsOf;
using testing::tableNamed;

TEST(CohortReport, ComparesGroupsAndRatersIfThereAreMarks) {
  const CohortInputs in = demonstrationCohort();
  const ReportModel report = cohortReport(in);
  const auto section = std::find_if(report.sections.begin(), report.sections.end(),
                                    [](const ReportSection& of) { return of.id == "comparisons"; });
  ASSERT_NE(section, report.sections.end());
  std::vector<std::string> ids;
  for (const ReportTable& table : section->tables) {
    ids.push_back(table.id);
  }
  EXPECT_THAT(ids, ::testing::ElementsAre("table-agreement", "table-means", "table-ancova",
                                          "table-mixed-anova", "table-within-groups"));
  const auto annex = std::find_if(report.sections.begin(), report.sections.end(),
                                  [](const ReportSection& of) { return of.id == "annex-comparisons"; });
  ASSERT_NE(annex, report.sections.end());
  EXPECT_GT(annex, section);
  EXPECT_EQ(tableNamed(report, "table-agreement-groups")->rows.size(), 9U);  // occasions x groups
  EXPECT_NE(tableNamed(report, "table-kappa"), nullptr);
  EXPECT_EQ(section->tables[0].rows.size(), 3U);
  EXPECT_EQ(section->tables[1].rows.size(), 9U);
  EXPECT_EQ(section->tables[2].rows.size(), 3U);
  EXPECT_THAT(section->paragraphs[1].str(), ::testing::HasSubstr("No plan of the analysis is in the record"));
  for (const ReportTable& table : section->tables) {
    for (const std::vector<ReportCell>& row : table.rows) {
      for (const Text& cell : row) {
        EXPECT_THAT(cell.str(), ::testing::Not(::testing::HasSubstr("not defined")));
      }
    }
  }
}

TEST(CohortReport, HasTheStatisticiansAdditions) {
  CohortInputs in = demonstrationCohort();
  in.trials[0].attempts = {{8.0, false}, {3.0, true}, {2.0, true}};
  const ReportModel report = cohortReport(in);

  const ReportFigure* forest = figureNamed(report, "figure-differences");
  ASSERT_NE(forest, nullptr);
  EXPECT_EQ(forest->categories.size(), 3U);  // pairs of three groups
  EXPECT_EQ(forest->references.at(0).value, 0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(forest->series[0].low[i], *forest->series[0].y[i]);
    EXPECT_GT(forest->series[0].high[i], *forest->series[0].y[i]);
  }
  ASSERT_NE(figureNamed(report, "figure-effects"), nullptr);
  ASSERT_NE(figureNamed(report, "figure-agreement"), nullptr);
  const ReportFigure* marks = figureNamed(report, "figure-marks");
  ASSERT_NE(marks, nullptr);
  EXPECT_EQ(marks->series.size(), 10U);      // raters
  EXPECT_EQ(marks->categories.size(), 30U);  // trainees
  const ReportFigure* severity = figureNamed(report, "figure-severity");
  ASSERT_NE(severity, nullptr);
  double sum = 0.0;
  for (const auto& offset : severity->series[0].y) {
    sum += *offset;
  }
  EXPECT_NEAR(sum, 0.0, 1e-12);  // complete marks: the raters' offsets cancel
  ASSERT_NE(figureNamed(report, "figure-bland-altman"), nullptr);
  for (const char* id : {"figure-courses-1", "figure-courses-2", "figure-courses-3", "figure-classes"}) {
    EXPECT_NE(figureNamed(report, id), nullptr) << id;
  }
}

TEST(CohortReport, ListsLearningCurvesAndWhyOthersAreMissing) {
  CohortInputs in = demonstrationCohort();
  TrialSummaryRow straight = in.trials[0];
  straight.trainee = "x102";
  straight.trialId = "t2";
  for (int n = 0; n < 16; ++n) {
    in.trials[0].attempts.push_back({2.0 + 6.0 * std::exp(-0.4 * n) + (n % 2 == 0 ? 0.1 : -0.1), true});
    straight.attempts.push_back({8.0 - 0.3 * n + (n % 2 == 0 ? 0.1 : -0.1), true});
  }
  in.trials.push_back(straight);
  const ReportModel report = cohortReport(in);
  const ReportTable* learning = tableNamed(report, "table-learning");
  ASSERT_NE(learning, nullptr);
  EXPECT_NEAR(std::stod(learning->rows[0].back().str()), 2.0, 0.1);
  EXPECT_EQ(learning->rows[1].back().str(), "not fitted: the values do not level off within these attempts");
  EXPECT_THAT(learning->notes.back().str(), ::testing::HasSubstr("fitted to 1 of 2 trainees"));
}

TEST(CohortReport, ReportsTheRatersNeededAndEachGroupsGain) {
  const CohortInputs in = demonstrationCohort();
  const ReportModel report = cohortReport(in);

  const ReportTable* needed = tableNamed(report, "table-raters-needed");
  ASSERT_NE(needed, nullptr);
  EXPECT_EQ(needed->rows.size(), 5U);  // 1, 2, 3, 5 and the ten of the study
  // In a single group, one rater's dependability is ICC(2,1), and that of all ten ICC(2,k).
  CohortInputs one = in;
  std::erase_if(one.trainingMarks, [](const TrainingMark& mark) { return mark.group > 0; });
  const IccResult icc = analyseStudy(one).occasions.back().groups.front().icc.value();
  const ReportModel ofOne = cohortReport(testing::scored(std::move(one)));
  const ReportTable* alone = tableNamed(ofOne, "table-raters-needed");
  EXPECT_EQ(alone->rows.front().at(1),
            withInterval(icc.agreementSingle.estimate, icc.agreementSingle.interval));
  EXPECT_EQ(alone->rows.back().at(1), withInterval(icc.agreementMean.estimate, icc.agreementMean.interval));
  EXPECT_THAT(needed->notes.front().str(), ::testing::HasSubstr("with 95 % confidence"));
  const ReportTable* rasch = tableNamed(report, "table-rasch");
  ASSERT_NE(rasch, nullptr);
  ASSERT_EQ(rasch->rows.size(), 10U);
  double sum = 0.0;
  for (const std::vector<ReportCell>& row : rasch->rows) {
    sum += std::stod(row.at(1).str());
  }
  EXPECT_NEAR(sum, 0.0, 0.06);  // ten severities of two decimals
  const ReportTable* within = tableNamed(report, "table-within-groups");
  ASSERT_NE(within, nullptr);
  EXPECT_EQ(within->rows.at(0).at(3), "55.0");   // all ten gained: 1 + 2 + ... + 10
  EXPECT_EQ(within->rows.at(0).at(4), "0.002");  // 2 / 2^10
}

TEST(CohortReport, OneMissingMarkExcludesNobody) {
  const std::string whose = demonstrationCohort().trainingMarks.back().trainee;
  const std::string by = demonstrationCohort().trainingMarks.back().rater;
  const CohortInputs in = losing([&](const TrainingMark& mark) {
    return mark.trainee == whose && mark.rater == by && mark.occasion == 2;
  });
  const ReportModel report = cohortReport(in);
  for (const char* id : {"table-ancova", "table-mixed-model", "table-bounds", "table-missing",
                         "table-mixed-anova", "table-gains", "table-agreement"}) {
    const ReportTable* table = tableNamed(report, id);
    ASSERT_NE(table, nullptr) << id;
    for (const std::vector<ReportCell>& row : table->rows) {
      for (const Text& cell : row) {
        EXPECT_THAT(cell.str(), ::testing::Not(::testing::HasSubstr("not defined"))) << id;
      }
    }
  }
  const ReportTable& agreement = *tableNamed(report, "table-agreement");
  ASSERT_EQ(agreement.rows.size(), 4U);  // the last occasion has a second row
  EXPECT_EQ(agreement.rows[2][1].str(), "29");
  EXPECT_EQ(agreement.rows[3][1].str(), "30");
  EXPECT_EQ(agreement.provenance.missing.str(), "1");
  EXPECT_EQ(tableNamed(report, "table-missing")->rows.size(), 1U);
  EXPECT_EQ(tableNamed(report, "table-missing")->rows[0][0].str(), whose);
  EXPECT_EQ(tableNamed(report, "table-missing")->rows[0][4].str(), "yes");
  EXPECT_THAT(paragraphsOf(report),
              ::testing::HasSubstr("Of 600 marks of the first and the last occasion 1 is "
                                   "missing, so the linear mixed model is the primary"));
  EXPECT_THAT(paragraphsOf(report), ::testing::Not(::testing::HasSubstr("Left out of both")));
  ASSERT_NE(figureNamed(report, "figure-differences"), nullptr);
  EXPECT_EQ(figureNamed(report, "figure-differences")->series.size(), 2U);

  // The first page answers with the primary comparison.
  const ReportSection& board = report.sections.front();
  EXPECT_EQ(board.figures[0].series[0].y, figureNamed(report, "figure-differences")->series[0].y);
  EXPECT_THAT(board.figures[0].provenance.formula.str(), ::testing::HasSubstr("mixed model"));
  EXPECT_EQ(board.figures[0].provenance.missing.str(), "1");
  EXPECT_THAT(testing::firstPageOf(report), ::testing::HasSubstr("Of 600 marks 1 is missing, so the answer"));
}

TEST(CohortReport, ACompletelyMissingRaterIsReportedAndCostsNoAgreement) {
  const std::string by = demonstrationCohort().trainingMarks.back().rater;
  const CohortInputs in =
      losing([&](const TrainingMark& mark) { return mark.rater == by && mark.occasion == 2; });
  const ReportModel report = cohortReport(in);
  const std::string said = paragraphsOf(report);
  EXPECT_THAT(said, ::testing::HasSubstr("No plan of the analysis is in the record"));
  EXPECT_THAT(said, ::testing::Not(::testing::HasSubstr("No mark of the first and the last occasion")));
  EXPECT_THAT(said, ::testing::HasSubstr("but none after 40 min: " + by));
  const ReportTable& agreement = *tableNamed(report, "table-agreement");
  ASSERT_EQ(agreement.rows.size(), 3U);
  EXPECT_EQ(agreement.rows[2][1].str(), "30");  // nine raters scored everybody
  EXPECT_EQ(agreement.provenance.missing.str(), "0");
  EXPECT_EQ(tableNamed(report, "table-raters-needed")->rows.back().at(0).str(), "10");
  EXPECT_EQ(tableNamed(report, "table-raters-needed")->provenance.n.str(), "270");
  const auto& raters = tableNamed(report, "table-raters")->rows;
  const auto absent =
      std::find_if(raters.begin(), raters.end(), [&](const auto& row) { return row[0] == by; });
  ASSERT_NE(absent, raters.end());
  EXPECT_THAT((*absent)[3].str(), ::testing::HasSubstr("too few trainees"));
  EXPECT_THAT(raters.front()[3].str(), ::testing::HasSubstr(" to "));
}

TEST(CohortReport, MethodsNameTheComparisonInUse) {
  EXPECT_THAT(paragraphsOf(cohortReport(demonstrationCohort())),
              ::testing::HasSubstr("Groups are compared by an analysis of covariance"));
  const TrainingMark lost = demonstrationCohort().trainingMarks.back();
  const std::string holed = paragraphsOf(cohortReport(losing([&](const TrainingMark& mark) {
    return mark.trainee == lost.trainee && mark.rater == lost.rater && mark.occasion == 2;
  })));
  EXPECT_THAT(holed, ::testing::HasSubstr("Groups are compared by a linear mixed model"));
  EXPECT_THAT(holed, ::testing::Not(::testing::HasSubstr("compared by an analysis of covariance")));
  const std::string none = paragraphsOf(
      cohortReport(losing([](const TrainingMark& mark) { return mark.group > 0 && mark.occasion == 2; })));
  EXPECT_THAT(none, ::testing::HasSubstr("the groups are not compared"));
}

TEST(CohortReport, ModelsAreComparedByTheSameRaters) {
  const CohortInputs in = demonstrationCohort();
  const Ledger ledger = analysedCohort(in).ledger;
  const auto at = [&](const std::string& model, const std::string& statistic) {
    return ledger.find({.section = ResultSection::kEvaluation, .statistic = statistic, .model = model});
  };
  for (const auto& [pair, first, second] :
       {std::tuple("PM - FEM", 0, 1), {"PM - MSM", 0, 2}, {"FEM - MSM", 1, 2}}) {
    const Result* difference = at(pair, "composite_difference");
    ASSERT_NE(difference, nullptr) << pair;
    EXPECT_EQ(difference->n, 40);
    // With every mark given, N is the mean of the raters' own scores by class weight.
    EXPECT_NEAR(*numberIn(difference->value), in.evaluations[first].n27 - in.evaluations[second].n27, 1e-12);
    const auto interval = std::get<Interval>(at(pair, "composite_difference_holm_95")->value);
    EXPECT_EQ(*numberIn(at(pair, "composite_difference_p_holm")->value) < 0.05,
              interval.lower > 0.0 || interval.upper < 0.0);
  }
  const auto own = std::get<Interval>(at("PM", "composite_M_95")->value);
  EXPECT_LT(own.lower, in.evaluations[0].n27);
  EXPECT_GT(own.upper, in.evaluations[0].n27);
  EXPECT_EQ(tableNamed(cohortReport(in), "table-model-differences")->rows.size(), 3U);
}

TEST(CohortReport, LabelsTheIntervalsOfTheAnswer) {
  const ReportSection board = cohortReport(demonstrationCohort()).sections.front();
  EXPECT_THAT(board.paragraphs[4].str(),
              ::testing::HasSubstr("the 95 % interval and the p value of each pair after Holm"));
  EXPECT_THAT(board.figures[0].notes.at(0).str(), ::testing::HasSubstr("adjusted for the number of pairs"));
}

TEST(CohortReport, NamesExcludedPeopleByCode) {
  const std::string whose = demonstrationCohort().trainees[3].code;
  CohortInputs in =
      losing([&](const TrainingMark& mark) { return mark.trainee == whose && mark.occasion == 2; });
  const ReportModel report = cohortReport(in);
  EXPECT_THAT(paragraphsOf(report), ::testing::HasSubstr("without any mark at one of the two: " + whose));
  EXPECT_EQ(tableNamed(report, "table-ancova")->provenance.n.str(), "29");
  EXPECT_EQ(tableNamed(report, "table-ancova")->provenance.missing.str(), "10");
  EXPECT_EQ(tableNamed(report, "table-missing")->rows[0][4].str(), "no");
  EXPECT_THAT(tableNamed(report, "table-mixed-anova")->notes.back().str(), ::testing::HasSubstr(whose));

  in.identity = ReportIdentity::kAggregated;
  const ReportModel aggregated = cohortReport(in);
  EXPECT_EQ(paragraphsOf(aggregated).find(whose), std::string::npos);
  EXPECT_EQ(tableNamed(aggregated, "table-missing"), nullptr);
  EXPECT_EQ(figureNamed(aggregated, "figure-residuals"), nullptr);
}

TEST(CohortReport, DifferentSlopesAreAnalysedSeparately) {
  CohortInputs in = demonstrationCohort();
  EXPECT_EQ(tableNamed(cohortReport(in), "table-slopes"), nullptr);
  std::map<std::string, double> before;
  for (const TraineeScore& score : in.scores) {
    if (score.occasion == 0) {
      before[score.trainee] = score.score;
    }
  }
  for (TrainingMark& mark : in.trainingMarks) {  // in the first group low scores become high and vice versa
    if (mark.group == 0 && mark.occasion == 2) {
      mark.steps = std::clamp<std::int64_t>(90 - static_cast<std::int64_t>(8.0 * before[mark.trainee]) +
                                                static_cast<std::int64_t>(mark.rater.back() % 3),
                                            in.trainingScale.lo, in.trainingScale.hi);
    }
  }
  in.scores = traineeScores(in.trainingScale, in.trainingMarks);
  in.summaries = groupSummaries(in.trainingScale, in.trainingMarks);
  const ReportModel report = cohortReport(in);
  const ReportTable* slopes = tableNamed(report, "table-slopes");
  ASSERT_NE(slopes, nullptr);
  EXPECT_EQ(slopes->rows.size(), 9U);  // pairs x stated scores before
  EXPECT_THAT(tableNamed(report, "table-ancova")->notes[1].str(), ::testing::HasSubstr("The slopes differ"));
  EXPECT_THAT(testing::firstPageOf(report),
              ::testing::HasSubstr("The difference depends on the score before"));
  EXPECT_EQ(csvCount(in, "separate_slopes_difference"), 9);
  EXPECT_EQ(csvCount(in, "separate_slope"), 3);
}

TEST(CohortReport, NoStatementAboutRatersGainsFromAnEffectOfTheTraining) {
  CohortInputs in = demonstrationCohort();
  for (TrainingMark& mark : in.trainingMarks) {
    mark.steps = std::clamp<std::int64_t>(mark.steps, 10, 60);
  }
  CohortInputs trained = in;
  for (TrainingMark& mark : trained.trainingMarks) {
    mark.steps += mark.group == 1 && mark.occasion == 2 ? 40 : 0;
  }
  const ReportModel usual = cohortReport(testing::scored(in));
  const ReportModel changed = cohortReport(testing::scored(trained));
  for (const char* id : {"table-agreement", "table-agreement-groups", "table-raters-needed"}) {
    const ReportTable* before = tableNamed(usual, id);
    const ReportTable* after = tableNamed(changed, id);
    ASSERT_TRUE(before != nullptr && after != nullptr) << id;
    EXPECT_EQ(before->rows, after->rows) << id;
  }
  const ReportFigure* figure = figureNamed(usual, "figure-agreement");
  ASSERT_NE(figure, nullptr);
  EXPECT_EQ(figure->series[1].low, figureNamed(changed, "figure-agreement")->series[1].low);
  for (const CohortCsvRow& row : cohortCsvRows(trained)) {
    EXPECT_FALSE(row.group.empty() &&
                 (row.statistic.starts_with("icc_") || row.statistic.starts_with("kappa")))
        << numberAddress(row);
  }
}

TEST(CohortReport, TheTableOfDifferencesHasTheErrorsOfTheAnswer) {
  const CohortInputs in = demonstrationCohort();
  const StudyAnalysis study = analyseStudy(in);
  ASSERT_EQ(study.primaryMethod(), PrimaryMethod::kRobust);
  const ReportModel report = cohortReport(in);
  const ReportTable* table = tableNamed(report, "table-ancova");
  ASSERT_NE(table, nullptr);
  for (std::size_t i = 0; i < 3; ++i) {
    const AdjustedDifference& pair = study.ancova->spread.pairs[i];
    EXPECT_EQ(table->rows[i][1], withInterval(pair.difference, pair.interval));
    EXPECT_EQ(figureNamed(report, "figure-differences")->series[0].high[i], pair.interval.upper);
  }
  EXPECT_THAT(table->provenance.formula.str(), ::testing::HasSubstr("HC3"));
}

TEST(CohortReport, ShowsKappaOfMarksInWholePoints) {
  CohortInputs in = demonstrationCohort();
  const ReportModel usual = cohortReport(in);
  const ReportTable* table = tableNamed(usual, "table-kappa");
  ASSERT_NE(table, nullptr);
  ASSERT_EQ(table->rows.size(), in.occasions.size() * in.groups.size());
  EXPECT_EQ(table->rows[0][2].str(), "45");  // pairs of ten raters

  const std::string first = in.trainingMarks.front().rater;
  std::map<std::pair<std::string, std::size_t>, std::int64_t> marks;  // by trainee and occasion
  for (const TrainingMark& mark : in.trainingMarks) {
    if (mark.rater == first) {
      marks[{mark.trainee, mark.occasion}] = mark.steps;
    }
  }
  for (TrainingMark& mark : in.trainingMarks) {  // all give what the first gives, within the same point
    const std::int64_t whole = marks.at({mark.trainee, mark.occasion}) / 10 * 10;
    mark.steps = std::clamp(whole + (mark.rater == first ? 0 : 4), in.trainingScale.lo, in.trainingScale.hi);
  }
  in.scores = traineeScores(in.trainingScale, in.trainingMarks);
  in.summaries = groupSummaries(in.trainingScale, in.trainingMarks);
  const ReportModel alike = cohortReport(in);
  EXPECT_EQ(tableNamed(alike, "table-kappa")->rows[0][4].str(), "1.000 (1.000 to 1.000)");
  EXPECT_EQ(tableNamed(alike, "table-kappa")->rows[0][5].str(), "100 %");
}

TEST(CohortReport, TestsEquivalenceWithThePlannedMarginOrSaysThatThereIsNone) {
  CohortInputs in = demonstrationCohort();
  EXPECT_EQ(tableNamed(cohortReport(in), "table-equivalence"), nullptr);
  EXPECT_THAT(paragraphsOf(cohortReport(in)), ::testing::HasSubstr("No margin was planned"));

  const Outcome<Ancova> model = analyseStudy(in).ancova;
  const AdjustedDifference& pair = model->spread.pairs.front();
  const double reach = tQuantile(0.95, pair.df) * pair.error;
  for (const bool wide : {false, true}) {
    in.equivalenceMargin = std::abs(pair.difference) + reach * (wide ? 1.01 : 0.99);
    const ReportModel report = cohortReport(in);
    const ReportTable* table = tableNamed(report, "table-equivalence");
    ASSERT_NE(table, nullptr);
    ASSERT_EQ(table->rows.size(), 3U);
    EXPECT_EQ(table->rows[0][3].str(), wide ? "yes" : "not shown");
    EXPECT_THAT(paragraphsOf(report), ::testing::Not(::testing::HasSubstr("No margin was planned")));
  }

  const TrainingMark lost = in.trainingMarks.back();
  CohortInputs holed = losing([&](const TrainingMark& mark) {
    return mark.trainee == lost.trainee && mark.rater == lost.rater && mark.occasion == 2;
  });
  holed.equivalenceMargin = 1.0;
  const ReportModel report = cohortReport(holed);
  EXPECT_THAT(tableNamed(report, "table-equivalence")->provenance.formula.str(),
              ::testing::HasSubstr("mixed"));
}

TEST(CohortReport, ShowsTheResidualsOfTheComparison) {
  const ReportModel report = cohortReport(demonstrationCohort());
  for (const char* id : {"figure-residuals", "figure-qq"}) {
    const ReportFigure* figure = figureNamed(report, id);
    ASSERT_NE(figure, nullptr) << id;
    std::size_t points = 0;
    double sum = 0.0;
    for (const FigureSeries& series : figure->series) {
      ASSERT_EQ(series.x.size(), series.y.size());
      if (series.faint) {  // the reference line
        EXPECT_EQ(series.x.front(), *series.y.front());
        continue;
      }
      points += series.x.size();
      for (const std::optional<double>& residual : series.y) {
        sum += *residual;
      }
    }
    EXPECT_EQ(points, 30U);
    EXPECT_NEAR(sum, 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace torsio
