// SPDX-License-Identifier: GPL-3.0-or-later
// Groups at the end, adjusted for the score before: differences, their assumptions, and residuals.
#include <algorithm>
#include <cmath>
#include <utility>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "assessment/statistics/descriptive.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

bool isRobust(const StudyAnalysis& study) {
  return study.ancova && !study.ancova->spread.pairs.empty();
}

Text formulaOf(const StudyAnalysis& study) {
  return isRobust(study) ? Text::tr("analysis of covariance, one pooled slope, HC3")
                         : Text::tr("analysis of covariance, one pooled slope");
}

ReportFigure forestOf(const CohortInputs& in, const std::string& id, const Text& title, const Text& axis,
                      const Text& formula) {
  ReportFigure figure = itemOf<ReportFigure>(in, id, title, formula);
  figure.kind = FigureKind::kForest;
  figure.yLabel = axis;
  return figure;
}

/// Describes the test of equal slopes and its consequence.
ReportParagraph slopesText(const StudyAnalysis& study, const ResultsAt& at) {
  const Outcome<FTest>& test = study.ancova->equalSlopes;
  if (!test) {
    return Text::tr("Test of equal slopes not defined: %1.", Text(test.reason()));
  }
  const ReportCell p = at("ancova_equal_slopes_p", kEqualsP);
  if (test->p >= kSlopesDiffer) {
    return {Text::tr("Test of equal slopes: %1; one slope for all groups is kept.", p.words()), {p}};
  }
  return {Text::tr("Test of equal slopes: %1. The slopes differ, so that a difference depends on the score "
                   "before: read the table with a slope for each group in place of this one.",
                   p.words()),
          {p}};
}

}  // namespace

Text pairName(const CohortInputs& in, std::size_t first, std::size_t second) {
  return Text::verbatim("%1 - %2", in.groups[first].name, in.groups[second].name);
}

std::int64_t comparedTrainees(const StudyAnalysis& study) {
  std::int64_t n = 0;
  for (const std::vector<double>& group : study.ends.after) {
    n += std::ssize(group);
  }
  return n;
}

std::vector<double> scoresOf(const CohortInputs& in, std::size_t group, std::size_t occasion) {
  std::vector<double> scores;
  for (const TraineeScore& score : in.scores) {
    if (score.group == group && score.occasion == occasion) {
      scores.push_back(score.score);
    }
  }
  return scores;
}

ReportTable meansTable(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table = itemOf<ReportTable>(in, "table-means", Text::tr("Mean scores of the groups"),
                                          Text::tr("mean over trainees, Student's t"));
  ResultTable rows(ledger, table,
                   {{Text::tr("Group")},
                    {Text::tr("Occasion")},
                    {Text::tr("Trainees"), "mean", kValues, Text(std::to_string(0))},
                    {Text::tr("Mean [95 %, not adjusted]"), "mean", kWithInterval},
                    {Text::tr("Standard deviation"), "standard_deviation_of_scores", fixed(3)}});
  table.provenance.n = ResultsAt(ledger, {}).count("scores");
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    for (std::size_t t = 0; t < in.occasions.size(); ++t) {
      rows.row({in.groups[g].name, in.occasions[t]},
               {.group = ledger.group(g), .occasion = ledger.occasion(t)});
    }
  }
  table.provenance.missing = ResultsAt(ledger, {}).count("scores_missing");
  table.notes = {
      Text::tr("Every trainee with a score at the occasion. Overlapping intervals of single means do not "
               "show that the means agree: look at the differences.")};
  return table;
}

ReportTable covarianceTable(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  const Outcome<Ancova>& got = study.ancova;
  const bool robust = isRobust(study);
  ReportTable table = itemOf<ReportTable>(
      in, "table-ancova", Text::tr("Scores at the end, adjusted for the score before"), formulaOf(study));
  std::vector<ResultColumn> columns{
      {Text::tr("Comparison")},
      {Text::tr("Difference [95 %, not adjusted]"), robust ? "robust_difference" : "adjusted_difference",
       kWithInterval},
      {Text::tr("[95 %, after Holm]"), robust ? "robust_difference_holm_95" : "adjusted_difference_holm_95"},
      {Text::verbatim("t"), robust ? "robust_t" : "t", fixed(2)},
      {Text::verbatim("p"), robust ? "robust_p" : "p", kAsP},
      {Text::tr("p (Holm)"), robust ? "robust_p_holm" : "p_holm", kAsP},
      {Text::tr("Hedges g of the end scores [95 %, not adjusted]"), "hedges_g", kWithInterval}};
  if (robust) {  // otherwise those of the note below
    columns.insert(columns.begin() + 4, {Text::tr("Degrees of freedom"), "robust_df", fixed(1)});
  }
  ResultTable rows(ledger, table, std::move(columns));
  table.provenance.n = resultsAtEnd(ledger).count("trainees_compared");
  table.provenance.missing = resultsAtEnd(ledger).count("marks_missing");
  if (!got) {
    table.rows.push_back({notDefined(got.reason()), "", "", "", "", "", ""});
    return table;
  }
  for (const AdjustedDifference& pair : concludedPairs(*got)) {
    rows.row({pairName(in, pair.first, pair.second)}, pairKey(ledger, pair.first, pair.second));
  }
  const ResultsAt at = resultsAtEnd(ledger);
  const ReportParagraph means = valuesOfGroups(in, ledger, got->groups, "adjusted_mean", kWithInterval);
  const ReportCell df1 = at("ancova_df", fixed(0));
  const ReportCell df2 = at("ancova_df_error", fixed(0));
  const ReportCell f = at("ancova_f", fixed(2));
  const ReportCell p = at("ancova_p", kEqualsP);
  table.notes = {
      {Text::tr("With one variance for all groups: effect of the group F(%1, %2) = %3, %4; adjusted means "
                "[95 %]: %5.",
                df1.words(), df2.words(), f.words(), p.words(), means.words()),
       {df1, df2, f, p},
       means.keys},
      slopesText(study, at),
      Text::tr("An interval after Holm excludes zero exactly where p (Holm) is below 0.05. That all of them "
               "hold at once is not claimed.")};
  return table;
}

std::optional<ReportTable> slopesTable(const CohortInputs& in, const StudyAnalysis& study,
                                       const Ledger& ledger) {
  if (!study.slopes) {
    return std::nullopt;
  }
  ReportTable table = itemOf<ReportTable>(
      in, "table-slopes", Text::tr("Scores at the end where each group has a slope of its own"),
      Text::tr("analysis of covariance, separate slopes; Johnson and Neyman"));
  ResultTable rows(
      ledger, table,
      {{Text::tr("Comparison")},
       {Text::tr("Score before"), "separate_slopes_score_before", fixed(2)},
       {Text::tr("Difference [95 %, not adjusted]"), "separate_slopes_difference", kWithInterval},
       {Text::verbatim("p"), "separate_slopes_p", kAsP},
       {Text::tr("p (Holm)"), "separate_slopes_p_holm", kAsP},
       {Text::tr("Differ (5 %)")}});
  for (const SlopesPair& pair : study.slopes->pairs) {
    ResultKey place = pairKey(ledger, pair.first, pair.second);
    const ReportCell differ = ResultsAt(ledger, place)("separate_slopes_differ");
    for (std::size_t b = 0; b < pair.at.size(); ++b) {
      const ResultKey baseline = slopesKey(study, b);
      place.index = baseline.index;
      place.record = baseline.record;
      rows.row({pairName(in, pair.first, pair.second), differ}, place);
    }
  }
  const ReportParagraph slopes = valuesOfGroups(in, ledger, study.slopes->groups, "separate_slope", fixed(3));
  table.notes = {{Text::tr("Slopes: %1. Stated scores before: the mean of all and one standard deviation to "
                           "either side. p (Holm) over all rows. This analysis was not planned: the test of "
                           "equal slopes asked for it.",
                           slopes.words()),
                  {},
                  slopes.keys}};
  table.provenance.n = resultsAtEnd(ledger).count("trainees_compared");
  table.provenance.missing = resultsAtEnd(ledger).count("marks_missing");
  return table;
}

std::optional<ReportTable> equivalenceTable(const CohortInputs& in, const StudyAnalysis& study,
                                            const Ledger& ledger) {
  if (!in.equivalenceMargin) {
    return std::nullopt;
  }
  const ReportCell margin =
      resultsAtEnd(ledger)("equivalence_margin", fixed(2), Text(formatFixed(*in.equivalenceMargin, 2)));
  const Text method = primaryMethodText(study);
  ReportTable table = itemOf<ReportTable>(
      in, "table-equivalence", Text::tr("Whether the groups are equal within the margin"),
      method.empty() ? Text(Text::tr("two one-sided tests")) : Text::tr("two one-sided tests, %1", method));
  table.columns = {Text::tr("Comparison"), Text::tr("Difference [90 %, not adjusted]"),
                   Text::tr("p (of equality)"), Text::tr("Equal within %1 points (5 %)", margin.words())};
  table.provenance.n = resultsAtEnd(ledger).count(study.mixed ? "mixed_model_marks" : "trainees_compared");
  table.provenance.missing = resultsAtEnd(ledger).count("marks_missing");
  const Text plan =
      in.hasAnalysisPlan()
          ? Text::tr("Planned with the cohort: a difference of at most %1 points does not matter.",
                     margin.words())
          : Text::tr("The margin of %1 points was imported with the study: nothing shows when it was chosen.",
                     margin.words());
  table.notes = {
      {Text::tr("%1 Equal: the 90 % interval lies within -%2 to %2, which is where p is below 0.05. "
                "Not shown to be equal does not say that the groups differ.",
                plan, margin.words()),
       {margin, margin}}};  // stated twice
  for (const PrimaryDifference& pair : primaryDifferences(study)) {
    if (!(pair.error > 0.0)) {
      table.rows.push_back({pairName(in, pair.first, pair.second), Text::tr("not defined"), "", ""});
      continue;
    }
    const ResultsAt cell = resultsOfPair(ledger, pair.first, pair.second);
    const ReportCell p = cell("equivalence_p", kAsP);
    ReportCell difference = cell("equivalence_90");
    if (difference.key != nullptr) {
      static_cast<Text&>(difference) =
          Text::verbatim("%1 %2", formatFixed(pair.value, 3), difference.words());
    }
    table.rows.push_back(
        {pairName(in, pair.first, pair.second),
         difference,
         p,
         {cell.number("equivalence_p") < 1.0 - kDefaultConfidence ? Text::tr("yes") : Text::tr("not shown"),
          p.key}});
  }
  if (table.rows.empty()) {
    table.rows.push_back({notDefined(study.ancova.reason()), "", "", ""});
  }
  return table;
}

std::vector<ReportFigure> differenceFigures(const CohortInputs& in, const StudyAnalysis& study,
                                            const Ledger& ledger) {
  if (!study.ancova) {
    return {};
  }
  ReportFigure points =
      forestOf(in, "figure-differences",
               Text::tr("Differences between the groups at the end, adjusted for the score before"),
               Text::tr("difference (points)"),
               study.mixed ? Text::tr("linear mixed model; %1", formulaOf(study)) : formulaOf(study));
  ReportFigure effects =
      forestOf(in, "figure-effects", Text::tr("Standardised differences of the scores at the end"),
               Text::tr("Hedges g"), Text::tr("Hedges g, interval from the noncentral t distribution"));
  effects.annex = true;
  FigureSeries difference{.name = study.mixed ? Text::tr("complete cases [95 %]")
                                              : Text::tr("difference [95 %]")};
  FigureSeries primary{.name = Text::tr("mixed model, primary [95 %]")};
  const char* adjusted = isRobust(study) ? "robust_difference" : "adjusted_difference";
  FigureSeries effect{.name = Text::tr("Hedges g [95 %]")};
  for (const AdjustedDifference& pair : concludedPairs(*study.ancova)) {
    const ResultsAt at = resultsOfPair(ledger, pair.first, pair.second);
    points.categories.push_back(pairName(in, pair.first, pair.second));
    addPoint(difference, at, adjusted, true);
    addPoint(primary, at, "mixed_model_difference", true);
    if (at.number("hedges_g")) {
      effects.categories.push_back(pairName(in, pair.first, pair.second));
      addPoint(effect, at, "hedges_g", true);
    }
  }
  points.series = study.mixed ? std::vector{primary, difference} : std::vector{difference};
  effects.series = {effect};
  points.notes = {
      Text::tr("First group minus second group. Intervals are not adjusted for the number of pairs.")};
  effects.notes = {Text::tr(
      "First group minus second group, scores at the end alone: the adjusted difference can be clear "
      "where this one is not. Intervals are not adjusted for the number of pairs.")};
  std::vector<ReportFigure> figures;
  for (ReportFigure* figure : {&points, &effects}) {
    if (figure->categories.empty()) {
      continue;
    }
    figure->references = {{0.0, Text::tr("no difference")}};
    figure->provenance.n = resultsAtEnd(ledger).count("trainees_compared");
    figure->provenance.missing = resultsAtEnd(ledger).count("marks_missing");
    figures.push_back(std::move(*figure));
  }
  return figures;
}

namespace {

/// Returns where points with normal residuals would be, from the lowest to the highest of them.
FigureSeries normalLine(const std::vector<FigureSeries>& points) {
  FigureSeries line;
  line.name = Text::tr("as normal residuals");
  line.faint = true;
  double low = 0.0;
  double high = 0.0;
  for (const FigureSeries& series : points) {
    for (const double x : series.x) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
  }
  line.x = {low, high};
  line.y = {low, high};
  return line;
}

}  // namespace

std::vector<ReportFigure> residualFigures(const CohortInputs& in, const StudyAnalysis& study,
                                          const Ledger& ledger) {
  if (!study.ancova) {
    return {};
  }
  const Ancova& model = *study.ancova;
  ReportFigure fitted =
      itemOf<ReportFigure>(in, "figure-residuals", Text::tr("Residuals of the analysis of covariance"),
                           Text::tr("score at the end minus what the model says"));
  fitted.annex = true;
  ReportFigure normal =
      itemOf<ReportFigure>(in, "figure-qq", Text::tr("Residuals against a normal distribution"),
                           Text::tr("residuals in order against normal quantiles at (i - 0.5) / n"));
  normal.annex = true;
  fitted.xLabel = Text::tr("what the model says (points)");
  fitted.yLabel = Text::tr("residual (points)");
  fitted.references = {{0.0, Text::tr("as the model says")}};
  normal.xLabel = Text::tr("normal quantile times standard deviation (points)");
  normal.yLabel = Text::tr("residual (points)");
  for (const std::size_t g : model.groups) {
    FigureSeries line{.name = in.groups[g].name};
    FigureSeries quantiles = line;
    for (std::size_t i = 0; i < model.residuals[g].size(); ++i) {
      const ResultsAt at(ledger, {.section = ResultSection::kComparison,
                                  .of = study.endCodes[g][i],
                                  .group = ledger.group(g),
                                  .occasion = ledger.lastOccasion()});
      line.x.push_back(model.fitted[g][i]);
      addPoint(line, at, "ancova_residual");
      quantiles.x.push_back(model.quantiles[g][i]);
      addPoint(quantiles, at, "ancova_residual");
    }
    fitted.series.push_back(std::move(line));
    normal.series.push_back(std::move(quantiles));
  }
  normal.series.push_back(normalLine(normal.series));
  const ResultsAt end = resultsAtEnd(ledger);
  const ReportCell w = end("residuals_shapiro_wilk_w", fixed(3));
  const ReportCell p = end("residuals_shapiro_wilk_p", kEqualsP);
  fitted.notes = {Text::tr(
      "A fan or bow shape indicates that the spread or the slope violates the model's assumptions.")};
  if (end.number("residuals_shapiro_wilk_w")) {
    normal.notes = {
        {Text::tr("Normal residuals lie along the line. Shapiro and Wilk: W = %1, %2; for looking "
                  "at, not for choosing a test.",
                  w.words(), p.words()),
         {w, p}}};
  } else {
    normal.notes = {Text::tr("Normal residuals lie along the line.")};
  }
  for (ReportFigure* figure : {&fitted, &normal}) {
    figure->kind = FigureKind::kScatter;
    figure->individual = true;  // a point is a person
    figure->provenance.n = resultsAtEnd(ledger).count("trainees_compared");
    figure->provenance.missing = resultsAtEnd(ledger).count("marks_missing");
  }
  return {std::move(fitted), std::move(normal)};
}

}  // namespace torsio
