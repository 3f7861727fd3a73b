// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "assessment/report/number_format.h"
#include "assessment/report/report_labels.h"
#include "assessment/report/report_sections.h"
#include "assessment/report/study_analysis.h"
#include "sim/base/text_list.h"

namespace torsio {

namespace {

constexpr int kDecimals = 3;

ReportTable tableOf(const CohortInputs& in, const std::string& id, const Text& title, const Text& formula) {
  ReportTable table;
  table.id = id;
  table.title = title;
  table.provenance.formula = formula;
  table.provenance.formulaVersion = kTrainingFormulaVersion;
  table.provenance.flags = commonFlags(in);
  return table;
}

ReportFigure forestOf(const CohortInputs& in, const std::string& id, const Text& title, const Text& axis,
                      const Text& formula) {
  ReportFigure figure;
  figure.id = id;
  figure.title = title;
  figure.kind = FigureKind::kForest;
  figure.yLabel = axis;
  figure.provenance.formula = formula;
  figure.provenance.formulaVersion = kTrainingFormulaVersion;
  figure.provenance.flags = commonFlags(in);
  return figure;
}

void addInterval(FigureSeries& series, double value, const Interval& interval) {
  series.y.emplace_back(value);
  series.low.push_back(interval.lower);
  series.high.push_back(interval.upper);
}

Text pairName(const CohortInputs& in, std::size_t first, std::size_t second) {
  return Text::verbatim("%1 - %2", in.groups[first].name, in.groups[second].name);
}

ReportTable agreementTable(const CohortInputs& in, const StudyAnalysis& study) {
  ReportTable table = tableOf(in, "table-agreement", Text::tr("Agreement of the raters at each occasion"),
                              Text::tr("Shrout and Fleiss ICC(2,1), ICC(2,k); Krippendorff alpha"));
  table.columns = {Text::tr("Occasion"), Text::tr("ICC(2,1) [95 %]"), Text::tr("ICC(2,k) [95 %]"),
                   Text::tr("SEM (points)"), Text::tr("Krippendorff alpha")};
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    const OccasionMarks& at = study.occasions[t];
    table.provenance.n += at.n;
    table.provenance.missing += at.missing;
    const Outcome<IccResult>& icc = at.icc;
    table.rows.push_back(
        {in.occasions[t],
         icc ? Text(withInterval(icc->agreementSingle.estimate, icc->agreementSingle.interval))
             : notDefined(icc.reason()),
         icc ? Text(withInterval(icc->agreementMean.estimate, icc->agreementMean.interval))
             : notDefined(icc.reason()),
         icc ? Text(formatFixed(icc->semAgreement, kDecimals)) : Text::tr("not defined"),
         at.alpha ? Text(formatFixed(at.alpha->alpha, kDecimals)) : notDefined(at.alpha.reason())});
  }
  table.notes = {Text::tr(
      "ICC: absolute agreement, raters as a random sample; (2,1) for one rater, (2,k) for the mean over all, "
      "which is the reported score. Alpha with the interval metric. A group that is much alike gives a low "
      "coefficient even when raters agree well: look at the standard error of measurement (SEM).")};
  return table;
}

/// Agreement at each scoring point with its interval: for one rater, and for the mean that is reported.
std::optional<ReportFigure> agreementFigure(const CohortInputs& in, const StudyAnalysis& study) {
  ReportFigure figure =
      forestOf(in, "figure-agreement", Text::tr("Agreement of the raters with 95 % intervals"),
               Text::tr("intraclass correlation"), Text::tr("Shrout and Fleiss ICC(2,1), ICC(2,k)"));
  FigureSeries one;
  FigureSeries mean;
  one.name = Text::tr("ICC(2,1), one rater");
  mean.name = Text::tr("ICC(2,k), mean of all raters");
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    const OccasionMarks& at = study.occasions[t];
    if (!at.icc || !at.icc->agreementSingle.interval || !at.icc->agreementMean.interval) {
      continue;
    }
    figure.categories.push_back(in.occasions[t]);
    addInterval(one, at.icc->agreementSingle.estimate, *at.icc->agreementSingle.interval);
    addInterval(mean, at.icc->agreementMean.estimate, *at.icc->agreementMean.interval);
    figure.provenance.n += at.n;
    figure.provenance.missing += at.missing;
  }
  if (figure.categories.empty()) {
    return std::nullopt;
  }
  figure.series = {one, mean};
  figure.yMin = std::min(0.0, *std::min_element(one.low.begin(), one.low.end()));
  figure.yMax = 1.0;
  figure.notes = {Text::tr("1 is perfect agreement; 0 is what marks by chance would give.")};
  return figure;
}

/// Adjusted differences in points, and standardised differences, each with interval and zero line.
std::vector<ReportFigure> differenceFigures(const CohortInputs& in, const StudyAnalysis& study) {
  if (!study.ancova) {
    return {};
  }
  ReportFigure points =
      forestOf(in, "figure-differences",
               Text::tr("Differences between the groups at the end, adjusted for the score before"),
               Text::tr("difference (points)"), Text::tr("analysis of covariance, one pooled slope"));
  ReportFigure effects =
      forestOf(in, "figure-effects", Text::tr("Standardised differences of the scores at the end"),
               Text::tr("Hedges g"), Text::tr("Hedges g, interval from the noncentral t distribution"));
  FigureSeries difference;
  FigureSeries effect;
  difference.name = Text::tr("difference [95 %]");
  effect.name = Text::tr("Hedges g [95 %]");
  const Groups& after = *study.scores.back();
  for (const AdjustedDifference& pair : study.ancova->pairs) {
    points.categories.push_back(pairName(in, pair.first, pair.second));
    addInterval(difference, pair.difference, pair.interval);
    const Outcome<HedgesG> g = hedgesG(after[pair.first], after[pair.second]);
    if (!g) {
      continue;
    }
    effects.categories.push_back(pairName(in, pair.first, pair.second));
    addInterval(effect, g->g, g->interval);
  }
  std::vector<ReportFigure> figures;
  for (auto [figure, series] : {std::pair{&points, &difference}, std::pair{&effects, &effect}}) {
    if (figure->categories.empty()) {
      continue;
    }
    figure->series = {*series};
    figure->references = {{0.0, Text::tr("no difference")}};
    for (const std::vector<double>& group : after) {
      figure->provenance.n += std::ssize(group);
    }
    figure->notes = {
        Text::tr("First group minus second group. An interval that crosses zero leaves the direction open.")};
    figures.push_back(*figure);
  }
  return figures;
}

ReportTable covarianceTable(const CohortInputs& in, const StudyAnalysis& study) {
  ReportTable table =
      tableOf(in, "table-ancova", Text::tr("Scores at the end, adjusted for the score before"),
              Text::tr("analysis of covariance, one pooled slope"));
  table.columns = {Text::tr("Comparison"), Text::tr("Difference [95 %]"),
                   Text::verbatim("t"),    Text::verbatim("p"),
                   Text::tr("p (Holm)"),   Text::tr("Hedges g of the end scores [95 %]")};
  const Outcome<Ancova>& got = study.ancova;
  const Groups& after = *study.scores.back();
  if (!got) {
    table.rows.push_back({notDefined(got.reason()), "", "", "", "", ""});
    return table;
  }
  for (const AdjustedDifference& pair : got->pairs) {
    const Outcome<HedgesG> g = hedgesG(after[pair.first], after[pair.second]);
    table.rows.push_back({pairName(in, pair.first, pair.second), withInterval(pair.difference, pair.interval),
                          formatFixed(pair.t, 2), formatP(pair.p), formatP(pair.pHolm),
                          g ? Text(withInterval(g->g, g->interval)) : notDefined(g.reason())});
  }
  std::vector<Text> means;
  for (std::size_t i = 0; i < got->adjusted.size(); ++i) {
    means.push_back(Text::verbatim("%1 %2", in.groups[i].name, formatFixed(got->adjusted[i].mean, 2)));
  }
  table.notes = {Text::tr("Effect of the group: F(%1, %2) = %3, %4. Adjusted means: %5.",
                          formatFixed(got->group.df1, 0), formatFixed(got->group.df2, 0),
                          formatFixed(got->group.f, 2), equalsP(got->group.p), listed(means)),
                 got->equalSlopes
                     ? Text::tr("Test of equal slopes: %1.", equalsP(got->equalSlopes->p))
                     : Text::tr("Test of equal slopes not defined: %1.", Text(got->equalSlopes.reason()))};
  for (const std::vector<double>& group : after) {
    table.provenance.n += std::ssize(group);
  }
  return table;
}

void addEffect(const Text& name, const AnovaEffect& effect, ReportTable& table) {
  table.rows.push_back(
      {name, formatFixed(effect.f, 2),
       filledIn("%1, %2", {formatFixed(effect.df, 0), formatFixed(effect.dfError, 0)}), formatP(effect.p),
       effect.pGreenhouseGeisser ? Text(formatP(*effect.pGreenhouseGeisser)) : Text::tr("does not apply"),
       formatFixed(effect.generalizedEtaSquared, kDecimals)});
}

ReportTable courseTable(const CohortInputs& in, const StudyAnalysis& study) {
  ReportTable table = tableOf(in, "table-mixed-anova", Text::tr("Course of the groups over the occasions"),
                              Text::tr("analysis of variance, groups x occasions, type III"));
  table.columns = {Text::tr("Effect"),
                   Text::verbatim("F"),
                   Text::tr("Degrees of freedom"),
                   Text::verbatim("p"),
                   Text::tr("p (Greenhouse-Geisser)"),
                   Text::tr("Generalised eta squared")};
  for (const std::optional<Groups>& at : study.scores) {
    for (const std::vector<double>& group : *at) {
      table.provenance.n += std::ssize(group);
    }
  }
  const Outcome<MixedAnova>& got = study.course;
  if (!got) {
    table.rows.push_back({notDefined(got.reason()), "", "", "", "", ""});
    return table;
  }
  if (got->interaction) {
    addEffect(Text::tr("group x occasion"), *got->interaction, table);
  }
  if (got->group) {
    addEffect(Text::tr("group"), *got->group, table);
  }
  addEffect(Text::tr("occasion"), got->time, table);
  table.notes = {
      Text::tr("The interaction is the question: whether the groups take different courses. "
               "Greenhouse-Geisser epsilon %1.",
               formatFixed(got->sphericity.greenhouseGeisser, kDecimals))};
  return table;
}

std::optional<ReportTable> gainTable(const CohortInputs& in, const StudyAnalysis& study) {
  if (study.wholeGains.empty()) {
    return std::nullopt;
  }
  const Groups& gains = study.wholeGains.front();
  const Outcome<KruskalWallis> got = kruskalWallis(gains);
  if (!got) {
    return std::nullopt;
  }
  ReportTable table = tableOf(in, "table-gains", Text::tr("Gain from before to the end, by ranks"),
                              Text::tr("Kruskal-Wallis, Dunn with Holm, exact Mann-Whitney"));
  table.columns = {Text::tr("Comparison"), Text::tr("Difference of mean ranks"), Text::tr("z (Dunn)"),
                   Text::tr("p (Holm)"),   Text::tr("P(first > second)"),        Text::tr("p (exact)")};
  for (const DunnPair& pair : got->pairs) {
    const Outcome<MannWhitney> exact = mannWhitney(gains[pair.first], gains[pair.second]);
    table.rows.push_back({pairName(in, pair.first, pair.second), formatFixed(-pair.difference, 2),
                          formatFixed(-pair.z, 2), formatP(pair.pHolm),
                          exact ? Text(formatFixed(exact->superiority, 2)) : notDefined(exact.reason()),
                          exact && exact->pExact ? Text(formatP(*exact->pExact)) : Text::tr("not counted")});
  }
  table.notes = {Text::tr("Kruskal-Wallis H = %1, %2, epsilon squared %3.", formatFixed(got->h, 2),
                          equalsP(got->p), formatFixed(got->epsilonSquared, kDecimals)),
                 Text::tr("A second look beside the analysis of covariance, which is the primary one. Gains "
                          "are ranked as whole "
                          "numbers.")};
  for (const std::vector<double>& group : gains) {
    table.provenance.n += std::ssize(group);
  }
  return table;
}

std::optional<ReportTable> modelsTable(const CohortInputs& in) {
  if (in.evaluations.size() < 2) {
    return std::nullopt;
  }
  std::map<std::string, std::vector<double>> byRater;
  for (const ModelEvaluation& model : in.evaluations) {
    for (const RaterComposite& composite : model.composites) {
      if (composite.score) {
        byRater[composite.rater].push_back(*composite.score);
      }
    }
  }
  std::vector<std::vector<double>> rows;
  for (const auto& [rater, scores] : byRater) {
    if (scores.size() == in.evaluations.size()) {
      rows.push_back(scores);
    }
  }
  if (rows.size() < 2) {
    return std::nullopt;
  }
  const Outcome<Friedman> got = friedman(NumberTable(rows));
  if (!got) {
    return std::nullopt;
  }
  ReportTable table = tableOf(in, "table-friedman", Text::tr("Order of the models over all raters"),
                              Text::tr("Friedman on the raters' own comprehensive scores"));
  table.columns = {Text::tr("Model"), Text::tr("Mean rank (1 is lowest)")};
  for (std::size_t k = 0; k < in.evaluations.size(); ++k) {
    table.rows.push_back(
        {in.evaluations[k].model, formatFixed(got->rankSums[k] / static_cast<double>(rows.size()), 2)});
  }
  table.notes = {Text::tr("Chi-squared(%1) = %2, %3; Kendall W = %4 over %5 raters.", formatFixed(got->df, 0),
                          formatFixed(got->chiSquared, 2), equalsP(got->p),
                          formatFixed(got->kendallW, kDecimals), rows.size())};
  table.provenance.formulaVersion = kEvaluationFormulaVersion;
  table.provenance.n = std::ssize(rows) * std::ssize(in.evaluations);
  return table;
}

}  // namespace

ReportSection analysisSection(const CohortInputs& in, const StudyAnalysis& study) {
  ReportSection section;
  section.title = Text::tr("Agreement and comparisons");
  if (in.demonstration) {
    section.paragraphs.push_back(Text::tr(
        "The marks are simulated. The tables show what is computed and how it is presented; their values "
        "mean nothing."));
  }
  section.paragraphs.push_back(Text::tr(
      "The analysis of covariance is the primary comparison; the others are given beside it. The trainee is "
      "the unit of analysis. p values are adjusted by Holm's method where it is said."));
  if (const std::optional<ReportFigure> figure = agreementFigure(in, study)) {
    section.figures.push_back(*figure);
  }
  section.tables.push_back(agreementTable(in, study));
  const bool whole = study.scores.size() >= 2 && std::all_of(study.scores.begin(), study.scores.end(),
                                                             [](const auto& at) { return at.has_value(); });
  if (whole) {
    for (const ReportFigure& figure : differenceFigures(in, study)) {
      section.figures.push_back(figure);
    }
    section.tables.push_back(covarianceTable(in, study));
    section.tables.push_back(courseTable(in, study));
    if (const std::optional<ReportTable> gains = gainTable(in, study)) {
      section.tables.push_back(*gains);
    }
  } else {
    section.paragraphs.push_back(Text::tr("Groups are not compared: scores are missing at some occasion."));
  }
  if (const std::optional<ReportTable> models = modelsTable(in)) {
    section.tables.push_back(*models);
  }
  return section;
}

}  // namespace torsio
