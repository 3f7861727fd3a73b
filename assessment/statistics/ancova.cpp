// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/ancova.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"

namespace torsio {

namespace {

/// Sums of squares and products about the means.
struct Moments {
  double n = 0.0;
  double meanX = 0.0;
  double meanY = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
};

Moments momentsOf(const std::vector<double>& x, const std::vector<double>& y) {
  TORSIO_EXPECTS(x.size() == y.size());
  Moments m;
  m.n = static_cast<double>(x.size());
  m.meanX = meanOf(x);
  m.meanY = meanOf(y);
  m.xx = sumOfSquares(x);
  m.yy = sumOfSquares(y);
  for (std::size_t i = 0; i < x.size(); ++i) {
    m.xy += (x[i] - m.meanX) * (y[i] - m.meanY);
  }
  return m;
}

Interval around(double middle, double reach) {
  return {middle - reach, middle + reach};
}

double quantileOf(double confidence, double df) {
  return tQuantile(0.5 * (1.0 + confidence), df);
}

/// Returns why the scores cannot be compared at all, if so.
std::optional<Text> notComparable(const Groups& before, const Groups& after) {
  TORSIO_EXPECTS(before.size() == after.size());
  for (const Groups* scores : {&before, &after}) {
    if (std::optional<Text> reason = beyondArithmetic(*scores)) {
      return reason;
    }
  }
  if (presentGroups(before).numbers.size() < 2) {
    return Text::tr("fewer than two groups have scores at both occasions");
  }
  return std::nullopt;
}

Outcome<FTest> slopesTest(const std::vector<Moments>& groups, double residual, double n) {
  const double k = static_cast<double>(groups.size());
  double separate = 0.0;
  double squares = 0.0;
  for (const Moments& m : groups) {
    squares += m.yy;
    if (m.xx == 0.0) {
      return Outcome<FTest>::undefined(Text::tr("the scores before do not vary in one group"));
    }
    separate += m.yy - m.xy * m.xy / m.xx;
  }
  FTest test;
  test.df1 = k - 1.0;
  test.df2 = n - 2.0 * k;
  if (test.df2 <= 0.0) {
    return Outcome<FTest>::undefined(Text::tr("too few trainees for separate slopes"));
  }
  if (!(separate > kLeftByRounding * squares)) {
    return Outcome<FTest>::undefined(Text::tr("the scores after follow the scores before exactly"));
  }
  test.f = (residual - separate) / test.df1 / (separate / test.df2);
  test.p = fUpper(std::max(0.0, test.f), test.df1, test.df2);
  return test;
}

struct Precision {
  double error = 0.0;
  double df = 0.0;
};

/// Returns the differences of all pairs of groups; `precisionOf(i, j)`: of one.
template <typename PrecisionOf>
std::vector<AdjustedDifference> pairsOf(const Ancova& of, double confidence, const PrecisionOf& precisionOf) {
  const std::size_t groups = of.groups.size();
  std::vector<AdjustedDifference> out;
  for (std::size_t i = 0; i < groups; ++i) {
    for (std::size_t j = i + 1; j < groups; ++j) {
      const auto [error, df] = precisionOf(i, j);
      out.push_back(adjustedDifference(of.groups[i], of.groups[j], of.adjusted[i].mean - of.adjusted[j].mean,
                                       error, df));
    }
  }
  addIntervals(out, confidence);
  return out;
}

void addPairs(const std::vector<Moments>& groups, const Moments& within, double confidence, Ancova& out) {
  out.pairs = pairsOf(out, confidence, [&](std::size_t i, std::size_t j) {
    const double shift = groups[i].meanX - groups[j].meanX;
    const double share = 1.0 / groups[i].n + 1.0 / groups[j].n + shift * shift / within.xx;
    return Precision{std::sqrt(out.residualVariance * share), out.residualDf};
  });
}

/// A difference is a weighted sum of the scores after; HC3 gives each score the variance e^2 / (1 - h)^2. The
/// sum of these, e' A e with residuals e = M y, has E = tr(A M) and the variance 2 tr(A M A M) if all scores
/// vary alike, and so as many degrees of freedom as a chi-squared variable with this ratio: E^2 / tr(A M A
/// M). M[i][j] is 1 for i = j, less 1/n within a group, less x[i] x[j] / xx: the traces are sums over
/// trainees.
std::vector<AdjustedDifference> robustPairs(const Groups& before, const std::vector<Moments>& groups,
                                            const Moments& within, double confidence, const Ancova& of) {
  constexpr double kFitsExactly = 1e-9;
  std::vector<std::vector<double>> variances(groups.size());
  std::vector<std::vector<double>> leftFree(groups.size());  // 1 - h
  for (std::size_t k = 0; k < groups.size(); ++k) {
    for (std::size_t i = 0; i < before[of.groups[k]].size(); ++i) {
      const double x = before[of.groups[k]][i] - groups[k].meanX;
      const double free = 1.0 - 1.0 / groups[k].n - x * x / within.xx;
      if (free < kFitsExactly) {
        return {};
      }
      const double e = of.residuals[of.groups[k]][i] / free;
      variances[k].push_back(e * e);
      leftFree[k].push_back(free);
    }
  }
  return pairsOf(of, confidence, [&](std::size_t first, std::size_t second) {
    const double shift = groups[first].meanX - groups[second].meanX;
    double variance = 0.0;
    double expected = 0.0;
    double squares = 0.0;
    double allXx = 0.0;
    for (std::size_t k = 0; k < groups.size(); ++k) {
      const double share = k == first ? 1.0 / groups[k].n : k == second ? -1.0 / groups[k].n : 0.0;
      double sum = 0.0;
      double sumX = 0.0;
      for (std::size_t i = 0; i < variances[k].size(); ++i) {
        const double x = before[of.groups[k]][i] - groups[k].meanX;
        const double weight = share - shift * x / within.xx;
        variance += weight * weight * variances[k][i];
        const double free = leftFree[k][i];
        const double a = weight * weight / (free * free);
        expected += a * free;
        squares += a * a * (2.0 * free - 1.0);  // M[i][i]^2 for what the sums of products take as h^2
        sum += a;
        sumX += a * x;
        allXx += a * x * x;
      }
      squares += sum * sum / (groups[k].n * groups[k].n) + 2.0 * sumX * sumX / (groups[k].n * within.xx);
    }
    squares += allXx * allXx / (within.xx * within.xx);
    return Precision{std::sqrt(variance), std::min(expected * expected / squares, of.residualDf)};
  });
}

void addSpread(const Groups& before, const std::vector<Moments>& groups, const Moments& within,
               double confidence, Ancova& out) {
  UnequalSpread& spread = out.spread;
  spread.test = brownForsythe(out.residuals);
  bool first = true;
  for (const std::size_t g : out.groups) {
    const double deviation = sampleDeviation(out.residuals[g]).value_or(0.0);
    spread.largest = first ? deviation : std::max(spread.largest, deviation);
    spread.smallest = first ? deviation : std::min(spread.smallest, deviation);
    first = false;
  }
  spread.pairs = robustPairs(before, groups, within, confidence, out);
}

void addResiduals(const Groups& before, const Groups& after, const std::vector<Moments>& groups,
                  Ancova& out) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> ordered;  // residual, group, trainee
  out.fitted.resize(before.size());
  out.residuals.resize(before.size());
  out.quantiles.resize(before.size());
  for (std::size_t k = 0; k < out.groups.size(); ++k) {
    const std::size_t g = out.groups[k];
    for (std::size_t i = 0; i < before[g].size(); ++i) {
      out.fitted[g].push_back(groups[k].meanY + out.slope * (before[g][i] - groups[k].meanX));
      out.residuals[g].push_back(after[g][i] - out.fitted[g][i]);
      ordered.push_back({out.residuals[g][i], g, i});
    }
    out.quantiles[g].resize(before[g].size());
  }
  std::sort(ordered.begin(), ordered.end());
  const double n = static_cast<double>(ordered.size());
  for (std::size_t rank = 0; rank < ordered.size(); ++rank) {
    const auto& [residual, g, i] = ordered[rank];
    out.quantiles[g][i] =
        normalQuantile((static_cast<double>(rank) + 0.5) / n) * std::sqrt(out.residualVariance);
  }
}

}  // namespace

Outcome<Ancova> ancova(const Groups& before, const Groups& after, double confidence) {
  if (const std::optional<Text> reason = notComparable(before, after)) {
    return Outcome<Ancova>::undefined(*reason);
  }
  std::vector<Moments> groups;
  Moments within;
  std::vector<double> allX;
  std::vector<double> allY;
  Ancova out;
  out.groups = presentGroups(before).numbers;
  for (const std::size_t g : out.groups) {
    groups.push_back(momentsOf(before[g], after[g]));
    within.xx += groups.back().xx;
    within.xy += groups.back().xy;
    within.yy += groups.back().yy;
    allX.insert(allX.end(), before[g].begin(), before[g].end());
    allY.insert(allY.end(), after[g].begin(), after[g].end());
  }
  const Moments total = momentsOf(allX, allY);
  const double k = static_cast<double>(groups.size());
  out.residualDf = total.n - k - 1.0;
  if (out.residualDf <= 0.0) {
    return Outcome<Ancova>::undefined(Text::tr("there are too few trainees"));
  }
  if (within.xx == 0.0) {
    return Outcome<Ancova>::undefined(Text::tr("the scores before do not vary within groups"));
  }
  if (within.yy == 0.0) {
    return Outcome<Ancova>::undefined(Text::tr("the scores after do not vary within groups"));
  }
  out.slope = within.xy / within.xx;
  const double residual = within.yy - out.slope * within.xy;
  if (!(residual > kLeftByRounding * within.yy)) {
    return Outcome<Ancova>::undefined(Text::tr("the scores after follow the scores before exactly"));
  }
  out.residualVariance = residual / out.residualDf;
  out.slopeError = std::sqrt(out.residualVariance / within.xx);
  const double withoutGroups = total.yy - total.xy * total.xy / total.xx;
  out.group.df1 = k - 1.0;
  out.group.df2 = out.residualDf;
  out.group.f = (withoutGroups - residual) / out.group.df1 / out.residualVariance;
  out.group.p = fUpper(std::max(0.0, out.group.f), out.group.df1, out.group.df2);
  out.partialEtaSquared = (withoutGroups - residual) / withoutGroups;
  const double t = quantileOf(confidence, out.residualDf);
  for (const Moments& m : groups) {
    AdjustedMean adjusted;
    const double shift = m.meanX - total.meanX;
    adjusted.mean = m.meanY - out.slope * shift;
    adjusted.error = std::sqrt(out.residualVariance * (1.0 / m.n + shift * shift / within.xx));
    adjusted.interval = around(adjusted.mean, t * adjusted.error);
    out.adjusted.push_back(adjusted);
  }
  addPairs(groups, within, confidence, out);
  addResiduals(before, after, groups, out);
  addSpread(before, groups, within, confidence, out);
  out.equalSlopes = slopesTest(groups, residual, total.n);
  return out;
}

namespace {

/// Two groups with separate slopes: the difference at x is level + slope x; its variance is a quadratic in x.
struct TwoLines {
  double level = 0.0;
  double slope = 0.0;
  double varianceConstant = 0.0;  ///< variance of the difference at x: constant + linear x + square x^2
  double varianceLinear = 0.0;
  double varianceSquare = 0.0;

  [[nodiscard]] double at(double x) const { return level + slope * x; }
  [[nodiscard]] double variance(double x) const {
    return varianceConstant + x * (varianceLinear + x * varianceSquare);
  }
};

/// Computes the lines about `origin`, chosen near the scores so that no digits are lost far from 0.
TwoLines twoLines(const Moments& a, const Moments& b, double variance, double origin) {
  TwoLines out;
  for (const auto& [m, sign] : {std::pair{&a, 1.0}, std::pair{&b, -1.0}}) {
    const double slope = m->xy / m->xx;
    const double middle = m->meanX - origin;
    out.level += sign * (m->meanY - slope * middle);
    out.slope += sign * slope;
    out.varianceConstant += variance * (1.0 / m->n + middle * middle / m->xx);
    out.varianceLinear -= 2.0 * variance * middle / m->xx;
    out.varianceSquare += variance / m->xx;
  }
  return out;
}

/// Returns where (level + slope x)^2 > t^2 variance(x).
SignificantRegion regionOf(const TwoLines& lines, double t, double origin) {
  const double a = lines.slope * lines.slope - t * t * lines.varianceSquare;
  const double b = 2.0 * lines.level * lines.slope - t * t * lines.varianceLinear;
  const double c = lines.level * lines.level - t * t * lines.varianceConstant;
  const double discriminant = b * b - 4.0 * a * c;
  SignificantRegion out;
  if (discriminant <= 0.0 || a == 0.0) {
    out.everywhere = a > 0.0 && discriminant < 0.0;
    return out;
  }
  const double far = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  const double one = far / a;
  const double other = c / far;
  const Interval roots{origin + std::min(one, other), origin + std::max(one, other)};
  (a > 0.0 ? out.outside : out.inside) = roots;
  return out;
}

}  // namespace

Outcome<SeparateSlopes> separateSlopes(const Groups& before, const Groups& after,
                                       std::span<const double> baselines, double confidence) {
  using Undefined = Outcome<SeparateSlopes>;
  if (const std::optional<Text> reason = notComparable(before, after)) {
    return Undefined::undefined(*reason);
  }
  SeparateSlopes out;
  out.baselines.assign(baselines.begin(), baselines.end());
  std::vector<Moments> groups;
  double residual = 0.0;
  double squares = 0.0;
  double total = 0.0;
  out.groups = presentGroups(before).numbers;
  for (const std::size_t g : out.groups) {
    const Moments m = momentsOf(before[g], after[g]);
    if (m.xx == 0.0) {
      return Undefined::undefined(Text::tr("the scores before do not vary in one group"));
    }
    out.slopes.push_back(m.xy / m.xx);
    residual += m.yy - m.xy * m.xy / m.xx;
    squares += m.yy;
    total += m.n;
    groups.push_back(m);
  }
  out.residualDf = total - 2.0 * static_cast<double>(groups.size());
  if (out.residualDf <= 0.0) {
    return Undefined::undefined(Text::tr("too few trainees for separate slopes"));
  }
  if (!(residual > kLeftByRounding * squares)) {
    return Undefined::undefined(Text::tr("the scores after follow the scores before exactly"));
  }
  out.residualVariance = residual / out.residualDf;
  for (const Moments& m : groups) {
    out.slopeErrors.push_back(std::sqrt(out.residualVariance / m.xx));
  }
  const double t = quantileOf(confidence, out.residualDf);
  std::vector<AdjustedDifference> all;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = i + 1; j < groups.size(); ++j) {
      const double origin = 0.5 * (groups[i].meanX + groups[j].meanX);
      const TwoLines lines = twoLines(groups[i], groups[j], out.residualVariance, origin);
      out.pairs.push_back({out.groups[i], out.groups[j], {}, regionOf(lines, t, origin)});
      for (const double x : baselines) {
        all.push_back(adjustedDifference(out.groups[i], out.groups[j], lines.at(x - origin),
                                         std::sqrt(lines.variance(x - origin)), out.residualDf));
      }
    }
  }
  addIntervals(all, confidence);
  auto next = all.cbegin();
  for (SlopesPair& pair : out.pairs) {
    pair.at.assign(next, next + std::ssize(baselines));
    next += std::ssize(baselines);
  }
  return out;
}

std::vector<double> defaultBaselines(const Groups& before) {
  std::vector<double> all;
  for (const std::vector<double>& group : before) {
    all.insert(all.end(), group.begin(), group.end());
  }
  const double mean = meanOf(all);
  const double deviation = *sampleDeviation(all);
  return {mean - deviation, mean, mean + deviation};
}

Equivalence equivalence(double difference, double error, double df, double margin, double alpha) {
  TORSIO_EXPECTS(error > 0.0 && margin > 0.0 && alpha > 0.0 && alpha < 0.5);
  const auto upper = [df](double t) {  // P(T >= t)
    const double half = 0.5 * tTwoSided(t, df);
    return t > 0.0 ? half : 1.0 - half;
  };
  Equivalence out;
  out.margin = margin;
  out.pBelow = upper((difference + margin) / error);
  out.pAbove = upper((margin - difference) / error);
  out.p = std::max(out.pBelow, out.pAbove);
  out.interval = around(difference, tQuantile(1.0 - alpha, df) * error);
  return out;
}

}  // namespace torsio
