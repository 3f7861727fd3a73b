// SPDX-License-Identifier: GPL-3.0-or-later
// Differences between the models, paired by rater.
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "assessment/statistics/multiplicity.h"

namespace torsio {

namespace {

/// Returns the differences of the raters with both scores, by class.
Groups pairedByClass(const CohortInputs& in, const ModelEvaluation& first, const ModelEvaluation& second) {
  std::map<std::string, double> ofSecond;
  for (const RaterComposite& composite : second.composites) {
    if (composite.score) {
      ofSecond[composite.rater] = *composite.score;
    }
  }
  Groups out(in.instrument.classes.size());
  for (const RaterComposite& composite : first.composites) {
    const auto other = ofSecond.find(composite.rater);
    if (composite.score && other != ofSecond.end()) {
      out[composite.raterClass].push_back(*composite.score - other->second);
    }
  }
  return out;
}

}  // namespace

std::vector<ModelDifference> modelDifferences(const CohortInputs& in) {
  std::vector<double> weights;
  for (const RaterClass& one : in.instrument.classes) {
    weights.push_back(static_cast<double>(one.weight_milli));
  }
  std::vector<ModelDifference> out;
  std::vector<double> p;
  for (std::size_t i = 0; i < in.evaluations.size(); ++i) {
    for (std::size_t j = i + 1; j < in.evaluations.size(); ++j) {
      const Groups paired = pairedByClass(in, in.evaluations[i], in.evaluations[j]);
      ModelDifference pair;
      pair.first = i;
      pair.second = j;
      for (const std::vector<double>& raters : paired) {
        pair.raters += std::ssize(raters);
      }
      pair.test = stratifiedMean(paired, weights);
      p.push_back(pair.test ? pair.test->p : 1.0);
      out.push_back(std::move(pair));
    }
  }
  const std::vector<double> adjusted = adjustHolm(p);
  const std::vector<double> factors = holmFactors(p);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (const Outcome<TTest>& test = out[i].test) {
      out[i].pHolm = adjusted[i];
      out[i].asHolm = holmInterval(test->difference, test->error, test->df, factors[i], kDefaultConfidence);
    }
  }
  return out;
}

ResultKey modelPairKey(const CohortInputs& in, const ModelDifference& pair) {
  return {.section = ResultSection::kEvaluation,
          .model = in.evaluations[pair.first].model + " - " + in.evaluations[pair.second].model};
}

std::optional<ReportTable> modelDifferencesTable(const CohortInputs& in, const Ledger& ledger) {
  if (in.evaluations.size() < 2) {
    return std::nullopt;
  }
  auto table = itemOf<ReportTable>(in, "table-model-differences", Text::tr("Differences between the models"),
                                   Text::tr("each rater's difference, mean by class weight"));
  table.provenance.formulaVersion.clear();
  table.columns = {Text::tr("Comparison"), Text::tr("Raters"), Text::tr("Difference"),
                   Text::tr("[95 %, after Holm]"), Text::tr("p (Holm)")};
  std::int64_t most = 0;
  for (const ModelDifference& pair : modelDifferences(in)) {
    const ResultKey key = modelPairKey(in, pair);
    const ResultsAt at(ledger, key);
    table.rows.push_back(
        {Text::verbatim("%1 - %2", in.evaluations[pair.first].model, in.evaluations[pair.second].model),
         at("composite_difference", kValues), at("composite_difference", fixed(2)),
         at("composite_difference_holm_95", intervalWith(2), ""),
         at("composite_difference_p_holm", kAsP, "")});
    if (pair.raters > most) {  // the pair that most raters scored
      most = pair.raters;
      table.provenance.n = at.count("composite_difference", kValues);
    }
  }
  table.notes = {
      Text::tr("Every rater is compared with himself or herself: raters who gave every mark of both models. "
               "Intervals are adjusted for the number of pairs, as the p values are.")};
  return table;
}

}  // namespace torsio
