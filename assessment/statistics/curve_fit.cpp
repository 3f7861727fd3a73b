// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/curve_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

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

/// Step of the damped problem, from the orthogonal factors of [J; sqrt(lambda) D].
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
    return Outcome<CurveFit>::undefined(Text::tr("the start lies outside the domain of the curve"));
  }
  double lambda = 1e-3;
  for (int iteration = 1; iteration <= kMaxIterations; ++iteration) {
    const Eigen::VectorXd step = dampedStep(*state, lambda);
    if (!step.allFinite()) {
      return Outcome<CurveFit>::undefined(Text::tr("the parameters cannot be told apart"));
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
      CurveFit out;
      out.iterations = iteration;
      finish(*state, b, out);
      if (!std::all_of(out.errors.begin(), out.errors.end(), [](double e) { return std::isfinite(e); })) {
        return Outcome<CurveFit>::undefined(Text::tr("the parameters cannot be told apart"));
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

/// The best of several starts: for a given rate the other parameters are a straight line.
Outcome<CurveFit> bestFit(LearningFamily family, std::span<const double> t, std::span<const double> y,
                          bool asymptote) {
  std::optional<CurveFit> best;
  Text reason = Text::tr("no start converges");
  for (const double rate : {0.05, 0.2, 0.5, 1.0, 2.0}) {
    std::vector<double> form;
    for (const double at : t) {
      form.push_back(shape(family, rate, at));
    }
    const double meanForm = meanOf(form);
    const double meanY = meanOf(y);
    double product = 0.0;
    for (std::size_t i = 0; i < form.size(); ++i) {
      product += (form[i] - meanForm) * (y[i] - meanY);
    }
    const double slope = product / std::max(1e-300, sumOfSquares(form));
    const std::vector<double> start = asymptote ? std::vector<double>{meanY - slope * meanForm, slope, rate}
                                                : std::vector<double>{meanY / meanForm, rate};
    const Outcome<CurveFit> fit = fitCurve(familyCurve(family, asymptote), t, y, start);
    if (!fit) {
      reason = fit.reason();
    }
    if (fit && (!best || fit->rss < best->rss)) {
      best = *fit;
    }
  }
  if (!best) {
    return Outcome<CurveFit>::undefined(reason);
  }
  return *best;
}

}  // namespace

Outcome<LearningCurve> fitLearningCurve(LearningFamily family, std::span<const double> attempt,
                                        std::span<const double> value, bool asymptoteNotNegative) {
  TORSIO_EXPECTS(attempt.size() == value.size());
  if (const std::optional<Text> reason = beyondArithmetic(value)) {
    return Outcome<LearningCurve>::undefined(*reason);
  }
  if (attempt.size() < kFewestAttempts) {
    return Outcome<LearningCurve>::undefined(
        Text::tr("fewer than eight attempts cannot tell three parameters apart"));
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

Interval learningBandAt(const LearningCurve& curve, double t, double confidence) {
  const std::size_t p = curve.fit.parameters.size();
  std::vector<double> gradient(p);
  const double value = familyCurve(curve.family, !curve.asymptoteAtZero)(curve.fit.parameters, t, gradient);
  double variance = 0.0;
  for (std::size_t i = 0; i < p; ++i) {
    for (std::size_t j = 0; j < p; ++j) {
      variance += gradient[i] * gradient[j] * curve.fit.covariance[i * p + j];
    }
  }
  const double df = static_cast<double>(curve.fit.n - p);
  const double reach = tQuantile(0.5 * (1.0 + confidence), df) * std::sqrt(std::max(0.0, variance));
  return {value - reach, value + reach};
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
  double xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - meanOf(x)) * (y[i] - meanOf(y));
  }
  LogLogLine out;
  out.slope = xy / xx;
  out.intercept = meanOf(y) - out.slope * meanOf(x);
  out.ratePerDoubling = std::exp2(out.slope);
  out.rSquared = xy * xy / (xx * yy);
  return out;
}

}  // namespace torsio
