// SPDX-License-Identifier: GPL-3.0-or-later
// Results of the evaluation of models: Eqs. 25 to 27, the raters' order of the models and their differences.
#include <algorithm>
#include <optional>
#include <string>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/result_writer.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"
#include "assessment/statistics/quantiles.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

using enum ResultSection;

void addStatistics(ResultWriter& rows, const ScoreStatistics& s) {
  rows.add("M", s.m, s.n);
  rows.add("s2_eq26_divisor_n", s.s2, s.n);
  rows.add("min", s.min, s.n);
  rows.add("max", s.max, s.n);
  rows.add("plain_mean", s.plainMean, s.n);
  rows.add("population_variance", s.populationVariance, s.n);
  rows.add("sample_variance", s.sampleVariance, s.n);
  rows.add("class_weighted_moment", s.classWeightedMoment, s.n);
  rows.add("se_of_M", s.standardError, s.n);
  rows.add("se_df", s.standardErrorDf, s.n);
}

/// Adds the means of the classes of raters for an index.
void addClassMeans(const CohortInputs& in, const ScoreStatistics& s, ResultWriter& rows) {
  for (std::size_t c = 0; c < s.classMeans.size(); ++c) {
    rows.place.raterClass = in.instrument.classes[c].id;
    rows.add("class_mean", s.classMeans[c], s.classCounts[c]);
  }
  rows.place.raterClass.clear();
}

/// Adds the distribution of the raters' own scores of a model.
void addComposites(const ModelEvaluation& model, ResultWriter& rows) {
  std::vector<double> scores;
  for (const RaterComposite& composite : model.composites) {
    if (composite.score) {
      scores.push_back(*composite.score);
    }
  }
  const std::int64_t n = std::ssize(scores);
  rows.madeOf = partsOf(
      {ResultPattern{.section = kEvaluation, .statistic = "composite", .of = kEach, .model = model.model},
       RecordRef{RecordKind::kCampaign}});
  rows.addCount("raters_with_all_marks", n, n);
  const auto& statistics = model.compositeStatistics;
  rows.add("composite_M", statistics ? std::optional(statistics->m) : std::nullopt, n);
  rows.add("composite_se_of_M", statistics ? statistics->standardError : std::nullopt, n);
  if (statistics && statistics->standardError && statistics->standardErrorDf) {
    const double reach = tQuantile(0.5 * (1.0 + kDefaultConfidence), *statistics->standardErrorDf) *
                         *statistics->standardError;
    rows.put("composite_M_95", Interval{statistics->m - reach, statistics->m + reach}, n);
  }
  if (const std::optional<BoxNumbers> box = boxNumbers(scores)) {
    rows.add("composite_lowest", box->min, n);
    rows.add("composite_lower_whisker", box->whiskerLow, n);
    rows.add("composite_lower_quartile", box->q1, n);
    rows.add("composite_median", box->median, n);
    rows.add("composite_upper_quartile", box->q3, n);
    rows.add("composite_upper_whisker", box->whiskerHigh, n);
    rows.add("composite_highest", box->max, n);
    rows.add("composite_plain_mean", box->mean, n);
  }
}

void addWeights(const CohortInputs& in, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kEvaluation}, commonFlags(in));
  rows.madeOf = partsOf({RecordRef{RecordKind::kCampaign}});
  for (const EvaluationIndex& index : in.instrument.indices) {
    rows.place.index = index.id;
    rows.add("index_weight", static_cast<double>(index.weight_milli) / 1000.0, 1);
  }
  rows.place.index.clear();
  for (const RaterClass& raterClass : in.instrument.classes) {
    rows.place.raterClass = raterClass.id;
    rows.add("class_weight", static_cast<double>(raterClass.weight_milli) / 1000.0, 1);
  }
}

void addMarks(const CohortInputs& in, const ModelRatings& ratings, ResultWriter& rows) {
  rows.place.model = ratings.model;
  for (const RaterSheet& sheet : ratings.sheets) {
    rows.place.of = sheet.rater;
    rows.place.raterClass = in.instrument.classes[sheet.raterClass].id;
    for (std::size_t j = 0; j < sheet.steps.size(); ++j) {
      rows.place.index = in.instrument.indices[j].id;
      rows.madeOf = partsOf({RecordRef{RecordKind::kEvaluationMark, sheet.markOf(j)}});
      std::optional<double> mark;
      if (sheet.steps[j]) {
        mark = pointsFromSteps(*sheet.steps[j], in.instrument.scale);
      }
      rows.add("mark", mark, mark ? 1 : 0);
    }
  }
}

/// Adds how many marks the indices of a model, or of all models, were computed from.
void addMarkCounts(const CohortInputs& in, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kEvaluation}, commonFlags(in));
  const auto add = [&](std::int64_t used, std::int64_t missing) {
    rows.madeOf = partsOf(
        {ResultPattern{.section = kEvaluation, .statistic = "mark", .of = kEach, .model = rows.place.model},
         RecordRef{RecordKind::kCampaign}});
    rows.addCount("marks_used", used, used);
    rows.addCount("marks_missing", missing, used);
  };
  std::int64_t inAll = 0;
  for (std::size_t k = 0; k < in.evaluations.size(); ++k) {
    std::int64_t used = 0;
    for (const ScoreStatistics& index : in.evaluations[k].indices) {
      used += index.n;
    }
    inAll += used;
    rows.place.model = in.evaluations[k].model;
    add(used, missingEvaluationMarks(in, in.ratings[k]));
  }
  rows.place.model.clear();
  add(inAll, missingEvaluationMarks(in));
}

/// Adds how many scores of single raters there are, in each class and in all.
void addCompositeCounts(const CohortInputs& in, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kEvaluation}, commonFlags(in));
  std::map<std::size_t, std::int64_t> ofClass;
  std::int64_t inAll = 0;
  for (const ModelEvaluation& model : in.evaluations) {
    for (const RaterComposite& composite : model.composites) {
      ofClass[composite.raterClass] += composite.score ? 1 : 0;
      inAll += composite.score ? 1 : 0;
    }
  }
  const auto add = [&](std::int64_t count) {
    rows.madeOf = partsOf({ResultPattern{.section = kEvaluation,
                                         .statistic = "composite",
                                         .of = kEach,
                                         .raterClass = rows.place.raterClass},
                           RecordRef{RecordKind::kCampaign}});
    rows.addCount("composites", count, count);
  };
  add(inAll);
  for (const auto& [raterClass, count] : ofClass) {
    rows.place.raterClass = in.instrument.classes[raterClass].id;
    add(count);
  }
}

/// Adds the raters' order of the models.
void addModelOrder(const CohortInputs& in, Ledger& ledger) {
  const std::optional<ModelOrder> order = modelOrder(in);
  if (!order) {
    return;
  }
  ResultWriter rows(ledger, {.section = kEvaluation}, commonFlags(in));
  rows.madeOf = partsOf({ResultPattern{.section = kEvaluation, .statistic = "composite", .of = kEach}});
  const std::int64_t n = order->raters;
  rows.add("models_friedman_chi_squared", order->test, &Friedman::chiSquared, n);
  rows.add("models_friedman_df", order->test, &Friedman::df, n);
  rows.add("models_friedman_p", order->test, &Friedman::p, n);
  rows.add("models_kendall_w", order->test, &Friedman::kendallW, n);
  rows.addCount("composites_ranked", n * std::ssize(in.evaluations), n);
  for (std::size_t k = 0; k < order->meanRanks.size(); ++k) {
    rows.place.model = in.evaluations[k].model;
    rows.add("mean_rank", order->meanRanks[k], n);
  }
}

/// Adds the differences between the models.
void addModelDifferences(const CohortInputs& in, Ledger& ledger) {
  for (const ModelDifference& pair : modelDifferences(in)) {
    ResultWriter rows(ledger, modelPairKey(in, pair), commonFlags(in));
    std::vector<ResultPart> parts{RecordRef{RecordKind::kCampaign}};
    for (const std::size_t of : {pair.first, pair.second}) {
      parts.emplace_back(ResultPattern{
          .section = kEvaluation, .statistic = "composite", .of = kEach, .model = in.evaluations[of].model});
    }
    rows.madeOf = partsOf(std::move(parts));
    rows.add("composite_difference", pair.test, &TTest::difference, pair.raters);
    if (pair.test) {
      rows.put("composite_difference_holm_95", pair.asHolm, pair.raters);
      rows.add("composite_difference_p_holm", pair.pHolm, pair.raters);
    }
  }
}

/// Adds what is available before a class of raters has scored everything.
void addUnfinishedEvaluation(const CohortInputs& in, Ledger& ledger) {
  ResultWriter marks(ledger, {.section = kEvaluation}, commonFlags(in), {"unfinished"});
  for (const ModelRatings& ratings : in.ratings) {
    addMarks(in, ratings, marks);
  }
  ResultWriter rows(ledger, {.section = kEvaluation}, commonFlags(in), {"unfinished"});
  rows.madeOf = partsOf({RecordRef{RecordKind::kCampaign}});
  rows.addCount("marks_in_so_far", in.unfinishedEvaluation->marks, in.unfinishedEvaluation->marks);
  for (const ClassScore& of : classScores(in)) {
    rows.place.model = of.model;
    rows.place.raterClass = in.instrument.classes[of.raterClass].id;
    rows.madeOf = partsOf({ResultPattern{.section = kEvaluation,
                                         .statistic = "mark",
                                         .of = kEach,
                                         .raterClass = rows.place.raterClass,
                                         .model = of.model},
                           RecordRef{RecordKind::kCampaign}});
    rows.put(kClassScoreStatistic,
             of.score ? ResultValue(*of.score) : Undefined{Text::tr("an index has no mark")}, of.raters);
    rows.addCount("class_raters", of.raters, of.raters);
    rows.addCount("class_marks", of.marks, of.marks);
  }
}

}  // namespace

void addEvaluationResults(const CohortInputs& in, Ledger& ledger) {
  if (!in.ratings.empty()) {
    addWeights(in, ledger);
  }
  if (in.unfinishedEvaluation) {
    addUnfinishedEvaluation(in, ledger);
    return;
  }
  for (std::size_t k = 0; k < in.evaluations.size(); ++k) {
    const ModelEvaluation& model = in.evaluations[k];
    ResultWriter rows(ledger, {.section = kEvaluation, .model = model.model}, commonFlags(in), model.flags);
    rows.madeOf = partsOf({ResultPattern{.section = kEvaluation, .statistic = "M", .model = model.model}});
    rows.add("N_eq27", model.n27, std::ssize(model.composites));
    for (std::size_t j = 0; j < model.indices.size(); ++j) {
      rows.place.index = in.instrument.indices[j].id;
      rows.setFlags(model.indices[j].flags);
      rows.madeOf = partsOf({ResultPattern{.section = kEvaluation,
                                           .statistic = "mark",
                                           .of = kEach,
                                           .model = model.model,
                                           .index = rows.place.index}});
      addStatistics(rows, model.indices[j]);
      addClassMeans(in, model.indices[j], rows);
    }
    rows.place.index.clear();
    rows.setFlags({});
    addComposites(model, rows);
    for (const RaterComposite& composite : model.composites) {
      rows.place.of = composite.rater;
      rows.place.raterClass = in.instrument.classes[composite.raterClass].id;
      rows.madeOf = partsOf({ResultPattern{
          .section = kEvaluation, .statistic = "mark", .of = composite.rater, .model = model.model}});
      rows.add("composite", composite.score, composite.score ? 1 : 0);
    }
    addMarks(in, in.ratings[k], rows);
  }
  if (!in.evaluations.empty()) {
    addMarkCounts(in, ledger);
    addCompositeCounts(in, ledger);
  }
  addModelOrder(in, ledger);
  addModelDifferences(in, ledger);
}

}  // namespace torsio
