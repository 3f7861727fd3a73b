// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/categorical_agreement.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "assessment/statistics/distributions.h"
#include "assessment/statistics/quantiles.h"
#include "sim/base/error.h"
#include "sim/base/random.h"

namespace torsio {

namespace {

/// Squared difference between the values numbered c and k.
double difference2(AlphaMetric metric, std::size_t c, std::size_t k, const std::vector<double>& values,
                   const std::vector<double>& counts) {
  if (c == k) {
    return 0.0;
  }
  switch (metric) {
    case AlphaMetric::kNominal:
      return 1.0;
    case AlphaMetric::kInterval:
      return (values[c] - values[k]) * (values[c] - values[k]);
    case AlphaMetric::kRatio: {
      const double sum = values[c] + values[k];
      const double ratio = sum == 0.0 ? 0.0 : (values[c] - values[k]) / sum;
      return ratio * ratio;
    }
    case AlphaMetric::kOrdinal: {
      double between = 0.0;
      for (std::size_t g = std::min(c, k); g <= std::max(c, k); ++g) {
        between += counts[g];
      }
      between -= 0.5 * (counts[c] + counts[k]);
      return between * between;
    }
  }
  return 0.0;
}

std::vector<double> valuesOfUnit(const IncompleteRatings& ratings, std::size_t unit) {
  std::vector<double> values;
  for (const auto& coder : ratings) {
    if (coder[unit]) {
      values.push_back(*coder[unit]);
    }
  }
  return values;
}

}  // namespace

Outcome<KrippendorffResult> krippendorffAlpha(const IncompleteRatings& ratings, AlphaMetric metric) {
  using Undefined = Outcome<KrippendorffResult>;
  if (ratings.size() < 2) {
    return Undefined::undefined(Text::tr("there are fewer than two coders"));
  }
  const std::size_t units = ratings.front().size();
  std::set<double> distinct;
  std::vector<std::vector<double>> pairable;
  for (const auto& coder : ratings) {
    TORSIO_EXPECTS(coder.size() == units);
  }
  KrippendorffResult out;
  for (std::size_t u = 0; u < units; ++u) {
    const std::vector<double> values = valuesOfUnit(ratings, u);
    if (values.size() < 2) {
      continue;
    }
    distinct.insert(values.begin(), values.end());
    out.pairable += std::ssize(values);
    pairable.push_back(values);
  }
  if (pairable.empty()) {
    return Undefined::undefined(Text::tr("no unit has two ratings"));
  }
  if (distinct.size() < 2) {
    return Undefined::undefined(Text::tr("every rating is the same"));
  }
  out.values.assign(distinct.begin(), distinct.end());
  const std::size_t size = out.values.size();
  const auto numberOf = [&](double x) {
    return static_cast<std::size_t>(std::lower_bound(out.values.begin(), out.values.end(), x) -
                                    out.values.begin());
  };
  out.coincidences = NumberTable(size, size);
  std::vector<double> counts(size, 0.0);
  for (const std::vector<double>& unit : pairable) {
    for (std::size_t i = 0; i < unit.size(); ++i) {
      counts[numberOf(unit[i])] += 1.0;
      for (std::size_t j = 0; j < unit.size(); ++j) {
        if (i != j) {
          out.coincidences.at(numberOf(unit[i]), numberOf(unit[j])) +=
              1.0 / static_cast<double>(unit.size() - 1);
        }
      }
    }
  }
  const double n = static_cast<double>(out.pairable);
  for (std::size_t c = 0; c < size; ++c) {
    for (std::size_t k = 0; k < size; ++k) {
      const double d = difference2(metric, c, k, out.values, counts);
      out.observed += out.coincidences.at(c, k) * d / n;
      out.expected += counts[c] * counts[k] * d / (n * (n - 1.0));
    }
  }
  if (out.expected == 0.0) {
    return Undefined::undefined(Text::tr("the values do not differ under this metric"));
  }
  out.alpha = 1.0 - out.observed / out.expected;
  return out;
}

Outcome<AlphaBootstrap> krippendorffInterval(const IncompleteRatings& ratings, AlphaMetric metric,
                                             std::uint64_t seed, int resamples, double confidence) {
  const Outcome<KrippendorffResult> point = krippendorffAlpha(ratings, metric);
  if (!point) {
    return Outcome<AlphaBootstrap>::undefined(point.reason());
  }
  Random random(seed);
  const std::size_t units = ratings.front().size();
  AlphaBootstrap out;
  out.resamples = resamples;
  std::vector<double> alphas;
  IncompleteRatings sample = ratings;
  for (int b = 0; b < resamples; ++b) {
    for (std::size_t u = 0; u < units; ++u) {
      const std::size_t from = random.bounded(units);
      for (std::size_t coder = 0; coder < ratings.size(); ++coder) {
        sample[coder][u] = ratings[coder][from];
      }
    }
    const Outcome<KrippendorffResult> alpha = krippendorffAlpha(sample, metric);
    if (alpha) {
      alphas.push_back(alpha->alpha);
    }
    if (!alpha) {
      ++out.undefined;
    }
  }
  if (alphas.empty()) {
    return Outcome<AlphaBootstrap>::undefined(Text::tr("no resample has any variation"));
  }
  const double tail = 0.5 * (1.0 - confidence);
  out.interval = {*quantile(alphas, tail), *quantile(alphas, 1.0 - tail)};
  return out;
}

namespace {

Outcome<KappaResult> kappaWithAgreement(const NumberTable& counts, const NumberTable& w, double confidence) {
  const std::size_t size = counts.rows();
  double n = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      n += counts.at(i, j);
    }
  }
  if (n == 0.0) {
    return Outcome<KappaResult>::undefined(Text::tr("there are no ratings"));
  }
  std::vector<double> rows(size, 0.0);
  std::vector<double> columns(size, 0.0);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      rows[i] += counts.at(i, j) / n;
      columns[j] += counts.at(i, j) / n;
    }
  }
  KappaResult out;
  std::vector<double> rowWeights(size, 0.0);
  std::vector<double> columnWeights(size, 0.0);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      out.observed += w.at(i, j) * counts.at(i, j) / n;
      out.expected += w.at(i, j) * rows[i] * columns[j];
      rowWeights[i] += w.at(i, j) * columns[j];
      columnWeights[j] += w.at(i, j) * rows[i];
    }
  }
  if (out.expected >= 1.0) {
    return Outcome<KappaResult>::undefined(Text::tr("both raters use one and the same category only"));
  }
  out.kappa = (out.observed - out.expected) / (1.0 - out.expected);
  // Fleiss, Cohen and Everitt (1969).
  double spread = 0.0;
  double spreadUnderNull = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      const double margins = rowWeights[i] + columnWeights[j];
      const double d = w.at(i, j) - margins * (1.0 - out.kappa);
      const double d0 = w.at(i, j) - margins;
      spread += counts.at(i, j) / n * d * d;
      spreadUnderNull += rows[i] * columns[j] * d0 * d0;
    }
  }
  const double centre = out.kappa - out.expected * (1.0 - out.kappa);
  const double scale = std::sqrt(n) * (1.0 - out.expected);
  out.error = std::sqrt(std::max(0.0, spread - centre * centre)) / scale;
  out.errorUnderNull = std::sqrt(std::max(0.0, spreadUnderNull - out.expected * out.expected)) / scale;
  if (out.errorUnderNull > 0.0) {
    out.z = out.kappa / out.errorUnderNull;
  }
  const double reach = normalQuantile(0.5 * (1.0 + confidence)) * out.error;
  out.interval = {out.kappa - reach, out.kappa + reach};
  return out;
}

}  // namespace

Outcome<KappaResult> cohenKappa(const NumberTable& table, KappaWeights weights, double confidence) {
  TORSIO_EXPECTS(table.rows() == table.columns());
  if (table.rows() < 2) {
    return Outcome<KappaResult>::undefined(Text::tr("there are fewer than two categories"));
  }
  NumberTable agreement(table.rows(), table.rows());
  const double span = static_cast<double>(table.rows() - 1);
  for (std::size_t i = 0; i < table.rows(); ++i) {
    for (std::size_t j = 0; j < table.rows(); ++j) {
      const double distance = (static_cast<double>(i) - static_cast<double>(j)) / span;
      double w = i == j ? 1.0 : 0.0;
      if (weights == KappaWeights::kLinear) {
        w = 1.0 - std::abs(distance);
      }
      if (weights == KappaWeights::kQuadratic) {
        w = 1.0 - distance * distance;
      }
      agreement.at(i, j) = w;
    }
  }
  return kappaWithAgreement(table, agreement, confidence);
}

Outcome<KappaResult> cohenKappa(const NumberTable& table, const NumberTable& disagreement,
                                double confidence) {
  TORSIO_EXPECTS(table.rows() == table.columns() && disagreement.rows() == table.rows() &&
                 disagreement.columns() == table.rows());
  double largest = 0.0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    for (std::size_t j = 0; j < table.rows(); ++j) {
      largest = std::max(largest, disagreement.at(i, j));
    }
  }
  if (largest == 0.0) {
    return Outcome<KappaResult>::undefined(Text::tr("no disagreement has any weight"));
  }
  NumberTable agreement(table.rows(), table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    for (std::size_t j = 0; j < table.rows(); ++j) {
      agreement.at(i, j) = 1.0 - disagreement.at(i, j) / largest;
    }
  }
  return kappaWithAgreement(table, agreement, confidence);
}

Outcome<FleissResult> fleissKappa(const NumberTable& counts) {
  if (counts.rows() < 1 || counts.columns() < 2) {
    return Outcome<FleissResult>::undefined(Text::tr("kappa needs subjects and at least two categories"));
  }
  double m = 0.0;
  for (const double count : counts.row(0)) {
    m += count;
  }
  if (m < 2.0) {
    return Outcome<FleissResult>::undefined(Text::tr("there are fewer than two raters"));
  }
  const double n = static_cast<double>(counts.rows());
  FleissResult out;
  std::vector<double> shares(counts.columns(), 0.0);
  std::vector<double> disagreements(counts.columns(), 0.0);
  for (std::size_t i = 0; i < counts.rows(); ++i) {
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t j = 0; j < counts.columns(); ++j) {
      const double count = counts.at(i, j);
      sum += count;
      squares += count * count;
      shares[j] += count / (n * m);
      disagreements[j] += count * (m - count);
    }
    if (sum != m) {
      throw Error(ErrorCode::kBadData,
                  Text::verbatim("the subjects were not all rated by the same number of raters"),
                  Text::verbatim("row %1", i + 1),
                  Text::verbatim("Use Krippendorff's alpha for incomplete ratings."));
    }
    out.observed += (squares - m) / (m * (m - 1.0)) / n;
  }
  double pq = 0.0;
  double skew = 0.0;
  for (std::size_t j = 0; j < shares.size(); ++j) {
    const double p = shares[j];
    const double q = 1.0 - p;
    out.expected += p * p;
    pq += p * q;
    skew += p * q * (q - p);
    out.byCategory.push_back(std::nullopt);
    if (p > 0.0 && p < 1.0) {
      out.byCategory[j] = 1.0 - disagreements[j] / (n * m * (m - 1.0) * p * q);
    }
  }
  if (pq == 0.0) {
    return Outcome<FleissResult>::undefined(Text::tr("only one category was used"));
  }
  out.kappa = (out.observed - out.expected) / (1.0 - out.expected);
  out.errorByCategory = std::sqrt(2.0 / (n * m * (m - 1.0)));
  out.errorUnderNull = out.errorByCategory * std::sqrt(pq * pq - skew) / pq;
  out.z = out.kappa / out.errorUnderNull;
  return out;
}

}  // namespace torsio
