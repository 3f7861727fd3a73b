// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/cusum.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>
#include <boost/math/quadrature/gauss.hpp>

#include "assessment/statistics/distributions.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr double kRounding = 1e-12;  // a sum within rounding of its limit has reached it

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

std::optional<double> averageRunLengthOneSided(double k, double h, double shift) {
  TORSIO_EXPECTS(h > 0.0);
  // Siegmund's approximation predicts where the equation has no significant digits left.
  const double drift = k - shift;
  const double away = h + 1.166;
  constexpr double kLongest = 1e12;
  if (drift > 0.0 && std::exp(2.0 * drift * away) > kLongest * 2.0 * drift * drift) {
    return std::nullopt;
  }
  using Rule = boost::math::quadrature::gauss<double, 20>;
  const int panels = std::max(4, static_cast<int>(std::ceil(h)));
  std::vector<double> nodes;
  std::vector<double> weights;
  const double half = 0.5 * h / panels;
  for (int panel = 0; panel < panels; ++panel) {
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

std::optional<double> averageRunLengthTwoSided(double k, double h, double shift) {
  const std::optional<double> up = averageRunLengthOneSided(k, h, shift);
  const std::optional<double> down = averageRunLengthOneSided(k, h, -shift);
  if (!up && !down) {
    return std::nullopt;
  }
  return 1.0 / ((up ? 1.0 / *up : 0.0) + (down ? 1.0 / *down : 0.0));
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

namespace {

/// Probabilities of the states of a sum with two possible steps, up and down, held at 0 from below, that has
/// not reached its limit. A state is the number of steps up and down since the sum was last 0: integers, so
/// equal sums merge. With f steps down, only a few numbers of steps up keep the sum between 0 and the limit.
class SumStates {
 public:
  /// Starts with probability 1 at 0 or, if `empty`, with none anywhere.
  SumStates(double up, double down, double limit, std::size_t attempts, bool empty = false)
      : atZero_(empty ? 0.0 : 1.0) {
    const double largest = static_cast<double>(attempts) * up;
    for (double lost = 0.0; lost <= largest && rows_.size() <= attempts; lost += down) {
      Row row;
      row.fewest = static_cast<std::size_t>(std::floor((lost + kRounding) / up)) + 1;
      const double most = std::ceil((limit - kRounding + lost) / up) - 1.0;
      row.states.resize(
          static_cast<std::size_t>(std::max(0.0, most - static_cast<double>(row.fewest) + 1.0)));
      rows_.push_back(std::move(row));
    }
  }

  /// Adds probability at 0.
  void enter(double share) { atZero_ += share; }

  /// Makes one attempt, down with probability `downRate`, and returns the probability of reaching the limit.
  double attempt(double downRate) {
    const double atStart = std::exchange(atZero_, atZero_ * downRate);
    double declared = 0.0;
    std::size_t holding = 1;
    // In descending order, so that what has moved is not moved again.
    for (std::size_t f = used_; f-- > 0;) {
      Row& row = rows_[f];
      for (std::size_t i = row.states.size(); i-- > 0;) {
        const double share = std::exchange(row.states[i], 0.0);
        if (share < kNothing) {
          continue;
        }
        holding = std::max(holding, f + 2);
        fall(f + 1, row.fewest + i, share * downRate);
        (i + 1 < row.states.size() ? row.states[i + 1] : declared) += share * (1.0 - downRate);
      }
    }
    used_ = std::min(holding, rows_.size());
    (rows_.front().states.empty() ? declared : rows_.front().states.front()) += atStart * (1.0 - downRate);
    return declared;
  }

 private:
  static constexpr double kNothing =
      1e-40;  // negligible probability: below rounding over any number of attempts

  struct Row {
    std::size_t fewest = 0;      // minimum steps up that keep the sum above 0
    std::vector<double> states;  // by number of steps up, from `fewest`
  };

  void fall(std::size_t down, std::size_t up, double share) {
    if (down < rows_.size() && up >= rows_[down].fewest) {
      rows_[down].states[up - rows_[down].fewest] += share;
    } else {
      atZero_ += share;
    }
  }

  std::vector<Row> rows_;  // by number of steps down
  std::size_t used_ = 1;   // rows that may be nonzero
  double atZero_ = 1.0;
};

SumStates lcCusumStates(const LcCusumDesign& design, std::size_t attempts) {
  const LcWeights weights = weightsOf(design);
  return {weights.success, -weights.failure, design.limit, attempts};
}

/// Probability of reaching the limit within the attempts; above `enough` a lower bound. After some hundred
/// attempts the rate of reaching the limit is constant to the last digit, and the rest follows in closed
/// form.
double reachedWithin(const LcCusumDesign& design, double failureRate, std::size_t attempts, double enough) {
  constexpr double kConstant = 1e-14;
  constexpr int kLong = 64;  // attempts over which the rate has stayed constant
  SumStates states = lcCusumStates(design, attempts);
  double declared = 0.0;
  double left = 1.0;
  double rate = 0.0;
  int constant = 0;
  for (std::size_t attempt = 1; attempt <= attempts; ++attempt) {
    const double now = states.attempt(failureRate);
    declared += now;
    if (declared > enough) {
      return declared;
    }
    const double before = std::exchange(rate, left > 0.0 ? now / left : 0.0);
    left -= now;
    constant = rate > 0.0 && std::abs(rate - before) <= kConstant * rate ? constant + 1 : 0;
    if (constant == kLong) {
      const double more = static_cast<double>(attempts - attempt);
      return declared - left * std::expm1(more * std::log1p(-rate));
    }
  }
  return declared;
}

}  // namespace

double lcCusumProbability(const LcCusumDesign& design, double failureRate, std::size_t attempts) {
  TORSIO_EXPECTS(failureRate >= 0.0 && failureRate <= 1.0);
  return reachedWithin(design, failureRate, attempts, 1.0);
}

double lcCusumNotAble(const LcCusumDesign& design, double failureRate, std::size_t attempts) {
  TORSIO_EXPECTS(failureRate >= 0.0 && failureRate <= 1.0);
  constexpr double kConstant = 1e-15;
  constexpr int kLong = 64;  // attempts over which nothing has changed
  const LcWeights weights = weightsOf(design);
  SumStates learning = lcCusumStates(design, attempts);
  SumStates watch(-weights.failure, weights.success, design.limit, attempts, true);
  double notAble = 1.0;
  int constant = 0;
  for (std::size_t attempt = 1; attempt <= attempts && constant < kLong; ++attempt) {
    const double declared = learning.attempt(failureRate);
    const double alarmed = watch.attempt(1.0 - failureRate);
    watch.enter(declared);
    learning.enter(alarmed);
    const double before = std::exchange(notAble, notAble - declared + alarmed);
    constant = std::abs(notAble - before) <= kConstant ? constant + 1 : 0;
    if (declared == 0.0 && alarmed == 0.0) {
      constant = 0;  // nobody can have reached it yet
    }
  }
  return notAble;
}

std::optional<double> chooseLcCusumLimit(double adequate, double inadequate, std::size_t attempts,
                                         double falsePass) {
  TORSIO_EXPECTS(falsePass > 0.0 && falsePass < 1.0);
  LcCusumDesign design{adequate, inadequate, 0.0};
  const double largest = weightsOf(design).success * static_cast<double>(attempts);
  // The probability falls as the limit rises: bisect over hundredths.
  int low = 0;
  int high = 1;
  const int most = static_cast<int>(std::floor(100.0 * largest));
  const auto passes = [&](int hundredths) {
    design.limit = hundredths / 100.0;
    return reachedWithin(design, inadequate, attempts, falsePass);
  };
  if (most < 1) {
    return std::nullopt;
  }
  while (passes(high) > falsePass) {  // small limits are cheap
    if (high == most) {
      return std::nullopt;
    }
    low = high;
    high = std::min(2 * high, most);
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
