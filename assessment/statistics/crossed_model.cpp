// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/crossed_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <Eigen/Dense>

#include "assessment/statistics/crossed_likelihood.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"

namespace torsio {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Index placeOf(std::size_t i) {
  return static_cast<Index>(i);
}

/// Variances that minimise the criterion, held at 0 where they would become negative.
struct Minimum {
  Parts variance{};
  std::array<bool, kParts> held{};
  CrossedLikelihood::Derivatives at;
  int iterations = 0;
  bool found = false;
};

/// Selects the rows and columns of the free variances.
MatrixXd amongFree(const std::array<Parts, kParts>& of, const std::vector<Index>& free) {
  MatrixXd out(std::ssize(free), std::ssize(free));
  for (Index i = 0; i < out.rows(); ++i) {
    for (Index j = 0; j < out.cols(); ++j) {
      out(i, j) = of[static_cast<std::size_t>(free[static_cast<std::size_t>(i)])]
                    [static_cast<std::size_t>(free[static_cast<std::size_t>(j)])];
    }
  }
  return out;
}

Eigen::Vector3d stepFrom(const CrossedLikelihood::Derivatives& at, const std::array<bool, kParts>& held) {
  std::vector<Index> free;
  for (std::size_t k = 0; k < kParts; ++k) {
    if (!held[k]) {
      free.push_back(placeOf(k));
    }
  }
  const Index n = std::ssize(free);
  VectorXd slope(n);
  for (Index i = 0; i < n; ++i) {
    slope[i] = at.slope[static_cast<std::size_t>(free[static_cast<std::size_t>(i)])];
  }
  Eigen::LLT<MatrixXd> factor(amongFree(at.curvature, free));
  if (factor.info() != Eigen::Success) {
    factor.compute(amongFree(at.expected, free));  // far from the minimum: Fisher's scoring
  }
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  if (factor.info() == Eigen::Success) {
    step(free) = -factor.solve(slope);
  }
  return step;
}

/// Returns the step without the components that are at their lower bound and would go below it; they would
/// stop the others, too.
Eigen::Vector3d stepWithin(const CrossedLikelihood::Derivatives& at, const std::array<bool, kParts>& held,
                           const Parts& variance, double vanishing) {
  std::array<bool, kParts> still = held;
  Eigen::Vector3d step = stepFrom(at, still);
  for (const std::size_t k : {kTargets, kRaters}) {
    if (!still[k] && variance[k] <= vanishing * variance[kResidual] && step[placeOf(k)] < 0.0) {
      still[k] = true;
      step = stepFrom(at, still);
    }
  }
  return step;
}

/// Returns the fraction of a step that keeps every variance positive.
double shareAboveZero(const Parts& variance, const Eigen::Vector3d& step) {
  constexpr double kOfTheWay = 0.9;
  double share = 1.0;
  for (std::size_t k = 0; k < kParts; ++k) {
    if (variance[k] + step[placeOf(k)] < 0.0) {
      share = std::min(share, -kOfTheWay * variance[k] / step[placeOf(k)]);
    }
  }
  return share;
}

Minimum minimum(const CrossedLikelihood& likelihood) {
  constexpr int kMaxSteps = 200;
  constexpr double kSettled = 1e-9;    // the next step of Newton's method is the square of this
  constexpr double kVanishing = 1e-6;  // relative to the residual variance; below, 0 is tried
  constexpr double kNoResidual = 1e9;  // ratio of a variance to the residual one
  Minimum out;
  out.variance = likelihood.start();
  if (!(out.variance[kResidual] > 0.0)) {
    return out;
  }
  out.at = likelihood.at(out.variance);
  const auto hold = [&](std::size_t k) {
    Parts without = out.variance;
    without[k] = 0.0;
    const CrossedLikelihood::Derivatives at = likelihood.at(without);
    if (at.slope[k] < 0.0) {
      return false;
    }
    out.held[k] = true;
    out.variance = without;
    out.at = at;
    return true;
  };
  for (out.iterations = 1; out.iterations <= kMaxSteps; ++out.iterations) {
    for (const std::size_t k : {kTargets, kRaters}) {
      if (!out.held[k] && out.variance[k] <= kVanishing * out.variance[kResidual] && !hold(k) &&
          out.variance[k] == 0.0) {
        out.variance[k] = kVanishing * out.variance[kResidual];
        out.at = likelihood.at(out.variance);
      }
    }
    const Eigen::Vector3d step = stepWithin(out.at, out.held, out.variance, kVanishing);
    double share = shareAboveZero(out.variance, step);
    Parts next{};
    CrossedLikelihood::Derivatives at;
    constexpr double kRise = 1e-9;  // of rounding
    for (int halvings = 0;; ++halvings) {
      for (std::size_t k = 0; k < kParts; ++k) {
        next[k] = out.variance[k] + share * step[placeOf(k)];
      }
      at = likelihood.at(next);
      constexpr int kMaxHalvings = 30;
      if (at.criterion <= out.at.criterion + kRise || halvings == kMaxHalvings) {
        break;
      }
      share *= 0.5;
    }
    if (!at.defined || std::max(next[kTargets], next[kRaters]) > kNoResidual * next[kResidual]) {
      return out;
    }
    double change = 0.0;
    for (std::size_t k = 0; k < kParts; ++k) {
      if (!out.held[k]) {
        change = std::max(change, std::abs(next[k] - out.variance[k]) / next[k]);
      }
    }
    out.variance = next;
    out.at = std::move(at);
    if (share == 1.0 && change < kSettled) {
      bool released = false;
      for (const std::size_t k : {kTargets, kRaters}) {
        if (out.held[k] && out.at.slope[k] < 0.0) {
          out.held[k] = false;
          out.variance[k] = kVanishing * out.variance[kResidual];
          released = true;
        }
      }
      if (!released) {
        out.found = true;
        return out;
      }
      out.at = likelihood.at(out.variance);
    }
  }
  return out;
}

/// Number of marks minus the degrees of freedom used by target and rater effects.
std::int64_t residualMarks(const std::vector<CrossedMark>& marks, std::size_t targets, std::size_t raters) {
  std::vector<std::size_t> root(targets + raters);
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) {
      root[i] = root[root[i]];
      i = root[i];
    }
    return i;
  };
  std::int64_t joins = 0;
  for (const CrossedMark& mark : marks) {
    const std::size_t a = find(mark.target);
    const std::size_t b = find(targets + mark.rater);
    if (a != b) {
      root[a] = b;
      ++joins;
    }
  }
  return std::ssize(marks) - joins;
}

double form(const std::vector<double>& x, const NumberTable& of, const std::vector<double>& y) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < y.size(); ++j) {
      sum += x[i] * of.at(i, j) * y[j];
    }
  }
  return sum;
}

}  // namespace

Outcome<CrossedModel> CrossedModel::fit(const std::vector<CrossedMark>& marks, const NumberTable& fixed) {
  using Undefined = Outcome<CrossedModel>;
  std::vector<double> values;
  std::size_t raters = 0;
  std::vector<bool> scored(fixed.rows(), false);
  for (const CrossedMark& mark : marks) {
    TORSIO_EXPECTS(mark.target < fixed.rows());
    values.push_back(mark.value);
    raters = std::max(raters, mark.rater + 1);
    scored[mark.target] = true;
  }
  for (const std::span<const double> numbers : {std::span<const double>(values), fixed.values()}) {
    if (const std::optional<Text> reason = beyondArithmetic(numbers)) {
      return Undefined::undefined(*reason);
    }
  }
  TORSIO_EXPECTS(std::find(scored.begin(), scored.end(), false) == scored.end());
  if (raters < 2) {
    return Undefined::undefined(Text::tr("there are fewer than two raters"));
  }
  if (fixed.rows() <= fixed.columns()) {
    return Undefined::undefined(Text::tr("there are too few trainees"));
  }
  if (residualMarks(marks, fixed.rows(), raters) < 1) {
    return Undefined::undefined(Text::tr("there are too few marks to separate trainees, raters and error"));
  }
  const CrossedLikelihood likelihood(marks, fixed, raters);
  if (!likelihood.separable()) {
    return Undefined::undefined(Text::tr("the scores before do not vary within groups"));
  }
  const double total = sumOfSquares(values);
  constexpr double kRounding = 1e-24;  // of the marks' own squares
  const double size = *std::max_element(values.begin(), values.end(),
                                        [](double x, double y) { return std::abs(x) < std::abs(y); });
  if (total == 0.0 ||
      likelihood.squaresLeft() <= kRounding * size * size * static_cast<double>(marks.size())) {
    return Undefined::undefined(Text::tr("the marks leave no residual"));
  }
  const Minimum lowest = minimum(likelihood);
  if (!lowest.found) {
    return Undefined::undefined(Text::tr("the marks leave no residual, or the fit does not settle"));
  }
  CrossedModel out;
  out.marks_ = marks.size();
  out.varianceResidual_ = lowest.variance[kResidual];
  out.varianceTargets_ = lowest.variance[kTargets];
  out.varianceRaters_ = lowest.variance[kRaters];
  out.criterion_ = lowest.at.criterion;
  out.iterations_ = lowest.iterations;
  out.coefficients_ = lowest.at.coefficients;
  out.covariance_ = lowest.at.covariance;
  std::vector<Index> free;
  for (std::size_t k = 0; k < kParts; ++k) {
    if (!lowest.held[k]) {
      free.push_back(placeOf(k));
      out.slopes_.push_back(lowest.at.covarianceSlopes[k]);
    }
  }
  const Eigen::LLT<MatrixXd> factor(amongFree(lowest.at.curvature, free));
  if (factor.info() != Eigen::Success) {
    return Undefined::undefined(Text::tr("the marks do not separate the variances"));
  }
  const MatrixXd covariance = 2.0 * factor.solve(MatrixXd::Identity(std::ssize(free), std::ssize(free)));
  out.varianceCovariance_ = NumberTable(free.size(), free.size());
  for (std::size_t i = 0; i < free.size(); ++i) {
    for (std::size_t j = 0; j < free.size(); ++j) {
      out.varianceCovariance_.at(i, j) = covariance(placeOf(i), placeOf(j));
    }
  }
  return out;
}

ModelEstimate CrossedModel::estimate(const std::vector<double>& weights, double confidence) const {
  TORSIO_EXPECTS(weights.size() == coefficients_.size());
  ModelEstimate out;
  out.value = std::inner_product(weights.begin(), weights.end(), coefficients_.begin(), 0.0);
  const double variance = form(weights, covariance_, weights);
  out.error = std::sqrt(variance);
  std::vector<double> slope;
  for (const NumberTable& of : slopes_) {
    slope.push_back(form(weights, of, weights));
  }
  out.df = 2.0 * variance * variance / form(slope, varianceCovariance_, slope);
  out.t = out.value / out.error;
  out.p = tTwoSided(out.t, out.df);
  const double reach = tQuantile(0.5 * (1.0 + confidence), out.df) * out.error;
  out.interval = {out.value - reach, out.value + reach};
  return out;
}

Outcome<FTest> CrossedModel::test(const std::vector<std::vector<double>>& contrasts) const {
  TORSIO_EXPECTS(!contrasts.empty());
  const Index q = std::ssize(contrasts);
  MatrixXd covariance(q, q);
  for (Index i = 0; i < q; ++i) {
    for (Index j = 0; j < q; ++j) {
      covariance(i, j) =
          form(contrasts[static_cast<std::size_t>(i)], covariance_, contrasts[static_cast<std::size_t>(j)]);
    }
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(covariance);
  FTest out;
  out.df1 = static_cast<double>(q);
  std::vector<double> df;
  for (Index m = 0; m < q; ++m) {
    std::vector<double> axis(coefficients_.size(), 0.0);
    for (Index i = 0; i < q; ++i) {
      for (std::size_t j = 0; j < axis.size(); ++j) {
        axis[j] += axes.eigenvectors()(i, m) * contrasts[static_cast<std::size_t>(i)][j];
      }
    }
    const ModelEstimate along = estimate(axis);
    out.f += along.t * along.t / out.df1;
    df.push_back(along.df);
  }
  const auto [least, most] = std::minmax_element(df.begin(), df.end());
  constexpr double kAlike = 1e-8;
  if (*most - *least < kAlike) {
    out.df2 = meanOf(df);
  } else if (*least <= 2.0) {
    return Outcome<FTest>::undefined(Text::tr("there are too few degrees of freedom"));
  } else {
    double sum = 0.0;
    for (const double of : df) {
      sum += of / (of - 2.0);
    }
    out.df2 = 2.0 * sum / (sum - out.df1);
  }
  out.p = fUpper(out.f, out.df1, out.df2);
  return out;
}

}  // namespace torsio
