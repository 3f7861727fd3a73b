// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring/evaluation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include <boost/multiprecision/cpp_int.hpp>

#include "assessment/scoring/exact_quotient.h"
#include "sim/base/contracts.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

using BigInteger = boost::multiprecision::cpp_int;

/// Marks of one index, class by class, as sums of whole steps.
struct ClassSums {
  std::int64_t n = 0;
  std::int64_t sum = 0;
  std::int64_t squares = 0;
};

double quotient(std::int64_t numerator, std::int64_t denominator) {
  return roundedQuotient(numerator, denominator);
}

double quotient(const BigInteger& numerator, const BigInteger& denominator) {
  if (numerator < 0) {
    return -nearestQuotient<BigInteger>(-numerator, denominator);
  }
  return nearestQuotient<BigInteger>(numerator, denominator);
}

/// Weights over their greatest common divisor: smaller numbers, the same shares.
std::vector<std::int64_t> reduced(std::vector<std::int64_t> weights) {
  std::int64_t divisor = 0;
  for (const std::int64_t weight : weights) {
    divisor = std::gcd(divisor, weight);
  }
  if (divisor > 1) {
    for (std::int64_t& weight : weights) {
      weight /= divisor;
    }
  }
  return weights;
}

/// Whether every product below stays under 2^53, so that one division of doubles rounds once.
bool fitsDouble(std::int64_t n, std::int64_t maxSteps, double denominator, std::int64_t stepsPerPoint) {
  const double largest = std::max(2.0 * static_cast<double>(maxSteps), static_cast<double>(stepsPerPoint));
  const double bound = static_cast<double>(n) * largest * largest * denominator * denominator;
  return bound < static_cast<double>(kExactDouble);
}

struct IndexInput {
  std::vector<ClassSums> classes;
  std::vector<std::int64_t> weights;  // 0 for a class that does not count in M
  std::vector<bool> inVariance;
  std::int64_t stepsPerPoint = 1;
  std::int64_t maxSteps = 1;
};

struct IndexExact {
  double m = 0.0;
  double s2 = 0.0;
  double moment = 0.0;
  BigInteger mNumerator;  // M = mNumerator / mDenominator steps
  BigInteger mDenominator = 1;
};

/// Common denominator of the class means, as a double: exact below 2^53, and only its size matters above.
double commonDenominatorSize(const IndexInput& in) {
  double lcm = 1.0;
  std::int64_t exact = 1;
  double weightSum = 0.0;
  for (std::size_t c = 0; c < in.classes.size(); ++c) {
    if (in.weights[c] == 0) {
      continue;
    }
    weightSum += static_cast<double>(in.weights[c]);
    if (lcm < 1e9) {
      exact = std::lcm(exact, in.classes[c].n);
      lcm = static_cast<double>(exact);
    } else {
      lcm *= static_cast<double>(in.classes[c].n);
    }
  }
  return lcm * weightSum;
}

template <class Integer>
Integer greatestDivisor(Integer a, Integer b) {
  while (b != 0) {
    Integer rest = a % b;
    a = b;
    b = rest;
  }
  return a;
}

/// Eqs. 25 and 26 as fractions of whole numbers; one rounding each at the end.
template <class Integer>
IndexExact solve(const IndexInput& in) {
  Integer lcm = 1;
  Integer weightSum = 0;
  for (std::size_t c = 0; c < in.classes.size(); ++c) {
    if (in.weights[c] == 0) {
      continue;
    }
    const Integer n = in.classes[c].n;
    lcm = lcm / greatestDivisor<Integer>(lcm, n) * n;
    weightSum += in.weights[c];
  }
  const Integer k = lcm * weightSum;
  Integer mNumerator = 0;
  Integer weightedSquares = 0;
  Integer n = 0;
  Integer sum = 0;
  Integer squares = 0;
  for (std::size_t c = 0; c < in.classes.size(); ++c) {
    const ClassSums& sums = in.classes[c];
    if (in.weights[c] != 0) {
      const Integer factor = lcm / sums.n * in.weights[c];
      mNumerator += factor * sums.sum;
      weightedSquares += factor * sums.squares;
    }
    if (!in.inVariance[c]) {
      continue;
    }
    n += sums.n;
    sum += sums.sum;
    squares += sums.squares;
  }
  const Integer q = in.stepsPerPoint;
  const Integer spread = squares * k * k - 2 * sum * k * mNumerator + n * mNumerator * mNumerator;
  const Integer moment = weightedSquares * k - mNumerator * mNumerator;
  IndexExact out;
  out.m = quotient(mNumerator, Integer(k * q));
  out.s2 = quotient(spread, Integer(n * k * k * q * q));
  out.moment = quotient(moment, Integer(k * k * q * q));
  out.mNumerator = mNumerator;
  out.mDenominator = k;
  return out;
}

IndexExact solveIndex(const IndexInput& in) {
  std::int64_t n = 0;
  for (const ClassSums& sums : in.classes) {
    n += sums.n;
  }
  if (fitsDouble(n, in.maxSteps, commonDenominatorSize(in), in.stepsPerPoint)) {
    return solve<std::int64_t>(in);
  }
  return solve<BigInteger>(in);
}

/// SE(M)^2 = sum w^2 s_c^2 / n_c, and its Welch-Satterthwaite degrees of freedom.
void addStandardError(const IndexInput& in, ScoreStatistics& out) {
  double weightSum = 0.0;
  for (const std::int64_t weight : in.weights) {
    weightSum += static_cast<double>(weight);
  }
  double variance = 0.0;
  double denominator = 0.0;
  for (std::size_t c = 0; c < in.classes.size(); ++c) {
    if (in.weights[c] == 0) {
      continue;
    }
    const ClassSums& sums = in.classes[c];
    if (sums.n < 2) {
      return;
    }
    const BigInteger spread = BigInteger(sums.n) * sums.squares - BigInteger(sums.sum) * sums.sum;
    const BigInteger scale = BigInteger(sums.n) * sums.n * (sums.n - 1) * in.stepsPerPoint * in.stepsPerPoint;
    const double share = static_cast<double>(in.weights[c]) / weightSum;
    const double part = share * share * quotient(spread, scale);
    variance += part;
    denominator += part * part / static_cast<double>(sums.n - 1);
  }
  out.standardError = std::sqrt(variance);
  if (denominator > 0.0) {
    out.standardErrorDf = variance * variance / denominator;
  }
}

/// Values of one index: those of class c are values[c].
ScoreStatistics statisticsOf(const std::vector<std::vector<std::int64_t>>& values, IndexInput in,
                             IndexExact& exact) {
  ScoreStatistics out;
  in.classes.assign(values.size(), {});
  std::int64_t low = in.maxSteps;
  std::int64_t high = -in.maxSteps;
  BigInteger sum = 0;
  BigInteger squares = 0;
  for (std::size_t c = 0; c < values.size(); ++c) {
    for (const std::int64_t x : values[c]) {
      in.classes[c].n += 1;
      in.classes[c].sum += x;
      in.classes[c].squares += x * x;
      if (!in.inVariance[c]) {
        continue;
      }
      low = std::min(low, x);
      high = std::max(high, x);
    }
    if (in.inVariance[c]) {
      out.n += in.classes[c].n;
      sum += in.classes[c].sum;
      squares += in.classes[c].squares;
    }
    out.classCounts.push_back(in.classes[c].n);
    out.classMeans.push_back(std::nullopt);
    if (in.classes[c].n > 0) {
      out.classMeans[c] = roundedQuotient(in.classes[c].sum, in.classes[c].n * in.stepsPerPoint);
    }
  }
  const BigInteger n = out.n;
  const BigInteger q = in.stepsPerPoint;
  const BigInteger spread = n * squares - sum * sum;
  out.plainMean = quotient(sum, BigInteger(n * q));
  out.populationVariance = quotient(spread, BigInteger(n * n * q * q));
  if (out.n > 1) {
    out.sampleVariance = quotient(spread, BigInteger(n * (n - 1) * q * q));
  }
  out.min = roundedQuotient(low, in.stepsPerPoint);
  out.max = roundedQuotient(high, in.stepsPerPoint);
  exact = solveIndex(in);
  out.m = exact.m;
  out.s2 = exact.s2;
  out.classWeightedMoment = exact.moment;
  addStandardError(in, out);
  return out;
}

std::vector<std::int64_t> classWeights(const EvaluationInstrument& instrument) {
  std::vector<std::int64_t> weights;
  for (const RaterClass& raterClass : instrument.classes) {
    weights.push_back(raterClass.weight_milli);
  }
  return weights;
}

std::vector<std::int64_t> indexWeights(const EvaluationInstrument& instrument) {
  std::vector<std::int64_t> weights;
  for (const EvaluationIndex& index : instrument.indices) {
    weights.push_back(index.weight_milli);
  }
  return reduced(weights);
}

void addFlag(std::vector<std::string>& flags, const std::string& flag) {
  const auto at = std::lower_bound(flags.begin(), flags.end(), flag);
  if (at == flags.end() || *at != flag) {
    flags.insert(at, flag);
  }
}

/// The working copy of one evaluation.
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
    combine();
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
                      Text("rater %1 gave no score for index \"%2\"", sheet.rater, instrument_.indices[j].id),
                      Text("model %1", ratings_.model),
                      "Complete the ratings or choose another policy for missing ones.");
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

  /// Weights of the classes that have marks for this index; refuses or flags when one has none.
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
      throw Error(ErrorCode::kBadData, Text("nobody rated %1", of), Text("model %1", ratings_.model),
                  "Collect ratings first.");
    }
    in.weights = reduced(in.weights);
    return in;
  }

  [[noreturn]] void refuseEmptyClass(std::size_t c, const std::string& of) const {
    throw Error(ErrorCode::kBadData, Text("class %1 has no ratings for %2", instrument_.classes[c].id, of),
                Text("model %1", ratings_.model),
                "Collect the ratings, or choose the policy that renormalises the class weights.");
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
    IndexExact exact;
    ScoreStatistics statistics = statisticsOf(values, in, exact);
    statistics.missing = missing;
    if (missing > 0) {
      addFlag(flags, "available-case");
    }
    for (const std::string& flag : flags) {
      addFlag(out_.flags, flag);
    }
    statistics.flags = flags;
    exact_.push_back(std::move(exact));
    out_.indices.push_back(std::move(statistics));
  }

  /// Eq. 27 over the exact fractions of Eq. 25, rounded once.
  void combine() {
    BigInteger numerator = 0;
    BigInteger denominator = 1;
    BigInteger weightSum = 0;
    for (std::size_t j = 0; j < exact_.size(); ++j) {
      const BigInteger divisor = greatestDivisor<BigInteger>(denominator, exact_[j].mDenominator);
      const BigInteger lift = exact_[j].mDenominator / divisor;
      numerator = numerator * lift + v_[j] * exact_[j].mNumerator * (denominator / divisor);
      denominator *= lift;
      weightSum += v_[j];
    }
    out_.n27 = quotient(numerator, BigInteger(denominator * weightSum * instrument_.scale.stepsPerPoint));
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
    IndexExact exact;
    out_.compositeStatistics = statisticsOf(values, in, exact);
    out_.compositeStatistics->missing = std::ssize(ratings_.sheets) - out_.compositeStatistics->n;
    out_.compositeStatistics->flags = flags;
  }

  const EvaluationInstrument& instrument_;
  const ModelRatings& ratings_;
  const EvaluationPolicy& policy_;
  std::vector<std::int64_t> v_;
  std::vector<const RaterSheet*> used_;
  std::vector<IndexExact> exact_;
  ModelEvaluation out_;
};

}  // namespace

std::vector<ModelRatings> groupRatings(const EvaluationInstrument& instrument,
                                       std::span<const EvaluationRating> ratings) {
  validateInstrument(instrument);
  std::vector<ModelRatings> models;
  std::map<std::string, std::size_t> modelAt;
  std::map<std::string, std::size_t> classOf;
  std::map<std::pair<std::size_t, std::string>, std::size_t> sheetAt;
  std::set<std::tuple<std::string, std::string, std::size_t>> seen;
  for (const EvaluationRating& rating : ratings) {
    if (rating.raterClass >= instrument.classes.size() || rating.index >= instrument.indices.size()) {
      throw Error(ErrorCode::kBadData, "a rating names a class or an index that the instrument does not have",
                  Text("rater %1, model %2", rating.rater, rating.model),
                  "Use the classes and indices of the instrument.");
    }
    const std::string where = "rater " + rating.rater + ", index " + instrument.indices[rating.index].id +
                              ", model " + rating.model;
    if (!seen.insert({rating.model, rating.rater, rating.index}).second) {
      throw Error(ErrorCode::kBadData, "the same mark appears twice", where,
                  "Keep one; a correction supersedes the earlier mark.");
    }
    if (rating.steps && !isOnScale(*rating.steps, instrument.scale)) {
      throw Error(ErrorCode::kBadData,
                  Text("score %1 lies outside the scale",
                       std::to_string(pointsFromSteps(*rating.steps, instrument.scale))),
                  where, "Correct the mark; marks are never clamped.");
    }
    const auto [knownClass, isNew] = classOf.emplace(rating.rater, rating.raterClass);
    if (!isNew && knownClass->second != rating.raterClass) {
      throw Error(ErrorCode::kBadData, "a rater appears in two classes", where, "Give each rater one class.");
    }
    const auto [model, modelIsNew] = modelAt.emplace(rating.model, models.size());
    if (modelIsNew) {
      models.push_back({rating.model, {}});
    }
    ModelRatings& of = models[model->second];
    const auto [sheet, sheetIsNew] =
        sheetAt.emplace(std::pair{model->second, rating.rater}, of.sheets.size());
    if (sheetIsNew) {
      of.sheets.push_back({rating.rater, rating.raterClass,
                           std::vector<std::optional<std::int64_t>>(instrument.indices.size())});
    }
    of.sheets[sheet->second].steps[rating.index] = rating.steps;
  }
  for (ModelRatings& model : models) {
    std::sort(model.sheets.begin(), model.sheets.end(), [](const RaterSheet& a, const RaterSheet& b) {
      return std::tie(a.raterClass, a.rater) < std::tie(b.raterClass, b.rater);
    });
  }
  return models;
}

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

EvaluationKernel::EvaluationKernel(const EvaluationInstrument& instrument,
                                   std::span<const std::size_t> raterClasses)
    : instrument_(instrument),
      raterClasses_(raterClasses.begin(), raterClasses.end()),
      classCounts_(instrument.classes.size(), 0),
      sums_(instrument.classes.size() * instrument.indices.size(), 0),
      squares_(instrument.indices.size(), 0),
      meanFactors_(instrument.classes.size(), 0) {
  validateInstrument(instrument);
  for (const std::size_t c : raterClasses_) {
    TORSIO_EXPECTS(c < classCounts_.size());
    TORSIO_EXPECTS(instrument.classes[c].weight_milli > 0);
    ++classCounts_[c];
  }
  const std::vector<std::int64_t> weights = reduced(classWeights(instrument));
  std::int64_t lcm = 1;
  std::int64_t weightSum = 0;
  for (std::size_t c = 0; c < weights.size(); ++c) {
    if (weights[c] == 0) {
      continue;
    }
    TORSIO_EXPECTS(classCounts_[c] > 0);
    lcm = std::lcm(lcm, classCounts_[c]);
    TORSIO_EXPECTS(lcm < 1'000'000);
    weightSum += weights[c];
  }
  for (std::size_t c = 0; c < weights.size(); ++c) {
    if (weights[c] > 0) {
      meanFactors_[c] = weights[c] * (lcm / classCounts_[c]);
    }
  }
  commonDenominator_ = lcm * weightSum;
  indexWeights_ = indexWeights(instrument);
  indexWeightSum_ = std::accumulate(indexWeights_.begin(), indexWeights_.end(), std::int64_t{0});
  const std::int64_t maxSteps = std::max(std::abs(instrument.scale.lo), std::abs(instrument.scale.hi));
  if (!fitsDouble(std::ssize(raterClasses_), maxSteps, static_cast<double>(commonDenominator_),
                  instrument.scale.stepsPerPoint)) {
    throw Error(ErrorCode::kBadParameter,
                "the class sizes have too large a common multiple for the fast evaluation", "rater classes",
                "Use evaluateModel.");
  }
}

double EvaluationKernel::run(std::span<const std::int64_t> steps, std::span<double> m, std::span<double> s2) {
  const std::size_t indices = instrument_.indices.size();
  TORSIO_EXPECTS(steps.size() == raterClasses_.size() * indices && m.size() == indices &&
                 s2.size() == indices);
  std::fill(sums_.begin(), sums_.end(), 0);
  std::fill(squares_.begin(), squares_.end(), 0);
  const std::int64_t* row = steps.data();
  for (const std::size_t c : raterClasses_) {
    std::int64_t* sums = sums_.data() + c * indices;
    for (std::size_t j = 0; j < indices; ++j) {
      sums[j] += row[j];
      squares_[j] += row[j] * row[j];
    }
    row += indices;
  }
  const std::int64_t n = std::ssize(raterClasses_);
  const std::int64_t k = commonDenominator_;
  const std::int64_t q = instrument_.scale.stepsPerPoint;
  std::int64_t total = 0;
  for (std::size_t j = 0; j < indices; ++j) {
    std::int64_t sum = 0;
    std::int64_t numerator = 0;
    for (std::size_t c = 0; c < classCounts_.size(); ++c) {
      sum += sums_[c * indices + j];
      numerator += meanFactors_[c] * sums_[c * indices + j];
    }
    const std::int64_t spread = squares_[j] * k * k - 2 * sum * k * numerator + n * numerator * numerator;
    m[j] = roundedQuotient(numerator, k * q);
    s2[j] = roundedQuotient(spread, n * k * k * q * q);
    total += indexWeights_[j] * numerator;
  }
  return roundedQuotient(total, indexWeightSum_ * k * q);
}

}  // namespace torsio
