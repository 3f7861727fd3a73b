// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/categorical_agreement.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"
#include "assessment/statistics/quantiles.h"
#include "assessment/statistics/ratio_differences.h"
#include "sim/core/error.h"
#include "sim/core/random.h"

namespace torsio {

namespace {

/// The ratings that can be paired, as indices of the distinct values by unit.
struct PairableRatings {
  std::vector<double> values;                   // distinct, ascending
  std::vector<std::vector<std::size_t>> units;  // a unit with fewer than two ratings is empty
};

PairableRatings pairableRatings(const IncompleteRatings& ratings) {
  const std::size_t units = ratings.front().size();
  std::vector<std::vector<double>> rated(units);
  for (const auto& coder : ratings) {
    TORSIO_EXPECTS(coder.size() == units);
    for (std::size_t u = 0; u < units; ++u) {
      if (coder[u]) {
        rated[u].push_back(*coder[u]);
      }
    }
  }
  PairableRatings out;
  out.units.resize(units);
  for (const std::vector<double>& unit : rated) {
    if (unit.size() > 1) {
      out.values.insert(out.values.end(), unit.begin(), unit.end());
    }
  }
  std::sort(out.values.begin(), out.values.end());
  out.values.erase(std::unique(out.values.begin(), out.values.end()), out.values.end());
  for (std::size_t u = 0; u < units; ++u) {
    for (std::size_t i = 0; rated[u].size() > 1 && i < rated[u].size(); ++i) {
      out.units[u].push_back(static_cast<std::size_t>(
          std::lower_bound(out.values.begin(), out.values.end(), rated[u][i]) - out.values.begin()));
    }
  }
  return out;
}

/// Places the values on a line so that their squared difference is their squared distance: the values
/// themselves or, for ranks, the midrank of each value.
std::vector<double> placesOf(AlphaMetric metric, const std::vector<double>& values,
                             const std::vector<double>& counts) {
  if (metric != AlphaMetric::kOrdinal) {
    return values;
  }
  std::vector<double> places;
  double below = 0.0;
  for (const double count : counts) {
    places.push_back(below + 0.5 * count);
    below += count;
  }
  return places;
}

/// Sum of the squared differences between all ordered pairs of ratings of a unit.
double withinUnit(AlphaMetric metric, const std::vector<std::size_t>& unit,
                  const std::vector<double>& places) {
  const double m = static_cast<double>(unit.size());
  double sum = 0.0;
  if (metric == AlphaMetric::kInterval || metric == AlphaMetric::kOrdinal) {
    double mean = 0.0;
    for (const std::size_t value : unit) {
      mean += places[value] / m;
    }
    for (const std::size_t value : unit) {
      sum += (places[value] - mean) * (places[value] - mean);
    }
    return 2.0 * m * sum;
  }
  for (const std::size_t a : unit) {
    for (const std::size_t b : unit) {
      sum += metric == AlphaMetric::kRatio ? ratioDifference2(places[a], places[b]) : (a == b ? 0.0 : 1.0);
    }
  }
  return sum;
}

/// Sum of the squared differences between all ordered pairs of ratings, `counts[c]` of the value c.
double betweenAll(AlphaMetric metric, const std::vector<double>& places, const std::vector<double>& counts,
                  double n) {
  double sum = 0.0;
  switch (metric) {
    case AlphaMetric::kNominal:
      for (const double count : counts) {
        sum += count * (n - count);
      }
      return sum;
    case AlphaMetric::kRatio:
      return sumOfRatioDifferences2(places, counts);
    case AlphaMetric::kOrdinal:
    case AlphaMetric::kInterval:
      break;
  }
  double mean = 0.0;
  for (std::size_t c = 0; c < places.size(); ++c) {
    mean += counts[c] / n * places[c];
  }
  for (std::size_t c = 0; c < places.size(); ++c) {
    sum += counts[c] * (places[c] - mean) * (places[c] - mean);
  }
  return 2.0 * n * sum;
}

/// Alpha of ratings with unit u repeated `copies[u]` times; what does not depend on the copies is cached.
class AlphaOfCopies {
 public:
  AlphaOfCopies(const PairableRatings& ratings, AlphaMetric metric) : ratings_(ratings), metric_(metric) {
    if (metric_ != AlphaMetric::kOrdinal) {
      for (const std::vector<std::size_t>& unit : ratings_.units) {
        within_.push_back(withinUnit(metric_, unit, ratings_.values));
      }
    }
  }

  [[nodiscard]] Outcome<KrippendorffResult> alpha(const std::vector<int>& copies) {
    using Undefined = Outcome<KrippendorffResult>;
    KrippendorffResult out;
    counts_.assign(ratings_.values.size(), 0.0);
    for (std::size_t u = 0; u < copies.size(); ++u) {
      out.pairable += copies[u] * std::ssize(ratings_.units[u]);
      for (const std::size_t value : ratings_.units[u]) {
        counts_[value] += copies[u];
      }
    }
    if (out.pairable == 0) {
      return Undefined::undefined(Text::tr("no unit has two ratings"));
    }
    if (std::ranges::count_if(counts_, [](double count) { return count > 0.0; }) < 2) {
      return Undefined::undefined(Text::tr("every rating is the same"));
    }
    const double n = static_cast<double>(out.pairable);
    const std::vector<double> places = placesOf(metric_, ratings_.values, counts_);
    for (std::size_t u = 0; u < copies.size(); ++u) {
      const std::vector<std::size_t>& unit = ratings_.units[u];
      if (copies[u] > 0 && !unit.empty()) {
        const double within = within_.empty() ? withinUnit(metric_, unit, places) : within_[u];
        out.observed += copies[u] * within / static_cast<double>(unit.size() - 1) / n;
      }
    }
    out.expected = betweenAll(metric_, places, counts_, n) / (n * (n - 1.0));
    if (out.expected == 0.0) {
      return Undefined::undefined(Text::tr("the values do not differ under this metric"));
    }
    if (!std::isfinite(out.observed) || !std::isfinite(out.expected)) {
      return Undefined::undefined(Text::tr("the values are too large to be squared"));
    }
    out.alpha = 1.0 - out.observed / out.expected;
    return out;
  }

 private:
  const PairableRatings& ratings_;
  AlphaMetric metric_;
  std::vector<double> within_;  // by unit; empty: depends on the copies
  std::vector<double> counts_;
};

}  // namespace

Outcome<KrippendorffResult> krippendorffAlpha(const IncompleteRatings& ratings, AlphaMetric metric) {
  if (ratings.size() < 2) {
    return Outcome<KrippendorffResult>::undefined(Text::tr("there are fewer than two coders"));
  }
  const PairableRatings pairable = pairableRatings(ratings);
  return AlphaOfCopies(pairable, metric).alpha(std::vector<int>(pairable.units.size(), 1));
}

namespace {

/// Orders the units by their ratings, so that resampling does not depend on the order of lines or coders.
std::vector<std::size_t> unitsInOrder(const IncompleteRatings& ratings) {
  std::vector<std::vector<double>> marks(ratings.front().size());
  for (std::size_t unit = 0; unit < marks.size(); ++unit) {
    for (const auto& coder : ratings) {
      if (coder[unit]) {
        marks[unit].push_back(*coder[unit]);
      }
    }
    std::sort(marks[unit].begin(), marks[unit].end());
  }
  std::vector<std::size_t> order(marks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return marks[a] < marks[b]; });
  return order;
}

}  // namespace

Outcome<AlphaBootstrap> krippendorffInterval(const IncompleteRatings& ratings, AlphaMetric metric,
                                             std::uint64_t seed, int resamples, double confidence) {
  const Outcome<KrippendorffResult> point = krippendorffAlpha(ratings, metric);
  if (!point) {
    return Outcome<AlphaBootstrap>::undefined(point.reason());
  }
  const PairableRatings pairable = pairableRatings(ratings);
  constexpr std::size_t kMaxRatios = 300;  // each resample compares every value with every other
  if (metric == AlphaMetric::kRatio && pairable.values.size() > kMaxRatios) {
    return Outcome<AlphaBootstrap>::undefined(
        Text::tr("there are more than %1 distinct values to compare in each resample", kMaxRatios));
  }
  AlphaOfCopies statistic(pairable, metric);
  Random random(seed);
  const std::vector<std::size_t> inOrder = unitsInOrder(ratings);
  const std::size_t units = inOrder.size();
  AlphaBootstrap out;
  out.resamples = resamples;
  std::vector<double> alphas;
  std::vector<int> copies(units);
  for (int b = 0; b < resamples; ++b) {
    std::fill(copies.begin(), copies.end(), 0);
    for (std::size_t u = 0; u < units; ++u) {
      ++copies[inOrder[random.bounded(units)]];
    }
    const Outcome<KrippendorffResult> alpha = statistic.alpha(copies);
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

Outcome<double> quadraticKappa(std::span<const double> first, std::span<const double> second) {
  TORSIO_EXPECTS(first.size() == second.size());
  if (first.size() < 2) {
    return Outcome<double>::undefined(Text::tr("there are fewer than two targets"));
  }
  // Observed disagreement, and that between every mark of one rater and every mark of the other.
  double observed = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    observed += (first[i] - second[i]) * (first[i] - second[i]);
  }
  const double apart = meanOf(first) - meanOf(second);
  const double expected =
      sumOfSquares(first) + sumOfSquares(second) + static_cast<double>(first.size()) * apart * apart;
  if (expected == 0.0) {
    return Outcome<double>::undefined(Text::tr("every rating is the same"));
  }
  return 1.0 - observed / expected;
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
      refuse(Text::verbatim("the subjects were not all rated by the same number of raters"),
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
