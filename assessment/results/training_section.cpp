// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "assessment/results/number_format.h"
#include "assessment/results/record_sentences.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/study_analysis.h"
#include "assessment/statistics/distributions.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr int kMarkDecimals = 2;
constexpr int kVarianceDecimals = 4;
constexpr const char* kVarianceOfMarks = "variance_of_all_marks_divisor_n";
constexpr std::size_t kOccasionsOfPaper = 3;
constexpr std::size_t kFirstScoresFigure = 20;

Provenance provenance(const CohortInputs& in, const Text& formula, std::int64_t n) {
  Provenance out;
  out.formula = formula;
  out.formulaVersion = kTrainingFormulaVersion;
  out.n = n;
  out.missing = std::ssize(in.trainees) * std::ssize(in.occasions) - std::ssize(in.scores);
  out.flags = commonFlags(in);
  return out;
}

void fixScale(const CohortInputs& in, ReportFigure& figure) {
  // The same axis for the three occasions, so that they can be compared visually; bars start at zero.
  figure.yMin = 0.0;
  figure.yMax = pointsFromSteps(in.trainingScale.hi, in.trainingScale);
}

ReportFigure scoresFigure(const CohortInputs& in, std::size_t occasion) {
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
  std::int64_t n = 0;
  for (const TraineeScore& score : in.scores) {
    largest = std::max(largest, score.number);
  }
  for (std::size_t i = 1; i <= largest; ++i) {
    out.categories.push_back(std::to_string(i));
  }
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    FigureSeries series;
    series.name = in.groups[g].name;
    series.y.assign(largest, std::nullopt);
    for (const TraineeScore& score : in.scores) {
      if (score.group == g && score.occasion == occasion) {
        series.y[score.number - 1] = score.score;
        ++n;
      }
    }
    out.series.push_back(series);
  }
  out.notes = {ofPaper ? Text::tr("Corresponds to Fig. %1 of the paper. A score is the mean over the raters.",
                                  kFirstScoresFigure + occasion)
                       : Text::tr("A score is the mean over the raters.")};
  out.provenance = provenance(in, Text::tr("mean over raters"), n);
  out.provenance.missing = std::ssize(in.trainees) - n;
  return out;
}

ReportFigure varianceFigure(const CohortInputs& in) {
  ReportFigure out;
  out.id = "figure-23";
  out.title = Text::tr("Variance of the trainee scores, divisor n");
  out.kind = FigureKind::kGroupedBars;
  out.yLabel = Text::tr("variance (points squared)");
  out.yMin = 0.0;
  out.categories = in.occasions;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    FigureSeries series;
    series.name = in.groups[g].name;
    series.y.assign(in.occasions.size(), std::nullopt);
    for (const GroupSummary& summary : in.summaries) {
      if (summary.group == g) {
        series.y[summary.occasion] = summary.varianceOfScores;
      }
    }
    out.series.push_back(series);
  }
  out.notes = {Text::tr(
      "Corresponds to Fig. 23 of the paper, which does not define its variance. Drawn is the variance of the "
      "trainee scores of a group about their mean, divisor n; the table gives two other readings.")};
  out.provenance = provenance(in, Text::tr("variance of trainee scores, divisor n"), std::ssize(in.scores));
  return out;
}

ReportFigure meansFigure(const CohortInputs& in) {
  ReportFigure out;
  out.id = "figure-training-means";
  out.title = Text::tr("Mean score of each group over the study");
  out.kind = FigureKind::kLines;
  out.xLabel = Text::tr("occasion");
  out.yLabel = Text::tr("score (points)");
  fixScale(in, out);
  out.categories = in.occasions;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    FigureSeries series;
    series.name = in.groups[g].name;
    for (const GroupSummary& summary : in.summaries) {
      if (summary.group == g) {
        series.x.push_back(static_cast<double>(summary.occasion));
        series.y.emplace_back(summary.mean);
      }
    }
    out.series.push_back(series);
  }
  out.provenance = provenance(in, Text::tr("mean over trainees"), std::ssize(in.scores));
  return out;
}

/// Shows the courses of all trainees of one group, with the group's mean and its 95 % interval.
ReportFigure coursesFigure(const CohortInputs& in, std::size_t group) {
  ReportFigure out;
  out.id = "figure-courses-" + std::to_string(group + 1);
  out.title = Text::tr("Course of every trainee, %1 (%2)", in.groups[group].name, in.groups[group].protocol);
  out.kind = FigureKind::kLines;
  out.individual = true;
  out.xLabel = Text::tr("occasion");
  out.yLabel = Text::tr("score (points)");
  fixScale(in, out);
  out.categories = in.occasions;
  std::map<std::string, FigureSeries> byTrainee;
  for (const TraineeScore& score : in.scores) {
    if (score.group != group) {
      continue;
    }
    FigureSeries& series = byTrainee[score.trainee];
    series.name = score.trainee;
    series.look = group;
    series.faint = true;
    series.y.resize(in.occasions.size());
    series.y[score.occasion] = score.score;
    ++out.provenance.n;
  }
  FigureSeries mean;
  mean.name = Text::tr("mean [95 %]");
  mean.look = group;
  mean.y.resize(in.occasions.size());
  mean.low.resize(in.occasions.size(), 0.0);
  mean.high.resize(in.occasions.size(), 0.0);
  bool alone = false;
  for (const GroupSummary& summary : in.summaries) {
    if (summary.group != group) {
      continue;
    }
    const auto n = static_cast<double>(summary.trainees);
    const double half = summary.sampleVarianceOfScores && n > 1.0
                            ? tQuantile(0.975, n - 1.0) * std::sqrt(*summary.sampleVarianceOfScores / n)
                            : 0.0;
    alone = alone || summary.trainees == 1;
    mean.y[summary.occasion] = summary.mean;
    mean.low[summary.occasion] = summary.mean - half;
    mean.high[summary.occasion] = summary.mean + half;
  }
  for (auto& [code, series] : byTrainee) {
    out.series.push_back(std::move(series));
  }
  out.series.push_back(mean);
  if (alone) {
    out.notes = {Text::tr("Where a single trainee has a score the mean has no interval.")};
  }
  const std::int64_t n = out.provenance.n;
  out.provenance = provenance(in, Text::tr("mean over raters; mean over trainees with Student's t"), n);
  std::int64_t members = 0;
  for (const CohortTrainee& trainee : in.trainees) {
    members += trainee.group == group ? 1 : 0;
  }
  out.provenance.missing = members * std::ssize(in.occasions) - n;
  return out;
}

ReportTable summaryTable(const CohortInputs& in) {
  ReportTable table;
  table.id = "table-training-summary";
  table.title = Text::tr("Training study: groups at each occasion");
  table.columns = {Text::tr("Occasion"),
                   Text::tr("Group"),
                   Text::tr("Trainees"),
                   Text::tr("Marks"),
                   Text::tr("Mean"),
                   Text::tr("Median"),
                   Text::tr("Lowest"),
                   Text::tr("Highest"),
                   Text::tr("Variance of scores, divisor n"),
                   Text::tr("Variance of scores, divisor n - 1"),
                   Text::tr("Variance of all marks, divisor n"),
                   Text::tr("Mean variance between raters, divisor n - 1")};
  std::int64_t n = 0;
  for (const GroupSummary& s : in.summaries) {
    n += s.marks;
    const auto cell = [&](const char* statistic, const std::optional<double>& value, int decimals) {
      return ReportCell(formatFixed(value, decimals),
                        {.statistic = statistic, .group = s.group, .occasion = s.occasion});
    };
    const ResultKey mean{.statistic = "mean", .group = s.group, .occasion = s.occasion};
    const ResultKey spread{.statistic = kVarianceOfMarks, .group = s.group, .occasion = s.occasion};
    table.rows.push_back(
        {in.occasions[s.occasion], in.groups[s.group].name, ReportCell(std::to_string(s.trainees), mean),
         ReportCell(std::to_string(s.marks), spread), cell("mean", s.mean, kMarkDecimals),
         cell("median", s.median, kMarkDecimals), cell("min", s.min, kMarkDecimals),
         cell("max", s.max, kMarkDecimals),
         cell("variance_of_scores_divisor_n", s.varianceOfScores, kVarianceDecimals),
         cell("variance_of_scores_divisor_n_minus_1", s.sampleVarianceOfScores, kVarianceDecimals),
         cell(kVarianceOfMarks, s.varianceOfMarks, kVarianceDecimals),
         cell("mean_between_rater_variance_divisor_n_minus_1", s.meanBetweenRaterVariance,
              kVarianceDecimals)});
  }
  table.notes = {Text::tr(
      "The trainee is the unit of analysis: marks of several raters for one trainee are averaged first.")};
  table.provenance = provenance(in, Text::tr("group summaries"), n);
  table.provenance.missing = 0;
  std::vector<Text> where;
  const std::vector<std::vector<std::int64_t>> missing = missingByGroup(in);
  for (std::size_t g = 0; g < missing.size(); ++g) {
    for (std::size_t t = 0; t < missing[g].size(); ++t) {
      table.provenance.missing += missing[g][t];
      if (missing[g][t] > 0) {
        where.push_back(Text::verbatim("%1, %2: %3", in.groups[g].name, in.occasions[t], missing[g][t]));
      }
    }
  }
  if (!where.empty()) {
    table.notes.push_back(
        Text::tr("Marks missing, short of the number that most trainees have at that "
                 "occasion: %1.",
                 listed(where, Text::tr("%1; %2"))));
  }
  return table;
}

ReportTable scoresTable(const CohortInputs& in) {
  ReportTable table;
  table.id = "table-training-scores";
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
    row[3 + score.occasion] = {
        Text(formatFixed(score.score, kMarkDecimals)),
        {.statistic = "score", .of = score.trainee, .group = score.group, .occasion = score.occasion}};
  }
  for (auto& [place, row] : rows) {
    table.rows.push_back(std::move(row));
  }
  table.provenance = provenance(in, Text::tr("mean over raters"), std::ssize(in.scores));
  return table;
}

/// States by how much a demonstration's training was shortened, from logged and recorded times.
Text shorteningSentence(const CohortInputs& in) {
  double noted_min = 0.0;
  double recorded_min = 0.0;
  for (const CohortDose& dose : in.doses) {
    noted_min += dose.virtual_min;
  }
  for (const TrialSummaryRow& trial : in.trials) {
    recorded_min += trial.detorsion.empty() ? trial.minutes : 0.0;
  }
  return noted_min > 0.0 && recorded_min > 0.0
             ? Text::tr(
                   "Training was shortened for this demonstration: %1 {minute|minutes} of simulated exercise "
                   "stand for %2 {minute|minutes} of the protocol (1 : %3).",
                   formatFixed(recorded_min, 1), formatFixed(noted_min, 1),
                   formatFixed(noted_min / recorded_min, 1))
             : Text::tr("Training was shortened for this demonstration.");
}

}  // namespace

ReportSection trainingSection(const CohortInputs& in) {
  ReportSection section{"training", Text::tr("Training study")};
  section.paragraphs.push_back(marksSentence(in));
  if (in.trainingTimeDivisor > 1) {
    section.paragraphs.push_back(shorteningSentence(in));
  }
  section.paragraphs.push_back(Text::tr("Rests taken during training: %1.", in.rests));
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    section.figures.push_back(scoresFigure(in, t));
  }
  section.figures.push_back(varianceFigure(in));
  section.figures.push_back(meansFigure(in));
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    section.figures.push_back(coursesFigure(in, g));
  }
  section.tables = {summaryTable(in), scoresTable(in)};
  return section;
}

}  // namespace torsio
