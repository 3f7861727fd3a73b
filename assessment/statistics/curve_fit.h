// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "assessment/statistics/values.h"

namespace torsio {

/// Returns the value of a curve at x and fills its derivatives by the parameters.
using Curve =
    std::function<double(std::span<const double> parameters, double x, std::span<double> derivatives)>;

struct CurveFit {
  std::vector<double> parameters;
  std::vector<double> errors;      ///< standard errors
  std::vector<double> covariance;  ///< parameters x parameters, row-major
  double rss = 0.0;
  double sigma = 0.0;  ///< residual standard deviation, divisor n - p
  double aicc = 0.0;   ///< n ln(rss / n) + 2 K + 2 K (K + 1) / (n - K - 1), K = p + 1
  std::size_t n = 0;
  int iterations = 0;
};

/// Fits a curve by least squares (Levenberg-Marquardt) from one starting point, with analytic derivatives.
/// Undefined unless there are at least two more points than parameters, or if the iteration does not
/// converge.
[[nodiscard]] Outcome<CurveFit> fitCurve(const Curve& curve, std::span<const double> x,
                                         std::span<const double> y, std::span<const double> start);

enum class LearningFamily {
  kExponential,  ///< y = c + a exp(-r (t - 1))
  kPower,        ///< y = c + a t^-b
};

struct LearningCurve {
  LearningFamily family = LearningFamily::kExponential;
  double asymptote = 0.0;        ///< c
  double gain = 0.0;             ///< a: from the first attempt to the asymptote (exponential: exactly)
  double rate = 0.0;             ///< r or b
  bool asymptoteAtZero = false;  ///< the fit is at the bound c >= 0: the family is doubtful for these data
  CurveFit fit;                  ///< parameters c, a, rate; a, rate when the asymptote is held at 0
};

/// Minimum number of attempts to identify three parameters.
inline constexpr std::size_t kMinAttempts = 8;

/// Fits one trainee's learning curve; `attempt` counts from 1. Trainees are fitted separately because a mean
/// of exponentials looks like a power law. Undefined for fewer than eight attempts or if no start converges.
[[nodiscard]] Outcome<LearningCurve> fitLearningCurve(LearningFamily family, std::span<const double> attempt,
                                                      std::span<const double> value,
                                                      bool asymptoteNotNegative = true);

/// Evaluates the curve at t.
[[nodiscard]] double learningCurveAt(const LearningCurve& curve, double t);
/// Returns the confidence band of the mean at t, by the delta method.
[[nodiscard]] Interval learningBandAt(const LearningCurve& curve, double t,
                                      double confidence = kDefaultConfidence);
/// Returns the confidence band of the mean at each t, by the delta method.
[[nodiscard]] std::vector<Interval> learningBand(const LearningCurve& curve, std::span<const double> t,
                                                 double confidence = kDefaultConfidence);

struct LogLogLine {
  double intercept = 0.0;
  double slope = 0.0;
  double ratePerDoubling = 0.0;  ///< 2^slope
  double rSquared = 0.0;
};
/// Fits a straight line to the logarithms, which forces the asymptote to 0. Undefined unless all values are
/// positive.
[[nodiscard]] Outcome<LogLogLine> logLogLine(std::span<const double> attempt, std::span<const double> value);

}  // namespace torsio
