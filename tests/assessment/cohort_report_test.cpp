// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/cohort_report.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/results/aggregated_inputs.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/figure_table.h"
#include "assessment/results/number_format.h"
#include "sim/core/error.h"
#include "sim/core/foreign_recording.h"
#include "tests/support/demonstration_cohort.h"
#include "tests/support/strange_cohorts.h"

namespace torsio {
namespace {

using testing::demonstrationCohort;
using testing::figureNamed;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::tableNamed;
using testing::withUntwistings;

TEST(CohortReport, ContainsEveryFigureOfThePaperWithMatchingSeriesAndCategories) {
  const ReportModel report = cohortReport(demonstrationCohort());

  for (const char* id : {"figure-15", "figure-16", "figure-17", "figure-18", "figure-19", "figure-20",
                         "figure-21", "figure-22", "figure-23"}) {
    const ReportFigure* figure = figureNamed(report, id);
    ASSERT_NE(figure, nullptr) << id;
    EXPECT_EQ(figure->series.size(), 3U) << id;
    EXPECT_FALSE(figure->yLabel.empty());
    EXPECT_GT(figure->provenance.n.str(), "0") << id;
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
  EXPECT_THAT(figureNamed(report, "figure-17")->title.str(),
              ::testing::HasSubstr("about the weighted mean, divisor n"));
  EXPECT_THAT(figureNamed(report, "figure-23")->title.str(), ::testing::HasSubstr("divisor n"));
  EXPECT_EQ(figureNamed(report, "figure-18")->categories.size(), 10U);
}

TEST(CohortReport, HasConsistentTablesWithUniqueNames) {
  const ReportModel report = cohortReport(demonstrationCohort());
  std::set<std::string> ids;
  int tables = 0;
  for (const ReportSection& section : report.sections) {
    for (const ReportTable& table : section.tables) {
      ++tables;
      EXPECT_TRUE(ids.insert(table.id).second) << table.id;
      EXPECT_FALSE(table.rows.empty()) << table.id;
      for (const std::vector<ReportCell>& row : table.rows) {
        EXPECT_EQ(row.size(), table.columns.size()) << table.id;
      }
    }
  }
  EXPECT_GE(tables, 9);
  EXPECT_TRUE(report.demonstration);
  EXPECT_EQ(report.sections.at(0).title, "At a glance");
  EXPECT_TRUE(std::any_of(report.sections.begin(), report.sections.end(), [](const ReportSection& section) {
    return section.title == "Annex: What was simulated" && !section.paragraphs.empty();
  }));
}

TEST(CohortReport, StartsWithAPageThatABoardReadsInAMinute) {
  CohortInputs in = demonstrationCohort();
  in.deviations = {{0, "T-01", "late", "came late"}};
  const ReportSection board = cohortReport(in).sections.front();

  ASSERT_GE(board.paragraphs.size(), 4U);
  EXPECT_THAT(board.paragraphs[0].str(),
              ::testing::HasSubstr("do the scores at the end (after 40 min) differ"));
  EXPECT_THAT(
      board.paragraphs[1].str(),
      ::testing::HasSubstr("30 trainees in 3 groups, 30 of them compared at the end, 0 of them withdrew; "
                           "10 physicians gave 900 marks; "
                           "1 deviation from"));
  ASSERT_EQ(board.figures.size(), 1U);
  EXPECT_EQ(board.figures[0].id, "figure-answer");
  const ReportModel whole = cohortReport(in);
  const ReportFigure* differences = figureNamed(whole, "figure-differences");
  ASSERT_NE(differences, nullptr);
  EXPECT_EQ(board.figures[0].series[0].y, differences->series[0].y) << "one number, two places";
  std::size_t excluded = 0;
  for (std::size_t i = 0; i < differences->series[0].y.size(); ++i) {
    excluded += differences->series[0].low[i] > 0.0 || differences->series[0].high[i] < 0.0 ? 1 : 0;
  }
  const std::string answer = board.paragraphs[2].str();
  EXPECT_EQ(answer.find("Every interval includes zero") != std::string::npos,
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
  able.attempts = 30;
  CohortCompetence notYet;
  notYet.trainee = "x102";
  in.competence = {able, notYet};

  EXPECT_EQ(cohortReport(in).sections.front().tables.at(0).rows.at(0).at(5).str(), "1 of 2: x101");
  EXPECT_EQ(cohortReport(in).sections.front().tables.at(0).rows.at(2).at(5).str(), "no recorded run");
  CohortInputs unjudged = in;
  unjudged.competence.clear();
  EXPECT_EQ(cohortReport(unjudged).sections.front().tables.at(0).rows.at(0).at(3).str(), "1");
  EXPECT_EQ(cohortReport(unjudged).sections.front().tables.at(0).rows.at(0).at(5).str(), "no run judged");
  in.identity = ReportIdentity::kAggregated;
  EXPECT_EQ(cohortReport(in).sections.front().tables.at(0).rows.at(0).at(5).str(), "not shown");
}

TEST(CohortReport, ListsOmissionsAfterTheFirstPage) {
  CohortInputs in = demonstrationCohort();
  in.identity = ReportIdentity::kAggregated;
  const ReportModel report = cohortReport(in);
  EXPECT_TRUE(report.sections.at(0).onFirstPage);
  EXPECT_EQ(report.sections.at(1).title, "What is left out");
}

TEST(CohortReport, ShowsTheScoringSheetWithItsAnchorsAndTheMarksByCriterion) {
  const CohortInputs in = demonstrationCohort();
  const ReportModel report = cohortReport(in);

  const ReportTable* sheet = tableNamed(report, "table-sheet-1");
  ASSERT_NE(sheet, nullptr);
  EXPECT_THAT(sheet->title.str(), ::testing::HasSubstr("Arm sheet, revision 2"));
  EXPECT_EQ(sheet->rows.at(0).at(3).str(), "1: far too slow; 10: quick and steady");
  EXPECT_EQ(sheet->rows.at(1).at(2).str(), "0.5");
  const ReportTable* groups = tableNamed(report, "table-criteria-1");
  ASSERT_NE(groups, nullptr);
  ASSERT_EQ(groups->rows.size(), 9U);
  ASSERT_EQ(in.summaries.size(), 9U);
  for (const std::vector<ReportCell>& row : groups->rows) {
    for (const GroupSummary& summary : in.summaries) {
      if (in.groups[summary.group].name == row[0] && in.occasions[summary.occasion] == row[1]) {
        EXPECT_EQ(row[3].str(), formatFixed(summary.mean, 1));
        EXPECT_EQ(row[4].str(), formatFixed(0.5 * summary.mean + 1.0, 1));
      }
    }
  }
  const ReportTable* trainees = tableNamed(report, "table-criteria-trainees-1");
  ASSERT_NE(trainees, nullptr);
  EXPECT_EQ(trainees->rows.size(), 90U);
  EXPECT_TRUE(trainees->individual);
}

TEST(CohortReport, ATracedCellShowsTheNumberOfItsLine) {
  CohortInputs in = demonstrationCohort();
  std::map<std::string, std::string> values;
  for (const CohortCsvRow& row : cohortCsvRows(in)) {
    EXPECT_TRUE(values.try_emplace(numberAddress(row), row.value).second) << numberAddress(row);
  }
  std::size_t cells = 0;
  const ReportModel report = cohortReport(in);
  for (const ReportSection& section : report.sections) {
    for (const ReportTable& table : section.tables) {
      for (const std::vector<ReportCell>& row : table.rows) {
        for (std::size_t c = 0; c < row.size(); ++c) {
          static const std::set<std::string> kNumbersOfValues = {"Trainees", "Marks",          "n",
                                                                 "Attempts", "Marks compared", "Raters"};
          if (row[c].key == nullptr || kNumbersOfValues.contains(table.columns[c].str())) {
            continue;
          }
          auto line = values.find(keyAddress(*row[c].key));
          for (const std::size_t level : {std::size_t{3}, std::size_t{0}}) {  // the lower end of an interval
            if (std::string address = keyAddress(*row[c].key); line == values.end()) {
              line = values.find(address.insert(address.size() - level, "_lower"));
            }
          }
          ASSERT_NE(line, values.end()) << table.id << ": " << row[c].str();
          if (line->second.empty() || line->second.find_first_not_of("0123456789.e+-") != std::string::npos) {
            continue;  // words, or undefined
          }
          ++cells;
          std::string shown = row[c].str();
          if (shown.ends_with(" %")) {
            EXPECT_NEAR(std::stod(shown), 100.0 * std::stod(line->second), 0.51) << table.id;
          } else if (!shown.starts_with("<")) {  // "< 0.001"
            shown.erase(0, shown.starts_with("[") ? 1 : 0);
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
  EXPECT_GT(cells, 600U);
}

TEST(CohortReport, EveryFigureHasATableOfItsValues) {
  const ReportModel report = cohortReport(demonstrationCohort());
  for (const ReportSection& section : report.sections) {
    for (const ReportFigure& figure : section.figures) {
      const ReportTable table = figureTable(figure);
      EXPECT_FALSE(table.rows.empty()) << figure.id;
      for (const std::vector<ReportCell>& row : table.rows) {
        EXPECT_EQ(row.size(), table.columns.size()) << figure.id;
      }
    }
  }
  // Exactly the same numbers.
  const ReportFigure* means = figureNamed(report, "figure-16");
  EXPECT_EQ(std::stod(figureTable(*means).rows.at(0).at(1).str()), *means->series.at(0).y.at(0));
}

TEST(CohortReport, AFiguresColumnHasTheDecimalsThatItsNumbersNeed) {
  ReportFigure figure;
  figure.kind = FigureKind::kGroupedBars;
  figure.categories = {Text::verbatim("a"), Text::verbatim("b"), Text::verbatim("c")};
  using Values = std::vector<std::optional<double>>;
  for (const Values& values :
       {Values{6.0, 10.0, 0.0}, Values{8.73, -8.5, std::nullopt}, Values{1.0 / 3.0, 100.0, 1e-9}}) {
    figure.series.emplace_back();
    figure.series.back().y = values;
  }

  const ReportTable table = figureTable(figure, 4);

  const auto column = [&](std::size_t c) {
    return table.rows[0][c].str() + " " + table.rows[1][c].str() + " " + table.rows[2][c].str();
  };
  EXPECT_EQ(column(1), "6 10 0");
  EXPECT_EQ(column(2), "8.73 -8.50 ");
  EXPECT_EQ(column(3), "0.3333 100.0000 0.0000");
}

TEST(CohortReport, TheValuesOfALineIncludeItsIntervals) {
  ReportFigure figure;
  figure.kind = FigureKind::kLines;
  figure.series = {{.name = Text::verbatim("Group 1"),
                    .x = {1.0, 2.0},
                    .y = {5.5, 4.0},
                    .low = {4.5, 3.0},
                    .high = {6.5, 5.0}},
                   {.name = Text::verbatim("limit"), .x = {1.0}, .y = {2.0}}};

  const ReportTable table = figureTable(figure, 4);

  ASSERT_EQ(table.columns.size(), 5U);
  EXPECT_EQ(table.rows.at(0).at(3), "4.5");
  EXPECT_EQ(table.rows.at(1).at(4), "5.0");
  EXPECT_EQ(table.rows.at(2).at(3), "");
}

TEST(CohortReport, AnAggregatedReportContainsNoIndividual) {
  CohortInputs in = demonstrationCohort();
  in.identity = ReportIdentity::kAggregated;
  in.trainees.erase(in.trainees.begin() + 4, in.trainees.begin() + 10);  // four of the first group remain

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
      for (const std::vector<ReportCell>& row : table.rows) {
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
  EXPECT_EQ(figureNamed(report, "figure-20"), nullptr);
  ASSERT_NE(figureNamed(report, "figure-23"), nullptr);
  EXPECT_EQ(figureNamed(report, "figure-23")->series.size(), 2U);
  for (const CohortCsvRow& row : cohortCsvRows(in)) {
    EXPECT_TRUE(row.item == "all" || row.section == "scoring_sheet" || row.section == "record")
        << "sheet and record are about nobody";
    EXPECT_NE(row.group, "Group 1");
  }
}

TEST(CohortReport, SmallCountsAreSuppressed) {
  EXPECT_EQ(
      countsText({{Text::verbatim("female"), 4}, {Text::verbatim("male"), 26}}, ReportIdentity::kAggregated),
      "not shown (fewer than 5)");
  EXPECT_EQ(
      countsText({{Text::verbatim("female"), 5}, {Text::verbatim("male"), 25}}, ReportIdentity::kAggregated),
      "female 5, male 25");
  EXPECT_EQ(countsText({{Text::verbatim("female"), 4}, {Text::verbatim("male"), 26}}, ReportIdentity::kCoded),
            "female 4, male 26");
}

TEST(CohortReport, StatesTheFreezeAndTheDeviations) {
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

TEST(CohortReport, SingleMarksAreOmittedWithoutTheRightToSeeThem) {
  CohortInputs in = demonstrationCohort();
  in.singleMarks = false;
  const ReportModel report = cohortReport(in);
  EXPECT_EQ(figureNamed(report, "figure-marks"), nullptr);
  EXPECT_EQ(figureNamed(report, "figure-bland-altman"), nullptr);
  EXPECT_NE(figureNamed(report, "figure-severity"), nullptr);
  for (const CohortCsvRow& row : cohortCsvRows(in)) {
    EXPECT_NE(row.statistic, "mark");
  }
}

TEST(CohortReport, RejectsInconsistentInputs) {
  CohortInputs in = demonstrationCohort();
  in.ratings.pop_back();
  EXPECT_THROW((void)cohortReport(in), Error);
  in = demonstrationCohort();
  in.trainees[0].group = 7;
  EXPECT_THROW((void)cohortReport(in), Error);
}

TEST(FormatUtc, HandlesLeapDaysAndTimesBefore1970) {
  EXPECT_EQ(formatUtc(1'767'600'000'000'000), "2026-01-05 08:00 UTC");  // date -u -d @1767600000
  EXPECT_EQ(formatUtc(951'782'400'000'000), "2000-02-29 00:00 UTC");    // date -u -d @951782400
  EXPECT_EQ(formatUtc(-60'000'000), "1969-12-31 23:59 UTC");
}

TEST(CohortReport, OmitsSectionsWithoutData) {
  CohortInputs in;
  in.instrument = paperInstrument();
  const ReportModel report = cohortReport(in);
  ASSERT_EQ(report.sections.size(), 1U);
  EXPECT_EQ(report.sections.front().id, "annex-provenance");
}

TEST(CohortReport, UntwistingsHaveTheirOwnTable) {
  const ReportModel report = cohortReport(withUntwistings());

  const ReportTable* table = tableNamed(report, "table-untwistings");
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
                                            "1.0", "0"));
  EXPECT_EQ(tableNamed(cohortReport(demonstrationCohort()), "table-untwistings"), nullptr);
}

TEST(CohortReport, UntwistingsAreExcludedFromTheLearningOfTwistsAndItsTable) {
  const ReportModel with = cohortReport(withUntwistings());
  const ReportModel without = cohortReport(demonstrationCohort());

  EXPECT_EQ(with.sections.size(), without.sections.size());  // they add no section about learning
  const ReportTable* trials = tableNamed(with, "table-trials");
  ASSERT_NE(trials, nullptr);
  EXPECT_EQ(trials->rows.size(), tableNamed(without, "table-trials")->rows.size());
  EXPECT_EQ(trials->provenance.n, tableNamed(without, "table-trials")->provenance.n);
}

TEST(CohortReport, ACohortWithUntwistingsOnlyHasNoTableOfTwists) {
  CohortInputs in = withUntwistings();
  std::erase_if(in.trials, [](const TrialSummaryRow& trial) { return trial.detorsion.empty(); });

  const ReportModel report = cohortReport(in);

  EXPECT_EQ(tableNamed(report, "table-trials"), nullptr);
  EXPECT_NE(tableNamed(report, "table-untwistings"), nullptr);
}

TEST(FormatFixed, IsIndependentOfLocaleAndHasNoNegativeZero) {
  EXPECT_EQ(formatFixed(1234.5, 2), "1234.50");
  EXPECT_EQ(formatFixed(-0.001, 2), "0.00");
  EXPECT_EQ(formatFixed(-0.006, 2), "-0.01");
  EXPECT_EQ(formatExact(0.1), "0.1");
  EXPECT_EQ(formatP(0.0001), "< 0.001");
}

/// Returns the answer to an item of a checklist; empty without it.
std::string answerIn(const ReportModel& report, const std::string& checklist, const std::string& item) {
  for (const ReportSection& section : report.sections) {
    for (const ReportTable& table : section.tables) {
      for (const std::vector<ReportCell>& row : table.rows) {
        if (table.id == checklist && row.front().str() == item) {
          return row.back().str();
        }
      }
    }
  }
  return {};
}

TEST(Checklist, FillsItselfWhereTheRecordKnows) {
  CohortInputs in = testing::demonstrationCohort();
  const ReportModel without = cohortReport(in);
  EXPECT_EQ(answerIn(without, "table-statements", "Registration"), "not recorded: registry, number and date");
  EXPECT_EQ(answerIn(without, "table-checklist-consort", "2"), "not recorded");
  EXPECT_EQ(answerIn(without, "table-checklist-consort", "6"), "not recorded");
  EXPECT_EQ(answerIn(without, "table-checklist-consort", "22a"), "see \"Flow of participants\"");
  EXPECT_EQ(answerIn(without, "table-checklist-consort", "16b"), "not recorded") << "nothing was frozen";

  in.statements = {{StudyItem::kRegistration, "ChiCTR 1, 2026-01-05"}};
  in.freeze = CohortFreeze{"final", "b", 1, "admin", true};
  EXPECT_EQ(answerIn(cohortReport(in), "table-checklist-consort", "16b"), "not recorded")
      << "nothing shows that every sheet was in";
  in.freeze->sheetsAsked = in.freeze->sheetsSubmitted = 900;
  in.allocation = {};
  const ReportModel with = cohortReport(in);
  EXPECT_EQ(answerIn(with, "table-statements", "Registration"), "ChiCTR 1, 2026-01-05");
  EXPECT_EQ(answerIn(with, "table-checklist-consort", "2"), "see \"What the study says about itself\"");
  EXPECT_EQ(answerIn(with, "table-checklist-consort", "16b"), "the data were frozen when every sheet was in");
  EXPECT_EQ(answerIn(with, "table-checklist-consort", "18"), "not recorded") << "no groups were drawn";
  EXPECT_EQ(answerIn(with, "table-checklist-grras", "11"), "see \"Raters\"");
}

TEST(Checklist, ClaimsNoMoreThanTheFirstPage) {
  const auto consort = [](const CohortInputs& in, const std::string& item) {
    return answerIn(cohortReport(in), "table-checklist-consort", item);
  };
  CohortInputs in = testing::soundCohort();
  EXPECT_EQ(consort(in, "9"),
            "3 parallel groups, drawn; differences, and equivalence within a planned margin");
  in.allocation.movedByHand = 1;
  EXPECT_EQ(consort(in, "9"),
            "3 parallel groups, not as drawn (see the first page); differences, and equivalence within a "
            "planned margin");

  in.allocation.commitment = std::string(64, 'c');
  in.allocation.lockedUtc_us = 1;
  EXPECT_THAT(consort(in, "18"), HasSubstr("sealed, with its hash, before the first allocation"));
  in.allocation.allocatedBeforeLock = 1;
  EXPECT_THAT(consort(in, "18"), HasSubstr("nothing shows that it was sealed before"));

  in.markWays = {.blinded = 2, .entered = 898};
  EXPECT_EQ(
      answerIn(cohortReport(in), "table-checklist-grras", "9"),
      "2 of 900 marks were given on sheets, whose raters do not see each other's marks before submitting");

  in.trials.front().model = kForeignModel;
  for (const ReportSection& section : cohortReport(in).sections) {
    for (const ReportTable& table : section.tables) {
      for (const std::vector<ReportCell>& row : table.rows) {
        EXPECT_THAT(row.back().str(), Not(HasSubstr("the simulator of Torsio"))) << table.id;
      }
    }
  }
}

}  // namespace
}  // namespace torsio
