// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring/evaluation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "assessment/scoring/exact_quotient.h"
#include "assessment/scoring/exact_statistics.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

void addFlag(std::vector<std::string>& flags, const std::string& flag) {
  const auto at = std::lower_bound(flags.begin(), flags.end(), flag);
  if (at == flags.end() || *at != flag) {
    flags.insert(at, flag);
  }
}

/// Evaluates one model.
class ModelSolver {
 public:
  ModelSolver(const EvaluationInstrument& instrument, const ModelRatings& ratings,
              const EvaluationPolicy& policy)
      : instrument_(instrument), ratings_(ratings), policy_(policy), v_(indexWeights(instrument)) {}

  ModelEvaluation run() {
    out_.model = ratings_.model;
    selectSheets();
    for (std::size_t j = 0; j < instrument_.indices.size(); ++j) {
      evaluateIndex(j);
    }
    out_.n27 = exact_.weightedMean(v_, instrument_.scale.stepsPerPoint);
    evaluateComposites();
    return std::move(out_);
  }

 private:
  void selectSheets() {
    for (const RaterSheet& sheet : ratings_.sheets) {
      TORSIO_EXPECTS(sheet.steps.size() == instrument_.indices.size());
      TORSIO_EXPECTS(sheet.raterClass < instrument_.classes.size());
      std::int64_t holes = 0;
      for (std::size_t j = 0; j < sheet.steps.size(); ++j) {
        if (sheet.steps[j]) {
          continue;
        }
        ++holes;
        if (policy_.missing == MissingPolicy::kRefuse) {
          throw Error(ErrorCode::kBadData,
                      Text::verbatim("rater %1 gave no score for index \"%2\"", sheet.rater,
                                     instrument_.indices[j].id),
                      Text::tr("model %1", ratings_.model),
                      Text::verbatim("Complete the ratings or choose another policy for missing ones."));
        }
      }
      out_.missing += holes;
      if (holes > 0 && policy_.missing == MissingPolicy::kListWise) {
        addFlag(out_.flags, "list-wise");
        continue;
      }
      if (holes > 0) {
        addFlag(out_.flags, "available-case");
      }
      used_.push_back(&sheet);
    }
  }

  /// Returns the weights of the classes with marks for this index; throws or flags if one has none.
  IndexInput inputFor(const std::vector<std::vector<std::int64_t>>& values, const std::string& of,
                      std::vector<std::string>& flags) const {
    IndexInput in;
    in.weights = classWeights(instrument_);
    in.stepsPerPoint = instrument_.scale.stepsPerPoint;
    in.maxSteps = std::max(std::abs(instrument_.scale.lo), std::abs(instrument_.scale.hi));
    bool any = false;
    for (std::size_t c = 0; c < values.size(); ++c) {
      const bool weighted = in.weights[c] > 0;
      in.inVariance.push_back(weighted || policy_.zeroWeightClassesInVariance);
      if (weighted && values[c].empty()) {
        if (policy_.missing != MissingPolicy::kRenormalise) {
          refuseEmptyClass(c, of);
        }
        addFlag(flags, "renormalised");
        in.weights[c] = 0;
      }
      if (weighted && std::ssize(values[c]) < policy_.minimumPerClass) {
        addFlag(flags, "few raters");
      }
      any = any || in.weights[c] > 0;
    }
    if (!any) {
      throw Error(ErrorCode::kBadData, Text::verbatim("nobody rated %1", of),
                  Text::tr("model %1", ratings_.model), Text::verbatim("Collect ratings first."));
    }
    in.weights = reducedWeights(in.weights);
    return in;
  }

  [[noreturn]] void refuseEmptyClass(std::size_t c, const std::string& of) const {
    throw Error(
        ErrorCode::kBadData, Text::verbatim("class %1 has no ratings for %2", instrument_.classes[c].id, of),
        Text::tr("model %1", ratings_.model),
        Text::verbatim("Collect the ratings, or choose the policy that renormalises the class weights."));
  }

  void evaluateIndex(std::size_t j) {
    std::vector<std::vector<std::int64_t>> values(instrument_.classes.size());
    std::int64_t missing = 0;
    for (const RaterSheet* sheet : used_) {
      if (sheet->steps[j]) {
        values[sheet->raterClass].push_back(*sheet->steps[j]);
      }
      if (!sheet->steps[j]) {
        ++missing;
      }
    }
    std::vector<std::string> flags;
    const IndexInput in = inputFor(values, "index \"" + instrument_.indices[j].id + "\"", flags);
    ScoreStatistics statistics = exact_.add(values, in);
    statistics.missing = missing;
    if (missing > 0) {
      addFlag(flags, "available-case");
    }
    for (const std::string& flag : flags) {
      addFlag(out_.flags, flag);
    }
    statistics.flags = flags;
    out_.indices.push_back(std::move(statistics));
  }

  void evaluateComposites() {
    const std::int64_t weightSum = std::accumulate(v_.begin(), v_.end(), std::int64_t{0});
    std::vector<std::vector<std::int64_t>> values(instrument_.classes.size());
    for (const RaterSheet& sheet : ratings_.sheets) {
      RaterComposite composite{sheet.rater, sheet.raterClass, std::nullopt};
      std::int64_t sum = 0;
      bool complete = true;
      for (std::size_t j = 0; j < v_.size(); ++j) {
        if (sheet.steps[j]) {
          sum += v_[j] * *sheet.steps[j];
        }
        complete = complete && sheet.steps[j].has_value();
      }
      if (complete) {
        composite.score = roundedQuotient(sum, weightSum * instrument_.scale.stepsPerPoint);
        values[sheet.raterClass].push_back(sum);
      }
      out_.composites.push_back(std::move(composite));
    }
    for (std::size_t c = 0; c < values.size(); ++c) {
      if (values[c].empty() && instrument_.classes[c].weight_milli > 0 &&
          policy_.missing != MissingPolicy::kRenormalise) {
        return;  // no class-weighted mean of composites without complete raters in every class
      }
    }
    if (std::all_of(values.begin(), values.end(), [](const auto& of) { return of.empty(); })) {
      return;
    }
    std::vector<std::string> flags;
    IndexInput in = inputFor(values, "the composites", flags);
    in.stepsPerPoint *= weightSum;
    in.maxSteps *= weightSum;
    out_.compositeStatistics = ExactStatistics().add(values, in);
    out_.compositeStatistics->missing = std::ssize(ratings_.sheets) - out_.compositeStatistics->n;
    out_.compositeStatistics->flags = flags;
  }

  const EvaluationInstrument& instrument_;
  const ModelRatings& ratings_;
  const EvaluationPolicy& policy_;
  std::vector<std::int64_t> v_;
  std::vector<const RaterSheet*> used_;
  ExactStatistics exact_;
  ModelEvaluation out_;
};

}  // namespace

ModelEvaluation evaluateModel(const EvaluationInstrument& instrument, const ModelRatings& ratings,
                              const EvaluationPolicy& policy) {
  validateInstrument(instrument);
  return ModelSolver(instrument, ratings, policy).run();
}

std::vector<ModelEvaluation> evaluate(const EvaluationInstrument& instrument,
                                      std::span<const EvaluationRating> ratings,
                                      const EvaluationPolicy& policy) {
  std::vector<ModelEvaluation> out;
  for (const ModelRatings& model : groupRatings(instrument, ratings)) {
    out.push_back(evaluateModel(instrument, model, policy));
  }
  return out;
}

}  // namespace torsio
