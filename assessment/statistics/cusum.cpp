// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/cusum.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Dense>
#include <boost/math/quadrature/gauss.hpp>

#include "assessment/statistics/distributions.h"
#include "sim/base/contracts.h"

namespace torsio {

namespace {

constexpr double kRounding = 1e-12;  // a sum that reaches its limit up to rounding has reached it

struct LcWeights {
  double success = 0.0;
  double failure = 0.0;
};

LcWeights weightsOf(const LcCusumDesign& design) {
  TORSIO_EXPECTS(design.adequate > 0.0 && design.adequate < design.inadequate && design.inadequate < 1.0);
  return {std::log((1.0 - design.adequate) / (1.0 - design.inadequate)),
          std::log(design.adequate / design.inadequate)};
}

}  // namespace

TabularCusum tabularCusum(std::span<const double> values, double target, double reference, double limit) {
  TORSIO_EXPECTS(reference >= 0.0 && limit > 0.0);
  TabularCusum out;
  TabularCusumPoint last;
  for (const double x : values) {
    TabularCusumPoint point;
    point.upper = std::max(0.0, x - (target + reference) + last.upper);
    point.lower = std::max(0.0, (target - reference) - x + last.lower);
    point.upperRun = point.upper > 0.0 ? last.upperRun + 1 : 0;
    point.lowerRun = point.lower > 0.0 ? last.lowerRun + 1 : 0;
    out.points.push_back(point);
    if (!out.firstSignal && (point.upper > limit || point.lower > limit)) {
      out.firstSignal = out.points.size();
    }
    last = point;
  }
  return out;
}

double averageRunLengthOneSided(double k, double h, double shift) {
  TORSIO_EXPECTS(h > 0.0);
  using Rule = boost::math::quadrature::gauss<double, 20>;
  constexpr int kPanels = 4;
  std::vector<double> nodes;
  std::vector<double> weights;
  const double half = 0.5 * h / kPanels;
  for (int panel = 0; panel < kPanels; ++panel) {
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      for (const double side : {-1.0, 1.0}) {
        nodes.push_back(half * (2.0 * panel + 1.0 + side * Rule::abscissa()[i]));
        weights.push_back(half * Rule::weights()[i]);
      }
    }
  }
  // L(u) = 1 + L(0) Phi(k - shift - u) + integral over (0, h) of L(x) phi(x + k - shift - u) dx; L(0) comes
  // first.
  const auto n = static_cast<Eigen::Index>(nodes.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n + 1, n + 1);
  for (Eigen::Index row = 0; row <= n; ++row) {
    const double u = row == 0 ? 0.0 : nodes[static_cast<std::size_t>(row - 1)];
    system(row, 0) -= normalCdf(k - shift - u);
    for (Eigen::Index column = 1; column <= n; ++column) {
      const auto at = static_cast<std::size_t>(column - 1);
      system(row, column) -= weights[at] * normalDensity(nodes[at] + k - shift - u);
    }
  }
  return system.partialPivLu().solve(Eigen::VectorXd::Ones(n + 1))[0];
}

double averageRunLengthTwoSided(double k, double h, double shift) {
  return 1.0 / (1.0 / averageRunLengthOneSided(k, h, shift) + 1.0 / averageRunLengthOneSided(k, h, -shift));
}

BinaryCusum binaryCusum(const std::vector<bool>& failed, double acceptable, double unacceptable, double alpha,
                        double beta) {
  TORSIO_EXPECTS(acceptable > 0.0 && acceptable < unacceptable && unacceptable < 1.0);
  const double p = std::log(unacceptable / acceptable);
  const double q = std::log((1.0 - acceptable) / (1.0 - unacceptable));
  BinaryCusum out;
  out.s = q / (p + q);
  out.h0 = std::log((1.0 - alpha) / beta) / (p + q);
  out.h1 = std::log((1.0 - beta) / alpha) / (p + q);
  double sum = 0.0;
  for (const bool failure : failed) {
    sum += failure ? 1.0 - out.s : -out.s;
    out.sums.push_back(sum);
  }
  return out;
}

LcCusum lcCusum(const std::vector<bool>& failed, const LcCusumDesign& design) {
  const LcWeights weights = weightsOf(design);
  LcCusum out;
  out.successWeight = weights.success;
  out.failureWeight = weights.failure;
  double sum = 0.0;
  for (const bool failure : failed) {
    sum = std::max(0.0, sum + (failure ? weights.failure : weights.success));
    out.sums.push_back(sum);
    if (!out.competentAt && sum >= design.limit - kRounding) {
      out.competentAt = out.sums.size();
    }
  }
  return out;
}

double lcCusumProbability(const LcCusumDesign& design, double failureRate, std::size_t attempts) {
  TORSIO_EXPECTS(failureRate >= 0.0 && failureRate <= 1.0);
  const LcWeights weights = weightsOf(design);
  // A state is the number of successes and failures since the sum was last 0: whole numbers, so equal sums
  // merge.
  std::map<std::pair<int, int>, double> states = {{{0, 0}, 1.0}};
  double declared = 0.0;
  for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
    std::map<std::pair<int, int>, double> next;
    for (const auto& [state, probability] : states) {
      for (const bool failure : {false, true}) {
        const std::pair<int, int> to = {state.first + (failure ? 0 : 1), state.second + (failure ? 1 : 0)};
        const double sum = to.first * weights.success + to.second * weights.failure;
        const double share = probability * (failure ? failureRate : 1.0 - failureRate);
        if (sum >= design.limit - kRounding) {
          declared += share;
        } else {
          next[sum <= kRounding ? std::pair{0, 0} : to] += share;
        }
      }
    }
    states = std::move(next);
  }
  return declared;
}

std::optional<double> chooseLcCusumLimit(double adequate, double inadequate, std::size_t attempts,
                                         double falsePass) {
  TORSIO_EXPECTS(falsePass > 0.0 && falsePass < 1.0);
  LcCusumDesign design{adequate, inadequate, 0.0};
  const double largest = weightsOf(design).success * static_cast<double>(attempts);
  // The probability falls as the limit rises: bisect over hundredths.
  int low = 0;
  int high = static_cast<int>(std::floor(100.0 * largest));
  const auto passes = [&](int hundredths) {
    design.limit = hundredths / 100.0;
    return lcCusumProbability(design, inadequate, attempts);
  };
  if (high < 1 || passes(high) > falsePass) {
    return std::nullopt;
  }
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (passes(middle) <= falsePass ? high : low) = middle;
  }
  return high / 100.0;
}

RelapseWatch watchForRelapse(const std::vector<bool>& failed, const LcCusumDesign& design) {
  const LcWeights weights = weightsOf(design);
  RelapseWatch out;
  double sum = 0.0;
  for (const bool failure : failed) {
    sum = std::max(0.0, sum - (failure ? weights.failure : weights.success));
    out.sums.push_back(sum);
    if (!out.alarmAt && sum >= design.limit - kRounding) {
      out.alarmAt = out.sums.size();
    }
  }
  return out;
}

}  // namespace torsio
