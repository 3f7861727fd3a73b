// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/mean_tests.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"

namespace torsio {

namespace {

constexpr Phrase kTooFew = Text::tr("a group has fewer than two values");
constexpr Phrase kNoSpread = Text::tr("the values do not vary");
constexpr Phrase kTooFewGroups = Text::tr("fewer than two groups have values");

double countOf(std::span<const double> x) {
  return static_cast<double>(x.size());
}

TTest finished(double difference, double error, double df, double confidence) {
  TTest out;
  out.difference = difference;
  out.error = error;
  out.t = difference / error;
  out.df = df;
  out.p = tTwoSided(out.t, df);
  const double reach = tQuantile(0.5 * (1.0 + confidence), df) * error;
  out.interval = {difference - reach, difference + reach};
  return out;
}

double varianceOf(std::span<const double> x) {
  return squaresBeyondRounding(x) / (countOf(x) - 1.0);
}

double pooledVariance(std::span<const double> x, std::span<const double> y) {
  return (squaresBeyondRounding(x) + squaresBeyondRounding(y)) / (countOf(x) + countOf(y) - 2.0);
}

/// Returns why two samples cannot be compared; empty: they can.
std::optional<Text> notComparable(std::span<const double> x, std::span<const double> y) {
  if (std::optional<Text> reason = beyondArithmetic(x, y)) {
    return reason;
  }
  return x.size() < 2 || y.size() < 2 ? std::optional<Text>(kTooFew) : std::nullopt;
}

bool everyGroupHas(const Groups& groups, std::size_t n) {
  return std::all_of(groups.begin(), groups.end(), [n](const auto& group) { return group.size() >= n; });
}

}  // namespace

PresentGroups presentGroups(const Groups& groups) {
  PresentGroups out;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!groups[g].empty()) {
      out.values.push_back(groups[g]);
      out.numbers.push_back(g);
    }
  }
  return out;
}

Outcome<TTest> welchT(std::span<const double> x, std::span<const double> y, double confidence) {
  if (const std::optional<Text> reason = notComparable(x, y)) {
    return Outcome<TTest>::undefined(*reason);
  }
  const double a = varianceOf(x) / countOf(x);
  const double b = varianceOf(y) / countOf(y);
  if (a + b == 0.0) {
    return Outcome<TTest>::undefined(kNoSpread);
  }
  const double df = (a + b) * (a + b) / (a * a / (countOf(x) - 1.0) + b * b / (countOf(y) - 1.0));
  return finished(meanOf(x) - meanOf(y), std::sqrt(a + b), df, confidence);
}

Outcome<TTest> studentT(std::span<const double> x, std::span<const double> y, double confidence) {
  if (const std::optional<Text> reason = notComparable(x, y)) {
    return Outcome<TTest>::undefined(*reason);
  }
  const double variance = pooledVariance(x, y);
  if (variance == 0.0) {
    return Outcome<TTest>::undefined(kNoSpread);
  }
  return finished(meanOf(x) - meanOf(y), std::sqrt(variance * (1.0 / countOf(x) + 1.0 / countOf(y))),
                  countOf(x) + countOf(y) - 2.0, confidence);
}

Outcome<TTest> pairedT(std::span<const double> x, std::span<const double> y, double confidence) {
  TORSIO_EXPECTS(x.size() == y.size());
  if (const std::optional<Text> reason = beyondArithmetic(x, y)) {
    return Outcome<TTest>::undefined(*reason);
  }
  if (x.size() < 2) {
    return Outcome<TTest>::undefined(Text::tr("there are fewer than two pairs"));
  }
  std::vector<double> differences;
  for (std::size_t i = 0; i < x.size(); ++i) {
    differences.push_back(x[i] - y[i]);
  }
  const double variance = *sampleVariance(differences);
  if (variance * (countOf(x) - 1.0) <= roundingSquares(x) + roundingSquares(y)) {
    return Outcome<TTest>::undefined(Text::tr("the differences do not vary"));
  }
  return finished(meanOf(differences), std::sqrt(variance / countOf(x)), countOf(x) - 1.0, confidence);
}

Outcome<TTest> stratifiedMean(const Groups& strata, std::span<const double> weights, double confidence) {
  TORSIO_EXPECTS(strata.size() == weights.size());
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  TTest out;
  double variance = 0.0;
  double denominator = 0.0;
  for (std::size_t c = 0; c < strata.size(); ++c) {
    if (weights[c] == 0.0) {
      continue;
    }
    if (strata[c].size() < 2) {
      return Outcome<TTest>::undefined(Text::tr("a class has fewer than two raters"));
    }
    const double n = static_cast<double>(strata[c].size());
    const double share = weights[c] / all;
    const double part = share * share * sumOfSquares(strata[c]) / (n - 1.0) / n;
    out.difference += share * meanOf(strata[c]);
    variance += part;
    denominator += part * part / (n - 1.0);
  }
  if (!(variance > 0.0)) {
    return Outcome<TTest>::undefined(kNoSpread);
  }
  out.error = std::sqrt(variance);
  out.df = variance * variance / denominator;
  out.t = out.difference / out.error;
  out.p = tTwoSided(out.t, out.df);
  const double reach = tQuantile(0.5 * (1.0 + confidence), out.df) * out.error;
  out.interval = {out.difference - reach, out.difference + reach};
  return out;
}

std::optional<Interval> meanInterval(std::span<const double> values, double confidence) {
  const std::optional<double> deviation = sampleDeviation(values);
  if (!deviation) {
    return std::nullopt;
  }
  const double n = countOf(values);
  const double reach = tQuantile(0.5 * (1.0 + confidence), n - 1.0) * *deviation / std::sqrt(n);
  return Interval{meanOf(values) - reach, meanOf(values) + reach};
}

Outcome<HedgesG> hedgesG(std::span<const double> x, std::span<const double> y, double confidence) {
  if (const std::optional<Text> reason = notComparable(x, y)) {
    return Outcome<HedgesG>::undefined(*reason);
  }
  const double variance = pooledVariance(x, y);
  if (variance == 0.0) {
    return Outcome<HedgesG>::undefined(kNoSpread);
  }
  const double df = countOf(x) + countOf(y) - 2.0;
  const double scale = std::sqrt(1.0 / countOf(x) + 1.0 / countOf(y));
  HedgesG out;
  out.d = (meanOf(x) - meanOf(y)) / std::sqrt(variance);
  out.correction = std::exp(std::lgamma(0.5 * df) - 0.5 * std::log(0.5 * df) - std::lgamma(0.5 * (df - 1.0)));
  out.g = out.correction * out.d;
  const double t = out.d / scale;
  const double tail = 0.5 * (1.0 - confidence);
  out.noncentrality = {noncentralityOfT(t, df, 1.0 - tail), noncentralityOfT(t, df, tail)};
  out.dInterval = {out.noncentrality.lower * scale, out.noncentrality.upper * scale};
  out.interval = {out.correction * out.dInterval.lower, out.correction * out.dInterval.upper};
  const double n = countOf(x) + countOf(y);
  out.error = out.correction * std::sqrt(n / (countOf(x) * countOf(y)) + out.d * out.d / (2.0 * n));
  const double reach = normalQuantile(1.0 - tail) * out.error;
  out.normalInterval = {out.g - reach, out.g + reach};
  return out;
}

Outcome<OneWayAnova> oneWayAnova(const Groups& given) {
  const Groups groups = presentGroups(given).values;
  if (const std::optional<Text> reason = beyondArithmetic(groups)) {
    return Outcome<OneWayAnova>::undefined(*reason);
  }
  if (groups.size() < 2) {
    return Outcome<OneWayAnova>::undefined(kTooFewGroups);
  }
  OneWayAnova out;
  std::vector<double> all;
  for (const std::vector<double>& group : groups) {
    all.insert(all.end(), group.begin(), group.end());
  }
  const double grand = meanOf(all);
  for (const std::vector<double>& group : groups) {
    const double shift = meanOf(group) - grand;
    out.ssBetween += countOf(group) * shift * shift;
    out.ssWithin += squaresBeyondRounding(group);
  }
  out.df1 = static_cast<double>(groups.size() - 1);
  out.df2 = countOf(all) - static_cast<double>(groups.size());
  if (out.df2 <= 0.0 || out.ssWithin == 0.0) {
    return Outcome<OneWayAnova>::undefined(Text::tr("the values do not vary within groups"));
  }
  out.msBetween = out.ssBetween / out.df1;
  out.msWithin = out.ssWithin / out.df2;
  out.f = out.msBetween / out.msWithin;
  out.p = fUpper(out.f, out.df1, out.df2);
  const double total = out.ssBetween + out.ssWithin;
  out.etaSquared = out.ssBetween / total;
  out.omegaSquared = (out.ssBetween - out.df1 * out.msWithin) / (total + out.msWithin);
  out.epsilonSquared = (out.ssBetween - out.df1 * out.msWithin) / total;
  return out;
}

Outcome<FTest> welchAnova(const Groups& given) {
  const Groups groups = presentGroups(given).values;
  if (const std::optional<Text> reason = beyondArithmetic(groups)) {
    return Outcome<FTest>::undefined(*reason);
  }
  if (groups.size() < 2) {
    return Outcome<FTest>::undefined(kTooFewGroups);
  }
  if (!everyGroupHas(groups, 2)) {
    return Outcome<FTest>::undefined(kTooFew);
  }
  const double k = static_cast<double>(groups.size());
  std::vector<double> weights;
  double weightSum = 0.0;
  double mean = 0.0;
  for (const std::vector<double>& group : groups) {
    const double variance = varianceOf(group);
    if (variance == 0.0) {
      return Outcome<FTest>::undefined(Text::tr("a group does not vary"));
    }
    weights.push_back(countOf(group) / variance);
    weightSum += weights.back();
    mean += weights.back() * meanOf(group);
  }
  mean /= weightSum;
  double between = 0.0;
  double lambda = 0.0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const double shift = meanOf(groups[i]) - mean;
    between += weights[i] * shift * shift;
    const double share = 1.0 - weights[i] / weightSum;
    lambda += share * share / (countOf(groups[i]) - 1.0);
  }
  FTest out;
  out.df1 = k - 1.0;
  out.df2 = (k * k - 1.0) / (3.0 * lambda);
  out.f = between / (k - 1.0) / (1.0 + 2.0 * (k - 2.0) / (k * k - 1.0) * lambda);
  out.p = fUpper(out.f, out.df1, out.df2);
  return out;
}

Outcome<FTest> brownForsythe(const Groups& groups) {
  if (const std::optional<Text> reason = beyondArithmetic(groups)) {
    return Outcome<FTest>::undefined(*reason);
  }
  Groups distances = presentGroups(groups).values;
  if (std::all_of(distances.begin(), distances.end(),
                  [](const auto& group) { return squaresBeyondRounding(group) == 0.0; })) {
    return Outcome<FTest>::undefined(kNoSpread);
  }
  for (std::vector<double>& group : distances) {
    const double median = medianOf(group);
    for (double& x : group) {
      x = std::abs(x - median);
    }
  }
  const Outcome<OneWayAnova> anova = oneWayAnova(distances);
  if (!anova) {
    return Outcome<FTest>::undefined(anova.reason());
  }
  return FTest{anova->f, anova->df1, anova->df2, anova->p};
}

Outcome<ChiSquaredTest> bartlett(const Groups& given) {
  const Groups groups = presentGroups(given).values;
  if (const std::optional<Text> reason = beyondArithmetic(groups)) {
    return Outcome<ChiSquaredTest>::undefined(*reason);
  }
  if (groups.size() < 2) {
    return Outcome<ChiSquaredTest>::undefined(kTooFewGroups);
  }
  if (!everyGroupHas(groups, 2)) {
    return Outcome<ChiSquaredTest>::undefined(kTooFew);
  }
  double dfSum = 0.0;
  double pooled = 0.0;
  double logs = 0.0;
  double reciprocals = 0.0;
  for (const std::vector<double>& group : groups) {
    const double df = countOf(group) - 1.0;
    const double variance = varianceOf(group);
    if (variance == 0.0) {
      return Outcome<ChiSquaredTest>::undefined(Text::tr("a group does not vary"));
    }
    dfSum += df;
    pooled += df * variance;
    logs += df * std::log(variance);
    reciprocals += 1.0 / df;
  }
  pooled /= dfSum;
  ChiSquaredTest out;
  out.df = static_cast<double>(groups.size() - 1);
  out.statistic = (dfSum * std::log(pooled) - logs) / (1.0 + (reciprocals - 1.0 / dfSum) / (3.0 * out.df));
  out.p = chiSquaredUpper(out.statistic, out.df);
  return out;
}

namespace {

/// Compares pairs of groups by the studentised range.
class PairComparer {
 public:
  PairComparer(const PresentGroups& groups, double confidence)
      : groups_(groups),
        confidence_(confidence),
        range_(std::max(2, static_cast<int>(groups.numbers.size()))) {}

  [[nodiscard]] PairComparison compared(std::size_t i, std::size_t j, double error, double df);

 private:
  const PresentGroups& groups_;
  double confidence_;
  StudentizedRange range_;
  std::map<double, double> quantiles_;  // by df
};

PairComparison PairComparer::compared(std::size_t i, std::size_t j, double error, double df) {
  PairComparison pair;
  pair.first = groups_.numbers[i];
  pair.second = groups_.numbers[j];
  pair.difference = meanOf(groups_.values[j]) - meanOf(groups_.values[i]);
  pair.df = df;
  // The studentised range statistic is sqrt(2) times the t statistic.
  const double scale = error / std::sqrt(2.0);
  pair.q = std::abs(pair.difference) / scale;
  pair.p = range_.upper(pair.q, df);
  const auto [quantile, isNew] = quantiles_.try_emplace(df);
  if (isNew) {
    quantile->second = range_.quantile(confidence_, df);
  }
  const double reach = quantile->second * scale;
  pair.interval = {pair.difference - reach, pair.difference + reach};
  return pair;
}

}  // namespace

Outcome<std::vector<PairComparison>> tukeyPairs(const Groups& groups, double confidence) {
  if (const std::optional<Text> reason = beyondArithmetic(groups)) {
    return Outcome<std::vector<PairComparison>>::undefined(*reason);
  }
  const Outcome<OneWayAnova> anova = oneWayAnova(groups);
  if (!anova) {
    return Outcome<std::vector<PairComparison>>::undefined(anova.reason());
  }
  std::vector<PairComparison> out;
  const PresentGroups present = presentGroups(groups);
  PairComparer pairs(present, confidence);
  for (std::size_t i = 0; i < present.values.size(); ++i) {
    for (std::size_t j = i + 1; j < present.values.size(); ++j) {
      const double error =
          std::sqrt(anova->msWithin * (1.0 / countOf(present.values[i]) + 1.0 / countOf(present.values[j])));
      out.push_back(pairs.compared(i, j, error, anova->df2));
    }
  }
  return out;
}

Outcome<std::vector<PairComparison>> gamesHowellPairs(const Groups& groups, double confidence) {
  using Undefined = Outcome<std::vector<PairComparison>>;
  if (const std::optional<Text> reason = beyondArithmetic(groups)) {
    return Outcome<std::vector<PairComparison>>::undefined(*reason);
  }
  std::vector<PairComparison> out;
  const PresentGroups present = presentGroups(groups);
  PairComparer pairs(present, confidence);
  for (std::size_t i = 0; i < present.values.size(); ++i) {
    for (std::size_t j = i + 1; j < present.values.size(); ++j) {
      const Outcome<TTest> test = welchT(present.values[i], present.values[j]);
      if (!test) {
        return Undefined::undefined(test.reason());
      }
      out.push_back(pairs.compared(i, j, test->error, test->df));
    }
  }
  if (out.empty()) {
    return Undefined::undefined(kTooFewGroups);
  }
  return out;
}

}  // namespace torsio
