// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/crossed_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <vector>

#include <Eigen/Dense>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"

namespace torsio {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kParts = 3;  // variances: residual, targets, raters
constexpr std::size_t kResidual = 0;
constexpr std::size_t kTargets = 1;
constexpr std::size_t kRaters = 2;
using Parts = std::array<double, kParts>;

Index indexOf(std::size_t i) {
  return static_cast<Index>(i);
}

/// Targets with equally many marks. Their weights are the same at any ratio of the variances, so that sums of
/// squares over targets are weighted sums over few of these, however many targets there are.
struct Level {
  double count = 0.0;    // marks of each
  double targets = 0.0;  // how many they are
  MatrixXd within;       // products of their rows of Sums::within
};

/// Sums over the marks. With n marks V0 = I + a Zt Zt' + b Zr Zr' is n x n; it is only met through the border
/// [Zr X] and the sums within targets, so that 2,000 targets with 40 raters stay small.
struct Sums {
  Index targets = 0;
  Index raters = 0;
  Index fixed = 0;
  double marks = 0.0;
  VectorXd counts;  // marks of each target
  MatrixXd within;  // targets x [raters, fixed, mark]: sums over the target's marks
  std::vector<Level> levels;
  MatrixXd products;  // of [raters, fixed, mark]
  MatrixXd back;      // coefficients of the orthogonal fixed part -> coefficients asked for
  VectorXd ordinary;  // least squares, which the marks have been freed of
  double logScale = 0.0;

  [[nodiscard]] Index border() const { return raters + fixed; }
};

/// Frees the marks from what the fixed part explains by least squares and makes that part orthonormal, so
/// that neither a large level of the marks nor the unit of a covariate costs digits.
bool orthogonalise(const NumberTable& fixed, const VectorXd& sums, Sums& out) {
  MatrixXd x(out.targets, out.fixed);
  VectorXd y(out.targets);
  for (Index i = 0; i < out.targets; ++i) {
    const double root = std::sqrt(out.counts[i]);
    for (Index j = 0; j < out.fixed; ++j) {
      x(i, j) = root * fixed.at(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
    }
    y[i] = root > 0.0 ? sums[i] / root : 0.0;
  }
  VectorXd lengths = x.colwise().norm();
  if (lengths.minCoeff() == 0.0) {
    return false;
  }
  const MatrixXd scaled = x * lengths.cwiseInverse().asDiagonal();
  const Eigen::ColPivHouseholderQR<MatrixXd> pivoted(scaled);
  constexpr double kDependent = 1e-10;
  if (std::abs(pivoted.matrixR()(out.fixed - 1, out.fixed - 1)) < kDependent) {
    return false;
  }
  const Eigen::HouseholderQR<MatrixXd> qr(scaled);
  const MatrixXd r = qr.matrixQR().topRows(out.fixed).triangularView<Eigen::Upper>();
  out.back = lengths.cwiseInverse().asDiagonal() *
             r.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(out.fixed, out.fixed));
  out.ordinary = lengths.cwiseInverse().asDiagonal() * VectorXd(qr.solve(y));
  out.logScale = 2.0 * (r.diagonal().array().abs().log().sum() + lengths.array().log().sum());
  return true;
}

std::vector<Level> levelsOf(const Sums& sums) {
  std::map<double, std::vector<Index>> rows;
  for (Index i = 0; i < sums.targets; ++i) {
    rows[sums.counts[i]].push_back(i);
  }
  std::vector<Level> levels;
  for (const auto& [count, of] : rows) {
    const MatrixXd within = sums.within(of, Eigen::all);
    levels.push_back(
        {.count = count, .targets = static_cast<double>(of.size()), .within = within.transpose() * within});
  }
  return levels;
}

/// Fills what the fit needs. False: the fixed coefficients cannot be told apart.
bool gather(const std::vector<CrossedMark>& marks, const NumberTable& fixed, Sums& out) {
  out.counts = VectorXd::Zero(out.targets);
  VectorXd sums = VectorXd::Zero(out.targets);
  for (const CrossedMark& mark : marks) {
    out.counts[indexOf(mark.target)] += 1.0;
    sums[indexOf(mark.target)] += mark.value;
  }
  if (!orthogonalise(fixed, sums, out)) {
    return false;
  }
  MatrixXd x(out.targets, out.fixed);
  for (Index i = 0; i < out.targets; ++i) {
    for (Index j = 0; j < out.fixed; ++j) {
      x(i, j) = fixed.at(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
    }
  }
  const VectorXd explained = x * out.ordinary;
  x = x * out.back;
  const Index k = out.border();
  out.within = MatrixXd::Zero(out.targets, k + 1);
  out.within.middleCols(out.raters, out.fixed) = out.counts.asDiagonal() * x;
  out.products = MatrixXd::Zero(k + 1, k + 1);
  for (const CrossedMark& mark : marks) {
    const Index i = indexOf(mark.target);
    const Index r = indexOf(mark.rater);
    const double rest = mark.value - explained[i];
    out.within(i, r) += 1.0;
    out.within(i, k) += rest;
    out.products(r, r) += 1.0;
    out.products(r, k) += rest;
    out.products(k, k) += rest * rest;
    out.products.row(r).segment(out.raters, out.fixed) += x.row(i);
  }
  out.products.block(out.raters, out.raters, out.fixed, out.fixed) =
      x.transpose() * out.counts.asDiagonal() * x;
  out.products.block(out.raters, k, out.fixed, 1) = x.transpose() * out.within.col(k);
  out.products.triangularView<Eigen::StrictlyLower>() = out.products.transpose();
  out.levels = levelsOf(out);
  return true;
}

/// The border and the marks under A = I + a Zt Zt'.
MatrixXd underTargets(const Sums& sums, double a) {
  MatrixXd out = sums.products;
  for (const Level& level : sums.levels) {
    out -= a / (1.0 + a * level.count) * level.within;
  }
  return out;
}

/// The fit at given ratios of the variances of targets (a) and raters (b) to the residual one.
struct Profile {
  double criterion = std::numeric_limits<double>::infinity();
  double squares = 0.0;  // y' P0 y
  MatrixXd inverse;      // M: of the border's equations; rows of raters are 0 where b is 0
  VectorXd solution;     // M F' A^-1 y
};

Profile profileOf(const Sums& sums, const MatrixXd& under, double a, double b, bool whole) {
  const Index k = sums.border();
  VectorXd scale = VectorXd::Ones(k);
  scale.head(sums.raters).setConstant(std::sqrt(b));
  MatrixXd q = scale.asDiagonal() * under.topLeftCorner(k, k) * scale.asDiagonal();
  q.diagonal().head(sums.raters).array() += 1.0;
  const Eigen::LLT<MatrixXd> factor(q);
  Profile out;
  if (factor.info() != Eigen::Success) {
    return out;
  }
  const VectorXd right = scale.asDiagonal() * under.col(k).head(k);
  const VectorXd solved = factor.solve(right);
  out.squares = under(k, k) - right.dot(solved);
  const double rest = sums.marks - static_cast<double>(sums.fixed);
  if (!(out.squares > 0.0)) {
    return out;
  }
  const double logQ = 2.0 * factor.matrixLLT().diagonal().array().log().sum();
  double logA = 0.0;
  for (const Level& level : sums.levels) {
    logA += level.targets * std::log1p(a * level.count);
  }
  out.criterion =
      logA + logQ + sums.logScale + rest * (1.0 + std::log(2.0 * std::numbers::pi * out.squares / rest));
  if (whole) {
    out.inverse = scale.asDiagonal() * factor.solve(MatrixXd::Identity(k, k)) * scale.asDiagonal();
    out.solution = scale.asDiagonal() * solved;
  }
  return out;
}

/// Slope and curvature of the criterion by the three variances, and the slopes of the coefficients'
/// covariance.
struct Derivatives {
  Profile profile;
  Parts slope{};
  Eigen::Matrix3d curvature;
  Eigen::Matrix3d expected;  // of the curvature
  MatrixXd covariance;       // of the orthogonal coefficients
  std::array<MatrixXd, kParts> covarianceSlopes;
};

/// Completes the entries of the residual from those of targets and raters: P0 V0 P0 = P0.
template <class Value>
void completeByResidual(double a, double b, const std::array<Value, kParts>& whole,
                        std::array<std::array<Value, kParts>, kParts>& of) {
  of[kRaters][kTargets] = of[kTargets][kRaters];
  for (const std::size_t k : {kTargets, kRaters}) {
    of[k][kResidual] = whole[k] - a * of[k][kTargets] - b * of[k][kRaters];
    of[kResidual][k] = of[k][kResidual];
  }
  of[kResidual][kResidual] = whole[kResidual] - a * of[kResidual][kTargets] - b * of[kResidual][kRaters];
}

Derivatives derivativesAt(const Sums& sums, const Parts& variance) {
  const double s = variance[kResidual];
  const double a = variance[kTargets] / s;
  const double b = variance[kRaters] / s;
  const Index k = sums.border();
  const MatrixXd under = underTargets(sums, a);
  Derivatives out;
  out.profile = profileOf(sums, under, a, b, true);
  const MatrixXd& m = out.profile.inverse;
  if (m.size() == 0) {
    return out;
  }
  const VectorXd shrink = (1.0 + a * sums.counts.array()).inverse();
  const VectorXd d = sums.counts.cwiseProduct(shrink);  // Zt' A^-1 Zt
  MatrixXd hh = MatrixXd::Zero(k, k);                   // of H = Zt' A^-1 F, which is met in products only
  MatrixXd hdh = MatrixXd::Zero(k, k);
  for (const Level& level : sums.levels) {
    const double shrunk = 1.0 / (1.0 + a * level.count);
    hh += shrunk * shrunk * level.within.topLeftCorner(k, k);
    hdh += level.count * shrunk * shrunk * shrunk * level.within.topLeftCorner(k, k);
  }
  const MatrixXd g = under.topLeftCorner(sums.raters, k);  // Zr' A^-1 F
  const MatrixXd ofRaters = under.topLeftCorner(sums.raters, sums.raters) - g * m * g.transpose();
  const MatrixXd crossed = MatrixXd::Identity(k, sums.raters) - m * g.transpose();  // H of it: Zt' P0 Zr
  const VectorXd solution = out.profile.solution;
  const VectorXd targets =
      shrink.cwiseProduct(sums.within.col(k) - sums.within.leftCols(k) * solution);  // Zt' P0 y
  const VectorXd ofTargets = sums.within.leftCols(k).transpose() * shrink.cwiseProduct(targets);
  const VectorXd raters = under.col(k).head(sums.raters) - g * solution;  // Zr' P0 y

  Parts traces{};
  traces[kTargets] = d.sum() - (m.cwiseProduct(hh)).sum();
  traces[kRaters] = ofRaters.trace();
  const double rest = sums.marks - static_cast<double>(sums.fixed);
  traces[kResidual] = rest - a * traces[kTargets] - b * traces[kRaters];
  std::array<Parts, kParts> pairs{};
  const MatrixXd mhh = m * hh;
  pairs[kTargets][kTargets] =
      d.squaredNorm() - 2.0 * m.cwiseProduct(hdh).sum() + mhh.cwiseProduct(mhh.transpose()).sum();
  pairs[kTargets][kRaters] = crossed.cwiseProduct(hh * crossed).sum();
  pairs[kRaters][kRaters] = ofRaters.squaredNorm();
  completeByResidual(a, b, traces, pairs);

  Parts squares{};
  squares[kTargets] = targets.squaredNorm();
  squares[kRaters] = raters.squaredNorm();
  squares[kResidual] = out.profile.squares - a * squares[kTargets] - b * squares[kRaters];
  std::array<Parts, kParts> forms{};
  forms[kTargets][kTargets] = d.dot(targets.cwiseAbs2()) - ofTargets.dot(m * ofTargets);
  forms[kTargets][kRaters] = ofTargets.dot(crossed * raters);
  forms[kRaters][kRaters] = raters.dot(ofRaters * raters);
  completeByResidual(a, b, squares, forms);

  for (std::size_t i = 0; i < kParts; ++i) {
    out.slope[i] = (traces[i] - squares[i] / s) / s;
    for (std::size_t j = 0; j < kParts; ++j) {
      out.expected(indexOf(i), indexOf(j)) = pairs[i][j] / (s * s);
      out.curvature(indexOf(i), indexOf(j)) = (2.0 * forms[i][j] / s - pairs[i][j]) / (s * s);
    }
  }
  out.covariance = s * m.bottomRightCorner(sums.fixed, sums.fixed);
  const MatrixXd mt = m.rightCols(sums.fixed);
  const MatrixXd kr = g * m.rightCols(sums.fixed);
  out.covarianceSlopes[kTargets] = mt.transpose() * hh * mt;
  out.covarianceSlopes[kRaters] = kr.transpose() * kr;
  out.covarianceSlopes[kResidual] = m.bottomRightCorner(sums.fixed, sums.fixed) -
                                    a * out.covarianceSlopes[kTargets] - b * out.covarianceSlopes[kRaters];
  return out;
}

/// Looks over a grid of ratios for a start from which Newton's method goes down into the lowest place.
Parts startOf(const Sums& sums) {
  constexpr std::array kRatios{0.0, 0.01, 0.05, 0.2, 0.6, 2.0, 8.0, 40.0};
  Parts best{};
  double lowest = std::numeric_limits<double>::infinity();
  for (const double a : kRatios) {
    const MatrixXd under = underTargets(sums, a);
    for (const double b : kRatios) {
      const Profile at = profileOf(sums, under, a, b, false);
      if (at.criterion < lowest) {
        lowest = at.criterion;
        const double s = at.squares / (sums.marks - static_cast<double>(sums.fixed));
        best = {s, a * s, b * s};
      }
    }
  }
  return best;
}

/// Variances at which the criterion is lowest; those that would become negative are held at 0.
struct Minimum {
  Parts variance{};
  std::array<bool, kParts> held{};
  Derivatives at;
  int iterations = 0;
  bool found = false;
};

Eigen::Vector3d stepFrom(const Derivatives& at, const std::array<bool, kParts>& held) {
  std::vector<Index> free;
  for (std::size_t k = 0; k < kParts; ++k) {
    if (!held[k]) {
      free.push_back(indexOf(k));
    }
  }
  const Index n = std::ssize(free);
  VectorXd slope(n);
  for (Index i = 0; i < n; ++i) {
    slope[i] = at.slope[static_cast<std::size_t>(free[static_cast<std::size_t>(i)])];
  }
  Eigen::LLT<MatrixXd> factor(at.curvature(free, free));
  if (factor.info() != Eigen::Success) {
    factor.compute(at.expected(free, free));  // far from the minimum: Fisher's scoring
  }
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  if (factor.info() == Eigen::Success) {
    step(free) = -factor.solve(slope);
  }
  return step;
}

/// The step from `variance` without the parts that stand at their lower bound and would go below it: they
/// would stop the others, too.
Eigen::Vector3d stepWithin(const Derivatives& at, const std::array<bool, kParts>& held, const Parts& variance,
                           double vanishing) {
  std::array<bool, kParts> still = held;
  Eigen::Vector3d step = stepFrom(at, still);
  for (const std::size_t k : {kTargets, kRaters}) {
    if (!still[k] && variance[k] <= vanishing * variance[kResidual] && step[indexOf(k)] < 0.0) {
      still[k] = true;
      step = stepFrom(at, still);
    }
  }
  return step;
}

/// Share of a step that keeps every variance above 0.
double shareAboveZero(const Parts& variance, const Eigen::Vector3d& step) {
  constexpr double kOfTheWay = 0.9;
  double share = 1.0;
  for (std::size_t k = 0; k < kParts; ++k) {
    if (variance[k] + step[indexOf(k)] < 0.0) {
      share = std::min(share, -kOfTheWay * variance[k] / step[indexOf(k)]);
    }
  }
  return share;
}

Minimum minimum(const Sums& sums) {
  constexpr int kMostSteps = 200;
  constexpr double kSettled = 1e-9;    // the next step of Newton's method is the square of this
  constexpr double kVanishing = 1e-6;  // of the residual variance: then it is asked whether 0 is better
  constexpr double kNoResidual = 1e9;  // ratio of a variance to the residual one
  Minimum out;
  out.variance = startOf(sums);
  if (!(out.variance[kResidual] > 0.0)) {
    return out;
  }
  out.at = derivativesAt(sums, out.variance);
  const auto hold = [&](std::size_t k) {
    Parts without = out.variance;
    without[k] = 0.0;
    const Derivatives at = derivativesAt(sums, without);
    if (at.slope[k] < 0.0) {
      return false;
    }
    out.held[k] = true;
    out.variance = without;
    out.at = at;
    return true;
  };
  for (out.iterations = 1; out.iterations <= kMostSteps; ++out.iterations) {
    for (const std::size_t k : {kTargets, kRaters}) {
      if (!out.held[k] && out.variance[k] <= kVanishing * out.variance[kResidual] && !hold(k) &&
          out.variance[k] == 0.0) {
        out.variance[k] = kVanishing * out.variance[kResidual];
        out.at = derivativesAt(sums, out.variance);
      }
    }
    const Eigen::Vector3d step = stepWithin(out.at, out.held, out.variance, kVanishing);
    double share = shareAboveZero(out.variance, step);
    Parts next{};
    Derivatives at;
    constexpr double kRise = 1e-9;  // of rounding
    for (int halvings = 0;; ++halvings) {
      for (std::size_t k = 0; k < kParts; ++k) {
        next[k] = out.variance[k] + share * step[indexOf(k)];
      }
      at = derivativesAt(sums, next);
      constexpr int kMostHalvings = 30;
      if (at.profile.criterion <= out.at.profile.criterion + kRise || halvings == kMostHalvings) {
        break;
      }
      share *= 0.5;
    }
    if (at.profile.inverse.size() == 0 ||
        std::max(next[kTargets], next[kRaters]) > kNoResidual * next[kResidual]) {
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
      out.at = derivativesAt(sums, out.variance);
    }
  }
  return out;
}

/// Marks that remain when every target and every rater has a level of its own.
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

NumberTable tableOf(const MatrixXd& matrix) {
  NumberTable out(static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols()));
  for (std::size_t i = 0; i < out.rows(); ++i) {
    for (std::size_t j = 0; j < out.columns(); ++j) {
      out.at(i, j) = matrix(indexOf(i), indexOf(j));
    }
  }
  return out;
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
    return Undefined::undefined(Text::tr("there are too few marks to tell trainees, raters and error apart"));
  }
  Sums sums;
  sums.targets = indexOf(fixed.rows());
  sums.raters = indexOf(raters);
  sums.fixed = indexOf(fixed.columns());
  sums.marks = static_cast<double>(marks.size());
  if (!gather(marks, fixed, sums)) {
    return Undefined::undefined(Text::tr("the scores before do not vary within groups"));
  }
  const double total = sumOfSquares(values);
  const double left = sums.products(sums.border(), sums.border());
  constexpr double kRounding = 1e-24;  // of the marks' own squares
  const double size = *std::max_element(values.begin(), values.end(),
                                        [](double x, double y) { return std::abs(x) < std::abs(y); });
  if (total == 0.0 || left <= kRounding * size * size * sums.marks) {
    return Undefined::undefined(Text::tr("the marks leave no residual"));
  }
  const Minimum lowest = minimum(sums);
  if (!lowest.found) {
    return Undefined::undefined(Text::tr("the marks leave no residual, or the fit does not settle"));
  }
  CrossedModel out;
  out.marks_ = marks.size();
  out.varianceResidual_ = lowest.variance[kResidual];
  out.varianceTargets_ = lowest.variance[kTargets];
  out.varianceRaters_ = lowest.variance[kRaters];
  out.criterion_ = lowest.at.profile.criterion;
  out.iterations_ = lowest.iterations;
  const VectorXd coefficients = sums.ordinary + sums.back * lowest.at.profile.solution.tail(sums.fixed);
  out.coefficients_.assign(coefficients.begin(), coefficients.end());
  const auto asked = [&](const MatrixXd& of) { return tableOf(sums.back * of * sums.back.transpose()); };
  out.covariance_ = asked(lowest.at.covariance);
  std::vector<Index> free;
  for (std::size_t k = 0; k < kParts; ++k) {
    if (!lowest.held[k]) {
      free.push_back(indexOf(k));
      out.slopes_.push_back(asked(lowest.at.covarianceSlopes[k]));
    }
  }
  const MatrixXd curvature = lowest.at.curvature(free, free);
  const Eigen::LLT<MatrixXd> factor(curvature);
  if (factor.info() != Eigen::Success) {
    return Undefined::undefined(Text::tr("the marks do not tell the variances apart"));
  }
  out.varianceCovariance_ =
      tableOf(2.0 * factor.solve(MatrixXd::Identity(std::ssize(free), std::ssize(free))));
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
