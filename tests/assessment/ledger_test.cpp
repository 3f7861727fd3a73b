// SPDX-License-Identifier: GPL-3.0-or-later
// The ledger of results: each number once, with what it is made of.
#include "assessment/results/ledger.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/figure_table.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {
namespace {

using testing::demonstrationCohort;

Result resultAt(ResultKey key, double value = 1.0) {
  return {std::move(key), value, 1, "", partsOf({RecordRef{RecordKind::kMark, "m1"}})};
}

TEST(Ledger, RefusesTheSameKeyTwiceAndAResultMadeOfNothing) {
  Ledger ledger;
  ledger.add(resultAt({.statistic = "score", .of = "T-01", .occasion = "before"}));
  ledger.add(resultAt({.statistic = "score", .of = "T-01", .occasion = "after"}));
  EXPECT_THROW(ledger.add(resultAt({.statistic = "score", .of = "T-01", .occasion = "after"}, 2.0)),
               ContractError);
  EXPECT_THROW(ledger.add({{.statistic = "mean"}, 1.0, 1, "", partsOf({})}), ContractError);
  EXPECT_EQ(ledger.every().size(), 2U);
}

TEST(Ledger, SelectsSinglePeopleButNoSummaryWhereAPatternAsksForEach) {
  Ledger ledger;
  ledger.add(resultAt({.statistic = "criterion_mean", .group = "Group 1"}));
  ledger.add(resultAt({.statistic = "criterion_mean", .of = "T-01", .group = "Group 1"}));
  ledger.add(resultAt({.statistic = "criterion_mean", .of = "T-02", .group = "Group 2"}));

  EXPECT_EQ(ledger.select({.statistic = "criterion_mean", .of = kEach}).size(), 2U);
  EXPECT_EQ(ledger.select({.statistic = "criterion_mean", .of = kEach, .group = "Group 2"}).size(), 1U);
  EXPECT_EQ(ledger.select({.statistic = "criterion_mean"}).size(), 1U);
  EXPECT_EQ(ledger.select({.statistic = "criterion_mean", .of = "T-02"}).front()->key.group, "Group 2");
  EXPECT_TRUE(ledger.select({.section = ResultSection::kTrial, .statistic = "criterion_mean"}).empty());
}

TEST(Ledger, KeyReadsAsItsLineOfTheTableOfNumbers) {
  EXPECT_EQ(keyAddress({.section = ResultSection::kComparison,
                        .statistic = "p_holm",
                        .group = "Group 1",
                        .against = "Group 2",
                        .occasion = "after, in all"}),
            "comparison,all,Group 1 - Group 2,,,\"after, in all\",p_holm");
  EXPECT_EQ(keyAddress({.section = ResultSection::kTrial,
                        .statistic = "twist_error_deg",
                        .of = "T-01",
                        .number = 3,
                        .when = "virtual",
                        .record = "t1"}),
            "trial,T-01,,,3,virtual,twist_error_deg");
}

/// Follows the results of a ledger down to the rows of the record.
class Follower {
 public:
  explicit Follower(const Ledger& ledger) : ledger_(ledger) {}
  /// Whether a result leads down to the record by every way, and never back to itself.
  bool reachesTheRecord(const Result& result) {
    if (sound_.contains(result.key)) {
      return true;
    }
    bool ends = open_.insert(result.key).second;
    bool leads = false;
    for (const ResultPart& part : *result.madeOf) {
      const auto* pattern = std::get_if<ResultPattern>(&part);
      const auto others = pattern != nullptr ? ledger_.select(*pattern) : std::vector<const Result*>{};
      leads = leads || pattern == nullptr || !others.empty();
      for (const Result* other : others) {
        ends = ends && reachesTheRecord(*other);
      }
    }
    open_.erase(result.key);
    if (ends && leads) {
      sound_.insert(result.key);
    }
    return ends && leads;
  }

 private:
  const Ledger& ledger_;
  std::set<ResultKey> sound_;
  std::set<ResultKey> open_;
};

/// Columns of numbers that name a row: dates, versions, hashes of the record, how many raters are assumed.
bool namesARow(const ReportTable& table, const Text& column) {
  static const std::set<std::pair<std::string, std::string>> kNames = {
      {"table-raters-needed", "Raters"}, {"table-training-scores", "Number"},
      {"table-provenance", "Value"},     {"table-participants", "Protocol"},
      {"table-allocation", "Value"},     {"table-mark-signatures", "Version"},
      {"table-mark-signatures", "When"}, {"table-chain", "Recordings (first eight digits of the run)"}};
  return kNames.contains({table.id, column.str()}) || &column == &table.columns.front();
}

/// Fails where a number of a table has no result, or one that does not lead down to the record.
void expectEveryNumberLeadsToTheRecord(const ReportTable& table, const Ledger& ledger, Follower& follower) {
  for (const std::vector<ReportCell>& row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string shown = row[c].str();
      const std::size_t digit = shown.find_first_not_of("<[-\u2212 ");
      if (digit == std::string::npos || shown[digit] < '0' || shown[digit] > '9' ||
          namesARow(table, table.columns[c])) {
        continue;
      }
      const Result* result = row[c].key == nullptr ? nullptr : ledger.find(*row[c].key);
      ASSERT_NE(result, nullptr) << table.id << ", " << table.columns[c] << ": " << shown;
      EXPECT_TRUE(follower.reachesTheRecord(*result)) << table.id << ", " << table.columns[c];
    }
  }
}

/// Collects the numbers that fill in a sentence, but for those in names of groups and occasions.
void collectNumbers(const Text& text, const ResultNames& names, std::vector<std::string>& out) {
  const auto is = [&](const std::string& name) { return name == text.str(); };
  if (std::any_of(names.groups.begin(), names.groups.end(), is) ||
      std::any_of(names.occasions.begin(), names.occasions.end(), is)) {
    return;
  }
  for (const Text& argument : text.arguments()) {
    if (argument.arguments().empty() && !argument.empty() &&
        std::string("0123456789[-").find(argument.str()[0]) != std::string::npos) {
      out.push_back(argument.str());
    }
    collectNumbers(argument, names, out);
  }
}

/// Fails where a sentence states a number of which it names no result.
void expectSentenceNamesItsResults(const std::string& where, const ReportParagraph& sentence,
                                   const Ledger& ledger, Follower& follower) {
  std::vector<std::string> numbers;
  collectNumbers(sentence, ledger.names(), numbers);
  std::erase_if(numbers, [&](const std::string& number) {
    return number == "0.80" || number == "20" ||
           where == "figure-" + number;  // settings, figures of the paper
  });
  EXPECT_GE(sentence.keys.size(), numbers.size()) << where << ": " << sentence;
  for (const auto& key : sentence.keys) {
    ASSERT_NE(key, nullptr) << where << ": " << sentence;
    const Result* result = ledger.find(*key);
    ASSERT_NE(result, nullptr) << where << ": " << sentence;
    EXPECT_TRUE(follower.reachesTheRecord(*result)) << where << ": " << sentence;
  }
}

/// Fails where a count below a table or figure has no result, or one that does not lead down to the record.
void expectCountsLeadToTheRecord(const std::string& id, const Provenance& caption, const Ledger& ledger,
                                 Follower& follower) {
  for (const ReportCell* count : {&caption.n, &caption.missing}) {
    if (!count->empty()) {
      const Result* result = count->key == nullptr ? nullptr : ledger.find(*count->key);
      ASSERT_NE(result, nullptr) << id << ": " << *count;
      EXPECT_TRUE(follower.reachesTheRecord(*result)) << id << ": " << *count;
    }
  }
  EXPECT_TRUE(caption.missing.empty() || !caption.n.empty()) << id;
}

/// Fails where a result, or a number of a table or figure of the report, does not lead down to the record.
void expectEveryResultLeadsToTheRecord(const CohortInputs& in) {
  const AnalysedCohort cohort = analysedCohort(in);
  Follower follower(cohort.ledger);
  for (const Result& result : cohort.ledger.every()) {
    EXPECT_TRUE(follower.reachesTheRecord(result)) << keyAddress(result.key);
  }
  const ReportModel report = cohortReport(in, cohort);
  const auto expectSentences = [&](const std::string& where, const std::vector<ReportParagraph>& sentences) {
    for (const ReportParagraph& sentence : sentences) {
      expectSentenceNamesItsResults(where, sentence, cohort.ledger, follower);
    }
  };
  for (const ReportSection& section : report.sections) {
    if (section.id == "summary") {  // the question, which comes first, names protocols
      expectSentences(section.id, {section.paragraphs.begin() + 1, section.paragraphs.end()});
    } else if (section.id != "annex-simulated") {  // settings of the program that simulated
      expectSentences(section.id, section.paragraphs);
    }
    for (const ReportTable& table : section.tables) {
      expectEveryNumberLeadsToTheRecord(table, cohort.ledger, follower);
      expectSentences(table.id, table.notes);
      expectCountsLeadToTheRecord(table.id, table.provenance, cohort.ledger, follower);
    }
    for (const ReportFigure& figure : section.figures) {
      ReportFigure drawn = figure;
      std::erase_if(drawn.series, [&](const FigureSeries& series) {
        return series.faint && figure.kind == FigureKind::kScatter;  // a line for comparison
      });
      expectEveryNumberLeadsToTheRecord(figureTable(drawn), cohort.ledger, follower);
      expectSentences(figure.id, figure.notes);
      expectCountsLeadToTheRecord(figure.id, figure.provenance, cohort.ledger, follower);
    }
  }
}

TEST(Ledger, EveryResultOfACohortLeadsToRowsOfTheRecord) {
  CohortInputs in = demonstrationCohort();
  in.equivalenceMargin = 1.0;
  in.programHash = std::string(64, 'e');
  in.auditHead = std::string(64, 'f');
  in.deviations = {{0, "x101", "late", "came late"}, {0, "x101", "late", "came late again"}};
  in.trials.front().attempts = {{3.0, true}, {2.0, true}};
  CohortCompetence verdict;
  verdict.trainee = "x101";
  verdict.exercise = Text::verbatim("twist");
  verdict.level = Text::verbatim("not shown");
  verdict.runs = {"t1"};
  verdict.sums = {0.5, 1.0};
  in.doses = {{"x101", 38.5, 0.0, 2.0}, {"y101", 19.0, 20.0, 0.0}};
  in.sheetsAsked = 1;
  in.sheetsPresent = 1;
  in.competence = {verdict, verdict};  // two exercises of one title
  expectEveryResultLeadsToTheRecord(in);
  const TrainingMark lost = in.trainingMarks.back();
  expectEveryResultLeadsToTheRecord(testing::losing([&](const TrainingMark& mark) {
    return mark.trainee == lost.trainee && mark.rater == lost.rater && mark.occasion == 2;
  }));
  expectEveryResultLeadsToTheRecord(testing::withUntwistings());
  expectEveryResultLeadsToTheRecord(testing::aClassOfRatersIsMissing());
}

TEST(Ledger, AnIntervalIsOneResultAndTwoLinesOfTheTableOfNumbers) {
  Ledger ledger;
  const ResultParts parts = partsOf({RecordRef{RecordKind::kMark, "m1"}});
  ledger.add({{.statistic = "mean_95"}, Interval{1.0, 2.0}, 5, "", parts});
  ledger.add({{.statistic = "limit_of_agreement"}, Interval{-1.0, 1.0}, 5, "", parts});
  std::vector<std::string> lines;
  ledger.eachLine(
      [&](const Result& line) { lines.push_back(line.key.statistic + " " + resultText(line.value)); });
  EXPECT_EQ(lines, (std::vector<std::string>{"mean_lower_95 1", "mean_upper_95 2",
                                             "limit_of_agreement_lower -1", "limit_of_agreement_upper 1"}));
}

TEST(Ledger, AComparisonIsPlannedOnlyWhereTheRecordHoldsAPlan) {
  CohortInputs in = demonstrationCohort();
  const ResultKey p{
      .section = ResultSection::kComparison, .statistic = "ancova_p", .occasion = "after 40 min"};
  EXPECT_EQ(analysedCohort(in).ledger.find(p)->origin, Origin::kUnplanned);
  in.equivalenceMargin = 1.0;
  const Ledger planned = analysedCohort(in).ledger;
  EXPECT_EQ(planned.find(p)->origin, Origin::kPlanned);
  ResultKey gain = p;
  gain.statistic = "gain_kruskal_wallis_p";
  EXPECT_EQ(planned.find(gain)->origin, Origin::kUnplanned);
}

TEST(Ledger, AKeyMeansTheSameWhenGroupsAreListedInAnotherOrder) {
  const CohortInputs in = demonstrationCohort();
  CohortInputs turned = in;
  std::rotate(turned.groups.begin(), turned.groups.begin() + 1, turned.groups.end());
  const auto turn = [&](auto& rows) {
    for (auto& row : rows) {
      row.group = (row.group + in.groups.size() - 1) % in.groups.size();
    }
  };
  turn(turned.trainees);
  turn(turned.scores);
  turn(turned.summaries);
  turn(turned.trainingMarks);
  turn(turned.criterionMarks);
  turn(turned.trials);
  const Ledger ledger = analysedCohort(in).ledger;
  const Ledger other = analysedCohort(turned).ledger;
  std::size_t compared = 0;
  for (const Result& result : ledger.every()) {
    const std::optional<double> value = numberIn(result.value);
    if (value && !result.key.group.empty() && result.key.against.empty()) {
      const Result* same = other.find(result.key);
      ASSERT_NE(same, nullptr) << keyAddress(result.key);
      EXPECT_NEAR(numberIn(same->value).value(), *value, 1e-9) << keyAddress(result.key);
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000U);
}

TEST(Ledger, AGroupMeanIsMadeOfTheScoresOfItsTrainees) {
  const Ledger ledger = analysedCohort(demonstrationCohort()).ledger;
  const Result* mean = ledger.find({.statistic = "mean", .group = "Group 2", .occasion = "after 40 min"});
  ASSERT_NE(mean, nullptr);
  double sum = 0.0;
  const auto scores = ledger.select(std::get<ResultPattern>(mean->madeOf->front()));
  for (const Result* score : scores) {
    sum += numberIn(score->value).value();
  }
  ASSERT_EQ(scores.size(), 10U);
  EXPECT_NEAR(numberIn(mean->value).value(), sum / 10.0, 1e-12);
}

}  // namespace
}  // namespace torsio
