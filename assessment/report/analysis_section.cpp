// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "assessment/report/number_format.h"
#include "assessment/report/report_sections.h"
#include "assessment/statistics/ancova.h"
#include "assessment/statistics/categorical_agreement.h"
#include "assessment/statistics/mixed_anova.h"
#include "assessment/statistics/rank_tests.h"
#include "assessment/statistics/reliability.h"

namespace torsio {

namespace {

constexpr int kDecimals = 3;

std::string withInterval(double value, const std::optional<Interval>& interval) {
  if (!interval) return formatFixed(value, kDecimals);
  return sentence({formatFixed(value, kDecimals), " [", formatFixed(interval->lower, kDecimals), ", ",
                   formatFixed(interval->upper, kDecimals), "]"});
}

std::string notDefined(const std::string& reason) {
  return sentence({"not defined: ", reason});
}

ReportTable tableOf(const CohortInputs& in, const std::string& id, const std::string& title,
                    const std::string& formula) {
  ReportTable table;
  table.id = id;
  table.title = title;
  table.provenance.formula = formula;
  table.provenance.formulaVersion = kTrainingFormulaVersion;
  table.provenance.flags = commonFlags(in);
  return table;
}

/// Marks of one scoring point: trainees x raters; a mark that was not given stays empty.
std::vector<std::vector<std::optional<double>>> marksAt(const CohortInputs& in, std::size_t occasion) {
  std::map<std::string, std::size_t> trainees;
  std::map<std::string, std::size_t> raters;
  for (const TrainingMark& mark : in.trainingMarks) {
    trainees.emplace(mark.trainee, 0);
    raters.emplace(mark.rater, 0);
  }
  std::size_t number = 0;
  for (auto& [code, at] : trainees) at = number++;
  number = 0;
  for (auto& [code, at] : raters) at = number++;
  std::vector<std::vector<std::optional<double>>> rows(trainees.size(),
                                                       std::vector<std::optional<double>>(raters.size()));
  for (const TrainingMark& mark : in.trainingMarks)
    if (mark.occasion == occasion)
      rows[trainees.at(mark.trainee)][raters.at(mark.rater)] = pointsFromSteps(mark.steps, in.trainingScale);
  return rows;
}

ReportTable agreementTable(const CohortInputs& in) {
  ReportTable table = tableOf(in, "table-agreement", "Agreement of the raters at each scoring point",
                              "Shrout and Fleiss ICC(2,1), ICC(2,k); Krippendorff alpha");
  table.columns = {"Scoring point", "ICC(2,1) [95 %]", "ICC(2,k) [95 %]", "SEM (points)",
                   "Krippendorff alpha"};
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    const std::vector<std::vector<std::optional<double>>> marks = marksAt(in, t);
    std::vector<std::vector<double>> complete;
    IncompleteRatings byRater(marks.empty() ? 0 : marks.front().size(),
                              std::vector<std::optional<double>>(marks.size()));
    for (std::size_t i = 0; i < marks.size(); ++i) {
      std::vector<double> row;
      for (std::size_t r = 0; r < marks[i].size(); ++r) {
        byRater[r][i] = marks[i][r];
        if (marks[i][r]) row.push_back(*marks[i][r]);
      }
      if (row.size() == marks[i].size()) complete.push_back(row);
      table.provenance.n += std::ssize(row);
      table.provenance.missing += std::ssize(marks[i]) - std::ssize(row);
    }
    std::vector<std::string> row = {in.occasions[t]};
    const bool whole = complete.size() == marks.size();
    const Outcome<IccResult> icc = whole ? intraclassCorrelation(NumberTable(complete))
                                         : Outcome<IccResult>::undefined("marks are missing");
    row.push_back(icc ? withInterval(icc->agreementSingle.estimate, icc->agreementSingle.interval)
                      : notDefined(icc.reason()));
    row.push_back(icc ? withInterval(icc->agreementMean.estimate, icc->agreementMean.interval)
                      : notDefined(icc.reason()));
    row.push_back(icc ? formatFixed(icc->semAgreement, kDecimals) : std::string("not defined"));
    const Outcome<KrippendorffResult> alpha = krippendorffAlpha(byRater, AlphaMetric::kInterval);
    row.push_back(alpha ? formatFixed(alpha->alpha, kDecimals) : notDefined(alpha.reason()));
    table.rows.push_back(row);
  }
  table.notes = {
      "ICC: absolute agreement, raters as a random sample; (2,1) for one rater, (2,k) for the mean over all, "
      "which is the reported score. Alpha with the interval metric. A group that is much alike gives a low "
      "coefficient even when raters agree well: look at the standard error of measurement (SEM)."};
  return table;
}

/// Scores of one scoring point by group, in the order of the trainee codes; empty when a trainee lacks one.
std::optional<Groups> groupsAt(const CohortInputs& in, std::size_t occasion) {
  std::vector<std::map<std::string, double>> byGroup(in.groups.size());
  for (const TraineeScore& score : in.scores)
    if (score.occasion == occasion) byGroup[score.group][score.trainee] = score.score;
  Groups out;
  for (std::size_t g = 0; g < byGroup.size(); ++g) {
    std::size_t members = 0;
    for (const CohortTrainee& trainee : in.trainees) members += trainee.group == g ? 1 : 0;
    if (byGroup[g].size() != members) return std::nullopt;
    out.emplace_back();
    for (const auto& [code, score] : byGroup[g]) out.back().push_back(score);
  }
  return out;
}

ReportTable covarianceTable(const CohortInputs& in, const Groups& before, const Groups& after) {
  ReportTable table = tableOf(in, "table-ancova", "Scores at the end, adjusted for the score before",
                              "analysis of covariance, one pooled slope");
  table.columns = {"Comparison", "Difference [95 %]", "t",
                   "p",          "p (Holm)",          "Hedges g of the end scores [95 %]"};
  const Outcome<Ancova> got = ancova(before, after);
  if (!got) {
    table.rows.push_back({notDefined(got.reason()), "", "", "", "", ""});
    return table;
  }
  for (const AdjustedDifference& pair : got->pairs) {
    const Outcome<HedgesG> g = hedgesG(after[pair.first], after[pair.second]);
    table.rows.push_back({sentence({in.groups[pair.first].name, " - ", in.groups[pair.second].name}),
                          withInterval(pair.difference, pair.interval), formatFixed(pair.t, 2),
                          formatP(pair.p), formatP(pair.pHolm),
                          g ? withInterval(g->g, g->interval) : notDefined(g.reason())});
  }
  std::string means;
  for (std::size_t i = 0; i < got->adjusted.size(); ++i)
    means += sentence({i == 0 ? "" : ", ", in.groups[i].name, " ", formatFixed(got->adjusted[i].mean, 2)});
  table.notes = {
      sentence({"Effect of the group: F(", formatFixed(got->group.df1, 0), ", ",
                formatFixed(got->group.df2, 0), ") = ", formatFixed(got->group.f, 2), ", p ",
                got->group.p < 0.001 ? "" : "= ", formatP(got->group.p), ". Adjusted means: ", means, "."}),
      got->equalSlopes ? sentence({"Test of equal slopes: p ", got->equalSlopes->p < 0.001 ? "" : "= ",
                                   formatP(got->equalSlopes->p), "."})
                       : sentence({"Test of equal slopes not defined: ", got->equalSlopes.reason(), "."})};
  for (const std::vector<double>& group : after) table.provenance.n += std::ssize(group);
  return table;
}

void addEffect(const std::string& name, const AnovaEffect& effect, ReportTable& table) {
  table.rows.push_back(
      {name, formatFixed(effect.f, 2),
       sentence({formatFixed(effect.df, 0), ", ", formatFixed(effect.dfError, 0)}), formatP(effect.p),
       effect.pGreenhouseGeisser ? formatP(*effect.pGreenhouseGeisser) : std::string("does not apply"),
       formatFixed(effect.generalizedEtaSquared, kDecimals)});
}

ReportTable courseTable(const CohortInputs& in, const std::vector<Groups>& occasions) {
  ReportTable table = tableOf(in, "table-mixed-anova", "Course of the groups over the scoring points",
                              "analysis of variance, groups x scoring points, type III");
  table.columns = {
      "Effect", "F", "Degrees of freedom", "p", "p (Greenhouse-Geisser)", "Generalised eta squared"};
  std::vector<NumberTable> groups;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    NumberTable scores(occasions.front()[g].size(), occasions.size());
    for (std::size_t t = 0; t < occasions.size(); ++t)
      for (std::size_t i = 0; i < scores.rows(); ++i) scores.at(i, t) = occasions[t][g][i];
    table.provenance.n += static_cast<std::int64_t>(scores.rows() * scores.columns());
    groups.push_back(scores);
  }
  const Outcome<MixedAnova> got = mixedAnova(groups);
  if (!got) {
    table.rows.push_back({notDefined(got.reason()), "", "", "", "", ""});
    return table;
  }
  if (got->interaction) addEffect("group x scoring point", *got->interaction, table);
  if (got->group) addEffect("group", *got->group, table);
  addEffect("scoring point", got->time, table);
  table.notes = {
      sentence({"The interaction is the question; everybody improves with time. Greenhouse-Geisser epsilon ",
                formatFixed(got->sphericity.greenhouseGeisser, kDecimals), "."})};
  return table;
}

std::optional<ReportTable> gainTable(const CohortInputs& in) {
  Groups gains;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    const std::optional<std::vector<std::int64_t>> exact =
        exactGains(in.scores, 0, in.occasions.size() - 1, g);
    if (!exact) return std::nullopt;
    gains.emplace_back();
    for (const std::int64_t gain : *exact) gains.back().push_back(static_cast<double>(gain));
  }
  const Outcome<KruskalWallis> got = kruskalWallis(gains);
  if (!got) return std::nullopt;
  ReportTable table = tableOf(in, "table-gains", "Gain from before to the end, by ranks",
                              "Kruskal-Wallis, Dunn with Holm, exact Mann-Whitney");
  table.columns = {"Comparison", "Difference of mean ranks", "z (Dunn)",
                   "p (Holm)",   "P(first > second)",        "p (exact)"};
  for (const DunnPair& pair : got->pairs) {
    const Outcome<MannWhitney> exact = mannWhitney(gains[pair.first], gains[pair.second]);
    table.rows.push_back({sentence({in.groups[pair.first].name, " - ", in.groups[pair.second].name}),
                          formatFixed(-pair.difference, 2), formatFixed(-pair.z, 2), formatP(pair.pHolm),
                          exact ? formatFixed(exact->superiority, 2) : notDefined(exact.reason()),
                          exact && exact->pExact ? formatP(*exact->pExact) : std::string("not counted")});
  }
  table.notes = {
      sentence({"Kruskal-Wallis H = ", formatFixed(got->h, 2), ", p ", got->p < 0.001 ? "" : "= ",
                formatP(got->p), ", epsilon squared ", formatFixed(got->epsilonSquared, kDecimals), "."}),
      "A second look beside the analysis of covariance, which is the primary one. Gains are ranked as whole "
      "numbers."};
  for (const std::vector<double>& group : gains) table.provenance.n += std::ssize(group);
  return table;
}

std::optional<ReportTable> modelsTable(const CohortInputs& in) {
  if (in.evaluations.size() < 2) return std::nullopt;
  std::map<std::string, std::vector<double>> byRater;
  for (const ModelEvaluation& model : in.evaluations)
    for (const RaterComposite& composite : model.composites)
      if (composite.score) byRater[composite.rater].push_back(*composite.score);
  std::vector<std::vector<double>> rows;
  for (const auto& [rater, scores] : byRater)
    if (scores.size() == in.evaluations.size()) rows.push_back(scores);
  if (rows.size() < 2) return std::nullopt;
  const Outcome<Friedman> got = friedman(NumberTable(rows));
  if (!got) return std::nullopt;
  ReportTable table = tableOf(in, "table-friedman", "Order of the models over all raters",
                              "Friedman on the raters' own comprehensive scores");
  table.columns = {"Model", "Mean rank (1 is lowest)"};
  for (std::size_t k = 0; k < in.evaluations.size(); ++k)
    table.rows.push_back(
        {in.evaluations[k].model, formatFixed(got->rankSums[k] / static_cast<double>(rows.size()), 2)});
  table.notes = {sentence({"Chi-squared(", formatFixed(got->df, 0), ") = ", formatFixed(got->chiSquared, 2),
                           ", p ", got->p < 0.001 ? "" : "= ", formatP(got->p),
                           "; Kendall W = ", formatFixed(got->kendallW, kDecimals), " over ",
                           std::to_string(rows.size()), " raters."})};
  table.provenance.formulaVersion = kEvaluationFormulaVersion;
  table.provenance.n = std::ssize(rows) * std::ssize(in.evaluations);
  return table;
}

}  // namespace

ReportSection analysisSection(const CohortInputs& in) {
  ReportSection section;
  section.title = "Agreement and comparisons";
  if (in.demonstration)
    section.paragraphs.push_back(
        "The marks are simulated. The tables show what is computed and how it is presented; their values "
        "mean nothing.");
  section.paragraphs.push_back(
      "The analysis of covariance is the primary comparison; the others are given beside it. The trainee is "
      "the unit of analysis. p values are adjusted by Holm's method where it is said.");
  section.tables.push_back(agreementTable(in));
  std::vector<Groups> occasions;
  for (std::size_t t = 0; t < in.occasions.size(); ++t)
    if (const std::optional<Groups> groups = groupsAt(in, t)) occasions.push_back(*groups);
  if (occasions.size() == in.occasions.size() && occasions.size() >= 2) {
    section.tables.push_back(covarianceTable(in, occasions.front(), occasions.back()));
    section.tables.push_back(courseTable(in, occasions));
    if (const std::optional<ReportTable> gains = gainTable(in)) section.tables.push_back(*gains);
  } else {
    section.paragraphs.push_back("Groups are not compared: scores are missing at some scoring point.");
  }
  if (const std::optional<ReportTable> models = modelsTable(in)) section.tables.push_back(*models);
  return section;
}

}  // namespace torsio
