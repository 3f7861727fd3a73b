// SPDX-License-Identifier: GPL-3.0-or-later
// A one-minute summary for a board: the question, who took part, the answer with its uncertainty, who reached
// the standard, limitations, and signatures.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/record_sentences.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/study_analysis.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr int kPointDecimals = 1;  // appropriate for a mean of ten marks in half points
constexpr double kSignificant = 0.05;
constexpr std::size_t kSignatures = 3;
constexpr std::size_t kNamedAtMost = 10;  // people in one cell
constexpr std::size_t kRoomyGroups = 3;   // more of them fill the page
constexpr std::size_t kPairsAtMost = 3;   // not shown to differ, but still named

bool opensDirection(const PrimaryDifference& pair) {
  return pair.interval.lower <= 0.0 && pair.interval.upper >= 0.0;
}

/// Returns the decimals needed to distinguish the ends of the interval, more than usual if it is narrow.
int decimalsOf(const PrimaryDifference& pair) {
  constexpr int kMaxDecimals = 4;
  constexpr double kSteps = 2.0;  // in units of the last decimal, between the ends
  int decimals = kPointDecimals;
  while (decimals < kMaxDecimals &&
         pair.interval.upper - pair.interval.lower < kSteps * std::pow(10.0, -decimals)) {
    ++decimals;
  }
  return decimals;
}

Text shown(const PrimaryDifference& pair) {
  const int decimals = decimalsOf(pair);
  return Text::tr("%1 points [%2; %3]", formatFixed(pair.value, decimals),
                  formatFixed(pair.interval.lower, decimals), formatFixed(pair.interval.upper, decimals));
}

Text questionOf(const CohortInputs& in) {
  std::vector<Text> protocols;
  for (const CohortGroup& group : in.groups) {
    protocols.push_back(group.protocol.empty() ? group.name
                                               : Text::verbatim("%1 (%2)", group.name, group.protocol));
  }
  return Text::tr(
      "Question: do trainees score differently at the end (%1) who trained in different ways: %2?",
      in.occasions.back(), listed(protocols));
}

Text peopleOf(const CohortInputs& in) {
  const auto withdrew = std::count_if(in.trainees.begin(), in.trainees.end(),
                                      [](const CohortTrainee& trainee) { return trainee.withdrew; });
  return Text::tr(
      "People: %1 {trainee|trainees} in %2 {group|groups}, %3 of them withdrew; %4 {physician|physicians} "
      "gave %5 {mark|marks}; %6 {deviation from the protocol was|deviations from the protocol were} "
      "reported.",
      in.trainees.size(), in.groups.size(), withdrew, in.trainingRaters, in.trainingMarks.size(),
      in.deviations.size());
}

/// Names the pairs that do not differ: readers must not think that there were none.
Text othersOf(const std::vector<Text>& differing, const std::vector<Text>& others) {
  const Text answer =
      Text::tr("Answer, adjusted for the score before, with the 95 % interval of each pair by itself: %1.",
               listed(differing, Text::tr("%1; %2")));
  if (others.empty()) {
    return answer;
  }
  return Text::verbatim(
      "%1 %2", answer,
      others.size() <= kPairsAtMost
          ? Text::tr("Not shown to differ: %1.", listed(others, Text::tr("%1; %2")))
          : Text::tr("%1 other pairs were not shown to differ: see the figure.", others.size()));
}

/// Answers the question as far as the data allow.
Text answerOf(const CohortInputs& in, const StudyAnalysis& study) {
  const std::vector<PrimaryDifference> pairs = primaryDifferences(study);
  if (pairs.empty()) {
    return in.groups.size() < 2
               ? Text::tr("Answer: none. There is only one group.")
               : Text::tr("Answer: none. The groups are not compared: %1.", Text(study.ancova.reason()));
  }
  std::vector<Text> differing;
  std::vector<Text> others;
  const PrimaryDifference* widest = &pairs.front();
  bool allHoldZero = true;
  for (const PrimaryDifference& pair : pairs) {
    allHoldZero = allHoldZero && opensDirection(pair);
    (pair.pHolm < kSignificant ? differing : others)
        .push_back(Text::tr("%1: %2, %3 after Holm", pairName(in, pair.first, pair.second), shown(pair),
                            equalsP(pair.pHolm)));
    if (std::abs(pair.value) > std::abs(widest->value)) {
      widest = &pair;
    }
  }
  if (!differing.empty()) {
    return othersOf(differing, others);
  }
  return Text::tr(
      "Answer: no difference between two groups was shown. The largest, adjusted for the score before, with "
      "the 95 % interval of this pair by itself: %1, %2. %3",
      pairName(in, widest->first, widest->second), shown(*widest),
      allHoldZero ? Text::tr("Every interval includes zero.")
                  : Text::tr("No p value stays below %1 after Holm.", formatFixed(kSignificant, 2)));
}

/// States what the answer is based on if that is not the analysis of covariance of every mark.
std::vector<Text> reservationsOf(const CohortInputs& in, const StudyAnalysis& study) {
  std::vector<Text> out;
  if (in.freeze && !in.freeze->unchanged) {
    out.push_back(
        Text::tr("The record has changed since it was frozen as \"%1\": these results are computed from the "
                 "record as it is now, not from the frozen data.",
                 in.freeze->name));
  }
  if (const std::vector<Text> groups = groupsNotCompared(in, study); !groups.empty()) {
    out.push_back(Text::tr("Not compared, as nobody has a score at both occasions: %1.", listed(groups)));
  }
  if (!primaryDifferences(study).empty()) {
    std::vector<Text> single;
    for (std::size_t g = 0; g < study.ends.after.size(); ++g) {
      if (study.ends.after[g].size() == 1) {
        single.push_back(in.groups[g].name);
      }
    }
    if (!single.empty()) {
      out.push_back(Text::tr(
          "A single trainee has a score at both occasions in: %1. Its differences rest on one person; "
          "how much trainees of a group vary is taken from the other groups.",
          listed(single)));
    }
  }
  if (study.mixed && study.endMissing == 0) {
    out.push_back(
        Text::tr("Not every trainee was marked by the same raters at the end, so the answer is that of the "
                 "linear mixed model, which allows for it; the analysis of covariance is shown beside it."));
  } else if (study.mixed) {
    out.push_back(
        Text::tr("Of %2 marks %1 {is|are} missing, so the answer is that of the linear mixed model, which "
                 "uses every mark that was given; the analysis of covariance is shown beside it.",
                 study.endMissing, study.endMarks + study.endMissing));
  }
  const auto open = std::count_if(study.bounds.begin(), study.bounds.end(), [](const MissingBounds& pair) {
    return !pair.worst || !pair.best ||
           (pair.worst->interval.lower <= 0.0 && pair.best->interval.upper >= 0.0);
  });
  if (open > 0 && !primaryDifferences(study).empty()) {
    out.push_back(
        Text::tr("The missing marks could, at worst, leave open which group is better in %1 of %2 "
                 "{comparison|comparisons}.",
                 open, study.bounds.size()));
  }
  if (study.slopes) {
    out.push_back(
        Text::tr("The difference depends on the score before (test of equal slopes: %1): read the table with "
                 "a slope for each group.",
                 equalsP(study.ancova->equalSlopes->p)));
  }
  return out;
}

std::optional<ReportFigure> answerFigure(const CohortInputs& in, const StudyAnalysis& study,
                                         const Ledger& ledger) {
  const std::vector<PrimaryDifference> pairs = primaryDifferences(study);
  if (pairs.empty()) {
    return std::nullopt;
  }
  ReportFigure figure = itemOf<ReportFigure>(
      in, "figure-answer", Text::tr("The answer: differences between the groups with 95 % intervals"),
      study.mixed ? Text::tr("linear mixed model, restricted maximum likelihood")
                  : Text::tr("analysis of covariance, one pooled slope"));
  figure.kind = FigureKind::kForest;
  figure.valuesInLabels = true;
  figure.yLabel = Text::tr("difference (points)");
  FigureSeries series{.name = Text::tr("difference [95 %]")};
  for (const PrimaryDifference& pair : pairs) {
    const int decimals = decimalsOf(pair);  // points, like the axis: a chart truncates long labels
    figure.categories.push_back(Text::verbatim(
        "%1: %2 [%3; %4]", pairName(in, pair.first, pair.second), formatFixed(pair.value, decimals),
        formatFixed(pair.interval.lower, decimals), formatFixed(pair.interval.upper, decimals)));
    addPoint(series, resultsOfPair(in, ledger, pair.first, pair.second),
             study.mixed ? "mixed_model_difference" : "adjusted_difference", true);
  }
  figure.series = {series};
  figure.references = {{0.0, Text::tr("no difference")}};
  figure.provenance.n = study.mixed ? static_cast<std::int64_t>(study.mixed->marks) : comparedTrainees(study);
  figure.provenance.missing = study.endMissing;
  figure.notes = {Text::tr("Intervals are not adjusted for the number of pairs.")};
  return figure;
}

/// Formats how many are competent, "2 of 10: T-03, T-07".
ReportCell ableOf(const CohortInputs& in, const Ledger& ledger, std::size_t group,
                  const std::vector<Text>& able) {
  const ResultsAt at(ledger, {.section = ResultSection::kCompetence, .group = group});
  ReportCell cell = at("able_at_every_exercise", {}, Text::tr("did not train there"));
  if (cell.key == nullptr) {
    return cell;
  }
  const Text count = Text::tr("%1 of %2", cell.words(), at("able_at_every_exercise", kValues).words());
  static_cast<Text&>(cell) = able.empty() || in.identity == ReportIdentity::kAggregated ? count
                             : able.size() > kNamedAtMost ? Text::tr("%1, see the section Competence", count)
                                                          : Text::tr("%1: %2", count, listed(able));
  return cell;
}

/// Returns per group the scores at the end, and how many were shown competent on the simulator.
ReportTable standardTable(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table =
      itemOf<ReportTable>(in, "table-standard", Text::tr("Scores at the end, and who reached the standard"),
                          Text::tr("mean of the trainee scores; LC-CUSUM"));
  table.columns = {Text::tr("Group"), Text::tr("Trainees"), Text::tr("Mean score [lowest; highest]"),
                   Text::tr("Competent on the simulator")};
  // Verdicts of the section Competence; none are computed here.
  std::map<std::string, bool> ableAtAll;
  double falsePass = 0.0;
  std::map<std::string, double>
      missed;  // by trainee: one exercise is enough for not being competent at all of them
  for (const CohortCompetence& one : in.competence) {
    const auto [known, first] = ableAtAll.try_emplace(one.trainee, one.able);
    known->second = known->second && one.able;
    falsePass = std::max(falsePass, one.falsePass);
    missed[one.trainee] += one.falseFail + one.falseAlarm;
  }
  double falseFail = 0.0;
  for (const auto& [trainee, sum] : missed) {
    falseFail = std::clamp(sum, falseFail, 1.0);
  }
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    std::vector<Text> able;
    for (const CohortTrainee& trainee : in.trainees) {
      const auto verdict = ableAtAll.find(trainee.code);
      if (trainee.group == g && verdict != ableAtAll.end() && verdict->second) {
        able.emplace_back(trainee.code);
      }
    }
    const ResultsAt end(ledger, {.group = g, .occasion = in.occasions.size() - 1});
    ReportCell score = end("mean", fixed(kPointDecimals), Text::tr("none"));
    if (score.key != nullptr) {
      static_cast<Text&>(score) =
          Text::verbatim("%1 [%2; %3]", score.words(), end("min", fixed(kPointDecimals)).words(),
                         end("max", fixed(kPointDecimals)).words());
    }
    const ResultsAt group(ledger, {.section = ResultSection::kParticipants, .group = g});
    table.rows.push_back({in.groups[g].name, group("allocated"), score, ableOf(in, ledger, g, able)});
  }
  table.provenance.n = std::ssize(in.trainees);
  if (!ableAtAll.empty()) {
    table.notes = {Text::tr(
        "Competent now: at every exercise that was tried, by the designs of the section Competence. Within "
        "the attempts named there, a trainee who is inadequate at one exercise is judged competent in at "
        "most %1 % of cases; one who is adequate at all of them is not judged competent in at most %2 %.",
        formatFixed(100.0 * falsePass, 1), formatFixed(100.0 * falseFail, 1))};
  }
  return table;
}

/// `roomy`: with a line for each signature.
ReportTable signatureTable(bool roomy) {
  ReportTable table;
  table.id = "table-signatures";
  table.title = Text::tr("Signatures");
  table.columns = {Text::tr("Name"), Text::tr("Role"), Text::tr("Date"), Text::tr("Signature")};
  for (std::size_t i = 0; i < kSignatures; ++i) {
    const Text above = roomy ? Text::verbatim("\n") : Text();
    table.rows.push_back({Text::verbatim("%1____________________", above),
                          Text::verbatim("%1______________", above), Text::verbatim("%1____________", above),
                          Text::verbatim("%1________________________", above)});
  }
  return table;
}

}  // namespace

ReportSection boardSection(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  ReportSection section{"summary", Text::tr("At a glance")};
  section.onFirstPage = true;
  section.paragraphs = {questionOf(in), peopleOf(in), answerOf(in, study)};
  for (Text& reservation : reservationsOf(in, study)) {
    section.paragraphs.push_back(std::move(reservation));
  }
  section.paragraphs.push_back(
      Text::tr("What this does not show: %1 Marks on a training arm say nothing about patients.",
               detectableSentence(in)));
  if (std::optional<ReportFigure> figure = answerFigure(in, study, ledger)) {
    section.figures.push_back(std::move(*figure));
  }
  const bool roomy = in.groups.size() <= kRoomyGroups;
  section.tables = {standardTable(in, ledger), signatureTable(roomy)};
  return section;
}

}  // namespace torsio
