// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring/evaluation_kernel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "assessment/scoring/exact_quotient.h"
#include "assessment/scoring/exact_statistics.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

/// Class means as integers over a common denominator.
struct CommonDenominator {
  std::vector<std::int64_t> factors;  // of the sum of each class
  std::int64_t denominator = 1;
  bool fits = true;
};

CommonDenominator commonDenominator(const EvaluationInstrument& instrument,
                                    std::span<const std::size_t> raterClasses) {
  constexpr std::int64_t kLargestMultiple = 1'000'000;
  std::vector<std::int64_t> counts(instrument.classes.size(), 0);
  for (const std::size_t c : raterClasses) {
    TORSIO_EXPECTS(c < counts.size());
    TORSIO_EXPECTS(instrument.classes[c].weight_milli > 0);
    ++counts[c];
  }
  const std::vector<std::int64_t> weights = reducedWeights(classWeights(instrument));
  CommonDenominator out;
  out.factors.assign(counts.size(), 0);
  std::int64_t lcm = 1;
  std::int64_t weightSum = 0;
  for (std::size_t c = 0; c < weights.size(); ++c) {
    if (weights[c] == 0) {
      continue;
    }
    TORSIO_EXPECTS(counts[c] > 0);
    lcm = std::lcm(lcm, counts[c]);
    weightSum += weights[c];
    if (lcm >= kLargestMultiple) {
      out.fits = false;
      return out;
    }
  }
  for (std::size_t c = 0; c < weights.size(); ++c) {
    if (weights[c] > 0) {
      out.factors[c] = weights[c] * (lcm / counts[c]);
    }
  }
  out.denominator = lcm * weightSum;
  const std::int64_t maxSteps = std::max(std::abs(instrument.scale.lo), std::abs(instrument.scale.hi));
  out.fits = fitsDouble(std::ssize(raterClasses), maxSteps, static_cast<double>(out.denominator),
                        instrument.scale.stepsPerPoint);
  return out;
}

}  // namespace

bool EvaluationKernel::fits(const EvaluationInstrument& instrument,
                            std::span<const std::size_t> raterClasses) {
  return commonDenominator(instrument, raterClasses).fits;
}

EvaluationKernel::EvaluationKernel(const EvaluationInstrument& instrument,
                                   std::span<const std::size_t> raterClasses)
    : instrument_(instrument),
      raterClasses_(raterClasses.begin(), raterClasses.end()),
      sums_(instrument.classes.size() * instrument.indices.size(), 0),
      squares_(instrument.indices.size(), 0) {
  validateInstrument(instrument);
  const CommonDenominator common = commonDenominator(instrument, raterClasses);
  TORSIO_EXPECTS(common.fits);
  meanFactors_ = common.factors;
  commonDenominator_ = common.denominator;
  indexWeights_ = indexWeights(instrument);
  indexWeightSum_ = std::accumulate(indexWeights_.begin(), indexWeights_.end(), std::int64_t{0});
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
    for (std::size_t c = 0; c < meanFactors_.size(); ++c) {
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
