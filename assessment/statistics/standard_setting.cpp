// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/standard_setting.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"

namespace torsio {

namespace {

/// Logistic regression of mastery on score by Newton's method; empty if the groups do not overlap.
void addLogistic(std::span<const double> novices, std::span<const double> masters, ContrastingGroups& out) {
  const double centre = out.midpoint;  // keeps the information matrix well conditioned
  double b0 = 0.0;
  double b1 = 0.0;
  for (int iteration = 0; iteration < 100; ++iteration) {
    double g0 = 0.0, g1 = 0.0, h00 = 0.0, h01 = 0.0, h11 = 0.0;
    const auto add = [&](double score, double y) {
      const double x = score - centre;
      const double p = 1.0 / (1.0 + std::exp(-(b0 + b1 * x)));
      g0 += y - p;
      g1 += (y - p) * x;
      h00 += p * (1.0 - p);
      h01 += p * (1.0 - p) * x;
      h11 += p * (1.0 - p) * x * x;
    };
    for (const double score : novices) {
      add(score, 0.0);
    }
    for (const double score : masters) {
      add(score, 1.0);
    }
    const double determinant = h00 * h11 - h01 * h01;
    if (!(determinant > 1e-12 * h00 * h11) || !(h00 > 1e-9)) {
      return;
    }
    const double step0 = (h11 * g0 - h01 * g1) / determinant;
    const double step1 = (h00 * g1 - h01 * g0) / determinant;
    b0 += step0;
    b1 += step1;
    if (std::abs(step0) > 1e-13 * (1.0 + std::abs(b0)) || std::abs(step1) > 1e-13 * (1.0 + std::abs(b1))) {
      continue;
    }
    if (!(b1 > 0.0)) {
      return;
    }
    out.cutLogistic = centre - b0 / b1;
    out.logistic = {b0 - b1 * centre, b1};
    const double v00 = h11 / determinant;
    const double v01 = -h01 / determinant;
    const double v11 = h00 / determinant;
    out.logisticErrors = {std::sqrt(v00 - 2.0 * centre * v01 + centre * centre * v11), std::sqrt(v11)};
    return;
  }
}

}  // namespace

Outcome<ContrastingGroups> contrastingGroups(std::span<const double> novices,
                                             std::span<const double> masters) {
  using Undefined = Outcome<ContrastingGroups>;
  if (const std::optional<Text> reason = beyondArithmetic(novices, masters)) {
    return Outcome<ContrastingGroups>::undefined(*reason);
  }
  if (novices.size() < 2 || masters.size() < 2) {
    return Undefined::undefined(Text::tr("a group has fewer than two trainees"));
  }
  ContrastingGroups out;
  out.meanNovices = meanOf(novices);
  out.meanMasters = meanOf(masters);
  out.deviationNovices = *sampleDeviation(novices);
  out.deviationMasters = *sampleDeviation(masters);
  if (out.deviationNovices == 0.0 || out.deviationMasters == 0.0) {
    return Undefined::undefined(Text::tr("a group does not vary"));
  }
  if (out.meanNovices >= out.meanMasters) {
    return Undefined::undefined(Text::tr("masters do not score higher than novices"));
  }
  out.midpoint = 0.5 * (out.meanNovices + out.meanMasters);
  // Equal log densities: a x^2 + b x + c = 0.
  const double va = out.deviationNovices * out.deviationNovices;
  const double vb = out.deviationMasters * out.deviationMasters;
  const double a = 1.0 / va - 1.0 / vb;
  const double b = -2.0 * (out.meanNovices / va - out.meanMasters / vb);
  const double c = out.meanNovices * out.meanNovices / va - out.meanMasters * out.meanMasters / vb +
                   2.0 * std::log(out.deviationNovices / out.deviationMasters);
  const auto between = [&](double x) { return x >= out.meanNovices && x <= out.meanMasters; };
  if (a == 0.0) {
    out.cutNormal = -c / b;
  } else {
    const double root = std::sqrt(std::max(0.0, b * b - 4.0 * a * c));
    const double q = -0.5 * (b + std::copysign(root, b));
    const double first = q / a;
    const double second = c / q;
    out.cutNormal = between(first) ? first : second;
    out.otherRoot = between(first) ? second : first;
  }
  if (!between(out.cutNormal)) {
    return Undefined::undefined(Text::tr("the fitted normals do not cross between the means"));
  }
  out.falsePass = normalUpper((out.cutNormal - out.meanNovices) / out.deviationNovices);
  out.falseFail = normalCdf((out.cutNormal - out.meanMasters) / out.deviationMasters);
  addLogistic(novices, masters, out);
  return out;
}

Outcome<Angoff> angoff(const NumberTable& percent) {
  if (const std::optional<Text> reason = beyondArithmetic(percent.values())) {
    return Outcome<Angoff>::undefined(*reason);
  }
  if (percent.rows() == 0) {
    return Outcome<Angoff>::undefined(Text::tr("there are no judges"));
  }
  Angoff out;
  for (std::size_t judge = 0; judge < percent.rows(); ++judge) {
    double sum = 0.0;
    for (const double value : percent.row(judge)) {
      TORSIO_EXPECTS(value >= 0.0 && value <= 100.0);
      sum += value;
    }
    out.judgeTotals.push_back(sum / 100.0);
  }
  out.cut = meanOf(out.judgeTotals);
  out.percent = 100.0 * out.cut / static_cast<double>(percent.columns());
  out.deviation = sampleDeviation(out.judgeTotals);
  if (out.deviation) {
    out.error = *out.deviation / std::sqrt(static_cast<double>(percent.rows()));
  }
  return out;
}

Outcome<BorderlineRegression> borderlineRegression(std::span<const double> globalRating,
                                                   std::span<const double> score, double borderline) {
  using Undefined = Outcome<BorderlineRegression>;
  TORSIO_EXPECTS(globalRating.size() == score.size());
  if (const std::optional<Text> reason = beyondArithmetic(globalRating, score)) {
    return Outcome<BorderlineRegression>::undefined(*reason);
  }
  if (score.size() < 3) {
    return Undefined::undefined(Text::tr("there are fewer than three trainees"));
  }
  const double xx = sumOfSquares(globalRating);
  const double yy = sumOfSquares(score);
  if (xx == 0.0) {
    return Undefined::undefined(Text::tr("every global mark is the same"));
  }
  if (yy == 0.0) {
    return Undefined::undefined(Text::tr("every score is the same"));
  }
  const double meanX = meanOf(globalRating);
  const double meanY = meanOf(score);
  double xy = 0.0;
  for (std::size_t i = 0; i < score.size(); ++i) {
    xy += (globalRating[i] - meanX) * (score[i] - meanY);
  }
  BorderlineRegression out;
  out.slope = xy / xx;
  out.intercept = meanY - out.slope * meanX;
  out.cut = out.intercept + out.slope * borderline;
  const double n = static_cast<double>(score.size());
  const double residual = std::max(0.0, yy - out.slope * xy) / (n - 2.0);
  out.error = std::sqrt(residual * (1.0 / n + (borderline - meanX) * (borderline - meanX) / xx));
  out.rSquared = xy * xy / (xx * yy);
  return out;
}

Outcome<ProficiencyThreshold> proficiencyThreshold(std::span<const double> experts,
                                                   const ProficiencyOptions& options) {
  using Undefined = Outcome<ProficiencyThreshold>;
  if (const std::optional<Text> reason = beyondArithmetic(experts)) {
    return Outcome<ProficiencyThreshold>::undefined(*reason);
  }
  constexpr double kOutlier = 1.96;
  std::vector<double> x(experts.begin(), experts.end());
  for (double& value : x) {
    if (!options.logScale) {
      continue;
    }
    if (!(value > 0.0)) {
      return Undefined::undefined(Text::tr("a value is not positive"));
    }
    value = std::log(value);
  }
  ProficiencyThreshold out;
  if (options.dropOutliers && x.size() >= 3) {
    const double mean = meanOf(x);
    const double reach = kOutlier * *sampleDeviation(x);
    out.dropped = std::erase_if(x, [&](double value) { return std::abs(value - mean) > reach; });
  }
  out.experts = x.size();
  if (x.size() < 2) {
    return Undefined::undefined(Text::tr("there are fewer than two experts"));
  }
  const double mean = meanOf(x);
  out.deviation = *sampleDeviation(x);
  if (out.deviation == 0.0) {
    return Undefined::undefined(Text::tr("the experts do not differ"));
  }
  const double n = static_cast<double>(x.size());
  out.toleranceFactor =
      noncentralTQuantile(options.confidence, n - 1.0, normalQuantile(options.coverage) * std::sqrt(n)) /
      std::sqrt(n);
  const double side = options.better == Better::kLower ? 1.0 : -1.0;
  const auto onScale = [&](double value) { return options.logScale ? std::exp(value) : value; };
  out.mean = onScale(mean);
  out.oneDeviation = onScale(mean + side * out.deviation);
  out.twoDeviations = onScale(mean + side * 2.0 * out.deviation);
  out.toleranceBound = onScale(mean + side * out.toleranceFactor * out.deviation);
  return out;
}

std::optional<std::size_t> proficientAt(std::span<const double> attempts, double threshold, Better better,
                                        std::size_t consecutive, std::size_t further) {
  std::size_t run = 0;
  std::size_t later = 0;
  bool established = consecutive == 0;
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    const bool passed = better == Better::kLower ? attempts[i] <= threshold : attempts[i] >= threshold;
    if (established) {
      later += passed ? 1 : 0;
    } else {
      run = passed ? run + 1 : 0;
      established = run >= consecutive;
    }
    if (established && later >= further) {
      return i + 1;
    }
  }
  return std::nullopt;
}

double proficientProbability(double pass, std::size_t attempts, std::size_t consecutive,
                             std::size_t further) {
  TORSIO_EXPECTS(pass >= 0.0 && pass <= 1.0);
  // States: the length of the run, then the number of further passes; the last one is absorbing.
  const std::size_t end = consecutive + further;
  std::vector<double> states(end + 1, 0.0);
  states[0] = 1.0;
  const std::size_t most = consecutive == 0 && further == 0 ? std::min<std::size_t>(attempts, 1) : attempts;
  for (std::size_t attempt = 0; attempt < most; ++attempt) {
    std::vector<double> next(end + 1, 0.0);
    next[end] = states[end];
    for (std::size_t at = 0; at < end; ++at) {
      next[at + 1] += states[at] * pass;
      next[at < consecutive ? 0 : at] += states[at] * (1.0 - pass);
    }
    states = std::move(next);
  }
  return attempts == 0 ? 0.0 : std::min(1.0, states[end]);  // rounding may exceed 1
}

}  // namespace torsio
