// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "assessment/results/number_format.h"
#include "assessment/results/record_sentences.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/study_analysis.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr int kMarkDecimals = 2;
constexpr int kVarianceDecimals = 4;
constexpr const char* kVarianceOfMarks = "variance_of_all_marks_divisor_n";
constexpr std::size_t kOccasionsOfPaper = 3;
constexpr std::size_t kFirstScoresFigure = 20;

/// `place`: an occasion or a group; of all without either.
Provenance provenance(const CohortInputs& in, const Ledger& ledger, const Text& formula,
                      const ResultKey& place = {}) {
  const ResultsAt at(ledger, place);
  return {formula, kTrainingFormulaVersion, at.count("scores"), at.count("scores_missing"), commonFlags(in)};
}

void fixScale(const CohortInputs& in, ReportFigure& figure) {
  // The same axis for the three occasions, so that they can be compared visually; bars start at zero.
  figure.yMin = 0.0;
  figure.yMax = pointsFromSteps(in.trainingScale.hi, in.trainingScale);
}

ReportFigure scoresFigure(const CohortInputs& in, const Ledger& ledger, std::size_t occasion) {
  ReportFigure out;
  // The paper has three occasions; its Fig. 23 is different.
  const bool ofPaper = in.occasions.size() == kOccasionsOfPaper;
  out.id = occasion < kOccasionsOfPaper ? "figure-" + std::to_string(kFirstScoresFigure + occasion)
                                        : "figure-scores-" + std::to_string(occasion + 1);
  out.title = Text::tr("Scores of the trainees %1", in.occasions[occasion]);
  out.kind = FigureKind::kGroupedBars;
  out.xLabel = Text::tr("trainee number in the group");
  out.individual = true;
  out.yLabel = Text::tr("score (points)");
  fixScale(in, out);
  std::size_t largest = 0;
  for (const TraineeScore& score : in.scores) {
    largest = std::max(largest, score.number);
  }
  for (std::size_t i = 1; i <= largest; ++i) {
    out.categories.push_back(std::to_string(i));
  }
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    FigureSeries series{.name = in.groups[g].name};
    series.y.assign(largest, std::nullopt);
    series.keys.assign(largest, nullptr);
    for (const TraineeScore& score : in.scores) {
      if (score.group == g && score.occasion == occasion) {
        FigureSeries point;
        addPoint(
            point,
            ResultsAt(ledger,
                      {.of = score.trainee, .group = ledger.group(g), .occasion = ledger.occasion(occasion)}),
            "score");
        series.y[score.number - 1] = point.y.front();
        series.keys[score.number - 1] = point.keys.front();
      }
    }
    out.series.push_back(std::move(series));
  }
  out.notes = {ofPaper ? Text::tr("Corresponds to Fig. %1 of the paper. A score is the mean over the raters.",
                                  kFirstScoresFigure + occasion)
                       : Text::tr("A score is the mean over the raters.")};
  out.provenance =
      provenance(in, ledger, Text::tr("mean over raters"), {.occasion = ledger.occasion(occasion)});
  return out;
}

/// Returns a series for each group with a statistic at every occasion.
std::vector<FigureSeries> groupSeries(const CohortInputs& in, const Ledger& ledger,
                                      const std::string& statistic) {
  std::vector<FigureSeries> all;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    FigureSeries series{.name = in.groups[g].name};
    for (std::size_t t = 0; t < in.occasions.size(); ++t) {
      addPoint(series, ResultsAt(ledger, {.group = ledger.group(g), .occasion = ledger.occasion(t)}),
               statistic);
    }
    all.push_back(std::move(series));
  }
  return all;
}

ReportFigure varianceFigure(const CohortInputs& in, const Ledger& ledger) {
  ReportFigure out;
  out.id = "figure-23";
  out.title = Text::tr("Variance of the trainee scores, divisor n");
  out.kind = FigureKind::kGroupedBars;
  out.yLabel = Text::tr("variance (points squared)");
  out.yMin = 0.0;
  out.categories = in.occasions;
  out.series = groupSeries(in, ledger, "variance_of_scores_divisor_n");
  out.notes = {Text::tr(
      "Corresponds to Fig. 23 of the paper, which does not define its variance. Drawn is the variance of the "
      "trainee scores of a group about their mean, divisor n; the table gives two other readings.")};
  out.provenance = provenance(in, ledger, Text::tr("variance of trainee scores, divisor n"));
  return out;
}

ReportFigure meansFigure(const CohortInputs& in, const Ledger& ledger) {
  ReportFigure out;
  out.id = "figure-training-means";
  out.title = Text::tr("Mean score of each group over the study");
  out.kind = FigureKind::kLines;
  out.xLabel = Text::tr("occasion");
  out.yLabel = Text::tr("score (points)");
  fixScale(in, out);
  out.categories = in.occasions;
  out.series = groupSeries(in, ledger, "mean");
  out.provenance = provenance(in, ledger, Text::tr("mean over trainees"));
  return out;
}

/// Shows the courses of all trainees of one group, with the group's mean and its 95 % interval.
ReportFigure coursesFigure(const CohortInputs& in, const Ledger& ledger, std::size_t group) {
  ReportFigure out;
  out.id = "figure-courses-" + std::to_string(group + 1);
  out.annex = true;
  const CohortGroup& shown = in.groups[group];
  out.title = shown.protocol.empty()
                  ? Text::tr("Course of every trainee, %1", shown.name)
                  : Text::tr("Course of every trainee, %1 (%2)", shown.name, shown.protocol);
  out.kind = FigureKind::kLines;
  out.individual = true;
  out.xLabel = Text::tr("occasion");
  out.yLabel = Text::tr("score (points)");
  fixScale(in, out);
  out.categories = in.occasions;
  std::set<std::string> trainees;
  for (const TraineeScore& score : in.scores) {
    if (score.group == group) {
      trainees.insert(score.trainee);
    }
  }
  for (const std::string& trainee : trainees) {
    FigureSeries series{.name = trainee, .look = group, .faint = true};
    for (std::size_t t = 0; t < in.occasions.size(); ++t) {
      addPoint(
          series,
          ResultsAt(ledger, {.of = trainee, .group = ledger.group(group), .occasion = ledger.occasion(t)}),
          "score");
    }
    out.series.push_back(std::move(series));
  }
  FigureSeries mean{.name = Text::tr("mean [95 %]"), .look = group};
  bool alone = false;
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    const ResultsAt at(ledger, {.group = ledger.group(group), .occasion = ledger.occasion(t)});
    addPoint(mean, at, "mean", true);
    alone = alone || (at.find("mean") != nullptr && at.find("mean")->n == 1);
  }
  out.series.push_back(std::move(mean));
  if (alone) {
    out.notes = {Text::tr("Where a single trainee has a score the mean has no interval.")};
  }
  out.provenance = provenance(in, ledger, Text::tr("mean over raters; mean over trainees with Student's t"),
                              {.group = ledger.group(group)});
  return out;
}

ReportTable summaryTable(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table;
  table.id = "table-training-summary";
  table.annex = true;
  table.title = Text::tr("Training study: groups at each occasion");
  ResultTable rows(
      ledger, table,
      {{Text::tr("Occasion")},
       {Text::tr("Group")},
       {Text::tr("Trainees"), "mean", kValues},
       {Text::tr("Marks"), kVarianceOfMarks, kValues},
       {Text::tr("Mean"), "mean", fixed(kMarkDecimals)},
       {Text::tr("Median"), "median", fixed(kMarkDecimals)},
       {Text::tr("Lowest"), "min", fixed(kMarkDecimals)},
       {Text::tr("Highest"), "max", fixed(kMarkDecimals)},
       {Text::tr("Variance of scores, divisor n"), "variance_of_scores_divisor_n", fixed(kVarianceDecimals)},
       {Text::tr("Variance of scores, divisor n - 1"), "variance_of_scores_divisor_n_minus_1",
        fixed(kVarianceDecimals)},
       {Text::tr("Variance of all marks, divisor n"), kVarianceOfMarks, fixed(kVarianceDecimals)},
       {Text::tr("Mean variance between raters, divisor n - 1"),
        "mean_between_rater_variance_divisor_n_minus_1", fixed(kVarianceDecimals)}});
  for (const GroupSummary& s : in.summaries) {
    rows.row({in.occasions[s.occasion], in.groups[s.group].name},
             {.group = ledger.group(s.group), .occasion = ledger.occasion(s.occasion)});
  }
  table.notes = {Text::tr(
      "The trainee is the unit of analysis: marks of several raters for one trainee are averaged first.")};
  const ResultsAt whole(ledger, {});
  table.provenance = {Text::tr("group summaries"), kTrainingFormulaVersion, whole.count("marks"),
                      whole.count("marks_missing"), commonFlags(in)};
  std::vector<Text> where;
  std::vector<std::shared_ptr<const ResultKey>> keys;
  const std::vector<std::vector<std::int64_t>> missing = missingByGroup(in);
  for (std::size_t g = 0; g < missing.size(); ++g) {
    for (std::size_t t = 0; t < missing[g].size(); ++t) {
      if (missing[g][t] > 0) {
        const ReportCell count = ResultsAt(
            ledger, {.group = ledger.group(g), .occasion = ledger.occasion(t)})("marks_missing_at_occasion");
        where.push_back(Text::tr("%1, %2: %3", in.groups[g].name, in.occasions[t], count.words()));
        keys.push_back(count.key);
      }
    }
  }
  if (!where.empty()) {
    table.notes.push_back(
        {Text::tr("Marks missing, short of the number that most trainees have at that occasion: %1.",
                  listed(where, Text::tr("%1; %2"))),
         {},
         keys});
  }
  return table;
}

ReportTable scoresTable(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table;
  table.id = "table-training-scores";
  table.annex = true;
  table.title = Text::tr("Training study: score of every trainee");
  table.individual = true;
  table.columns = {Text::tr("Group"), Text::tr("Number"), Text::tr("Trainee")};
  table.columns.insert(table.columns.end(), in.occasions.begin(), in.occasions.end());
  std::map<std::tuple<std::size_t, std::size_t, std::string>, std::vector<ReportCell>> rows;
  for (const TraineeScore& score : in.scores) {
    std::vector<ReportCell>& row = rows[{score.group, score.number, score.trainee}];
    if (row.empty()) {
      row = {in.groups[score.group].name, std::to_string(score.number), score.trainee};
      row.resize(table.columns.size(), Text::tr("missing"));
    }
    row[3 + score.occasion] =
        ResultsAt(ledger, {.of = score.trainee,
                           .group = ledger.group(score.group),
                           .occasion = ledger.occasion(score.occasion)})("score", fixed(kMarkDecimals));
  }
  for (auto& [place, row] : rows) {
    table.rows.push_back(std::move(row));
  }
  table.provenance = provenance(in, ledger, Text::tr("mean over raters"));
  return table;
}

/// States by how much a demonstration's training was shortened, from logged and recorded times.
ReportParagraph shorteningSentence(const Ledger& ledger) {
  const ResultsAt at(ledger, wholeKey(kTrainingTimes));
  if (!at.number("noted_for_each_recorded")) {
    return Text::tr("Training was shortened for this demonstration.");
  }
  const ReportCell recorded = at("recorded_virtual_min", fixed(1));
  const ReportCell noted = at("noted_virtual_min", fixed(1));
  const ReportCell ratio = at("noted_for_each_recorded", fixed(1));
  return {Text::tr("Training was shortened for this demonstration: %1 {minute|minutes} of simulated exercise "
                   "stand for %2 {minute|minutes} of the protocol (1 : %3).",
                   recorded.words(), noted.words(), ratio.words()),
          {recorded, noted, ratio}};
}

}  // namespace

ReportSection trainingSection(const CohortInputs& in, const Ledger& ledger) {
  ReportSection section{"training", Text::tr("Training study")};
  section.paragraphs.push_back(marksSentence(in, ledger));
  if (in.demonstration && in.trainingTimeDivisor > 1) {
    section.paragraphs.push_back(shorteningSentence(ledger));
  }
  const ReportCell rested = ResultsAt(ledger, wholeKey(kTrainingTimes))("trainees_who_rested");
  section.paragraphs.push_back(
      {Text::tr("Trainees who rested during training: %1.", rested.words()), {rested}});
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    section.figures.push_back(scoresFigure(in, ledger, t));
  }
  section.figures.push_back(varianceFigure(in, ledger));
  section.figures.push_back(meansFigure(in, ledger));
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    section.figures.push_back(coursesFigure(in, ledger, g));
  }
  section.tables = {summaryTable(in, ledger), scoresTable(in, ledger)};
  return section;
}

}  // namespace torsio
