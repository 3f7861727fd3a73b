// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/report/cohort_report.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/report/aggregated_inputs.h"
#include "assessment/report/cohort_csv.h"
#include "assessment/report/figure_table.h"
#include "assessment/report/number_format.h"
#include "assessment/report/study_analysis.h"
#include "assessment/statistics/distributions.h"
#include "sim/base/error.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {
namespace {

using testing::demonstrationCohort;

const ReportFigure* find(const ReportModel& report, const std::string& id) {
  for (const ReportSection& section : report.sections) {
    for (const ReportFigure& figure : section.figures) {
      if (figure.id == id) {
        return &figure;
      }
    }
  }
  return nullptr;
}

const ReportTable* tableOf(const ReportModel& report, const std::string& id) {
  for (const ReportSection& section : report.sections) {
    for (const ReportTable& table : section.tables) {
      if (table.id == id) {
        return &table;
      }
    }
  }
  return nullptr;
}

TEST(CohortReport, HoldsEveryFigureOfThePaperWithSeriesThatFitItsCategories) {
  const ReportModel report = cohortReport(demonstrationCohort());

  for (const char* id : {"figure-15", "figure-16", "figure-17", "figure-18", "figure-19", "figure-20",
                         "figure-21", "figure-22", "figure-23"}) {
    const ReportFigure* figure = find(report, id);
    ASSERT_NE(figure, nullptr) << id;
    EXPECT_EQ(figure->series.size(), 3U) << id;
    EXPECT_FALSE(figure->yLabel.empty());
    EXPECT_GT(figure->provenance.n, 0) << id;
    EXPECT_THAT(figure->provenance.flags, ::testing::Contains(Text::verbatim("demonstration data"))) << id;
    for (const FigureSeries& series : figure->series) {
      if (figure->kind == FigureKind::kBoxes) {
        EXPECT_EQ(series.y.size(), 40U);
        ASSERT_TRUE(series.box.has_value());
        EXPECT_LE(series.box->lowerQuartile, series.box->median);
        continue;
      }
      EXPECT_EQ(series.y.size(), figure->categories.size()) << id;
      if (figure->kind == FigureKind::kRanges) {
        ASSERT_EQ(series.low.size(), series.y.size());
        for (std::size_t i = 0; i < series.y.size(); ++i) {
          EXPECT_LE(series.low[i], *series.y[i]);
          EXPECT_GE(series.high[i], *series.y[i]);
        }
      }
    }
  }
  EXPECT_THAT(find(report, "figure-17")->title.str(),
              ::testing::HasSubstr("about the weighted mean, divisor n"));
  EXPECT_THAT(find(report, "figure-23")->title.str(), ::testing::HasSubstr("divisor n"));
  EXPECT_EQ(find(report, "figure-18")->categories.size(), 10U);
}

TEST(CohortReport, HasTablesWhoseRowsFitTheirColumnsAndUniqueNames) {
  const ReportModel report = cohortReport(demonstrationCohort());
  std::set<std::string> ids;
  int tables = 0;
  for (const ReportSection& section : report.sections) {
    for (const ReportTable& table : section.tables) {
      ++tables;
      EXPECT_TRUE(ids.insert(table.id).second) << table.id;
      EXPECT_FALSE(table.rows.empty()) << table.id;
      for (const std::vector<Text>& row : table.rows) {
        EXPECT_EQ(row.size(), table.columns.size()) << table.id;
      }
    }
  }
  EXPECT_GE(tables, 9);
  EXPECT_TRUE(report.demonstration);
  EXPECT_EQ(report.sections.at(0).title, "At a glance");
  EXPECT_EQ(report.sections.at(1).title, "What was simulated");
}

TEST(CohortReport, BeginsWithAPageThatABoardReadsInAMinute) {
  CohortInputs in = demonstrationCohort();
  in.deviations = {{0, "T-01", "late", "came late"}};
  const ReportSection board = cohortReport(in).sections.front();

  ASSERT_GE(board.paragraphs.size(), 4U);
  EXPECT_THAT(board.paragraphs[0].str(), ::testing::HasSubstr("do trainees score differently"));
  EXPECT_THAT(
      board.paragraphs[1].str(),
      ::testing::HasSubstr("30 trainees in 3 groups, 0 of them withdrew; 10 physicians gave 900 marks; "
                           "1 deviation from"));
  ASSERT_EQ(board.figures.size(), 1U);
  EXPECT_EQ(board.figures[0].id, "figure-answer");
  const ReportModel whole = cohortReport(in);
  const ReportFigure* differences = find(whole, "figure-differences");
  ASSERT_NE(differences, nullptr);
  EXPECT_EQ(board.figures[0].series[0].y, differences->series[0].y) << "one number, two places";
  std::size_t excluded = 0;
  for (std::size_t i = 0; i < differences->series[0].y.size(); ++i) {
    excluded += differences->series[0].low[i] > 0.0 || differences->series[0].high[i] < 0.0 ? 1 : 0;
  }
  const std::string answer = board.paragraphs[2].str();
  EXPECT_EQ(answer.find("Every interval holds zero") != std::string::npos,
            answer.find("no difference") != std::string::npos && excluded == 0)
      << answer;
  EXPECT_TRUE(board.onFirstPage);
  for (std::size_t i = 0; i < board.figures[0].categories.size(); ++i) {
    EXPECT_THAT(board.figures[0].categories[i].str(),
                ::testing::HasSubstr(formatFixed(*board.figures[0].series[0].y[i], 1)))
        << "the value stands in its label";
  }
  ASSERT_EQ(board.tables.size(), 2U);
  EXPECT_EQ(board.tables[0].rows.size(), 3U);
  EXPECT_EQ(board.tables[1].id, "table-signatures");
}

TEST(CohortReport, NamesOnTheFirstPageWhoReachedTheStandard) {
  CohortInputs in = demonstrationCohort();
  CohortCompetence able;
  able.trainee = "x101";
  able.able = true;
  CohortCompetence notYet;
  notYet.trainee = "x102";
  in.competence = {able, notYet};

  EXPECT_EQ(cohortReport(in).sections.front().tables.at(0).rows.at(0).at(3).str(), "1 of 2: x101");
  EXPECT_EQ(cohortReport(in).sections.front().tables.at(0).rows.at(2).at(3).str(), "did not train there");
  in.identity = ReportIdentity::kAggregated;
  EXPECT_EQ(cohortReport(in).sections.front().tables.at(0).rows.at(0).at(3).str(), "1 of 2");
}

TEST(CohortReport, WhatIsLeftOutStandsAfterThePageOfTheBoard) {
  CohortInputs in = demonstrationCohort();
  in.identity = ReportIdentity::kAggregated;
  const ReportModel report = cohortReport(in);
  EXPECT_TRUE(report.sections.at(0).onFirstPage);
  EXPECT_EQ(report.sections.at(1).title, "What is left out");
}

TEST(CohortReport, ShowsTheScoringSheetWithItsAnchorsAndWhatWasGivenForEachCriterion) {
  const CohortInputs in = demonstrationCohort();
  const ReportModel report = cohortReport(in);

  const ReportTable* sheet = tableOf(report, "table-sheet-1");
  ASSERT_NE(sheet, nullptr);
  EXPECT_THAT(sheet->title.str(), ::testing::HasSubstr("Arm sheet, revision 2"));
  EXPECT_EQ(sheet->rows.at(0).at(3).str(), "1: far too slow; 10: quick and steady");
  EXPECT_EQ(sheet->rows.at(1).at(2).str(), "0.5");
  const ReportTable* groups = tableOf(report, "table-criteria-1");
  ASSERT_NE(groups, nullptr);
  ASSERT_EQ(groups->rows.size(), 9U);
  ASSERT_EQ(in.summaries.size(), 9U);
  for (const std::vector<Text>& row : groups->rows) {
    for (const GroupSummary& summary : in.summaries) {
      if (in.groups[summary.group].name == row[0] && in.occasions[summary.occasion] == row[1]) {
        EXPECT_EQ(row[3].str(), formatFixed(summary.mean, 1));
        EXPECT_EQ(row[4].str(), formatFixed(0.5 * summary.mean + 1.0, 1));
      }
    }
  }
  const ReportTable* trainees = tableOf(report, "table-criteria-trainees-1");
  ASSERT_NE(trainees, nullptr);
  EXPECT_EQ(trainees->rows.size(), 90U);
  EXPECT_TRUE(trainees->individual);
}

std::size_t rowsOf(const CohortInputs& in, const std::string& section, const std::string& statistic) {
  const std::vector<CohortCsvRow> rows = cohortCsvRows(in);
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [&](const CohortCsvRow& row) {
    return row.section == section && row.statistic == statistic;
  }));
}

TEST(CohortCsv, HasEveryMarkOfACriterionTheAnchorsTheRevisionAndTheProgram) {
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

TEST(CohortReport, ACellThatLeadsBackShowsTheNumberThatItsLineHolds) {
  CohortInputs in = demonstrationCohort();
  std::map<std::string, std::string> values;
  for (const CohortCsvRow& row : cohortCsvRows(in)) {
    EXPECT_TRUE(values.try_emplace(numberAddress(row), row.value).second) << numberAddress(row);
  }
  std::size_t cells = 0;
  for (const ReportSection& section : cohortReport(in).sections) {
    for (const ReportTable& table : section.tables) {
      ASSERT_TRUE(table.origins.empty() || table.origins.size() == table.rows.size()) << table.id;
      for (std::size_t r = 0; r < table.origins.size(); ++r) {
        ASSERT_EQ(table.origins[r].size(), table.rows[r].size()) << table.id;
        for (std::size_t c = 0; c < table.origins[r].size(); ++c) {
          if (table.origins[r][c].empty()) {
            continue;
          }
          ++cells;
          const auto line = values.find(table.origins[r][c]);
          ASSERT_NE(line, values.end()) << table.origins[r][c];
          const std::string shown = table.rows[r][c].str();
          if (!shown.starts_with("<")) {  // "< 0.001"
            const std::size_t point = shown.find('.');
            const auto end = shown.find_first_not_of("0123456789", point + 1);
            const auto decimals = static_cast<double>(std::min(end, shown.size()) - point - 1);
            EXPECT_NEAR(std::stod(shown), std::stod(line->second), 0.51 * std::pow(10.0, -decimals))
                << table.id << ": " << line->first;
          }
        }
      }
    }
  }
  EXPECT_GT(cells, 400U);
}

TEST(CohortCsv, AMeanOfTwoMarksOfACriterionIsNotShownToWhoMayNotSeeMarks) {
  CohortInputs in = demonstrationCohort();
  in.singleMarks = false;
  std::size_t kept = 0;
  for (CriterionMark& mark : in.criterionMarks) {  // all but two could not be given
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

TEST(CohortReport, ComparesGroupsAndRatersWhenTheMarksAreGiven) {
  const CohortInputs in = demonstrationCohort();
  const ReportModel report = cohortReport(in);
  const auto section =
      std::find_if(report.sections.begin(), report.sections.end(),
                   [](const ReportSection& of) { return of.title == "Agreement and comparisons"; });
  ASSERT_NE(section, report.sections.end());
  std::vector<std::string> ids;
  for (const ReportTable& table : section->tables) {
    ids.push_back(table.id);
  }
  EXPECT_THAT(ids, ::testing::ElementsAre("table-agreement", "table-agreement-groups", "table-kappa",
                                          "table-means", "table-ancova", "table-mixed-anova", "table-gains",
                                          "table-friedman", "table-within-groups"));
  EXPECT_EQ(section->tables[0].rows.size(), 3U);
  EXPECT_EQ(section->tables[1].rows.size(), 9U);  // occasions x groups
  EXPECT_EQ(section->tables[3].rows.size(), 9U);
  EXPECT_EQ(section->tables[4].rows.size(), 3U);
  EXPECT_THAT(section->paragraphs[1].str(), ::testing::HasSubstr("Planned and used"));
  for (const ReportTable& table : section->tables) {
    for (const std::vector<Text>& row : table.rows) {
      for (const Text& cell : row) {
        EXPECT_THAT(cell.str(), ::testing::Not(::testing::HasSubstr("not defined")));
      }
    }
  }
}

TEST(CohortReport, HasTheAdditionsOfTheStatistician) {
  CohortInputs in = demonstrationCohort();
  in.trials[0].attempts = {{8.0, false}, {3.0, true}, {2.0, true}};
  const ReportModel report = cohortReport(in);

  const ReportFigure* forest = find(report, "figure-differences");
  ASSERT_NE(forest, nullptr);
  EXPECT_EQ(forest->categories.size(), 3U);  // pairs of three groups
  EXPECT_EQ(forest->references.at(0).value, 0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(forest->series[0].low[i], *forest->series[0].y[i]);
    EXPECT_GT(forest->series[0].high[i], *forest->series[0].y[i]);
  }
  ASSERT_NE(find(report, "figure-effects"), nullptr);
  ASSERT_NE(find(report, "figure-agreement"), nullptr);
  const ReportFigure* marks = find(report, "figure-marks");
  ASSERT_NE(marks, nullptr);
  EXPECT_EQ(marks->series.size(), 10U);      // raters
  EXPECT_EQ(marks->categories.size(), 30U);  // trainees
  const ReportFigure* severity = find(report, "figure-severity");
  ASSERT_NE(severity, nullptr);
  double sum = 0.0;
  for (const auto& offset : severity->series[0].y) {
    sum += *offset;
  }
  EXPECT_NEAR(sum, 0.0, 1e-12);  // complete marks: what one rater is above, the others are below
  ASSERT_NE(find(report, "figure-bland-altman"), nullptr);
  for (const char* id : {"figure-courses-1", "figure-courses-2", "figure-courses-3", "figure-classes"}) {
    EXPECT_NE(find(report, id), nullptr) << id;
  }
}

TEST(CohortReport, SaysWhoseLearningHasACurveAndWhyNot) {
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
  const ReportTable* learning = tableOf(report, "table-learning");
  ASSERT_NE(learning, nullptr);
  EXPECT_NEAR(std::stod(learning->rows[0].back().str()), 2.0, 0.1);
  EXPECT_EQ(learning->rows[1].back().str(), "not fitted: the values do not level off within these attempts");
  EXPECT_THAT(learning->notes.back().str(), ::testing::HasSubstr("fitted to 1 of 2 trainees"));
}

TEST(CohortReport, SaysHowManyRatersAreNeededAndWhatEachGroupGained) {
  const CohortInputs in = demonstrationCohort();
  const StudyAnalysis study = analyseStudy(in);
  const ReportModel report = cohortReport(in);

  const ReportTable* needed = tableOf(report, "table-raters-needed");
  ASSERT_NE(needed, nullptr);
  EXPECT_EQ(needed->rows.size(), 5U);  // 1, 2, 3, 5 and the ten of the study
  // One rater: dependability is ICC(2,1); all ten: ICC(2,k).
  const IccResult& icc = study.occasions.back().icc.value();
  EXPECT_EQ(needed->rows.front().at(1), formatFixed(icc.agreementSingle.estimate, 3));
  EXPECT_EQ(needed->rows.back().at(1), formatFixed(icc.agreementMean.estimate, 3));
  const ReportTable* rasch = tableOf(report, "table-rasch");
  ASSERT_NE(rasch, nullptr);
  ASSERT_EQ(rasch->rows.size(), 10U);
  double sum = 0.0;
  for (const std::vector<Text>& row : rasch->rows) {
    sum += std::stod(row.at(1).str());
  }
  EXPECT_NEAR(sum, 0.0, 0.06);  // ten severities of two decimals
  const ReportTable* within = tableOf(report, "table-within-groups");
  ASSERT_NE(within, nullptr);
  EXPECT_EQ(within->rows.at(0).at(3), "55.0");   // all ten gained: 1 + 2 + ... + 10
  EXPECT_EQ(within->rows.at(0).at(4), "0.002");  // 2 / 2^10
}

TEST(CohortReport, EveryFigureHasATableOfTheValuesThatAreDrawn) {
  const ReportModel report = cohortReport(demonstrationCohort());
  for (const ReportSection& section : report.sections) {
    for (const ReportFigure& figure : section.figures) {
      const ReportTable table = figureTable(figure);
      EXPECT_FALSE(table.rows.empty()) << figure.id;
      for (const std::vector<Text>& row : table.rows) {
        EXPECT_EQ(row.size(), table.columns.size()) << figure.id;
      }
    }
  }
  // The very numbers, to the last digit.
  const ReportFigure* means = find(report, "figure-16");
  EXPECT_EQ(std::stod(figureTable(*means).rows.at(0).at(1).str()), *means->series.at(0).y.at(0));
}

TEST(CohortReport, AnAggregatedReportHasNoLineAboutASinglePerson) {
  CohortInputs in = demonstrationCohort();
  in.identity = ReportIdentity::kAggregated;
  in.trainees.erase(in.trainees.begin() + 4, in.trainees.begin() + 10);  // four are left of the first group

  const ReportModel report = cohortReport(in);
  std::string all;
  for (const ReportSection& section : report.sections) {
    for (const Text& paragraph : section.paragraphs) {
      all += paragraph.str();
    }
    for (const ReportFigure& figure : section.figures) {
      EXPECT_FALSE(figure.individual) << figure.id;
      for (const FigureSeries& series : figure.series) {
        all += series.name.str();
      }
      for (const Text& category : figure.categories) {
        all += category.str();
      }
    }
    for (const ReportTable& table : section.tables) {
      for (const std::vector<Text>& row : table.rows) {
        for (const Text& cell : row) {
          all += cell.str();
        }
      }
    }
  }
  for (const CohortTrainee& trainee : in.trainees) {
    EXPECT_EQ(all.find(trainee.code), std::string::npos);
  }
  EXPECT_EQ(all.find("R101"), std::string::npos);
  EXPECT_NE(all.find("Group 1 is left out: it has fewer than 5 trainees"), std::string::npos);
  EXPECT_EQ(find(report, "figure-20"), nullptr);
  ASSERT_NE(find(report, "figure-23"), nullptr);
  EXPECT_EQ(find(report, "figure-23")->series.size(), 2U);
  for (const CohortCsvRow& row : cohortCsvRows(in)) {
    EXPECT_TRUE(row.item == "all" || row.section == "scoring_sheet") << "the sheet is about nobody";
    EXPECT_NE(row.group, "Group 1");
  }
}

TEST(CohortReport, SmallCountsAreNotShownBesideOthers) {
  EXPECT_EQ(
      countsText({{Text::verbatim("female"), 4}, {Text::verbatim("male"), 26}}, ReportIdentity::kAggregated),
      "not shown (fewer than 5)");
  EXPECT_EQ(
      countsText({{Text::verbatim("female"), 5}, {Text::verbatim("male"), 25}}, ReportIdentity::kAggregated),
      "female 5, male 25");
  EXPECT_EQ(countsText({{Text::verbatim("female"), 4}, {Text::verbatim("male"), 26}}, ReportIdentity::kCoded),
            "female 4, male 26");
}

TEST(CohortReport, SaysWhatWasFrozenWhenAndWhatDeviated) {
  CohortInputs in = demonstrationCohort();
  in.freeze = CohortFreeze{"final", std::string(64, 'b'), 1'767'600'000'000'000, "admin", false};
  in.deviations = {{1'767'600'000'000'000, "x101", "late", "came twenty minutes late"}};
  in.doses = {{"x101", 38.5, 0.0, 5.0}};

  const ReportModel report = cohortReport(in);

  EXPECT_THAT(report.facts, ::testing::Contains(
                                ::testing::Pair(Text::verbatim("Frozen data set"), Text::verbatim("final"))));
  EXPECT_THAT(report.facts, ::testing::Contains(::testing::Pair(
                                Text::verbatim("Frozen"), Text::verbatim("2026-01-05 08:00 UTC by admin"))));
  bool deviation = false;
  bool dose = false;
  for (const ReportSection& section : report.sections) {
    for (const ReportTable& table : section.tables) {
      if (table.id == "table-deviations") {
        deviation = table.rows.at(0).at(3) == "came twenty minutes late";
      }
      if (table.id == "table-dose") {
        dose = table.rows.at(0).at(3) == "38.5";
      }
    }
  }
  EXPECT_TRUE(deviation);
  EXPECT_TRUE(dose);
}

TEST(CohortReport, SingleMarksAreLeftOutForWhoMayNotSeeThem) {
  CohortInputs in = demonstrationCohort();
  in.singleMarks = false;
  const ReportModel report = cohortReport(in);
  EXPECT_EQ(find(report, "figure-marks"), nullptr);
  EXPECT_EQ(find(report, "figure-bland-altman"), nullptr);
  EXPECT_NE(find(report, "figure-severity"), nullptr);
  for (const CohortCsvRow& row : cohortCsvRows(in)) {
    EXPECT_NE(row.statistic, "mark");
  }
}

std::string textOf(const ReportModel& report) {
  std::string all;
  for (const ReportSection& section : report.sections) {
    for (const Text& paragraph : section.paragraphs) {
      all += paragraph.str() + "\n";
    }
  }
  return all;
}

/// Takes marks out and computes the scores anew.
CohortInputs without(const std::function<bool(const TrainingMark&)>& missing) {
  CohortInputs in = demonstrationCohort();
  std::erase_if(in.trainingMarks, missing);
  in.scores = traineeScores(in.trainingScale, in.trainingMarks);
  in.summaries = groupSummaries(in.trainingScale, in.trainingMarks);
  return in;
}

TEST(CohortReport, OneMissingMarkTakesNothingOut) {
  const std::string whose = demonstrationCohort().trainingMarks.back().trainee;
  const std::string by = demonstrationCohort().trainingMarks.back().rater;
  const CohortInputs in = without([&](const TrainingMark& mark) {
    return mark.trainee == whose && mark.rater == by && mark.occasion == 2;
  });
  const ReportModel report = cohortReport(in);
  for (const char* id : {"table-ancova", "table-mixed-model", "table-bounds", "table-missing",
                         "table-mixed-anova", "table-gains", "table-agreement"}) {
    const ReportTable* table = tableOf(report, id);
    ASSERT_NE(table, nullptr) << id;
    for (const std::vector<Text>& row : table->rows) {
      for (const Text& cell : row) {
        EXPECT_THAT(cell.str(), ::testing::Not(::testing::HasSubstr("not defined"))) << id;
      }
    }
  }
  const ReportTable& agreement = *tableOf(report, "table-agreement");
  ASSERT_EQ(agreement.rows.size(), 4U);  // the last occasion has a second line
  EXPECT_EQ(agreement.rows[2][1].str(), "29");
  EXPECT_EQ(agreement.rows[3][1].str(), "30");
  EXPECT_EQ(agreement.provenance.missing, 1);
  EXPECT_EQ(tableOf(report, "table-missing")->rows.size(), 1U);
  EXPECT_EQ(tableOf(report, "table-missing")->rows[0][0].str(), whose);
  EXPECT_EQ(tableOf(report, "table-missing")->rows[0][4].str(), "yes");
  EXPECT_THAT(textOf(report), ::testing::HasSubstr("1 of 600 marks of the first and the last occasion are "
                                                   "missing, so the linear mixed model is the primary"));
  EXPECT_THAT(textOf(report), ::testing::Not(::testing::HasSubstr("Left out of both")));
  ASSERT_NE(find(report, "figure-differences"), nullptr);
  EXPECT_EQ(find(report, "figure-differences")->series.size(), 2U);

  // The first page answers by the comparison that is primary.
  const ReportSection& board = report.sections.front();
  EXPECT_EQ(board.figures[0].series[0].y, find(report, "figure-differences")->series[0].y);
  EXPECT_THAT(board.figures[0].provenance.formula.str(), ::testing::HasSubstr("mixed model"));
  EXPECT_EQ(board.figures[0].provenance.missing, 1);
  EXPECT_THAT(board.paragraphs[3].str(), ::testing::HasSubstr("1 of 600 marks are missing, so the answer"));
}

TEST(CohortReport, ARaterWhoIsMissingAsAWholeIsSaidAndTakesNoAgreementOut) {
  const std::string by = demonstrationCohort().trainingMarks.back().rater;
  const CohortInputs in =
      without([&](const TrainingMark& mark) { return mark.rater == by && mark.occasion == 2; });
  const ReportModel report = cohortReport(in);
  const std::string said = textOf(report);
  EXPECT_THAT(said, ::testing::HasSubstr("Planned and used"));
  EXPECT_THAT(said, ::testing::Not(::testing::HasSubstr("No mark of the first and the last occasion")));
  EXPECT_THAT(said, ::testing::HasSubstr("but none after 40 min: " + by));
  const ReportTable& agreement = *tableOf(report, "table-agreement");
  ASSERT_EQ(agreement.rows.size(), 3U);
  EXPECT_EQ(agreement.rows[2][1].str(), "30");  // nine raters scored everybody
  EXPECT_EQ(agreement.provenance.missing, 0);
  EXPECT_EQ(tableOf(report, "table-raters-needed")->rows.back().at(0).str(), "10");
  EXPECT_EQ(tableOf(report, "table-raters-needed")->provenance.n, 270);
  const auto& raters = tableOf(report, "table-raters")->rows;
  const auto absent =
      std::find_if(raters.begin(), raters.end(), [&](const auto& row) { return row[0] == by; });
  ASSERT_NE(absent, raters.end());
  EXPECT_THAT((*absent)[3].str(), ::testing::HasSubstr("too few trainees"));
  EXPECT_THAT(raters.front()[3].str(), ::testing::HasSubstr(" to "));
}

TEST(CohortReport, MethodsNameTheComparisonThatIsUsed) {
  EXPECT_THAT(textOf(cohortReport(demonstrationCohort())),
              ::testing::HasSubstr("Groups are compared by an analysis of covariance"));
  const TrainingMark lost = demonstrationCohort().trainingMarks.back();
  const std::string holed = textOf(cohortReport(without([&](const TrainingMark& mark) {
    return mark.trainee == lost.trainee && mark.rater == lost.rater && mark.occasion == 2;
  })));
  EXPECT_THAT(holed, ::testing::HasSubstr("Groups are compared by a linear mixed model"));
  EXPECT_THAT(holed, ::testing::Not(::testing::HasSubstr("compared by an analysis of covariance")));
  const std::string none = textOf(
      cohortReport(without([](const TrainingMark& mark) { return mark.group > 0 && mark.occasion == 2; })));
  EXPECT_THAT(none, ::testing::HasSubstr("the groups are not compared"));
}

TEST(CohortReport, LabelsTheIntervalsOfTheAnswer) {
  const ReportSection board = cohortReport(demonstrationCohort()).sections.front();
  EXPECT_THAT(board.paragraphs[2].str(), ::testing::HasSubstr("by itself"));
  EXPECT_THAT(board.figures[0].notes.at(0).str(), ::testing::HasSubstr("not adjusted"));
}

TEST(CohortReport, NamesWhoIsLeftOutByCode) {
  const std::string whose = demonstrationCohort().trainees[3].code;
  CohortInputs in =
      without([&](const TrainingMark& mark) { return mark.trainee == whose && mark.occasion == 2; });
  const ReportModel report = cohortReport(in);
  EXPECT_THAT(textOf(report), ::testing::HasSubstr("without any mark at one of the two: " + whose));
  EXPECT_EQ(tableOf(report, "table-ancova")->provenance.n, 29);
  EXPECT_EQ(tableOf(report, "table-ancova")->provenance.missing, 10);
  EXPECT_EQ(tableOf(report, "table-missing")->rows[0][4].str(), "no");
  EXPECT_THAT(tableOf(report, "table-mixed-anova")->notes.back().str(), ::testing::HasSubstr(whose));

  in.identity = ReportIdentity::kAggregated;
  const ReportModel aggregated = cohortReport(in);
  EXPECT_EQ(textOf(aggregated).find(whose), std::string::npos);
  EXPECT_EQ(tableOf(aggregated, "table-missing"), nullptr);
  EXPECT_EQ(find(aggregated, "figure-residuals"), nullptr);
}

std::int64_t csvCount(const CohortInputs& in, const std::string& statistic) {
  const std::vector<CohortCsvRow> rows = cohortCsvRows(in);
  return std::count_if(rows.begin(), rows.end(),
                       [&](const CohortCsvRow& row) { return row.statistic == statistic; });
}

TEST(CohortReport, SlopesThatDifferAreAnalysedAsWell) {
  CohortInputs in = demonstrationCohort();
  EXPECT_EQ(tableOf(cohortReport(in), "table-slopes"), nullptr);
  std::map<std::string, double> before;
  for (const TraineeScore& score : in.scores) {
    if (score.occasion == 0) {
      before[score.trainee] = score.score;
    }
  }
  for (TrainingMark& mark : in.trainingMarks) {  // the first group: whoever was bad before is good at the end
    if (mark.group == 0 && mark.occasion == 2) {
      mark.steps = std::clamp<std::int64_t>(90 - static_cast<std::int64_t>(8.0 * before[mark.trainee]) +
                                                static_cast<std::int64_t>(mark.rater.back() % 3),
                                            in.trainingScale.lo, in.trainingScale.hi);
    }
  }
  in.scores = traineeScores(in.trainingScale, in.trainingMarks);
  in.summaries = groupSummaries(in.trainingScale, in.trainingMarks);
  const ReportModel report = cohortReport(in);
  const ReportTable* slopes = tableOf(report, "table-slopes");
  ASSERT_NE(slopes, nullptr);
  EXPECT_EQ(slopes->rows.size(), 9U);  // pairs x stated scores before
  EXPECT_THAT(tableOf(report, "table-ancova")->notes[1].str(), ::testing::HasSubstr("The slopes differ"));
  EXPECT_THAT(report.sections.front().paragraphs[3].str(),
              ::testing::HasSubstr("The difference depends on the score before"));
  EXPECT_EQ(csvCount(in, "separate_slopes_difference"), 9);
  EXPECT_EQ(csvCount(in, "separate_slope"), 3);
}

TEST(CohortReport, ShowsKappaOfMarksInWholePoints) {
  CohortInputs in = demonstrationCohort();
  const ReportModel usual = cohortReport(in);
  const ReportTable* table = tableOf(usual, "table-kappa");
  ASSERT_NE(table, nullptr);
  ASSERT_EQ(table->rows.size(), in.occasions.size());
  EXPECT_EQ(table->rows[0][1].str(), "45");  // pairs of ten raters

  const std::string first = in.trainingMarks.front().rater;
  std::map<std::pair<std::string, std::size_t>, std::int64_t> marks;  // by trainee and occasion
  for (const TrainingMark& mark : in.trainingMarks) {
    if (mark.rater == first) {
      marks[{mark.trainee, mark.occasion}] = mark.steps;
    }
  }
  for (TrainingMark& mark : in.trainingMarks) {  // all give what the first gives, but within the same point
    const std::int64_t whole = marks.at({mark.trainee, mark.occasion}) / 10 * 10;
    mark.steps = std::clamp(whole + (mark.rater == first ? 0 : 4), in.trainingScale.lo, in.trainingScale.hi);
  }
  in.scores = traineeScores(in.trainingScale, in.trainingMarks);
  in.summaries = groupSummaries(in.trainingScale, in.trainingMarks);
  const ReportModel alike = cohortReport(in);
  EXPECT_EQ(tableOf(alike, "table-kappa")->rows[0][3].str(), "1.000 (1.000 to 1.000)");
  EXPECT_EQ(tableOf(alike, "table-kappa")->rows[0][4].str(), "100 %");
}

TEST(CohortReport, TestsEquivalenceWithTheMarginOfThePlanAndWithoutOneSaysSo) {
  CohortInputs in = demonstrationCohort();
  EXPECT_EQ(tableOf(cohortReport(in), "table-equivalence"), nullptr);
  EXPECT_THAT(textOf(cohortReport(in)), ::testing::HasSubstr("No margin was planned"));

  const Outcome<Ancova> model = analyseStudy(in).ancova;
  const AdjustedDifference& pair = model->pairs.front();
  const double reach = tQuantile(0.95, model->residualDf) * pair.error;
  for (const bool wide : {false, true}) {
    in.equivalenceMargin = std::abs(pair.difference) + reach * (wide ? 1.01 : 0.99);
    const ReportModel report = cohortReport(in);
    const ReportTable* table = tableOf(report, "table-equivalence");
    ASSERT_NE(table, nullptr);
    ASSERT_EQ(table->rows.size(), 3U);
    EXPECT_EQ(table->rows[0][3].str(), wide ? "yes" : "not shown");
    EXPECT_THAT(textOf(report), ::testing::Not(::testing::HasSubstr("No margin was planned")));
  }

  const TrainingMark lost = in.trainingMarks.back();
  CohortInputs holed = without([&](const TrainingMark& mark) {
    return mark.trainee == lost.trainee && mark.rater == lost.rater && mark.occasion == 2;
  });
  holed.equivalenceMargin = 1.0;
  const ReportModel report = cohortReport(holed);
  EXPECT_THAT(tableOf(report, "table-equivalence")->provenance.formula.str(), ::testing::HasSubstr("mixed"));
}

TEST(CohortReport, ShowsTheResidualsOfTheComparison) {
  const ReportModel report = cohortReport(demonstrationCohort());
  for (const char* id : {"figure-residuals", "figure-qq"}) {
    const ReportFigure* figure = find(report, id);
    ASSERT_NE(figure, nullptr) << id;
    std::size_t points = 0;
    double sum = 0.0;
    for (const FigureSeries& series : figure->series) {
      ASSERT_EQ(series.x.size(), series.y.size());
      points += series.x.size();
      for (const std::optional<double>& residual : series.y) {
        sum += *residual;
      }
    }
    EXPECT_EQ(points, 30U);
    EXPECT_NEAR(sum, 0.0, 1e-9);
  }
}

TEST(CohortReport, RefusesInputsThatDoNotBelongTogether) {
  CohortInputs in = demonstrationCohort();
  in.ratings.pop_back();
  EXPECT_THROW((void)cohortReport(in), Error);
  in = demonstrationCohort();
  in.trainees[0].group = 7;
  EXPECT_THROW((void)cohortReport(in), Error);
}

TEST(FormatUtc, KnowsLeapDaysAndTimesBefore1970) {
  EXPECT_EQ(formatUtc(1'767'600'000'000'000), "2026-01-05 08:00 UTC");  // date -u -d @1767600000
  EXPECT_EQ(formatUtc(951'782'400'000'000), "2000-02-29 00:00 UTC");    // date -u -d @951782400
  EXPECT_EQ(formatUtc(-60'000'000), "1969-12-31 23:59 UTC");
}

TEST(CohortReport, LeavesOutSectionsWithoutData) {
  CohortInputs in;
  in.instrument = paperInstrument();
  const ReportModel report = cohortReport(in);
  EXPECT_EQ(report.sections.size(), 2U);  // methods and provenance
}

/// Three untwistings of the first group in one phase: two undone, one of them after a relapse; in the third
/// blood never came back.
CohortInputs withUntwistings() {
  CohortInputs in = demonstrationCohort();
  const auto add = [&in](std::map<std::string, double> values) {
    TrialSummaryRow trial;
    trial.trialId = "untwisting-" + std::to_string(in.trials.size());
    trial.trainee = in.trainees.front().code;
    trial.phase = Text::tr("volvulus");
    trial.samples = 1000;
    trial.detorsion = std::move(values);
    in.trials.push_back(trial);
  };
  add({{"detorse.done", 1.0},
       {"detorse.relapse", 0.0},
       {"detorse.first_direction", 1.0},
       {"detorse.time_to_flow", 20.0},
       {"detorse.dose", 0.2},
       {"detorse.overload_time", 0.0},
       {"detorse.regrips", 3.0},
       {"detorse.least_regrips", 2.0},
       {"detorse.slip_back", 0.0}});
  add({{"detorse.done", 1.0},
       {"detorse.relapse", 1.0},
       {"detorse.first_direction", 0.0},
       {"detorse.time_to_flow", 40.0},
       {"detorse.dose", 0.4},
       {"detorse.overload_time", 0.8},
       {"detorse.regrips", 5.0},
       {"detorse.least_regrips", 2.0},
       {"detorse.slip_back", 1.0}});
  add({{"detorse.done", 0.0},
       {"detorse.dose", 1.2},
       {"detorse.overload_time", 0.0},
       {"detorse.regrips", 0.0},
       {"detorse.least_regrips", 1.0},
       {"detorse.slip_back", 0.0}});
  return in;
}

TEST(CohortReport, UntwistingsHaveATableOfTheirOwn) {
  const ReportModel report = cohortReport(withUntwistings());

  const ReportTable* table = tableOf(report, "table-untwistings");
  ASSERT_NE(table, nullptr);
  ASSERT_EQ(table->rows.size(), 1U);
  std::vector<std::string> cells;
  for (const Text& cell : table->rows.front()) {
    cells.push_back(cell.str());
  }
  // Medians: time of 20 and 40; dose of .2, .4, 1.2; beyond the least of 1, 3, -1; slip back of 0, 0, 57.3
  // degrees.
  EXPECT_THAT(cells, ::testing::ElementsAre(demonstrationCohort().groups.front().name.str(), "volvulus", "3",
                                            "2 of 3", "1 of 2", "1 of 2", "1 of 3", "2 of 3", "30.0", "0.40",
                                            "1.0", "0.0"));
  EXPECT_EQ(tableOf(cohortReport(demonstrationCohort()), "table-untwistings"), nullptr);
}

TEST(CohortReport, UntwistingsEnterNeitherTheLearningOfTwistsNorTheirTable) {
  const ReportModel with = cohortReport(withUntwistings());
  const ReportModel without = cohortReport(demonstrationCohort());

  EXPECT_EQ(with.sections.size(), without.sections.size());  // no section about learning because of them
  const ReportTable* trials = tableOf(with, "table-trials");
  ASSERT_NE(trials, nullptr);
  EXPECT_EQ(trials->rows.size(), tableOf(without, "table-trials")->rows.size());
  EXPECT_EQ(trials->provenance.n, tableOf(without, "table-trials")->provenance.n);
}

TEST(CohortReport, ACohortThatOnlyUndoesOrgansHasNoTableOfTwists) {
  CohortInputs in = withUntwistings();
  std::erase_if(in.trials, [](const TrialSummaryRow& trial) { return trial.detorsion.empty(); });

  const ReportModel report = cohortReport(in);

  EXPECT_EQ(tableOf(report, "table-trials"), nullptr);
  EXPECT_NE(tableOf(report, "table-untwistings"), nullptr);
}

TEST(CohortCsv, HasARowForEachMetricOfAnUntwisting) {
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
  EXPECT_EQ(twists, 0);  // an untwisting has none
}

TEST(CohortCsv, IsTidyCompleteAndTheSameEachTime) {
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

TEST(CohortCsv, HoldsWhatTheTablesOfTheStudyShow) {
  CohortInputs in = demonstrationCohort();
  in.equivalenceMargin = 1.0;
  // Agreement: three occasions, and within each of three groups.
  EXPECT_EQ(csvCount(in, "sem_of_mean"), 12);
  EXPECT_EQ(csvCount(in, "icc_2_k_lower_95"), 12);
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
      if (row.statistic == statistic) {
        return row.value;
      }
    }
    return std::string();
  };
  EXPECT_EQ(wordOf(in, "primary_analysis"), "analysis of covariance");
  EXPECT_EQ(wordOf(in, "marks_missing"), "0");

  const TrainingMark lost = in.trainingMarks.back();
  const CohortInputs holed = without([&](const TrainingMark& mark) {
    return mark.trainee == lost.trainee && mark.rater == lost.rater && mark.occasion == 2;
  });
  EXPECT_EQ(wordOf(holed, "planned_analysis"), "analysis of covariance");
  EXPECT_EQ(wordOf(holed, "primary_analysis"), "linear mixed model");
  EXPECT_EQ(wordOf(holed, "marks_missing"), "1");
  EXPECT_EQ(csvCount(holed, "reml_mean"), 1);
  EXPECT_EQ(csvCount(holed, "bound_worst_lower_95"), 3);

  in.identity = ReportIdentity::kAggregated;
  EXPECT_EQ(csvCount(in, "ancova_residual"), 0);
  EXPECT_EQ(csvCount(in, "limit_of_agreement_upper"), 0);
}

TEST(CohortCsvText, QuotesFieldsThatHoldCommasAndQuotes) {
  CohortCsvRow row;
  row.item = "a,b";
  row.flags = "say \"so\"";
  EXPECT_THAT(cohortCsvText({row}), ::testing::EndsWith("\r\n,\"a,b\",,,,,,,,\"say \"\"so\"\"\"\r\n"));
}

TEST(FormatFixed, IsIndependentOfLocaleAndHasNoNegativeZero) {
  EXPECT_EQ(formatFixed(1234.5, 2), "1234.50");
  EXPECT_EQ(formatFixed(-0.001, 2), "0.00");
  EXPECT_EQ(formatFixed(-0.006, 2), "-0.01");
  EXPECT_EQ(formatFixed(std::optional<double>(), 2), "not defined");
  EXPECT_EQ(formatExact(0.1), "0.1");
  EXPECT_EQ(formatP(0.0001), "< 0.001");
}

}  // namespace
}  // namespace torsio
