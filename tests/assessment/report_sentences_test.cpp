// SPDX-License-Identifier: GPL-3.0-or-later
// The report's sentences follow from the record.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/results/cohort_csv.h"
#include "assessment/results/cohort_report.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {
namespace {

using testing::demonstrationCohort;
using ::testing::HasSubstr;
using ::testing::Not;

/// All sentences of a report.
std::string saidBy(const CohortInputs& in) {
  std::string all;
  for (const ReportSection& section : cohortReport(in).sections) {
    for (const Text& paragraph : section.paragraphs) {
      all += paragraph.str() + "\n";
    }
    for (const ReportFigure& figure : section.figures) {
      for (const Text& note : figure.notes) {
        all += note.str() + "\n";
      }
    }
    for (const ReportTable& table : section.tables) {
      for (const Text& note : table.notes) {
        all += note.str() + "\n";
      }
    }
  }
  return all;
}

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

TEST(ReportSentences, BlindingFollowsFromHowEachMarkWasGiven) {
  CohortInputs in = demonstrationCohort();
  in.markWays = {.blinded = 900};
  EXPECT_THAT(saidBy(in), HasSubstr("Raters were blinded: all marks of the training study (900)"));
  EXPECT_THAT(saidBy(in), Not(HasSubstr("not blinded")));
  in.markWays = {.live = 900};
  EXPECT_THAT(saidBy(in), HasSubstr("Raters were not blinded: all marks of the training study (900)"));
  in.markWays = {.entered = 900};
  EXPECT_THAT(saidBy(in), HasSubstr("Nothing shows that raters were blinded"));
  in.markWays = {.blinded = 600, .live = 299, .entered = 1};
  EXPECT_THAT(saidBy(in), HasSubstr("of 900 marks of the training study 600 were given on recordings under a "
                                    "case label, 299 live"));
  in.markWays = {};
  EXPECT_THAT(saidBy(in), Not(HasSubstr("linded")));
}

TEST(ReportSentences, HiddenModelsAndRatersAmongTraineesAreReported) {
  CohortInputs in = demonstrationCohort();
  in.modelsHidden = 3;
  EXPECT_THAT(saidBy(in), HasSubstr("All models (3) stood before their raters under hidden labels"));
  EXPECT_THAT(saidBy(in), Not(HasSubstr("are raters of the models as well")));
  in.modelsHidden = 1;
  EXPECT_THAT(saidBy(in), HasSubstr("1 of 3 models"));
  in.ratings.front().sheets.front().rater = in.trainees.front().code;
  EXPECT_THAT(saidBy(in), HasSubstr("1 trainee of this cohort is a rater of the models as well"));
}

TEST(ReportSentences, TheCommitmentIsDatedByTheRecord) {
  CohortInputs in = demonstrationCohort();
  in.allocation.commitment = "c0ffee";
  in.allocation.lockedUtc_us = 0;
  EXPECT_THAT(saidBy(in), HasSubstr("when it was made is not in the record"));
  in.allocation.lockedUtc_us = 1'767'600'000'000'000;
  EXPECT_THAT(saidBy(in), HasSubstr("made 2026-01-05 08:00 UTC, before the first enrolment"));
  in.allocation.enrolledBeforeLock = 30;
  EXPECT_THAT(saidBy(in), HasSubstr("before anybody was allocated and after 30 trainees had been enrolled"));
  in.allocation.allocatedBeforeLock = 2;
  EXPECT_THAT(saidBy(in), HasSubstr("after 2 trainees had been allocated"));
  EXPECT_THAT(saidBy(in), HasSubstr("seed: not recorded"));
  in.allocation.commitment.clear();
  EXPECT_THAT(saidBy(in), HasSubstr("No commitment to the seed is in the record"));
  in.allocation.replayed = false;
  in.allocation.replayDiffers = true;
  EXPECT_THAT(saidBy(in), HasSubstr("was NOT found the same"));
  in.allocation.method = Text::verbatim("complete permutation");
  in.allocation.movedByHand = 2;
  EXPECT_THAT(saidBy(in), HasSubstr("2 trainees were moved by hand"));
  EXPECT_THAT(saidBy(in), Not(HasSubstr("any difference is due to chance")));
  EXPECT_THAT(saidBy(in), HasSubstr("seed: 0"));
}

TEST(ReportSentences, AnImportedMarginIsNotCalledPlanned) {
  CohortInputs in = demonstrationCohort();
  in.equivalenceMargin = 0.5;
  const auto note = [&] { return tableIn(cohortReport(in), "table-equivalence")->notes.at(0).str(); };
  EXPECT_THAT(note(), HasSubstr("Planned with the cohort: a difference of at most 0.50 points"));
  in.imported = CohortOrigin{"Torsio", "set", std::string(64, 'c'), "admin", 1};
  EXPECT_THAT(note(), Not(HasSubstr("Planned with")));
  EXPECT_THAT(note(), HasSubstr("nothing shows when it was chosen"));
}

TEST(ReportSentences, ARecordingWithoutItsHashIsNotCalledSealed) {
  CohortInputs in = demonstrationCohort();
  EXPECT_THAT(saidBy(in), HasSubstr("Every recording is sealed in the record"));
  in.trials.front().contentHash.clear();
  EXPECT_THAT(saidBy(in), Not(HasSubstr("Every recording is sealed in the record")));
  EXPECT_THAT(saidBy(in), HasSubstr("1 recording has no content hash"));
}

TEST(ReportSentences, RecordedPlannedAndNotedTrainingTimesAreReported) {
  CohortInputs in = demonstrationCohort();
  in.groups[0].plannedVirtual_min = 40.0;
  in.groups[0].plannedReal_min = 0.0;
  in.doses = {{"x101", 38.5, 0.0, 5.0}};
  in.trials.resize(1);
  in.trials[0].trainee = "x101";
  in.trials[0].group = 0;
  in.trials[0].minutes = 0.33;

  const ReportModel report = cohortReport(in);
  const ReportTable* table = tableIn(report, "table-dose");
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->rows.at(0).at(2), "40.0");
  EXPECT_EQ(table->rows.at(0).at(3), "38.5");
  EXPECT_EQ(table->rows.at(0).at(4), "0.3");
  EXPECT_THAT(saidBy(in), HasSubstr("Recordings make up 0.9 % of the time noted"));
  EXPECT_EQ(table->provenance.formula, "plan of the arms; times noted; lengths of the recordings");
}

TEST(ReportSentences, HardlyAnyRecordedTimeBehindManyNotedMinutesIsSaidOnPageOne) {
  CohortInputs in = demonstrationCohort();
  in.demonstration = false;
  for (CohortGroup& group : in.groups) {
    group.plannedVirtual_min = group.plannedReal_min = 40.0;
  }
  in.doses = {{"x101", 40.0, 40.0, 5.0}};
  in.trials.resize(1);
  in.trials[0].trainee = "x101";
  in.trials[0].group = 0;
  in.trials[0].minutes = 0.5;
  const std::string said =
      "minutes on the simulator are noted per trainee on average, but the recorded runs last";
  EXPECT_THAT(saidBy(in), HasSubstr(said));

  in.trials[0].minutes = 12.0;  // the rest was spent between the runs
  EXPECT_THAT(saidBy(in), Not(HasSubstr(said)));
  in.trials[0].minutes = 0.5;
  in.demonstration = true;
  EXPECT_THAT(saidBy(in), Not(HasSubstr(said))) << "a demonstration's runs are shortened";
}

TEST(ReportSentences, AMissingMarkIsReportedWhereMarksAreCounted) {
  CohortInputs in = demonstrationCohort();
  EXPECT_THAT(saidBy(in), HasSubstr("physicians scored every trainee at 3 occasions"));
  EXPECT_THAT(saidBy(in), HasSubstr("every trainee is scored by the same raters"));
  in.trainingMarks.pop_back();
  EXPECT_THAT(saidBy(in), HasSubstr("10 physicians gave 899 marks at 3 occasions"));
  EXPECT_THAT(saidBy(in), HasSubstr("a strict or lenient rater may change their order"));
}

TEST(ReportSentences, NothingIsClaimedWithoutData) {
  CohortInputs in;
  in.instrument = paperInstrument();
  EXPECT_EQ(saidBy(in), "");
}

TEST(ShownInputs, NoMarkOrMeanIsShownBeforeTheSetIsCompleteOrFrozen) {
  CohortInputs in = demonstrationCohort();
  in.sheetsAsked = 900;
  in.sheetsPresent = 899;

  const ReportModel open = cohortReport(in);
  EXPECT_THAT(saidBy(in), HasSubstr("899 of 900 sheets"));
  EXPECT_EQ(tableIn(open, "table-training-scores"), nullptr);
  EXPECT_EQ(tableIn(open, "table-training-summary"), nullptr);
  EXPECT_EQ(tableIn(open, "table-agreement"), nullptr);
  EXPECT_EQ(tableIn(open, "table-raters"), nullptr);
  for (const CohortCsvRow& row : cohortCsvRows(in)) {
    EXPECT_TRUE(row.section != "agreement" && row.section != "comparison") << row.statistic;
    EXPECT_TRUE(row.section != "training" || row.statistic == "sheets_asked" ||
                row.statistic == "sheets_present")
        << row.statistic;
  }
  const std::vector<std::vector<ReportCell>>& groups = tableIn(open, "table-participants")->rows;
  for (const std::vector<ReportCell>& row : groups) {
    EXPECT_EQ(row.back(), "not shown");  // not even the mean before training
  }
  for (const std::vector<ReportCell>& row : tableIn(open, "table-flow")->rows) {
    EXPECT_EQ(row[5], "10") << "who was scored is no secret, and none would be untrue";
  }

  in.freeze = CohortFreeze{"final", std::string(64, 'b'), 1, "admin", true};
  EXPECT_NE(tableIn(cohortReport(in), "table-training-scores"), nullptr);
  in.freeze.reset();
  in.sheetsPresent = 900;
  EXPECT_NE(tableIn(cohortReport(in), "table-training-scores"), nullptr);
  EXPECT_THAT(saidBy(in), Not(HasSubstr("sheets that raters were asked for")));
}

TEST(ShownInputs, TheModelsAreShownOnceEveryAssignedRaterHasGivenAllMarks) {
  CohortInputs in = demonstrationCohort();
  in.evaluationRatersAsked = 41;
  EXPECT_EQ(tableIn(cohortReport(in), "table-comprehensive"), nullptr);
  EXPECT_THAT(saidBy(in), HasSubstr("40 of 41 raters who were asked"));
  for (const CohortCsvRow& row : cohortCsvRows(in)) {
    EXPECT_NE(row.section, "evaluation");
  }
  in.evaluationRatersAsked = 40;
  EXPECT_NE(tableIn(cohortReport(in), "table-comprehensive"), nullptr);
  in.ratings.front().sheets.front().steps.front().reset();
  EXPECT_EQ(tableIn(cohortReport(in), "table-comprehensive"), nullptr);
  in.freeze = CohortFreeze{"final", std::string(64, 'b'), 1, "admin", true};
  EXPECT_NE(tableIn(cohortReport(in), "table-comprehensive"), nullptr);
}

TEST(ShownInputs, NoSingleMarkLeaksThroughASmallCell) {
  CohortInputs in = demonstrationCohort();
  in.singleMarks = false;
  in.scores.front().n = 2;  // of two marks, one's own reveals the other
  const std::string code = in.scores.front().trainee;
  const std::size_t group = in.scores.front().group;

  const ReportModel report = cohortReport(in);
  const auto& rows = tableIn(report, "table-training-scores")->rows;
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& one) { return one[2] == code; });
  ASSERT_NE(row, rows.end());
  EXPECT_EQ((*row)[3], "missing");
  EXPECT_NE((*row)[4], "missing");
  for (const std::vector<ReportCell>& summary : tableIn(report, "table-training-summary")->rows) {
    EXPECT_FALSE(summary[0] == in.occasions[0] && summary[1] == in.groups[group].name);  // would reveal it
  }
  EXPECT_THAT(saidBy(in), HasSubstr("Scores of fewer than 3 marks"));
  for (const CohortCsvRow& line : cohortCsvRows(in)) {
    EXPECT_FALSE(line.section == "training" && line.item == code && line.occasion == in.occasions[0].str());
  }
  in.singleMarks = true;
  EXPECT_EQ(tableIn(cohortReport(in), "table-training-summary")->rows.size(), 9U);
}

CohortCompetence verdictOf(const CohortInputs& in, std::size_t trainee, bool able) {
  CohortCompetence one;
  one.trainee = in.trainees[trainee].code;
  one.group = in.trainees[trainee].group;
  one.exercise = Text::verbatim("Quarter turn");
  one.attempts = 3;
  one.level = able ? Text::verbatim("competent, since attempt 2") : Text::verbatim("learning");
  one.able = able;
  one.ableAt = able ? std::optional<std::int64_t>(2) : std::nullopt;
  one.sums = {1.0, 2.0, 1.5};
  one.limit = 2.0;
  one.falsePass = 0.049;
  one.falseFail = 0.094;
  one.falseAlarm = 0.014;
  one.declaredWithinMade = {0.5, 0.3, 0.2, 0.1, 0.049};
  one.plannedAttempts = 50;
  one.fewestAttempts = 2;
  one.design = Text::verbatim("Design.");
  one.errors = Text::verbatim("Errors.");
  return one;
}

TEST(CompetenceSection, PrintsTheErrorRatesBesideEveryLevel) {
  CohortInputs in = demonstrationCohort();
  in.competence = {verdictOf(in, 0, true), verdictOf(in, 1, false)};

  const ReportModel report = cohortReport(in);
  const ReportTable* table = tableIn(report, "table-competence");
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->rows.at(0).at(5), "competent, since attempt 2");
  EXPECT_EQ(table->rows.at(0).at(6), "4.9 %");
  EXPECT_EQ(table->rows.at(1).at(7), "9.4 %");
  EXPECT_EQ(table->rows.at(1).at(8), "2");
  ASSERT_EQ(table->notes.size(), 2U) << "what all have in common is said once";
  EXPECT_EQ(table->notes.at(0), "Exercise: Quarter turn.");
  EXPECT_EQ(table->notes.at(1), "Design: shipped with the exercise.");
  const ReportTable* odds = tableIn(report, "table-competence-odds");
  ASSERT_NE(odds, nullptr);
  ASSERT_EQ(odds->rows.size(), 1U);
  EXPECT_EQ(odds->rows.at(0).at(1), "3");
  EXPECT_EQ(odds->columns.at(6), "30\u00A0%");
  EXPECT_EQ(odds->rows.at(0).at(6), "4.9 %");
  EXPECT_THAT(saidBy(in), HasSubstr("Quarter turn. Design. Errors."));
  std::int64_t rates = 0;
  for (const CohortCsvRow& row : cohortCsvRows(in)) {
    rates += row.section == "competence" && row.statistic.starts_with("false_");
  }
  EXPECT_EQ(rates, 6 + 2) << "of two verdicts, and the largest of each kind over both";
  in.identity = ReportIdentity::kAggregated;
  EXPECT_EQ(tableIn(cohortReport(in), "table-competence"), nullptr);
}

TEST(CompetenceSection, StatesCommonPropertiesOfExercisesOnce) {
  CohortInputs in = demonstrationCohort();
  in.competence = {verdictOf(in, 0, true), verdictOf(in, 0, false), verdictOf(in, 1, false)};
  in.competence[1].exercise = Text::verbatim("Half turn");
  in.competence[2].errors = Text::verbatim("Others.");

  const std::string said = saidBy(in);

  EXPECT_THAT(said, HasSubstr("Quarter turn; Half turn. Design. Errors."));
  EXPECT_THAT(said, HasSubstr("Quarter turn. Design. Others."));
  EXPECT_EQ(said.find("Errors."), said.rfind("Errors."));
}

TEST(CompetenceSection, TheFirstPageUsesItsVerdictsOnly) {
  CohortInputs in = demonstrationCohort();
  std::vector<std::size_t> people;
  for (std::size_t i = 0; i < in.trainees.size(); ++i) {
    if (in.trainees[i].group == 0) {
      people.push_back(i);
    }
  }
  ASSERT_GE(people.size(), 3U);
  in.competence = {verdictOf(in, people[0], true), verdictOf(in, people[1], true),
                   verdictOf(in, people[2], false)};
  CohortCompetence other = verdictOf(in, people[1], false);
  other.exercise = Text::verbatim("Half turn");
  other.falsePass = 0.12;
  in.competence.push_back(other);

  const ReportModel report = cohortReport(in);
  const ReportTable* table = tableIn(report, "table-standard");
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->rows.at(0).at(5), "1 of 3: x101") << "one is competent at all that was tried";
  ASSERT_EQ(table->notes.size(), 1U);
  EXPECT_THAT(
      table->notes[0].str(),
      HasSubstr("at most 12.0 % of trainees who are inadequate at an exercise are judged competent at it, "
                "and at most 21.6 % of those who are adequate at every exercise are not"))
      << "one of the two exercises is enough not to be competent at both";
  in.competence[3].required = false;
  EXPECT_EQ(tableIn(cohortReport(in), "table-standard")->rows.at(0).at(5), "2 of 3: x101, x102");
  in.competence.clear();
  EXPECT_TRUE(tableIn(cohortReport(in), "table-standard")->notes.empty());
}
// "At most 10.8 %" stood beside "0 of 10" people with 10 attempts, where 17 were the fewest that can pass.
TEST(CompetenceSection, TooFewRunsAreNoVerdict) {
  CohortInputs in = demonstrationCohort();
  in.competence = {verdictOf(in, 0, false), verdictOf(in, 1, false)};
  for (CohortCompetence& one : in.competence) {
    one.fewestAttempts = 25;
    one.level = Text::verbatim("not shown yet");
    one.falsePass = 0.0;
    one.falseFail = 1.0;
    one.falseAlarm = 0.0;
  }
  const ReportModel report = cohortReport(in);
  const ReportTable* table = tableIn(report, "table-standard");
  ASSERT_NE(table, nullptr);
  EXPECT_THAT(
      table->notes.at(0).str(),
      HasSubstr("Nobody can have been shown competent yet: at least 25 runs at an exercise are needed, "
                "and nobody made more than 3."));
  EXPECT_THAT(table->notes.at(0).str(), Not(HasSubstr("at most")));
  const ReportTable* counts = tableIn(report, "table-competence-groups");
  ASSERT_NE(counts, nullptr);
  EXPECT_EQ(counts->rows.at(0).at(2), "competent 0, not competent 0, not shown yet 2");
  // A required exercise that nobody tried counts against competence.
  in.competence = {verdictOf(in, 0, true), verdictOf(in, 0, false)};
  in.competence[1].exercise = Text::verbatim("Never tried");
  in.competence[1].attempts = 0;
  in.competence[1].sums.clear();
  EXPECT_THAT(tableIn(cohortReport(in), "table-standard")->rows.at(0).at(5).str(), HasSubstr("0 of 1"));
}

}  // namespace
}  // namespace torsio
