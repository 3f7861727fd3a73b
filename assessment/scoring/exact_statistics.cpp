// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring/exact_statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <boost/multiprecision/cpp_int.hpp>

#include "assessment/scoring/exact_quotient.h"

namespace torsio {

namespace {

using BigInteger = boost::multiprecision::cpp_int;

double exactQuotient(std::int64_t numerator, std::int64_t denominator) {
  return roundedQuotient(numerator, denominator);
}

double exactQuotient(const BigInteger& numerator, const BigInteger& denominator) {
  if (numerator < 0) {
    return -nearestQuotient<BigInteger>(-numerator, denominator);
  }
  return nearestQuotient<BigInteger>(numerator, denominator);
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

struct IndexExact {
  double m = 0.0;
  double s2 = 0.0;
  double moment = 0.0;
  BigInteger mNumerator;  // M = mNumerator / mDenominator steps
  BigInteger mDenominator = 1;
};

/// Common denominator of the class means as a double: exact below 2^53; above, only its magnitude matters.
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

/// Eqs. 25 and 26 as integer fractions, each rounded once at the end.
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
  out.m = exactQuotient(mNumerator, Integer(k * q));
  out.s2 = exactQuotient(spread, Integer(n * k * k * q * q));
  out.moment = exactQuotient(moment, Integer(k * k * q * q));
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
    const double part = share * share * exactQuotient(spread, scale);
    variance += part;
    denominator += part * part / static_cast<double>(sums.n - 1);
  }
  out.standardError = std::sqrt(variance);
  if (denominator > 0.0) {
    out.standardErrorDf = variance * variance / denominator;
  }
}

}  // namespace

/// M of Eq. 25 for each index, in steps.
struct ExactStatistics::Means {
  struct Fraction {
    BigInteger numerator;
    BigInteger denominator = 1;
  };
  std::vector<Fraction> ofIndex;
};

ExactStatistics::ExactStatistics() : means_(std::make_unique<Means>()) {}
ExactStatistics::~ExactStatistics() = default;

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
  return reducedWeights(weights);
}

std::vector<std::int64_t> reducedWeights(std::vector<std::int64_t> weights) {
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

bool fitsDouble(std::int64_t n, std::int64_t maxSteps, double denominator, std::int64_t stepsPerPoint) {
  const double largest = std::max(2.0 * static_cast<double>(maxSteps), static_cast<double>(stepsPerPoint));
  const double bound = static_cast<double>(n) * largest * largest * denominator * denominator;
  return bound < static_cast<double>(kExactDouble);
}

ScoreStatistics ExactStatistics::add(const std::vector<std::vector<std::int64_t>>& values, IndexInput in) {
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
  out.plainMean = exactQuotient(sum, BigInteger(n * q));
  out.populationVariance = exactQuotient(spread, BigInteger(n * n * q * q));
  if (out.n > 1) {
    out.sampleVariance = exactQuotient(spread, BigInteger(n * (n - 1) * q * q));
  }
  out.min = roundedQuotient(low, in.stepsPerPoint);
  out.max = roundedQuotient(high, in.stepsPerPoint);
  const IndexExact exact = solveIndex(in);
  means_->ofIndex.push_back({exact.mNumerator, exact.mDenominator});
  out.m = exact.m;
  out.s2 = exact.s2;
  out.classWeightedMoment = exact.moment;
  addStandardError(in, out);
  return out;
}

double ExactStatistics::weightedMean(std::span<const std::int64_t> weights,
                                     std::int64_t stepsPerPoint) const {
  BigInteger numerator = 0;
  BigInteger denominator = 1;
  BigInteger weightSum = 0;
  for (std::size_t j = 0; j < means_->ofIndex.size(); ++j) {
    const auto& [top, bottom] = means_->ofIndex[j];
    const BigInteger lift = bottom / greatestDivisor<BigInteger>(denominator, bottom);
    numerator = numerator * lift + weights[j] * top * (denominator * lift / bottom);
    denominator *= lift;
    weightSum += weights[j];
  }
  return exactQuotient(numerator, BigInteger(denominator * weightSum * stepsPerPoint));
}

}  // namespace torsio
