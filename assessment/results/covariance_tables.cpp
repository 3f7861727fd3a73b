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
#include "assessment/statistics/distributions.h"
#include "assessment/statistics/shapiro_wilk.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

ReportFigure forestOf(const CohortInputs& in, const std::string& id, const Text& title, const Text& axis,
                      const Text& formula) {
  ReportFigure figure = itemOf<ReportFigure>(in, id, title, formula);
  figure.kind = FigureKind::kForest;
  figure.yLabel = axis;
  return figure;
}

void addInterval(FigureSeries& series, double value, const Interval& interval) {
  series.y.emplace_back(value);
  series.low.push_back(interval.lower);
  series.high.push_back(interval.upper);
}

Text regionText(const SignificantRegion& region) {
  if (region.inside) {
    return Text::tr("for a score before between %1 and %2", formatFixed(region.inside->lower, 2),
                    formatFixed(region.inside->upper, 2));
  }
  if (region.outside) {
    return Text::tr("for a score before below %1 or above %2", formatFixed(region.outside->lower, 2),
                    formatFixed(region.outside->upper, 2));
  }
  return region.everywhere ? Text::tr("for every score before") : Text::tr("for no score before");
}

/// Describes the test of equal slopes and its consequence.
Text slopesText(const StudyAnalysis& study) {
  const Outcome<FTest>& test = study.ancova->equalSlopes;
  if (!test) {
    return Text::tr("Test of equal slopes not defined: %1.", Text(test.reason()));
  }
  if (test->p >= kSlopesDiffer) {
    return Text::tr("Test of equal slopes: %1; one slope for all groups is kept.", equalsP(test->p));
  }
  return Text::tr(
      "Test of equal slopes: %1. The slopes differ, so that a difference depends on the score before: read "
      "the table with a slope for each group in place of this one.",
      equalsP(test->p));
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

ReportTable meansTable(const CohortInputs& in, const StudyAnalysis& study) {
  ReportTable table = itemOf<ReportTable>(in, "table-means", Text::tr("Mean scores of the groups"),
                                          Text::tr("mean over trainees, Student's t"));
  table.columns = {Text::tr("Group"), Text::tr("Occasion"), Text::tr("Trainees"),
                   Text::tr("Mean [95 %, not adjusted]"), Text::tr("Standard deviation")};
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    for (std::size_t t = 0; t < in.occasions.size(); ++t) {
      const std::vector<double> scores = scoresOf(in, g, t);
      table.provenance.n += std::ssize(scores);
      table.rows.push_back({in.groups[g].name, in.occasions[t], std::to_string(scores.size()),
                            scores.empty() ? ReportCell(Text::tr("not defined"))
                                           : ReportCell(withInterval(meanOf(scores), meanInterval(scores)),
                                                        {.statistic = "mean", .group = g, .occasion = t}),
                            formatFixed(sampleDeviation(scores), 3)});
    }
  }
  table.provenance.missing = study.endMissing;
  table.notes = {
      Text::tr("Every trainee with a score at the occasion. Overlapping intervals of single means do not "
               "show that the means agree: look at the differences.")};
  return table;
}

ReportTable covarianceTable(const CohortInputs& in, const StudyAnalysis& study) {
  ReportTable table =
      itemOf<ReportTable>(in, "table-ancova", Text::tr("Scores at the end, adjusted for the score before"),
                          Text::tr("analysis of covariance, one pooled slope"));
  table.columns = {Text::tr("Comparison"),
                   Text::tr("Difference [95 %, not adjusted]"),
                   Text::tr("[95 %, all pairs together]"),
                   Text::verbatim("t"),
                   Text::verbatim("p"),
                   Text::tr("p (Holm)"),
                   Text::tr("Hedges g of the end scores [95 %, not adjusted]")};
  const Outcome<Ancova>& got = study.ancova;
  const Groups& after = study.ends.after;
  table.provenance.n = comparedTrainees(study);
  table.provenance.missing = study.endMissing;
  if (!got) {
    table.rows.push_back({notDefined(got.reason()), "", "", "", "", "", ""});
    return table;
  }
  for (const AdjustedDifference& pair : got->pairs) {
    const Outcome<HedgesG> g = hedgesG(after[pair.first], after[pair.second]);
    const CellsAt cell = cellsOfPair(in, pair.first, pair.second);
    table.rows.push_back(
        {pairName(in, pair.first, pair.second),
         cell("adjusted_difference", withInterval(pair.difference, pair.interval)),
         cell("adjusted_difference_simultaneous_lower_95", intervalText(pair.simultaneous)),
         cell("t", formatFixed(pair.t, 2)), cell("p", formatP(pair.p)), cell("p_holm", formatP(pair.pHolm)),
         g ? cell("hedges_g", withInterval(g->g, g->interval)) : ReportCell(notDefined(g.reason()))});
  }
  std::vector<Text> means;
  for (std::size_t i = 0; i < got->adjusted.size(); ++i) {
    means.push_back(Text::verbatim("%1 %2", in.groups[got->groups[i]].name,
                                   withInterval(got->adjusted[i].mean, got->adjusted[i].interval)));
  }
  table.notes = {
      Text::tr("Effect of the group: F(%1, %2) = %3, %4. Adjusted means [95 %]: %5.",
               formatFixed(got->group.df1, 0), formatFixed(got->group.df2, 0), formatFixed(got->group.f, 2),
               equalsP(got->group.p), listed(means)),
      slopesText(study),
      Text::tr("Intervals of all pairs together are widened after Bonferroni: all of them hold at once with "
               "95 % or more. They are wider than Holm's p values ask for.")};
  return table;
}

std::optional<ReportTable> slopesTable(const CohortInputs& in, const StudyAnalysis& study) {
  if (!study.slopes) {
    return std::nullopt;
  }
  ReportTable table = itemOf<ReportTable>(
      in, "table-slopes", Text::tr("Scores at the end where each group has a slope of its own"),
      Text::tr("analysis of covariance, separate slopes; Johnson and Neyman"));
  table.columns = {
      Text::tr("Comparison"), Text::tr("Score before"), Text::tr("Difference [95 %, not adjusted]"),
      Text::verbatim("p"),    Text::tr("p (Holm)"),     Text::tr("Differ (5 %)")};
  for (const SlopesPair& pair : study.slopes->pairs) {
    for (std::size_t b = 0; b < pair.at.size(); ++b) {
      const AdjustedDifference& at = pair.at[b];
      table.rows.push_back({pairName(in, pair.first, pair.second), formatFixed(study.slopes->baselines[b], 2),
                            withInterval(at.difference, at.interval), formatP(at.p), formatP(at.pHolm),
                            regionText(pair.region)});
    }
  }
  std::vector<Text> slopes;
  for (std::size_t g = 0; g < study.slopes->slopes.size(); ++g) {
    slopes.push_back(Text::verbatim("%1 %2", in.groups[study.slopes->groups[g]].name,
                                    formatFixed(study.slopes->slopes[g], 3)));
  }
  table.notes = {
      Text::tr("Slopes: %1. Stated scores before: the mean of all and one standard deviation to "
               "either side. p (Holm) over all rows. This analysis was not planned: the test of "
               "equal slopes asked for it.",
               listed(slopes))};
  table.provenance.n = comparedTrainees(study);
  table.provenance.missing = study.endMissing;
  return table;
}

std::vector<ReportFigure> differenceFigures(const CohortInputs& in, const StudyAnalysis& study) {
  if (!study.ancova) {
    return {};
  }
  ReportFigure points =
      forestOf(in, "figure-differences",
               Text::tr("Differences between the groups at the end, adjusted for the score before"),
               Text::tr("difference (points)"),
               study.mixed ? Text::tr("linear mixed model; analysis of covariance, one pooled slope")
                           : Text::tr("analysis of covariance, one pooled slope"));
  ReportFigure effects =
      forestOf(in, "figure-effects", Text::tr("Standardised differences of the scores at the end"),
               Text::tr("Hedges g"), Text::tr("Hedges g, interval from the noncentral t distribution"));
  FigureSeries difference;
  FigureSeries primary;
  FigureSeries effect;
  difference.name = study.mixed ? Text::tr("complete cases [95 %]") : Text::tr("difference [95 %]");
  primary.name = Text::tr("mixed model, primary [95 %]");
  effect.name = Text::tr("Hedges g [95 %]");
  const Groups& after = study.ends.after;
  for (std::size_t i = 0; i < study.ancova->pairs.size(); ++i) {
    const AdjustedDifference& pair = study.ancova->pairs[i];
    points.categories.push_back(pairName(in, pair.first, pair.second));
    addInterval(difference, pair.difference, pair.interval);
    if (study.mixed) {
      const ModelEstimate& of = study.mixed->pairs[i].difference;
      addInterval(primary, of.value, of.interval);
    }
    if (const Outcome<HedgesG> g = hedgesG(after[pair.first], after[pair.second])) {
      effects.categories.push_back(pairName(in, pair.first, pair.second));
      addInterval(effect, g->g, g->interval);
    }
  }
  points.series = study.mixed ? std::vector{primary, difference} : std::vector{difference};
  effects.series = {effect};
  std::vector<ReportFigure> figures;
  for (ReportFigure* figure : {&points, &effects}) {
    if (figure->categories.empty()) {
      continue;
    }
    figure->references = {{0.0, Text::tr("no difference")}};
    figure->provenance.n = comparedTrainees(study);
    figure->provenance.missing = study.endMissing;
    figure->notes = {
        Text::tr("First group minus second group. An interval that crosses zero leaves the direction open. "
                 "Intervals are not adjusted for the number of pairs.")};
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

std::vector<ReportFigure> residualFigures(const CohortInputs& in, const StudyAnalysis& study) {
  if (!study.ancova) {
    return {};
  }
  const Ancova& model = *study.ancova;
  ReportFigure fitted =
      itemOf<ReportFigure>(in, "figure-residuals", Text::tr("Residuals of the analysis of covariance"),
                           Text::tr("score at the end minus what the model says"));
  ReportFigure normal =
      itemOf<ReportFigure>(in, "figure-qq", Text::tr("Residuals against a normal distribution"),
                           Text::tr("residuals in order against normal quantiles at (i - 0.5) / n"));
  fitted.xLabel = Text::tr("what the model says (points)");
  fitted.yLabel = Text::tr("residual (points)");
  fitted.references = {{0.0, Text::tr("as the model says")}};
  normal.xLabel = Text::tr("normal quantile times standard deviation (points)");
  normal.yLabel = Text::tr("residual (points)");
  std::vector<double> all;
  for (const std::size_t g : model.groups) {
    FigureSeries series;
    series.name = in.groups[g].name;
    series.x = model.fitted[g];
    series.y.assign(model.residuals[g].begin(), model.residuals[g].end());
    fitted.series.push_back(series);
    series.x = model.quantiles[g];
    normal.series.push_back(std::move(series));
    all.insert(all.end(), model.residuals[g].begin(), model.residuals[g].end());
  }
  normal.series.push_back(normalLine(normal.series));
  const Outcome<NormalityTest> shape = shapiroWilk(all);
  fitted.notes = {Text::tr(
      "A fan or bow shape indicates that the spread or the slope violates the model's assumptions.")};
  normal.notes = {
      shape ? Text::tr("Normal residuals lie along the line. Shapiro and Wilk: W = %1, %2; for looking at, "
                       "not for choosing a test.",
                       formatFixed(shape->w, 3), equalsP(shape->p))
            : Text::tr("Normal residuals lie along the line.")};
  for (ReportFigure* figure : {&fitted, &normal}) {
    figure->kind = FigureKind::kScatter;
    figure->individual = true;  // a point is a person
    figure->provenance.n = comparedTrainees(study);
    figure->provenance.missing = study.endMissing;
  }
  return {std::move(fitted), std::move(normal)};
}

}  // namespace torsio
