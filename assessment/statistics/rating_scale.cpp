// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/rating_scale.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Core>

namespace torsio {

namespace {

constexpr double kFar = 300.0;  // logits; ratios within this are representable, and so are their products

}  // namespace

RatingScale::RatingScale(const std::vector<double>& tau)
    : sums_(tau.size() + 1, 0.0), up_(tau.size()), down_(tau.size()), categories_(sums_.size()) {
  for (std::size_t k = 0; k < tau.size(); ++k) {
    sums_[k + 1] = sums_[k] + tau[k];
    up_[k] = std::exp(-tau[k]);
    down_[k] = std::exp(tau[k]);
    near_ = near_ && std::abs(tau[k]) < kFar;
  }
  std::iota(categories_.begin(), categories_.end(), 0.0);
}

void RatingScale::at(double location, CategoryOdds& out) const {
  out.p.resize(sums_.size());
  if (!byQuotients(location, out.p)) {
    byExponentials(location, out.p);
  }
  const auto size = static_cast<Eigen::Index>(out.p.size());
  Eigen::Map<Eigen::ArrayXd> p(out.p.data(), size);
  const Eigen::Map<const Eigen::ArrayXd> category(categories_.data(), size);
  p /= p.sum();
  out.mean = (category * p).sum();
  out.variance = ((category - out.mean).square() * p).sum();
}

double RatingScale::exponent(double location, std::size_t k) const {
  return static_cast<double>(k) * location - sums_[k];
}

/// Computes from the middle category to both sides; false if a value overflows or underflows.
bool RatingScale::byQuotients(double location, std::vector<double>& p) const {
  constexpr double kLeast = 1e-250;
  if (!near_ || !(std::abs(location) < kFar)) {
    return false;
  }
  const double up = std::exp(location);
  const double down = std::exp(-location);
  const std::size_t middle = p.size() / 2;
  p[middle] = 1.0;
  double least = 1.0;
  double most = 1.0;
  for (std::size_t k = middle + 1; k < p.size(); ++k) {
    p[k] = p[k - 1] * (up * up_[k - 1]);
    least = std::min(least, p[k]);
    most = std::max(most, p[k]);
  }
  for (std::size_t k = middle; k-- > 0;) {
    p[k] = p[k + 1] * (down * down_[k]);
    least = std::min(least, p[k]);
    most = std::max(most, p[k]);
  }
  return least > kLeast && most < 1.0 / kLeast;
}

void RatingScale::byExponentials(double location, std::vector<double>& p) const {
  double largest = 0.0;
  for (std::size_t k = 1; k < p.size(); ++k) {
    largest = std::max(largest, exponent(location, k));
  }
  for (std::size_t k = 0; k < p.size(); ++k) {
    p[k] = std::exp(exponent(location, k) - largest);
  }
}

}  // namespace torsio
