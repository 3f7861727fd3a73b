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

/// Probabilities of the two outcomes before the next attempt.
struct Share {
  double afterUp = 0.0;
  double afterDown = 0.0;
  void add(const Share& other, double weight = 1.0) {
    afterUp += weight * other.afterUp;
    afterDown += weight * other.afterDown;
  }
  [[nodiscard]] double all() const { return afterUp + afterDown; }
};

/// Probability that an attempt takes the sum down, by the outcome of the attempt before.
struct DownRate {
  double afterUp = 0.0;
  double afterDown = 0.0;
  [[nodiscard]] double of(const Share& share) const {
    return afterUp * share.afterUp + afterDown * share.afterDown;
  }
};

/// Probabilities of the states of a sum with two possible steps, up and down, held at 0 from below, that has
/// not reached its limit. A state is the number of steps up and down since the sum was last 0: integers, so
/// equal sums merge. With f steps down, only a few numbers of steps up keep the sum between 0 and the limit.
class SumStates {
 public:
  /// Starts at 0 with the probabilities of `start`.
  SumStates(double up, double down, double limit, std::size_t attempts, const Share& start) : atZero_(start) {
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

  void enter(const Share& share) { atZero_.add(share); }

  /// Makes one attempt and returns the probability of reaching the limit.
  double attempt(const DownRate& rate) {
    const Share atStart = std::exchange(atZero_, {});
    const double fallen = rate.of(atStart);
    atZero_.afterDown = fallen;
    double reached = 0.0;
    std::size_t holding = 1;
    // In descending order, so that what has moved is not moved again.
    for (std::size_t f = used_; f-- > 0;) {
      Row& row = rows_[f];
      for (std::size_t i = row.states.size(); i-- > 0;) {
        const Share share = std::exchange(row.states[i], {});
        if (share.all() < kNothing) {
          continue;
        }
        holding = std::max(holding, f + 2);
        const double down = rate.of(share);
        fall(f + 1, row.fewest + i, down);
        (i + 1 < row.states.size() ? row.states[i + 1].afterUp : reached) += share.all() - down;
      }
    }
    used_ = std::min(holding, rows_.size());
    (rows_.front().states.empty() ? reached : rows_.front().states.front().afterUp) += atStart.all() - fallen;
    return reached;
  }

  /// Adds the probabilities of another sum with the same steps and limit.
  void add(const SumStates& other, double weight) {
    atZero_.add(other.atZero_, weight);
    used_ = std::max(used_, other.used_);
    for (std::size_t f = 0; f < other.used_; ++f) {
      for (std::size_t i = 0; i < other.rows_[f].states.size(); ++i) {
        rows_[f].states[i].add(other.rows_[f].states[i], weight);
      }
    }
  }

  void clear() {
    atZero_ = {};
    for (std::size_t f = 0; f < used_; ++f) {
      std::fill(rows_[f].states.begin(), rows_[f].states.end(), Share{});
    }
    used_ = 1;
  }

 private:
  static constexpr double kNothing =
      1e-40;  // negligible probability: below rounding over any number of attempts

  struct Row {
    std::size_t fewest = 0;     // minimum steps up that keep the sum above 0
    std::vector<Share> states;  // by number of steps up, from `fewest`
  };

  void fall(std::size_t down, std::size_t up, double share) {
    if (down < rows_.size() && up >= rows_[down].fewest) {
      rows_[down].states[up - rows_[down].fewest].afterDown += share;
    } else {
      atZero_.afterDown += share;
    }
  }

  std::vector<Row> rows_;  // by number of steps down
  std::size_t used_ = 1;   // rows that may be nonzero
  Share atZero_;
};

/// A rate that a session may have, and its probability.
struct SessionRate {
  double failure = 0.0;
  double weight = 1.0;
};

/// Returns nodes and weights of the beta distribution of a session's rate by Gauss-Jacobi quadrature (Golub
/// and Welsch): exact, as n nodes integrate polynomials of degree 2 n - 1 and a session of so many attempts
/// is one of the rate.
std::vector<SessionRate> sessionRates(double failureRate, const AttemptDependence& dependence,
                                      std::size_t attempts) {
  if (dependence.session <= 0.0 || dependence.perSession <= 1 || failureRate <= 0.0 || failureRate >= 1.0) {
    return {{failureRate, 1.0}};
  }
  const auto longest = std::min<std::int64_t>(dependence.perSession, static_cast<std::int64_t>(attempts));
  const auto nodes = static_cast<Eigen::Index>(longest / 2 + 1);
  const double precision = (1.0 - dependence.session) / dependence.session;
  const double a = (1.0 - failureRate) * precision - 1.0;  // exponent of 1 - t
  const double b = failureRate * precision - 1.0;          // exponent of 1 + t
  Eigen::VectorXd diagonal(nodes);
  Eigen::VectorXd beside(nodes - 1);
  diagonal[0] = (b - a) / (a + b + 2.0);
  for (Eigen::Index i = 1; i < nodes; ++i) {
    const auto n = static_cast<double>(i);
    const double twice = 2.0 * n + a + b;
    diagonal[i] = (b * b - a * a) / (twice * (twice + 2.0));
    const double squared =
        i == 1 ? 4.0 * (1.0 + a) * (1.0 + b) / (twice * twice * (twice + 1.0))
               : 4.0 * n * (n + a) * (n + b) * (n + a + b) / (twice * twice * (twice + 1.0) * (twice - 1.0));
    beside[i - 1] = std::sqrt(squared);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside);
  std::vector<SessionRate> rates;
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const double first = solver.eigenvectors()(0, i);
    rates.push_back({std::clamp(0.5 * (1.0 + solver.eigenvalues()[i]), 0.0, 1.0), first * first});
  }
  return rates;
}

/// Everybody with one failure rate, attempt by attempt: how many have been declared competent, and how many
/// count as competent now.
class Course {
 public:
  Course(const LcCusumDesign& design, double failureRate, std::size_t attempts, bool watched)
      : lag_(design.dependence.lag),
        perSession_(std::max<std::int64_t>(1, design.dependence.perSession)),
        rates_(sessionRates(failureRate, design.dependence, attempts)),
        watched_(watched),
        all_(startOf(design, failureRate, attempts, watched)) {
    TORSIO_EXPECTS(lag_ >= 0.0 && lag_ < 1.0 && design.dependence.session >= 0.0 &&
                   design.dependence.session < 1.0);
    if (rates_.size() > 1) {
      bySession_.assign(rates_.size(), all_);
    }
  }

  void attempt() {
    if (bySession_.empty()) {
      advance(all_, rates_.front().failure);
      return;
    }
    if (inSession_ == 0) {
      for (State& state : bySession_) {
        state.clear(watched_);
        state.add(all_, 1.0, watched_);
      }
    }
    inSession_ = (inSession_ + 1) % perSession_;
    all_.clear(watched_);
    for (std::size_t i = 0; i < rates_.size(); ++i) {
      State& state = bySession_[i];
      const double weight = rates_[i].weight;
      advance(state, rates_[i].failure);
      all_.now += weight * state.now;
      if (inSession_ == 0) {
        all_.add(state, weight, watched_);
      } else {
        all_.notAble += weight * state.notAble;
      }
    }
  }

  /// Probability of being declared competent at the last attempt.
  [[nodiscard]] double declaredNow() const { return all_.now; }
  /// Probability of not counting as competent after the last attempt.
  [[nodiscard]] double notAble() const { return all_.notAble; }

 private:
  struct State {
    SumStates learning;
    SumStates watch;
    double now = 0.0;
    double notAble = 1.0;
    void clear(bool watched) {
      learning.clear();
      if (watched) {
        watch.clear();
      }
      now = 0.0;
      notAble = 0.0;
    }
    void add(const State& other, double weight, bool watched) {
      learning.add(other.learning, weight);
      if (watched) {
        watch.add(other.watch, weight);
      }
      notAble += weight * other.notAble;
    }
  };

  static State startOf(const LcCusumDesign& design, double failureRate, std::size_t attempts, bool watched) {
    const LcWeights weights = weightsOf(design);
    return {.learning = {weights.success, -weights.failure, design.limit, attempts,
                         Share{.afterUp = 1.0 - failureRate, .afterDown = failureRate}},
            .watch = {-weights.failure, weights.success, design.limit, watched ? attempts : 0, Share{}}};
  }

  void advance(State& state, double failure) const {
    const DownRate fails{.afterUp = (1.0 - lag_) * failure, .afterDown = (1.0 - lag_) * failure + lag_};
    state.now = state.learning.attempt(fails);
    state.notAble -= state.now;
    if (watched_) {  // its steps down are the successes
      const double success = 1.0 - failure;
      const double alarmed = state.watch.attempt(
          {.afterUp = (1.0 - lag_) * success, .afterDown = (1.0 - lag_) * success + lag_});
      state.watch.enter({.afterDown = state.now});
      state.learning.enter({.afterDown = alarmed});
      state.notAble += alarmed;
    }
  }

  double lag_;
  std::int64_t perSession_;
  std::vector<SessionRate> rates_;
  bool watched_;
  State all_;                     // between sessions; within one, only its two probabilities
  std::vector<State> bySession_;  // one per rate; empty: all sessions have the same
  std::int64_t inSession_ = 0;
};

/// Probability of reaching the limit within the attempts; above `enough` a lower bound. After some hundred
/// sessions the rate of reaching the limit is constant, and the rest follows in closed form.
double reachedWithin(const LcCusumDesign& design, double failureRate, std::size_t attempts, double enough) {
  constexpr int kLong = 64;  // sessions over which the rate has stayed constant
  const std::size_t perSession =
      design.dependence.session > 0.0
          ? static_cast<std::size_t>(std::max<std::int64_t>(1, design.dependence.perSession))
          : 1;
  const double constantWithin = perSession == 1 ? 1e-14 : 1e-12;
  Course course(design, failureRate, attempts, false);
  double declared = 0.0;
  double left = 1.0;
  double now = 0.0;
  double rate = 0.0;
  int constant = 0;
  for (std::size_t attempt = 1; attempt <= attempts; ++attempt) {
    course.attempt();
    now += course.declaredNow();
    declared += course.declaredNow();
    if (declared > enough) {
      return declared;
    }
    if (attempt % perSession != 0) {
      continue;
    }
    const double before = std::exchange(rate, left > 0.0 ? now / left : 0.0);
    left -= std::exchange(now, 0.0);
    constant = rate > 0.0 && std::abs(rate - before) <= constantWithin * rate ? constant + 1 : 0;
    if (constant == kLong) {
      const double more = static_cast<double>(attempts - attempt) / static_cast<double>(perSession);
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
  Course course(design, failureRate, attempts, true);
  bool begun = false;  // somebody can have reached the limit
  int constant = 0;
  for (std::size_t attempt = 1; attempt <= attempts && constant < kLong; ++attempt) {
    const double before = course.notAble();
    course.attempt();
    begun = begun || course.declaredNow() > 0.0;
    constant = begun && std::abs(course.notAble() - before) <= kConstant ? constant + 1 : 0;
  }
  return course.notAble();
}

std::optional<double> chooseLcCusumLimit(LcCusumDesign design, std::size_t attempts, double falsePass) {
  TORSIO_EXPECTS(falsePass > 0.0 && falsePass < 1.0);
  const double largest = weightsOf(design).success * static_cast<double>(attempts);
  // The probability falls as the limit rises: bisect over hundredths.
  int low = 0;
  int high = 1;
  const int most = static_cast<int>(std::floor(100.0 * largest));
  const auto passes = [&](int hundredths) {
    design.limit = hundredths / 100.0;
    return reachedWithin(design, design.inadequate, attempts, falsePass);
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
