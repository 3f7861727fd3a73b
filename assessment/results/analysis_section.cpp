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

ReportTable courseTable(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  ReportTable table =
      itemOf<ReportTable>(in, "table-mixed-anova", Text::tr("Course of the groups over the occasions"),
                          Text::tr("analysis of variance, groups x occasions, type III"));
  table.columns = {Text::tr("Effect"),
                   Text::verbatim("F"),
                   Text::tr("Degrees of freedom"),
                   Text::verbatim("p"),
                   Text::tr("p (Greenhouse-Geisser)"),
                   Text::tr("Generalised eta squared")};
  table.provenance.n = ResultsAt(ledger, {}).count("scores");
  const Outcome<MixedAnova>& got = study.course;
  if (!got) {
    table.rows.push_back({notDefined(got.reason()), "", "", "", "", ""});
    return table;
  }
  const ResultsAt cell = resultsAtEnd(ledger);
  for (const auto& [id, name] :
       std::vector<std::pair<std::string, Phrase>>{{"mixed_interaction", Text::tr("group x occasion")},
                                                   {"mixed_group", Text::tr("group")},
                                                   {"mixed_time", Text::tr("occasion")}}) {
    if (cell.find(id + "_f") == nullptr) {
      continue;
    }
    const ReportCell df = cell(id + "_df", fixed(0));
    table.rows.push_back(
        {name,
         cell(id + "_f", fixed(2)),
         {Text::verbatim("%1,\u00A0%2", df.words(), cell(id + "_df_error", fixed(0)).words()), df.key},
         cell(id + "_p", kAsP),
         cell(id + "_p_greenhouse_geisser", kAsP, Text::tr("does not apply")),
         cell(id + "_generalised_eta_squared", fixed(kDecimals))});
  }
  const ReportCell epsilon = cell("greenhouse_geisser_epsilon", fixed(kDecimals));
  const Text correction = Text::tr("Greenhouse-Geisser epsilon %1.", epsilon.words());
  table.notes = {{cell.find("mixed_interaction_f") == nullptr
                      ? correction
                      : Text(Text::tr("The interaction is the question: whether the groups take different "
                                      "courses. %1",
                                      correction)),
                  {epsilon}}};
  if (!study.leftOutOfCourse.empty()) {
    const std::vector<Text> codes(study.leftOutOfCourse.begin(), study.leftOutOfCourse.end());
    if (in.identity == ReportIdentity::kAggregated) {
      const ReportCell count = cell("trainees_without_every_score");
      const Text trainees = Text::tr("%1 trainees", count.words());
      table.notes.push_back(
          {Text::tr("Left out, without a score at every occasion: %1.", trainees), {count}});
    } else {
      table.notes.push_back(Text::tr("Left out, without a score at every occasion: %1.", listed(codes)));
    }
  }
  return table;
}

std::optional<ReportTable> gainTable(const CohortInputs& in, const StudyAnalysis& study,
                                     const Ledger& ledger) {
  if (!study.gains) {
    return std::nullopt;
  }
  const Outcome<KruskalWallis>& got = study.gains->between;
  ReportTable table =
      itemOf<ReportTable>(in, "table-gains", Text::tr("Gain from before to the end, by ranks"),
                          Text::tr("Kruskal-Wallis, Dunn with Holm, exact Mann-Whitney"));
  table.annex = true;  // a second look
  ResultTable rows(ledger, table,
                   {{Text::tr("Comparison")},
                    {Text::tr("Difference of mean ranks"), "gain_difference_of_mean_ranks", fixed(2)},
                    {Text::tr("z (Dunn)"), "gain_dunn_z", fixed(2)},
                    {Text::tr("p (Holm)"), "gain_dunn_p_holm", kAsP},
                    {Text::tr("P(first > second)"), "gain_superiority", fixed(2)},
                    {Text::tr("p (exact)"), "gain_mann_whitney_p_exact", kAsP, Text::tr("not counted")}});
  table.provenance.n = resultsAtEnd(ledger).count("trainees_compared");
  if (!got) {
    table.rows.push_back({notDefined(got.reason()), "", "", "", "", ""});
    return table;
  }
  for (const DunnPair& pair : got->pairs) {
    rows.row({pairName(in, pair.first, pair.second)}, pairKey(ledger, pair.first, pair.second));
  }
  const ResultsAt at = resultsAtEnd(ledger);
  const ReportCell h = at("gain_kruskal_wallis_h", fixed(2));
  const ReportCell p = at("gain_kruskal_wallis_p", kEqualsP);
  const ReportCell effect = at("gain_epsilon_squared", fixed(kDecimals));
  table.notes = {
      {Text::tr("Kruskal-Wallis H = %1, %2, epsilon squared %3.", h.words(), p.words(), effect.words()),
       {h, p, effect}},
      Text::tr("A second look beside the primary comparison. Gains are ranked as whole numbers, of the "
               "trainees with a score at both occasions. p (Holm) is Dunn's; p (exact) is of this pair "
               "alone.")};
  return table;
}

std::optional<ReportTable> modelsTable(const CohortInputs& in, const Ledger& ledger) {
  const std::optional<ModelOrder> order = modelOrder(in);
  if (!order) {
    return std::nullopt;
  }
  const Outcome<Friedman>& got = order->test;
  ReportTable table =
      itemOf<ReportTable>(in, "table-friedman", Text::tr("Order of the models over all raters"),
                          Text::tr("Friedman on the raters' own comprehensive scores"));
  table.annex = true;
  ResultTable rows(ledger, table,
                   {{Text::tr("Model")}, {Text::tr("Mean rank (1 is lowest)"), "mean_rank", fixed(2)}});
  table.provenance.formulaVersion = kEvaluationFormulaVersion;
  table.provenance.n = ResultsAt(ledger, {.section = ResultSection::kEvaluation}).count("composites_ranked");
  if (!got) {
    table.rows.push_back({notDefined(got.reason()), ""});
    return table;
  }
  for (const ModelEvaluation& model : in.evaluations) {
    rows.row({model.model}, {.section = ResultSection::kEvaluation, .model = model.model});
  }
  const ResultsAt at(ledger, {.section = ResultSection::kEvaluation});
  const ReportCell df = at("models_friedman_df", fixed(0));
  const ReportCell chiSquared = at("models_friedman_chi_squared", fixed(2));
  const ReportCell p = at("models_friedman_p", kEqualsP);
  const ReportCell w = at("models_kendall_w", fixed(kDecimals));
  const ReportCell raters = at("models_friedman_p", kValues);
  table.notes = {{Text::tr("Chi-squared(%1) = %2, %3; Kendall W = %4 over %5 {rater|raters}.", df.words(),
                           chiSquared.words(), p.words(), w.words(), raters.words()),
                  {df, chiSquared, p, w, raters}}};
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

ReportSection analysisSection(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  ReportSection section{"comparisons", Text::tr("Agreement and comparisons")};
  if (in.demonstration) {
    section.paragraphs.push_back(Text::tr(
        "The marks are simulated. The tables show what is computed and how it is presented; their values "
        "mean nothing."));
  }
  for (ReportParagraph& sentence : plannedAndUsed(in, study, ledger)) {
    section.paragraphs.push_back(std::move(sentence));
  }
  section.paragraphs.push_back(Text::tr(
      "The trainee is the unit of analysis. p values are adjusted by Holm's method where it is said."));
  const auto addTable = [&](std::optional<ReportTable> table) {
    if (table) {
      section.tables.push_back(std::move(*table));
    }
  };
  if (std::optional<ReportFigure> figure = agreementFigure(in, ledger)) {
    section.figures.push_back(std::move(*figure));
  }
  addTable(agreementTable(in, study, ledger));
  addTable(agreementWithinTable(in, study, ledger));
  addTable(kappaTable(in, ledger));
  if (study.occasions.size() >= 2) {
    for (ReportFigure& figure : differenceFigures(in, study, ledger)) {
      section.figures.push_back(std::move(figure));
    }
    for (ReportFigure& figure : residualFigures(in, study, ledger)) {
      section.figures.push_back(std::move(figure));
    }
    addTable(meansTable(in, ledger));
    addTable(missingTable(in, study, ledger));
    addTable(mixedModelTable(in, study, ledger));
    addTable(covarianceTable(in, study, ledger));
    addTable(sitesTable(in, study, ledger));
    addTable(heterogeneityTable(in, study, ledger));
    addTable(siteDifferencesTable(in, study, ledger));
    addTable(equipmentTable(in, study, ledger));
    addTable(slopesTable(in, study, ledger));
    addTable(boundsTable(in, study, ledger));
    addTable(equivalenceTable(in, study, ledger));
    if (!in.equivalenceMargin) {
      section.paragraphs.push_back(Text::tr(
          "No margin was planned within which a difference would not matter. Nothing here shows that "
          "groups are equal, however far a difference is from significant."));
    }
    addTable(courseTable(in, study, ledger));
    addTable(gainTable(in, study, ledger));
  } else {
    section.paragraphs.push_back(Text::tr("Groups are not compared: there are fewer than two occasions."));
  }
  addTable(modelsTable(in, ledger));
  return section;
}

}  // namespace torsio
