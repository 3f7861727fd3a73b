// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/curve_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include <Eigen/Dense>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"

namespace torsio {

namespace {

using Eigen::Index;

constexpr int kMaxIterations = 500;
constexpr double kSettled = 1e-13;  // relative size of the last Gauss-Newton step

struct State {
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
  double rss = 0.0;
};

std::optional<State> evaluate(const Curve& curve, std::span<const double> x, std::span<const double> y,
                              const Eigen::VectorXd& b) {
  const auto n = static_cast<Index>(x.size());
  State out{Eigen::VectorXd(n), Eigen::MatrixXd(n, b.size()), 0.0};
  std::vector<double> derivatives(static_cast<std::size_t>(b.size()));
  for (Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double value = curve({b.data(), derivatives.size()}, x[at], derivatives);
    out.residuals[i] = y[at] - value;
    for (Index j = 0; j < b.size(); ++j) {
      out.jacobian(i, j) = derivatives[static_cast<std::size_t>(j)];
    }
  }
  out.rss = out.residuals.squaredNorm();
  if (!std::isfinite(out.rss) || !out.jacobian.allFinite()) {
    return std::nullopt;
  }
  return out;
}

/// Step of the damped problem from the QR factorisation of [J; sqrt(lambda) D].
Eigen::VectorXd dampedStep(const State& state, double lambda) {
  const Index n = state.jacobian.rows();
  const Index p = state.jacobian.cols();
  Eigen::MatrixXd stacked = Eigen::MatrixXd::Zero(n + p, p);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + p);
  stacked.topRows(n) = state.jacobian;
  right.head(n) = state.residuals;
  for (Index j = 0; j < p; ++j) {
    stacked(n + j, j) = std::sqrt(lambda) * std::max(1e-300, state.jacobian.col(j).norm());
  }
  return stacked.colPivHouseholderQr().solve(right);
}

/// Takes Gauss-Newton steps as long as they shrink: near the minimum the squares no longer distinguish
/// parameters that the derivatives still do.
void polish(const Curve& curve, std::span<const double> x, std::span<const double> y, State& state,
            Eigen::VectorXd& b) {
  constexpr int kMaxSteps = 50;
  constexpr double kShrinks = 0.9;
  constexpr double kRounding = 1e-9;  // of the squares
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMaxSteps; ++i) {
    const Eigen::VectorXd step = dampedStep(state, 0.0);
    if (!step.allFinite() || !(step.norm() < kShrinks * before)) {
      return;
    }
    const std::optional<State> next = evaluate(curve, x, y, b + step);
    if (!next || next->rss > (1.0 + kRounding) * state.rss) {
      return;
    }
    before = step.norm();
    b += step;
    state = *next;
  }
}

void finish(const State& state, const Eigen::VectorXd& b, CurveFit& out) {
  const double n = static_cast<double>(state.residuals.size());
  const double p = static_cast<double>(b.size());
  out.rss = state.rss;
  out.n = static_cast<std::size_t>(state.residuals.size());
  out.sigma = std::sqrt(state.rss / (n - p));
  const double k = p + 1.0;
  out.aicc = n * std::log(state.rss / n) + 2.0 * k + 2.0 * k * (k + 1.0) / (n - k - 1.0);
  const Eigen::MatrixXd r =
      state.jacobian.householderQr().matrixQR().topRows(b.size()).triangularView<Eigen::Upper>();
  const Eigen::MatrixXd inverse =
      r.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(b.size(), b.size()));
  const Eigen::MatrixXd covariance = inverse * inverse.transpose() * (out.sigma * out.sigma);
  for (Index i = 0; i < b.size(); ++i) {
    out.parameters.push_back(b[i]);
    out.errors.push_back(std::sqrt(covariance(i, i)));
    for (Index j = 0; j < b.size(); ++j) {
      out.covariance.push_back(covariance(i, j));
    }
  }
}

}  // namespace

Outcome<CurveFit> fitCurve(const Curve& curve, std::span<const double> x, std::span<const double> y,
                           std::span<const double> start) {
  TORSIO_EXPECTS(x.size() == y.size());
  if (x.size() < start.size() + 2) {
    return Outcome<CurveFit>::undefined(Text::tr("there are too few points for the parameters"));
  }
  Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(start.data(), static_cast<Index>(start.size()));
  std::optional<State> state = evaluate(curve, x, y, b);
  if (!state) {
    return Outcome<CurveFit>::undefined(Text::tr("the start is outside the domain of the curve"));
  }
  double lambda = 1e-3;
  for (int iteration = 1; iteration <= kMaxIterations; ++iteration) {
    const Eigen::VectorXd step = dampedStep(*state, lambda);
    if (!step.allFinite()) {
      return Outcome<CurveFit>::undefined(Text::tr("the parameters cannot be separated"));
    }
    const Eigen::VectorXd next = b + step;
    const std::optional<State> trial = evaluate(curve, x, y, next);
    const bool better = trial && trial->rss <= state->rss;
    const bool tiny = step.norm() <= kSettled * (b.norm() + kSettled);
    if (better) {
      b = next;
      state = trial;
      lambda = std::max(1e-16, lambda * 0.1);
    } else {
      lambda *= 10.0;
    }
    if (tiny || lambda > 1e14) {
      if (!(state->rss > 0.0)) {
        return Outcome<CurveFit>::undefined(Text::tr("the curve passes through every point"));
      }
      polish(curve, x, y, *state, b);
      CurveFit out;
      out.iterations = iteration;
      finish(*state, b, out);
      if (!std::all_of(out.errors.begin(), out.errors.end(), [](double e) { return std::isfinite(e); })) {
        return Outcome<CurveFit>::undefined(Text::tr("the parameters cannot be separated"));
      }
      return out;
    }
  }
  return Outcome<CurveFit>::undefined(Text::tr("the fit does not settle"));
}

namespace {

double shape(LearningFamily family, double rate, double t) {
  return family == LearningFamily::kExponential ? std::exp(-rate * (t - 1.0)) : std::pow(t, -rate);
}

double shapeByRate(LearningFamily family, double rate, double t) {
  return family == LearningFamily::kExponential ? -(t - 1.0) * shape(family, rate, t)
                                                : -std::log(t) * shape(family, rate, t);
}

Curve familyCurve(LearningFamily family, bool withAsymptote) {
  return [=](std::span<const double> b, double t, std::span<double> d) {
    const std::size_t first = withAsymptote ? 1 : 0;
    const double form = shape(family, b[first + 1], t);
    if (withAsymptote) {
      d[0] = 1.0;
    }
    d[first] = form;
    d[first + 1] = b[first] * shapeByRate(family, b[first + 1], t);
    return (withAsymptote ? b[0] : 0.0) + b[first] * form;
  };
}

/// For a given rate the other parameters follow from a linear fit: starting point and its squares.
struct Start {
  std::vector<double> parameters;
  double rss = 0.0;
};

Start startAt(LearningFamily family, std::span<const double> t, std::span<const double> y, bool asymptote,
              double rate) {
  double forms = 0.0;
  double values = 0.0;
  double squares = 0.0;
  double products = 0.0;
  std::vector<double> form;
  form.reserve(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) {
    form.push_back(shape(family, rate, t[i]));
    forms += form[i];
    values += y[i];
  }
  const double n = static_cast<double>(t.size());
  const double meanForm = asymptote ? forms / n : 0.0;
  const double meanY = asymptote ? values / n : 0.0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    squares += (form[i] - meanForm) * (form[i] - meanForm);
    products += (form[i] - meanForm) * (y[i] - meanY);
  }
  const double slope = products / std::max(1e-300, squares);
  Start out;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double rest = y[i] - meanY - slope * (form[i] - meanForm);
    out.rss += rest * rest;
  }
  out.parameters = asymptote ? std::vector<double>{meanY - slope * meanForm, slope, rate}
                             : std::vector<double>{slope, rate};
  return out;
}

/// Half the derivative of the residual squares by the rate, the other parameters following it.
double slopeByRate(LearningFamily family, std::span<const double> t, std::span<const double> y,
                   bool asymptote, double rate) {
  const std::vector<double> b = startAt(family, t, y, asymptote, rate).parameters;
  const double gain = b[asymptote ? 1 : 0];
  double slope = 0.0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double rest = y[i] - (asymptote ? b[0] : 0.0) - gain * shape(family, rate, t[i]);
    slope -= rest * gain * shapeByRate(family, rate, t[i]);
  }
  return slope;
}

/// Returns the rate near `rate` at which the residual squares are least, to the last digits: near the minimum
/// the squares no longer distinguish rates that their derivative still does.
double settledRate(LearningFamily family, std::span<const double> t, std::span<const double> y,
                   bool asymptote, double rate) {
  constexpr int kHalvings = 200;
  const auto slope = [&](double at) { return slopeByRate(family, t, y, asymptote, at); };
  for (double reach = 1e-9; reach < 0.1; reach *= 10.0) {
    double low = rate * (1.0 - reach);
    double high = rate * (1.0 + reach);
    if (!(slope(low) < 0.0 && slope(high) > 0.0)) {
      continue;
    }
    for (int i = 0; i < kHalvings && low < high; ++i) {
      const double middle = std::midpoint(low, high);
      if (middle == low || middle == high) {
        break;
      }
      (slope(middle) < 0.0 ? low : high) = middle;
    }
    return std::midpoint(low, high);
  }
  return rate;
}

/// Residual squares at infinite rate: the first point is fitted by itself.
double restAtFastest(std::span<const double> t, std::span<const double> y, bool asymptote) {
  const auto first = std::min_element(t.begin(), t.end()) - t.begin();
  std::vector<double> others;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (static_cast<std::ptrdiff_t>(i) != first) {
      others.push_back(y[i]);
    }
  }
  return asymptote ? sumOfSquares(others)
                   : std::inner_product(others.begin(), others.end(), others.begin(), 0.0);
}

/// Residual squares of a curve with asymptote as its rate goes to zero: a straight line in t or, for the
/// power law, in log t.
double restAtSlowest(LearningFamily family, std::span<const double> t, std::span<const double> y) {
  std::vector<double> x;
  for (const double at : t) {
    x.push_back(family == LearningFamily::kExponential ? at : std::log(at));
  }
  const double meanX = meanOf(x);
  const double meanY = meanOf(y);
  double product = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    product += (x[i] - meanX) * (y[i] - meanY);
  }
  const double slope = product / std::max(1e-300, sumOfSquares(x));
  double rest = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double d = y[i] - meanY - slope * (x[i] - meanX);
    rest += d * d;
  }
  return rest;
}

/// Starts from the best rate on a grid, which lies in the lowest valley. If the squares keep falling beyond
/// the slow end of the grid, a straight line fits better than any curve.
Outcome<CurveFit> bestFit(LearningFamily family, std::span<const double> t, std::span<const double> y,
                          bool asymptote) {
  constexpr double kFastest = 8.0;
  constexpr double kStep = 1.4;
  constexpr double kLeastDecay = 0.05;  // over all attempts
  const auto [first, last] = std::minmax_element(t.begin(), t.end());
  const double range =
      family == LearningFamily::kExponential ? *last - *first : std::log(*last) - std::log(*first);
  const double slowest = std::min(0.01, kLeastDecay / std::max(range, kLeastDecay));
  std::optional<Start> best;
  double fastest = slowest;
  for (double rate = slowest; rate < kFastest * kStep; rate *= kStep) {
    Start start = startAt(family, t, y, asymptote, rate);
    fastest = rate;
    if (!best || start.rss < best->rss) {
      best = std::move(start);
    }
  }
  if (best->parameters.back() == fastest && restAtFastest(t, y, asymptote) <= best->rss) {
    return Outcome<CurveFit>::undefined(
        Text::tr("the first attempt differs too much from the others to estimate a learning rate"));
  }
  if (asymptote && best->parameters.back() == slowest && restAtSlowest(family, t, y) <= best->rss) {
    return Outcome<CurveFit>::undefined(Text::tr("the values do not level off within these attempts"));
  }
  const Curve curve = familyCurve(family, asymptote);
  Outcome<CurveFit> fit = fitCurve(curve, t, y, best->parameters);
  if (!fit) {
    return fit;
  }
  const double rate = settledRate(family, t, y, asymptote, fit->parameters.back());
  const std::vector<double> settled = startAt(family, t, y, asymptote, rate).parameters;
  const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(settled.data(), std::ssize(settled));
  if (const std::optional<State> state = evaluate(curve, t, y, b)) {
    CurveFit out;
    out.iterations = fit->iterations;
    finish(*state, b, out);
    return out;
  }
  return fit;
}

}  // namespace

Outcome<LearningCurve> fitLearningCurve(LearningFamily family, std::span<const double> attempt,
                                        std::span<const double> value, bool asymptoteNotNegative) {
  TORSIO_EXPECTS(attempt.size() == value.size());
  if (const std::optional<Text> reason = beyondArithmetic(value)) {
    return Outcome<LearningCurve>::undefined(*reason);
  }
  if (attempt.size() < kMinAttempts) {
    return Outcome<LearningCurve>::undefined(
        Text::tr("fewer than eight attempts cannot separate three parameters"));
  }
  for (const double t : attempt) {
    TORSIO_EXPECTS(t >= 1.0);
  }
  const Outcome<CurveFit> free = bestFit(family, attempt, value, true);
  if (!free) {
    return Outcome<LearningCurve>::undefined(free.reason());
  }
  LearningCurve out;
  out.family = family;
  out.asymptoteAtZero = asymptoteNotNegative && free->parameters[0] < 0.0;
  if (!out.asymptoteAtZero) {
    out.fit = *free;
    out.asymptote = free->parameters[0];
    out.gain = free->parameters[1];
    out.rate = free->parameters[2];
    return out;
  }
  const Outcome<CurveFit> held = bestFit(family, attempt, value, false);
  if (!held) {
    return Outcome<LearningCurve>::undefined(held.reason());
  }
  out.fit = *held;
  out.gain = held->parameters[0];
  out.rate = held->parameters[1];
  return out;
}

double learningCurveAt(const LearningCurve& curve, double t) {
  return curve.asymptote + curve.gain * shape(curve.family, curve.rate, t);
}

std::vector<Interval> learningBand(const LearningCurve& curve, std::span<const double> t, double confidence) {
  const std::size_t p = curve.fit.parameters.size();
  const Curve family = familyCurve(curve.family, !curve.asymptoteAtZero);
  const double quantile = tQuantile(0.5 * (1.0 + confidence), static_cast<double>(curve.fit.n - p));
  std::vector<double> gradient(p);
  std::vector<Interval> out;
  for (const double at : t) {
    const double value = family(curve.fit.parameters, at, gradient);
    double variance = 0.0;
    for (std::size_t i = 0; i < p; ++i) {
      for (std::size_t j = 0; j < p; ++j) {
        variance += gradient[i] * gradient[j] * curve.fit.covariance[i * p + j];
      }
    }
    const double reach = quantile * std::sqrt(std::max(0.0, variance));
    out.push_back({value - reach, value + reach});
  }
  return out;
}

Interval learningBandAt(const LearningCurve& curve, double t, double confidence) {
  return learningBand(curve, std::span(&t, 1), confidence).front();
}

Outcome<LogLogLine> logLogLine(std::span<const double> attempt, std::span<const double> value) {
  TORSIO_EXPECTS(attempt.size() == value.size());
  if (const std::optional<Text> reason = beyondArithmetic(value)) {
    return Outcome<LogLogLine>::undefined(*reason);
  }
  if (attempt.size() < 3) {
    return Outcome<LogLogLine>::undefined(Text::tr("there are fewer than three attempts"));
  }
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < attempt.size(); ++i) {
    if (!(attempt[i] > 0.0 && value[i] > 0.0)) {
      return Outcome<LogLogLine>::undefined(Text::tr("a value is not positive"));
    }
    x.push_back(std::log(attempt[i]));
    y.push_back(std::log(value[i]));
  }
  const double xx = sumOfSquares(x);
  const double yy = sumOfSquares(y);
  if (xx == 0.0 || yy == 0.0) {
    return Outcome<LogLogLine>::undefined(Text::tr("the values do not vary"));
  }
  const double meanX = meanOf(x);
  const double meanY = meanOf(y);
  double xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - meanX) * (y[i] - meanY);
  }
  LogLogLine out;
  out.slope = xy / xx;
  out.intercept = meanY - out.slope * meanX;
  out.ratePerDoubling = std::exp2(out.slope);
  out.rSquared = xy * xy / (xx * yy);
  return out;
}

}  // namespace torsio
