// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/reliability.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"

namespace torsio {

namespace {

struct TwoWay {
  double n = 0.0;
  double k = 0.0;
  double rows = 0.0;
  double columns = 0.0;
  double error = 0.0;
  double within = 0.0;
};

/// Computes sums of squares from residuals, not as differences of large totals.
TwoWay twoWay(const NumberTable& x) {
  TwoWay ss;
  ss.n = static_cast<double>(x.rows());
  ss.k = static_cast<double>(x.columns());
  std::vector<double> rowMeans;
  std::vector<double> columnMeans;
  for (std::size_t i = 0; i < x.rows(); ++i) {
    rowMeans.push_back(meanOf(x.row(i)));
  }
  for (std::size_t j = 0; j < x.columns(); ++j) {
    columnMeans.push_back(meanOf(x.column(j)));
  }
  const double grand = meanOf(rowMeans);
  for (const double mean : rowMeans) {
    ss.rows += ss.k * (mean - grand) * (mean - grand);
  }
  for (const double mean : columnMeans) {
    ss.columns += ss.n * (mean - grand) * (mean - grand);
  }
  for (std::size_t i = 0; i < x.rows(); ++i) {
    for (std::size_t j = 0; j < x.columns(); ++j) {
      const double residual = x.at(i, j) - rowMeans[i] - columnMeans[j] + grand;
      const double inside = x.at(i, j) - rowMeans[i];
      ss.error += residual * residual;
      ss.within += inside * inside;
    }
  }
  return ss;
}

/// Returns the single-rater and mean-of-raters coefficients with their intervals, from the target mean square
/// over an error mean square with `df2` degrees of freedom.
std::pair<IccForm, IccForm> singleAndMean(const IccResult& of, double error, double df2, double tail) {
  const double k = static_cast<double>(of.raters);
  const double df1 = static_cast<double>(of.targets) - 1.0;
  const IccForm single{(of.bms - error) / (of.bms + (k - 1.0) * error), std::nullopt};
  const IccForm mean{(of.bms - error) / of.bms, std::nullopt};
  if (error == 0.0) {
    return {single, mean};
  }
  const double f = of.bms / error;
  const double low = f / fQuantile(1.0 - tail, df1, df2);
  const double high = f * fQuantile(1.0 - tail, df2, df1);
  return {{single.estimate, Interval{(low - 1.0) / (low + k - 1.0), (high - 1.0) / (high + k - 1.0)}},
          {mean.estimate, Interval{1.0 - 1.0 / low, 1.0 - 1.0 / high}}};
}

void addOneWay(IccResult& out, double tail) {
  const double n = static_cast<double>(out.targets);
  const double k = static_cast<double>(out.raters);
  const double df1 = n - 1.0;
  const double df2 = n * (k - 1.0);
  if (out.wms > 0.0) {
    out.fOneWay = out.bms / out.wms;
    out.pOneWay = fUpper(*out.fOneWay, df1, df2);
  }
  std::tie(out.oneWaySingle, out.oneWayMean) = singleAndMean(out, out.wms, df2, tail);
}

void addConsistency(IccResult& out, double tail) {
  const double n = static_cast<double>(out.targets);
  const double k = static_cast<double>(out.raters);
  const double df1 = n - 1.0;
  const double df2 = (n - 1.0) * (k - 1.0);
  if (out.ems > 0.0) {
    out.fTwoWay = out.bms / out.ems;
    out.pTwoWay = fUpper(*out.fTwoWay, df1, df2);
    out.fRaters = out.jms / out.ems;
    out.pRaters = fUpper(*out.fRaters, k - 1.0, df2);
  }
  std::tie(out.consistencySingle, out.consistencyMean) = singleAndMean(out, out.ems, df2, tail);
}

void addAgreement(IccResult& out, double confidence) {
  const double n = static_cast<double>(out.targets);
  const double k = static_cast<double>(out.raters);
  out.agreementSingle.estimate =
      (out.bms - out.ems) / (out.bms + (k - 1.0) * out.ems + k * (out.jms - out.ems) / n);
  out.agreementMean.estimate = (out.bms - out.ems) / (out.bms + (out.jms - out.ems) / n);
  const auto found = agreementInterval({.raters = k,
                                        .targetsPerRater = n,
                                        .targets_ms = out.bms,
                                        .targets_df = n - 1.0,
                                        .raters_ms = out.jms,
                                        .raters_df = k - 1.0,
                                        .error_ms = out.ems,
                                        .error_df = (n - 1.0) * (k - 1.0)},
                                       confidence);
  if (!found) {
    return;
  }
  const Interval& single = found->first;
  out.agreementDf = found->second;
  out.agreementSingle.interval = single;
  out.agreementMean.interval = Interval{spearmanBrown(single.lower, k), spearmanBrown(single.upper, k)};
}

}  // namespace

std::optional<std::pair<Interval, double>> agreementInterval(const RatedSquares& of, double confidence) {
  if (of.error_ms == 0.0) {
    return std::nullopt;
  }
  const double k = of.raters;
  const double n = of.targetsPerRater;
  const double tail = 0.5 * (1.0 - confidence);
  const double r = (of.targets_ms - of.error_ms) /
                   (of.targets_ms + (k - 1.0) * of.error_ms + k * (of.raters_ms - of.error_ms) / n);
  const double a = k * r / (n * (1.0 - r)) * of.raters_ms;
  const double b = (1.0 + k * r * (n - 1.0) / (n * (1.0 - r))) * of.error_ms;
  const double v = (a + b) * (a + b) / (a * a / of.raters_df + b * b / of.error_df);
  if (!(v > 0.0) || !std::isfinite(v)) {
    return std::nullopt;
  }
  const double f1 = fQuantile(1.0 - tail, of.targets_df, v);
  const double f2 = fQuantile(1.0 - tail, v, of.targets_df);
  if (!std::isfinite(f1) || !std::isfinite(f2)) {  // v near 0: the interval is unbounded
    return std::nullopt;
  }
  const double spread = k * of.raters_ms + (k * n - k - n) * of.error_ms;
  const Interval single{n * (of.targets_ms - f1 * of.error_ms) / (f1 * spread + n * of.targets_ms),
                        n * (f2 * of.targets_ms - of.error_ms) / (spread + n * f2 * of.targets_ms)};
  if (!std::isfinite(spearmanBrown(single.lower, k)) || !std::isfinite(spearmanBrown(single.upper, k))) {
    return std::nullopt;  // likewise
  }
  return std::pair(single, v);
}

Outcome<IccResult> intraclassCorrelation(const NumberTable& ratings, double confidence) {
  if (const std::optional<Text> reason = beyondArithmetic(ratings.values())) {
    return Outcome<IccResult>::undefined(*reason);
  }
  if (ratings.rows() < 2) {
    return Outcome<IccResult>::undefined(Text::tr("there are fewer than two targets"));
  }
  if (ratings.columns() < 2) {
    return Outcome<IccResult>::undefined(Text::tr("there are fewer than two raters"));
  }
  TwoWay ss = twoWay(ratings);
  if (ss.rows + ss.within == 0.0) {
    return Outcome<IccResult>::undefined(Text::tr("every rating is the same"));
  }
  constexpr double kRounding = 1e-13;  // of the total: what remains of a residual that is truly zero
  const double total = ss.rows + ss.within;
  if (ss.rows <= kRounding * total) {
    return Outcome<IccResult>::undefined(Text::tr("the targets do not differ"));
  }
  ss.error = ss.error <= kRounding * total ? 0.0 : ss.error;
  ss.within = ss.within <= kRounding * total ? 0.0 : ss.within;
  ss.columns = ss.within == 0.0 ? 0.0 : ss.columns;
  IccResult out;
  out.targets = ratings.rows();
  out.raters = ratings.columns();
  out.bms = ss.rows / (ss.n - 1.0);
  out.wms = ss.within / (ss.n * (ss.k - 1.0));
  out.jms = ss.columns / (ss.k - 1.0);
  out.ems = ss.error / ((ss.n - 1.0) * (ss.k - 1.0));
  const double tail = 0.5 * (1.0 - confidence);
  addOneWay(out, tail);
  addConsistency(out, tail);
  addAgreement(out, confidence);
  out.varianceTargets = (out.bms - out.ems) / ss.k;
  out.varianceRaters = (out.jms - out.ems) / ss.n;
  out.varianceResidual = out.ems;
  out.semConsistency = std::sqrt(out.ems);
  out.semAgreement = std::sqrt(std::max(0.0, out.varianceRaters) + out.ems);
  out.semMean = out.semAgreement / std::sqrt(ss.k);
  return out;
}

namespace {

std::optional<double> alphaOf(const NumberTable& x, std::optional<std::size_t> without) {
  std::vector<double> sums(x.rows(), 0.0);
  double itemVariances = 0.0;
  double items = 0.0;
  for (std::size_t j = 0; j < x.columns(); ++j) {
    if (without == j) {
      continue;
    }
    const std::vector<double> column = x.column(j);
    itemVariances += *sampleVariance(column);
    for (std::size_t i = 0; i < x.rows(); ++i) {
      sums[i] += column[i];
    }
    items += 1.0;
  }
  const double total = *sampleVariance(sums);
  if (items < 2.0 || total == 0.0) {
    return std::nullopt;
  }
  return items / (items - 1.0) * (1.0 - itemVariances / total);
}

std::optional<double> standardizedAlpha(const NumberTable& x) {
  double correlations = 0.0;
  double pairs = 0.0;
  for (std::size_t a = 0; a < x.columns(); ++a) {
    for (std::size_t b = a + 1; b < x.columns(); ++b) {
      const std::vector<double> u = x.column(a);
      const std::vector<double> v = x.column(b);
      const double meanU = meanOf(u);
      const double meanV = meanOf(v);
      double product = 0.0;
      for (std::size_t i = 0; i < u.size(); ++i) {
        product += (u[i] - meanU) * (v[i] - meanV);
      }
      const double scale = std::sqrt(sumOfSquares(u) * sumOfSquares(v));
      if (scale == 0.0) {
        return std::nullopt;
      }
      correlations += product / scale;
      pairs += 1.0;
    }
  }
  return spearmanBrown(correlations / pairs, static_cast<double>(x.columns()));
}

}  // namespace

Outcome<CronbachResult> cronbachAlpha(const NumberTable& answers, double confidence) {
  if (const std::optional<Text> reason = beyondArithmetic(answers.values())) {
    return Outcome<CronbachResult>::undefined(*reason);
  }
  if (answers.rows() < 2 || answers.columns() < 2) {
    return Outcome<CronbachResult>::undefined(Text::tr("alpha needs at least two persons and two items"));
  }
  const std::optional<double> alpha = alphaOf(answers, std::nullopt);
  if (!alpha) {
    return Outcome<CronbachResult>::undefined(Text::tr("the sums over the items do not vary"));
  }
  CronbachResult out;
  out.alpha = *alpha;
  const double df1 = static_cast<double>(answers.rows() - 1);
  const double df2 = df1 * static_cast<double>(answers.columns() - 1);
  const double tail = 0.5 * (1.0 - confidence);
  out.interval = {1.0 - (1.0 - *alpha) * fQuantile(1.0 - tail, df1, df2),
                  1.0 - (1.0 - *alpha) * fQuantile(tail, df1, df2)};
  for (std::size_t j = 0; j < answers.columns(); ++j) {
    out.alphaWithout.push_back(alphaOf(answers, j));
  }
  out.standardized = standardizedAlpha(answers);
  return out;
}

Outcome<KendallResult> kendallW(const NumberTable& ratings) {
  if (ratings.rows() < 2 || ratings.columns() < 2) {
    return Outcome<KendallResult>::undefined(
        Text::tr("concordance needs at least two targets and two raters"));
  }
  const double n = static_cast<double>(ratings.rows());
  const double m = static_cast<double>(ratings.columns());
  std::vector<std::int64_t> doubledSums(ratings.rows(), 0);
  std::int64_t ties = 0;
  for (std::size_t j = 0; j < ratings.columns(); ++j) {
    const DoubledRanks ranks = doubledRanks(ratings.column(j));
    ties += ranks.tieTerm;
    for (std::size_t i = 0; i < ratings.rows(); ++i) {
      doubledSums[i] += ranks.ranks[i];
    }
  }
  KendallResult out;
  out.tieTerm = static_cast<double>(ties);
  const double middle = m * (n + 1.0);  // of the doubled sums
  for (const std::int64_t sum : doubledSums) {
    const double d = static_cast<double>(sum) - middle;
    out.s += 0.25 * d * d;
  }
  const double denominator = m * m * (n * n * n - n) - m * out.tieTerm;
  if (denominator <= 0.0) {
    return Outcome<KendallResult>::undefined(Text::tr("every rater ties all targets"));
  }
  out.w = 12.0 * out.s / denominator;
  out.wUncorrected = 12.0 * out.s / (m * m * (n * n * n - n));
  out.df = n - 1.0;
  out.chiSquared = m * (n - 1.0) * out.w;
  out.p = chiSquaredUpper(out.chiSquared, out.df);
  return out;
}

Outcome<BlandAltmanResult> blandAltman(std::span<const double> x, std::span<const double> y,
                                       double multiplier, double confidence) {
  TORSIO_EXPECTS(x.size() == y.size());
  if (const std::optional<Text> reason = beyondArithmetic(x, y)) {
    return Outcome<BlandAltmanResult>::undefined(*reason);
  }
  if (x.size() < 2) {
    return Outcome<BlandAltmanResult>::undefined(Text::tr("limits of agreement need at least two pairs"));
  }
  BlandAltmanResult out;
  out.n = x.size();
  const double n = static_cast<double>(x.size());
  std::vector<double> differences;
  std::vector<double> means;
  for (std::size_t i = 0; i < x.size(); ++i) {
    differences.push_back(x[i] - y[i]);
    means.push_back(0.5 * (x[i] + y[i]));
  }
  out.meanDifference = meanOf(differences);
  out.deviation = *sampleDeviation(differences);
  out.limits = {out.meanDifference - multiplier * out.deviation,
                out.meanDifference + multiplier * out.deviation};
  const double t = tQuantile(0.5 * (1.0 + confidence), n - 1.0);
  const double meanReach = t * out.deviation / std::sqrt(n);
  out.meanInterval = {out.meanDifference - meanReach, out.meanDifference + meanReach};
  out.limitError = std::sqrt(3.0 / n) * out.deviation;
  out.limitErrorExact = std::sqrt(1.0 / n + multiplier * multiplier / (2.0 * (n - 1.0))) * out.deviation;
  const double reach = t * out.limitError;
  out.lowerLimitInterval = {out.limits.lower - reach, out.limits.lower + reach};
  out.upperLimitInterval = {out.limits.upper - reach, out.limits.upper + reach};
  const double spread = sumOfSquares(means);
  if (spread > 0.0) {
    const double meanOfMeans = meanOf(means);
    double product = 0.0;
    for (std::size_t i = 0; i < means.size(); ++i) {
      product += (means[i] - meanOfMeans) * (differences[i] - out.meanDifference);
    }
    out.slope = product / spread;
  }
  return out;
}

std::vector<Outcome<BlandAltmanResult>> blandAltmanAgainstPanel(const NumberTable& ratings) {
  TORSIO_EXPECTS(ratings.columns() >= 2);
  std::vector<Outcome<BlandAltmanResult>> out;
  for (std::size_t rater = 0; rater < ratings.columns(); ++rater) {
    std::vector<double> others;
    for (std::size_t i = 0; i < ratings.rows(); ++i) {
      std::vector<double> row = ratings.row(i);
      row.erase(row.begin() + static_cast<std::ptrdiff_t>(rater));
      others.push_back(meanOf(row));
    }
    out.push_back(blandAltman(ratings.column(rater), others));
  }
  return out;
}

}  // namespace torsio
