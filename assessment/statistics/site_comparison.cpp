// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/site_comparison.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <Eigen/Dense>

#include "assessment/statistics/descriptive.h"

namespace torsio {

// Its helpers have names that other files of statistics use, too.
namespace of_sites {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr double kFitsExactly = 1e-9;  // 1 - leverage

Eigen::Index placeOf(const std::vector<std::size_t>& sorted, std::size_t number) {
  return std::lower_bound(sorted.begin(), sorted.end(), number) - sorted.begin();
}

/// The fixed part: a column for each group, the score before, then factors without their first level.
struct Design {
  std::vector<std::size_t> groups;
  std::vector<std::size_t> sites;
  Matrix x;
  Vector y;
};

Design designOf(const std::vector<SiteTrainee>& trainees, bool siteColumns, bool withLevels) {
  Design out{present(trainees, &SiteTrainee::group), present(trainees, &SiteTrainee::site), {}, {}};
  const std::vector<std::size_t> levels = present(trainees, &SiteTrainee::level);
  const auto n = std::ssize(trainees);
  const auto ofGroups = std::ssize(out.groups);
  const auto ofSites = siteColumns ? std::ssize(out.sites) - 1 : 0;
  const auto ofLevels = withLevels ? std::ssize(levels) - 1 : 0;
  out.x = Matrix::Zero(n, ofGroups + 1 + ofSites + ofLevels);
  out.y = Vector::Zero(n);
  double middle = 0.0;
  for (const SiteTrainee& one : trainees) {
    middle += one.before / static_cast<double>(n);
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const SiteTrainee& one = trainees[static_cast<std::size_t>(i)];
    out.x(i, placeOf(out.groups, one.group)) = 1.0;
    out.x(i, ofGroups) = one.before - middle;
    if (const Eigen::Index site = placeOf(out.sites, one.site); siteColumns && site > 0) {
      out.x(i, ofGroups + site) = 1.0;
    }
    if (const Eigen::Index level = placeOf(levels, one.level); withLevels && level > 0) {
      out.x(i, ofGroups + ofSites + level) = 1.0;
    }
    out.y(i) = one.after;
  }
  return out;
}

/// Least squares with an orthonormal basis of the columns.
struct Fit {
  Matrix q;
  Matrix inverse;  ///< of X'X
  Vector coefficients;
  Vector residuals;
  double squares = 0.0;
  double logDeterminant = 0.0;  ///< of X'X
};

std::optional<Fit> fitOf(const Matrix& x, const Vector& y) {
  Eigen::ColPivHouseholderQR<Matrix> rank(x);
  rank.setThreshold(1e-10);
  if (rank.rank() < x.cols()) {
    return std::nullopt;
  }
  const Eigen::HouseholderQR<Matrix> qr(x);
  Fit out;
  out.q = qr.householderQ() * Matrix::Identity(x.rows(), x.cols());
  const Matrix r = qr.matrixQR().topRows(x.cols()).triangularView<Eigen::Upper>();
  const Matrix inverse = r.triangularView<Eigen::Upper>().solve(Matrix::Identity(x.cols(), x.cols()));
  out.inverse = inverse * inverse.transpose();
  out.coefficients = inverse * (out.q.transpose() * y);
  out.residuals = y - x * out.coefficients;
  out.squares = out.residuals.squaredNorm();
  out.logDeterminant = 2.0 * r.diagonal().array().abs().log().sum();
  return out;
}

/// Error and degrees of freedom of HC3 (see ancova.cpp); empty if somebody who counts fits exactly.
std::optional<std::pair<double, double>> robustPrecision(const Fit& fit, const Vector& weights,
                                                         double residualDf) {
  const Vector leverage = fit.q.rowwise().squaredNorm();
  Vector a = Vector::Zero(weights.size());
  double variance = 0.0;
  double expected = 0.0;
  double squares = 0.0;
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const double free = 1.0 - leverage(i);
    if (free < kFitsExactly) {
      if (std::abs(weights(i)) > kFitsExactly) {
        return std::nullopt;
      }
      continue;  // alone at a centre: says nothing about a difference
    }
    a(i) = weights(i) * weights(i) / (free * free);
    variance += a(i) * fit.residuals(i) * fit.residuals(i);
    expected += a(i) * free;
    squares += a(i) * a(i) * (2.0 * free - 1.0);
  }
  squares += (fit.q.transpose() * a.asDiagonal() * fit.q).squaredNorm();
  return std::pair{std::sqrt(variance), std::min(residualDf, expected * expected / squares)};
}

/// The model with random centres at a ratio of their variance to the residual one: least squares of scores
/// less a share of their centre's mean (restricted likelihood of Patterson and Thompson 1971).
class RandomSites {
 public:
  RandomSites(const std::vector<SiteTrainee>& trainees, Design design)
      : design_(std::move(design)), sizes_(Vector::Zero(std::ssize(design_.sites))) {
    for (const SiteTrainee& one : trainees) {
      siteOf_.push_back(placeOf(design_.sites, one.site));
      sizes_(siteOf_.back()) += 1.0;
    }
    sums_ = summed(design_.x);
  }

  /// What the criterion consists of, with derivatives by the ratio.
  struct State {
    Fit fit;
    double slopeOfSquares = 0.0;
    double slopeOfLogs = 0.0;  ///< of the logarithms of the determinants
    Matrix pulls;              ///< centres x coefficients: their part of the derivative of X'V^-1 X
  };

  [[nodiscard]] const Design& design() const noexcept { return design_; }
  [[nodiscard]] double df() const { return static_cast<double>(design_.x.rows() - design_.x.cols()); }

  [[nodiscard]] State at(double ratio) const {
    State out;
    out.fit = fitOf(shrunk(design_.x, ratio), shrunk(design_.y, ratio)).value();
    const Vector share = (1.0 + ratio * sizes_.array()).inverse();
    out.pulls = share.asDiagonal() * sums_;
    const Vector left = share.asDiagonal() * summed(design_.y - design_.x * out.fit.coefficients);
    out.slopeOfSquares = -left.squaredNorm();
    out.slopeOfLogs = sizes_.dot(share) - (out.pulls * out.fit.inverse).cwiseProduct(out.pulls).sum();
    return out;
  }
  [[nodiscard]] double criterion(double ratio) const {
    const Fit fit = fitOf(shrunk(design_.x, ratio), shrunk(design_.y, ratio)).value();
    return df() * std::log(fit.squares) + fit.logDeterminant + (1.0 + ratio * sizes_.array()).log().sum();
  }
  [[nodiscard]] double slope(double ratio) const {
    const State state = at(ratio);
    return df() * state.slopeOfSquares / state.fit.squares + state.slopeOfLogs;
  }

 private:
  [[nodiscard]] Matrix summed(const Matrix& m) const {
    Matrix out = Matrix::Zero(sizes_.size(), m.cols());
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
      out.row(siteOf_[static_cast<std::size_t>(i)]) += m.row(i);
    }
    return out;
  }
  [[nodiscard]] Matrix shrunk(const Matrix& m, double ratio) const {
    const Matrix sums = summed(m);
    Matrix out = m;
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
      const Eigen::Index site = siteOf_[static_cast<std::size_t>(i)];
      out.row(i) -= (1.0 - 1.0 / std::sqrt(1.0 + sizes_(site) * ratio)) / sizes_(site) * sums.row(site);
    }
    return out;
  }

  Design design_;
  std::vector<Eigen::Index> siteOf_;
  Vector sizes_;
  Matrix sums_;
};

/// Returns the ratio that minimises the criterion: on a grid of shares first, as it may have several minima,
/// then where the slope is 0.
double bestRatio(const RandomSites& model) {
  constexpr int kGridSteps = 40;
  constexpr double kLargestShare = 0.999;
  const auto ratioOf = [](int i) {
    const double share = kLargestShare * i / kGridSteps;
    return share / (1.0 - share);
  };
  int best = 0;
  double least = model.criterion(0.0);
  for (int i = 1; i <= kGridSteps; ++i) {
    if (const double value = model.criterion(ratioOf(i)); value < least) {
      best = i;
      least = value;
    }
  }
  double low = ratioOf(std::max(0, best - 1));
  double high = ratioOf(std::min(kGridSteps, best + 1));
  if (best == 0 && model.slope(0.0) >= 0.0) {
    return 0.0;
  }
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) {
      break;
    }
    (model.slope(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// First derivative by central differences of fourth order.
double derivativeOf(const std::function<double(double)>& f, double at) {
  const double step = 0.01 * at;
  return (8.0 * (f(at + step) - f(at - step)) - (f(at + 2.0 * step) - f(at - 2.0 * step))) / (12.0 * step);
}

std::vector<AdjustedDifference> randomPairs(const RandomSites& model, double ratio, double variance) {
  const RandomSites::State state = model.at(ratio);
  const std::vector<std::size_t>& groups = model.design().groups;
  // Curvature of the criterion in the ratio and the residual variance.
  const double bend = ratio > 0.0 ? derivativeOf(
                                        [&](double other) {
                                          const RandomSites::State at = model.at(other);
                                          return at.slopeOfLogs + at.slopeOfSquares / variance;
                                        },
                                        ratio)
                                  : 0.0;
  const double mixed = -state.slopeOfSquares / (variance * variance);
  const double residual = model.df() / (variance * variance);
  const double determinant = bend * residual - mixed * mixed;
  std::vector<AdjustedDifference> out;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = i + 1; j < groups.size(); ++j) {
      Vector contrast = Vector::Zero(state.fit.coefficients.size());
      contrast(static_cast<Eigen::Index>(i)) = 1.0;
      contrast(static_cast<Eigen::Index>(j)) = -1.0;
      const Vector spread = state.fit.inverse * contrast;
      const double own = contrast.dot(spread);
      double df = model.df();
      if (ratio > 0.0 &&
          determinant > 0.0) {  // Satterthwaite: 2 f^2 / (g' C g), C twice the inverse curvature
        const double byRatio = variance * (state.pulls * spread).squaredNorm();
        const double squares = byRatio * byRatio * residual - 2.0 * byRatio * own * mixed + own * own * bend;
        df = std::min(df, variance * variance * own * own * determinant / squares);
      }
      out.push_back(adjustedDifference(groups[i], groups[j], contrast.dot(state.fit.coefficients),
                                       std::sqrt(variance * own), df));
    }
  }
  return out;
}

std::vector<AdjustedDifference> fixedPairs(const Design& design, const Fit& fit, double variance, double df) {
  const Matrix weights = design.x * fit.inverse;
  std::vector<AdjustedDifference> out;
  for (std::size_t i = 0; i < design.groups.size(); ++i) {
    for (std::size_t j = i + 1; j < design.groups.size(); ++j) {
      const auto a = static_cast<Eigen::Index>(i);
      const auto b = static_cast<Eigen::Index>(j);
      const double pooled =
          std::sqrt(variance * (fit.inverse(a, a) + fit.inverse(b, b) - 2.0 * fit.inverse(a, b)));
      const auto [error, own] =
          robustPrecision(fit, weights.col(a) - weights.col(b), df).value_or(std::pair{pooled, df});
      out.push_back(adjustedDifference(design.groups[i], design.groups[j],
                                       fit.coefficients(a) - fit.coefficients(b), error, own));
    }
  }
  return out;
}

double squaresAbout(const Vector& y) {
  return (y.array() - y.mean()).square().sum();
}

}  // namespace
}  // namespace of_sites

Outcome<SiteComparison> compareWithinSites(const std::vector<SiteTrainee>& trainees, SiteTerm term,
                                           bool withLevels, double confidence) {
  using Undefined = Outcome<SiteComparison>;
  if (const std::optional<Text> reason = sitesNotComparable(trainees)) {
    return Undefined::undefined(*reason);
  }
  of_sites::Design design = of_sites::designOf(trainees, term == SiteTerm::kFixed, withLevels);
  const auto df = static_cast<double>(design.x.rows() - design.x.cols());
  if (df <= 0.0) {
    return Undefined::undefined(Text::tr("there are too few trainees"));
  }
  const std::optional<of_sites::Fit> fit = of_sites::fitOf(design.x, design.y);
  if (!fit) {
    return Undefined::undefined(
        Text::tr("groups, centres, scores before and further factors cannot be told apart"));
  }
  if (!(fit->squares > kLeftByRounding * of_sites::squaresAbout(design.y))) {
    return Undefined::undefined(Text::tr("the scores after follow the scores before exactly"));
  }
  SiteComparison out;
  out.term = term;
  out.trainees = trainees.size();
  out.sites = design.sites.size();
  if (term == SiteTerm::kFixed) {
    out.residualVariance = fit->squares / df;
    out.pairs = of_sites::fixedPairs(design, *fit, out.residualVariance, df);
  } else {
    const of_sites::RandomSites model(trainees, std::move(design));
    const double ratio = of_sites::bestRatio(model);
    out.residualVariance = model.at(ratio).fit.squares / df;
    out.siteVariance = ratio * out.residualVariance;
    out.pairs = of_sites::randomPairs(model, ratio, out.residualVariance);
  }
  addIntervals(out.pairs, confidence);
  return out;
}

}  // namespace torsio
