// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <utility>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr int kDecimals = 3;

void addEffect(const CohortInputs& in, const std::string& id, const Text& name, const AnovaEffect& effect,
               ReportTable& table) {
  const auto cell = [&](const char* statistic, const std::string& shown) {
    return ReportCell(shown, {.section = ResultSection::kComparison,
                              .statistic = id + statistic,
                              .occasion = in.occasions.size() - 1});
  };
  table.rows.push_back(
      {name, cell("_f", formatFixed(effect.f, 2)),
       filledIn("%1, %2", {formatFixed(effect.df, 0), formatFixed(effect.dfError, 0)}),
       cell("_p", formatP(effect.p)),
       effect.pGreenhouseGeisser ? cell("_p_greenhouse_geisser", formatP(*effect.pGreenhouseGeisser))
                                 : ReportCell(Text::tr("does not apply")),
       cell("_generalised_eta_squared", formatFixed(effect.generalizedEtaSquared, kDecimals))});
}

ReportTable courseTable(const CohortInputs& in, const StudyAnalysis& study) {
  ReportTable table =
      itemOf<ReportTable>(in, "table-mixed-anova", Text::tr("Course of the groups over the occasions"),
                          Text::tr("analysis of variance, groups x occasions, type III"));
  table.columns = {Text::tr("Effect"),
                   Text::verbatim("F"),
                   Text::tr("Degrees of freedom"),
                   Text::verbatim("p"),
                   Text::tr("p (Greenhouse-Geisser)"),
                   Text::tr("Generalised eta squared")};
  table.provenance.n = std::ssize(in.scores);
  const Outcome<MixedAnova>& got = study.course;
  if (!got) {
    table.rows.push_back({notDefined(got.reason()), "", "", "", "", ""});
    return table;
  }
  if (got->interaction) {
    addEffect(in, "mixed_interaction", Text::tr("group x occasion"), *got->interaction, table);
  }
  if (got->group) {
    addEffect(in, "mixed_group", Text::tr("group"), *got->group, table);
  }
  addEffect(in, "mixed_time", Text::tr("occasion"), got->time, table);
  table.notes = {
      Text::tr("The interaction is the question: whether the groups take different courses. "
               "Greenhouse-Geisser epsilon %1.",
               formatFixed(got->sphericity.greenhouseGeisser, kDecimals))};
  if (!study.leftOutOfCourse.empty()) {
    const std::vector<Text> codes(study.leftOutOfCourse.begin(), study.leftOutOfCourse.end());
    table.notes.push_back(Text::tr(
        "Left out, without a score at every occasion: %1.",
        in.identity == ReportIdentity::kAggregated ? Text::tr("%1 trainees", codes.size()) : listed(codes)));
  }
  return table;
}

std::optional<ReportTable> gainTable(const CohortInputs& in, const StudyAnalysis& study) {
  if (!study.gains) {
    return std::nullopt;
  }
  const Outcome<KruskalWallis>& got = study.gains->between;
  ReportTable table =
      itemOf<ReportTable>(in, "table-gains", Text::tr("Gain from before to the end, by ranks"),
                          Text::tr("Kruskal-Wallis, Dunn with Holm, exact Mann-Whitney"));
  table.columns = {Text::tr("Comparison"), Text::tr("Difference of mean ranks"), Text::tr("z (Dunn)"),
                   Text::tr("p (Holm)"),   Text::tr("P(first > second)"),        Text::tr("p (exact)")};
  for (const std::vector<double>& group : study.gains->gains) {
    table.provenance.n += std::ssize(group);
  }
  if (!got) {
    table.rows.push_back({notDefined(got.reason()), "", "", "", "", ""});
    return table;
  }
  for (std::size_t i = 0; i < got->pairs.size(); ++i) {
    const DunnPair& pair = got->pairs[i];
    const Outcome<MannWhitney>& exact = study.gains->pairs[i];
    const CellsAt cell = cellsOfPair(in, pair.first, pair.second);
    table.rows.push_back(
        {pairName(in, pair.first, pair.second),
         cell("gain_difference_of_mean_ranks", formatFixed(-pair.difference, 2)),
         cell("gain_dunn_z", formatFixed(-pair.z, 2)), cell("gain_dunn_p_holm", formatP(pair.pHolm)),
         cell("gain_superiority",
              exact ? Text(formatFixed(exact->superiority, 2)) : notDefined(exact.reason())),
         cell("gain_mann_whitney_p_exact",
              exact && exact->pExact ? Text(formatP(*exact->pExact)) : Text(Text::tr("not counted")))});
  }
  table.notes = {
      Text::tr("Kruskal-Wallis H = %1, %2, epsilon squared %3.", formatFixed(got->h, 2), equalsP(got->p),
               formatFixed(got->epsilonSquared, kDecimals)),
      Text::tr("A second look beside the primary comparison. Gains are ranked as whole numbers, of the "
               "trainees with a score at both occasions. p (Holm) is Dunn's; p (exact) is of this pair "
               "alone.")};
  return table;
}

std::optional<ReportTable> modelsTable(const CohortInputs& in) {
  const std::optional<ModelOrder> order = modelOrder(in);
  if (!order) {
    return std::nullopt;
  }
  const Outcome<Friedman>& got = order->test;
  ReportTable table =
      itemOf<ReportTable>(in, "table-friedman", Text::tr("Order of the models over all raters"),
                          Text::tr("Friedman on the raters' own comprehensive scores"));
  table.columns = {Text::tr("Model"), Text::tr("Mean rank (1 is lowest)")};
  table.provenance.formulaVersion = kEvaluationFormulaVersion;
  table.provenance.n = order->raters * std::ssize(in.evaluations);
  if (!got) {
    table.rows.push_back({notDefined(got.reason()), ""});
    return table;
  }
  for (std::size_t k = 0; k < in.evaluations.size(); ++k) {
    const CellsAt cell({.section = ResultSection::kEvaluation, .model = in.evaluations[k].model});
    table.rows.push_back({in.evaluations[k].model, cell("mean_rank", formatFixed(order->meanRanks[k], 2))});
  }
  table.notes = {Text::tr("Chi-squared(%1) = %2, %3; Kendall W = %4 over %5 {rater|raters}.",
                          formatFixed(got->df, 0), formatFixed(got->chiSquared, 2), equalsP(got->p),
                          formatFixed(got->kendallW, kDecimals), order->raters)};
  return table;
}

}  // namespace

std::optional<ModelOrder> modelOrder(const CohortInputs& in) {
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
  ModelOrder out;
  out.raters = std::ssize(rows);
  out.test = friedman(NumberTable(rows));
  if (out.test) {
    for (const double sum : out.test->rankSums) {
      out.meanRanks.push_back(sum / static_cast<double>(rows.size()));
    }
  }
  return out;
}

ReportSection analysisSection(const CohortInputs& in, const StudyAnalysis& study) {
  ReportSection section{"comparisons", Text::tr("Agreement and comparisons")};
  if (in.demonstration) {
    section.paragraphs.push_back(Text::tr(
        "The marks are simulated. The tables show what is computed and how it is presented; their values "
        "mean nothing."));
  }
  for (const Text& sentence : plannedAndUsed(in, study)) {
    section.paragraphs.push_back(sentence);
  }
  section.paragraphs.push_back(Text::tr(
      "The trainee is the unit of analysis. p values are adjusted by Holm's method where it is said."));
  const auto addTable = [&](std::optional<ReportTable> table) {
    if (table) {
      section.tables.push_back(std::move(*table));
    }
  };
  if (std::optional<ReportFigure> figure = agreementFigure(in, study)) {
    section.figures.push_back(std::move(*figure));
  }
  addTable(agreementTable(in, study));
  addTable(agreementWithinTable(in, study));
  addTable(kappaTable(in, study));
  if (study.occasions.size() >= 2) {
    for (ReportFigure& figure : differenceFigures(in, study)) {
      section.figures.push_back(std::move(figure));
    }
    for (ReportFigure& figure : residualFigures(in, study)) {
      section.figures.push_back(std::move(figure));
    }
    addTable(meansTable(in, study));
    addTable(missingTable(in, study));
    addTable(mixedModelTable(in, study));
    addTable(covarianceTable(in, study));
    addTable(slopesTable(in, study));
    addTable(boundsTable(in, study));
    addTable(equivalenceTable(in, study));
    if (!in.equivalenceMargin) {
      section.paragraphs.push_back(Text::tr(
          "No margin was planned within which a difference would not matter. Nothing here shows that "
          "groups are equal, however far a difference is from significant."));
    }
    addTable(courseTable(in, study));
    addTable(gainTable(in, study));
  } else {
    section.paragraphs.push_back(Text::tr("Groups are not compared: there are fewer than two occasions."));
  }
  addTable(modelsTable(in));
  return section;
}

}  // namespace torsio
