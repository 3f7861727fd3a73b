// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/crossed_likelihood.h"

#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Dense>

namespace torsio {

/// Sums over the marks. V0 = I + a Zt Zt' + b Zr Zr' is n x n for n marks; it is used only through the border
/// [Zr X] and the sums within targets, so that 2,000 targets with 40 raters stay cheap.
struct CrossedLikelihood::Sums {
  /// Targets with the same number of marks. They share their weights at any variance ratio, so sums of
  /// squares over targets reduce to weighted sums over a few levels.
  struct Level {
    double count = 0.0;      // marks of each
    double targets = 0.0;    // number of targets
    Eigen::MatrixXd within;  // products of their rows of Sums::within
  };

  Eigen::Index targets = 0;
  Eigen::Index raters = 0;
  Eigen::Index fixed = 0;
  double marks = 0.0;
  Eigen::VectorXd counts;  // marks of each target
  Eigen::MatrixXd within;  // targets x [raters, fixed, mark]: sums over the target's marks
  std::vector<Level> levels;
  Eigen::MatrixXd products;  // of [raters, fixed, mark]
  Eigen::MatrixXd back;      // coefficients of the orthogonal fixed part -> coefficients asked for
  Eigen::VectorXd ordinary;  // least-squares coefficients, already subtracted from the marks
  double logScale = 0.0;

  [[nodiscard]] Eigen::Index border() const { return raters + fixed; }
};

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using CrossedSums = CrossedLikelihood::Sums;
using Level = CrossedSums::Level;

Index indexOf(std::size_t i) {
  return static_cast<Index>(i);
}

/// Subtracts the least-squares fit of the fixed part from the marks and orthonormalises that part, so that
/// neither a large mean mark nor the unit of a covariate costs precision.
bool orthogonalise(const NumberTable& fixed, const VectorXd& sums, CrossedSums& out) {
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

std::vector<Level> levelsOf(const CrossedSums& sums) {
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

/// Computes the sums for the fit. Returns false if the fixed coefficients cannot be separated.
bool gather(const std::vector<CrossedMark>& marks, const NumberTable& fixed, CrossedSums& out) {
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
MatrixXd underTargets(const CrossedSums& sums, double a) {
  MatrixXd out = sums.products;
  for (const Level& level : sums.levels) {
    out -= a / (1.0 + a * level.count) * level.within;
  }
  return out;
}

/// The fit at given ratios of target (a) and rater (b) variance to the residual variance.
struct Profile {
  double criterion = std::numeric_limits<double>::infinity();
  double squares = 0.0;  // y' P0 y
  MatrixXd inverse;      // M: of the border's equations; rows of raters are 0 where b is 0
  VectorXd solution;     // M F' A^-1 y
};

Profile profileOf(const CrossedSums& sums, const MatrixXd& under, double a, double b, bool whole) {
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

/// Derives the entries of the residual from those of targets and raters: P0 V0 P0 = P0.
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

NumberTable tableOf(const MatrixXd& matrix) {
  NumberTable out(static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols()));
  for (std::size_t i = 0; i < out.rows(); ++i) {
    for (std::size_t j = 0; j < out.columns(); ++j) {
      out.at(i, j) = matrix(indexOf(i), indexOf(j));
    }
  }
  return out;
}

}  // namespace

CrossedLikelihood::CrossedLikelihood(const std::vector<CrossedMark>& marks, const NumberTable& fixed,
                                     std::size_t raters)
    : sums_(std::make_unique<Sums>()) {
  sums_->targets = indexOf(fixed.rows());
  sums_->raters = indexOf(raters);
  sums_->fixed = indexOf(fixed.columns());
  sums_->marks = static_cast<double>(marks.size());
  separable_ = gather(marks, fixed, *sums_);
}

CrossedLikelihood::~CrossedLikelihood() = default;

double CrossedLikelihood::squaresLeft() const {
  return sums_->products(sums_->border(), sums_->border());
}

Parts CrossedLikelihood::start() const {
  const Sums& sums = *sums_;
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

CrossedLikelihood::Derivatives CrossedLikelihood::at(const Parts& variance) const {
  const Sums& sums = *sums_;
  const double s = variance[kResidual];
  const double a = variance[kTargets] / s;
  const double b = variance[kRaters] / s;
  const Index k = sums.border();
  const MatrixXd under = underTargets(sums, a);
  Derivatives out;
  const Profile profile = profileOf(sums, under, a, b, true);
  const MatrixXd& m = profile.inverse;
  if (m.size() == 0) {
    return out;
  }
  out.defined = true;
  out.criterion = profile.criterion;
  const VectorXd shrink = (1.0 + a * sums.counts.array()).inverse();
  const VectorXd d = sums.counts.cwiseProduct(shrink);  // Zt' A^-1 Zt
  MatrixXd hh = MatrixXd::Zero(k, k);                   // of H = Zt' A^-1 F, which appears in products only
  MatrixXd hdh = MatrixXd::Zero(k, k);
  for (const Level& level : sums.levels) {
    const double shrunk = 1.0 / (1.0 + a * level.count);
    hh += shrunk * shrunk * level.within.topLeftCorner(k, k);
    hdh += level.count * shrunk * shrunk * shrunk * level.within.topLeftCorner(k, k);
  }
  const MatrixXd g = under.topLeftCorner(sums.raters, k);  // Zr' A^-1 F
  const MatrixXd ofRaters = under.topLeftCorner(sums.raters, sums.raters) - g * m * g.transpose();
  const MatrixXd crossed = MatrixXd::Identity(k, sums.raters) - m * g.transpose();  // H of it: Zt' P0 Zr
  const VectorXd& solution = profile.solution;
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
  squares[kResidual] = profile.squares - a * squares[kTargets] - b * squares[kRaters];
  std::array<Parts, kParts> forms{};
  forms[kTargets][kTargets] = d.dot(targets.cwiseAbs2()) - ofTargets.dot(m * ofTargets);
  forms[kTargets][kRaters] = ofTargets.dot(crossed * raters);
  forms[kRaters][kRaters] = raters.dot(ofRaters * raters);
  completeByResidual(a, b, squares, forms);

  for (std::size_t i = 0; i < kParts; ++i) {
    out.slope[i] = (traces[i] - squares[i] / s) / s;
    for (std::size_t j = 0; j < kParts; ++j) {
      out.expected[i][j] = pairs[i][j] / (s * s);
      out.curvature[i][j] = (2.0 * forms[i][j] / s - pairs[i][j]) / (s * s);
    }
  }
  const VectorXd coefficients = sums.ordinary + sums.back * solution.tail(sums.fixed);
  out.coefficients.assign(coefficients.begin(), coefficients.end());
  const auto asked = [&](const MatrixXd& of) { return tableOf(sums.back * of * sums.back.transpose()); };
  out.covariance = asked(s * m.bottomRightCorner(sums.fixed, sums.fixed));
  const MatrixXd mt = m.rightCols(sums.fixed);
  const MatrixXd kr = g * m.rightCols(sums.fixed);
  const MatrixXd byTargets = mt.transpose() * hh * mt;
  const MatrixXd byRaters = kr.transpose() * kr;
  out.covarianceSlopes[kTargets] = asked(byTargets);
  out.covarianceSlopes[kRaters] = asked(byRaters);
  out.covarianceSlopes[kResidual] =
      asked(m.bottomRightCorner(sums.fixed, sums.fixed) - a * byTargets - b * byRaters);
  return out;
}

}  // namespace torsio
