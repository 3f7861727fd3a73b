// SPDX-License-Identifier: GPL-3.0-or-later
// The rank tests of several samples: Kruskal and Wallis with Dunn's pairs, Friedman.
#include <cmath>
#include <numeric>

#include "assessment/statistics/binomial_count.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"
#include "assessment/statistics/multiplicity.h"
#include "assessment/statistics/rank_tests.h"

namespace torsio {

namespace {

constexpr std::int64_t kEnumerationLimit = 2'000'000;

/// Counts the assignments of ranks to groups whose H is at least the observed one, group by group.
class KruskalCounter {
 public:
  KruskalCounter(const std::vector<std::int64_t>& ranks, const std::vector<std::size_t>& sizes)
      : ranks_(ranks), sizes_(sizes), sums_(sizes.size(), 0), left_(sizes) {
    std::int64_t lcm = 1;
    for (const std::size_t size : sizes) {
      lcm = std::lcm(lcm, static_cast<std::int64_t>(size));
    }
    for (const std::size_t size : sizes) {
      factors_.push_back(lcm / static_cast<std::int64_t>(size));
    }
  }

  /// H orders like the sum of squared rank sums over group sizes; times the common multiple it is an integer.
  [[nodiscard]] std::int64_t order(const std::vector<std::int64_t>& sums) const {
    std::int64_t value = 0;
    for (std::size_t g = 0; g < sums.size(); ++g) {
      value += factors_[g] * sums[g] * sums[g];
    }
    return value;
  }

  void count(std::int64_t observed) {
    observed_ = observed;
    assign(0);
  }

  std::int64_t extreme = 0;
  std::int64_t total = 0;

 private:
  void assign(std::size_t i) {
    if (i == ranks_.size()) {
      ++total;
      if (order(sums_) >= observed_) {
        ++extreme;
      }
      return;
    }
    for (std::size_t g = 0; g < sizes_.size(); ++g) {
      if (left_[g] == 0) {
        continue;
      }
      --left_[g];
      sums_[g] += ranks_[i];
      assign(i + 1);
      sums_[g] -= ranks_[i];
      ++left_[g];
    }
  }

  const std::vector<std::int64_t>& ranks_;
  const std::vector<std::size_t>& sizes_;
  std::vector<std::int64_t> factors_;
  std::vector<std::int64_t> sums_;
  std::vector<std::size_t> left_;
  std::int64_t observed_ = 0;
};

void addExactKruskal(const DoubledRanks& ranks, const Groups& groups,
                     const std::vector<std::int64_t>& doubledSums, KruskalWallis& out) {
  std::vector<std::size_t> sizes;
  std::int64_t arrangements = 1;
  std::int64_t seated = 0;
  for (const std::vector<double>& group : groups) {
    sizes.push_back(group.size());
    seated += static_cast<std::int64_t>(group.size());
    const std::optional<std::int64_t> ways = binomialCount(seated, static_cast<std::int64_t>(group.size()));
    if (!ways || *ways > kEnumerationLimit || arrangements * *ways > kEnumerationLimit) {
      return;
    }
    arrangements *= *ways;
  }
  KruskalCounter counter(ranks.ranks, sizes);
  counter.count(counter.order(doubledSums));
  out.exactCount = counter.extreme;
  out.exactTotal = counter.total;
  out.pExact = static_cast<double>(counter.extreme) / static_cast<double>(counter.total);
}

void addDunn(const Groups& groups, double n, KruskalWallis& out) {
  const double common = n * (n + 1.0) / 12.0 - out.tieTerm / (12.0 * (n - 1.0));
  std::vector<double> p;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = i + 1; j < groups.size(); ++j) {
      DunnPair pair;
      pair.first = i;
      pair.second = j;
      pair.difference = out.meanRanks[j] - out.meanRanks[i];
      pair.error = std::sqrt(common * (1.0 / static_cast<double>(groups[i].size()) +
                                       1.0 / static_cast<double>(groups[j].size())));
      pair.z = pair.difference / pair.error;
      pair.p = normalTwoSided(pair.z);
      p.push_back(pair.p);
      out.pairs.push_back(pair);
    }
  }
  const std::vector<double> adjusted = adjustHolm(p);
  for (std::size_t i = 0; i < adjusted.size(); ++i) {
    out.pairs[i].pHolm = adjusted[i];
  }
}

}  // namespace

Outcome<KruskalWallis> kruskalWallis(const Groups& given) {
  using Undefined = Outcome<KruskalWallis>;
  const auto [groups, numbers] = presentGroups(given);
  if (groups.size() < 2) {
    return Undefined::undefined(Text::tr("fewer than two groups have values"));
  }
  std::vector<double> all;
  for (const std::vector<double>& group : groups) {
    all.insert(all.end(), group.begin(), group.end());
  }
  const DoubledRanks ranks = doubledRanks(all);
  const double n = static_cast<double>(all.size());
  const double k = static_cast<double>(groups.size());
  KruskalWallis out;
  out.tieTerm = static_cast<double>(ranks.tieTerm);
  out.tieCorrection = 1.0 - out.tieTerm / (n * n * n - n);
  if (!(out.tieCorrection > 0.0)) {
    return Undefined::undefined(Text::tr("all values are the same"));
  }
  std::vector<std::int64_t> doubledSums;
  std::size_t at = 0;
  double spread = 0.0;
  for (const std::vector<double>& group : groups) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < group.size(); ++i) {
      sum += ranks.ranks[at++];
    }
    doubledSums.push_back(sum);
    const double size = static_cast<double>(group.size());
    out.meanRanks.push_back(0.5 * static_cast<double>(sum) / size);
    const double d = out.meanRanks.back() - 0.5 * (n + 1.0);
    spread += size * d * d;
  }
  out.hUncorrected = 12.0 / (n * (n + 1.0)) * spread;
  out.h = out.hUncorrected / out.tieCorrection;
  out.df = k - 1.0;
  out.p = chiSquaredUpper(out.h, out.df);
  out.epsilonSquared = out.h / (n - 1.0);
  out.etaSquaredH = n > k ? (out.h - k + 1.0) / (n - k) : 0.0;
  addExactKruskal(ranks, groups, doubledSums, out);
  addDunn(groups, n, out);
  for (DunnPair& pair : out.pairs) {
    pair.first = numbers[pair.first];
    pair.second = numbers[pair.second];
  }
  return out;
}

Outcome<Friedman> friedman(const NumberTable& values) {
  if (values.rows() < 2 || values.columns() < 2) {
    return Outcome<Friedman>::undefined(Text::tr("the test needs at least two blocks and two treatments"));
  }
  const double n = static_cast<double>(values.rows());
  const double k = static_cast<double>(values.columns());
  std::vector<std::int64_t> doubledSums(values.columns(), 0);
  double ties = 0.0;
  for (std::size_t i = 0; i < values.rows(); ++i) {
    const DoubledRanks ranks = doubledRanks(values.row(i));
    ties += static_cast<double>(ranks.tieTerm);
    for (std::size_t j = 0; j < values.columns(); ++j) {
      doubledSums[j] += ranks.ranks[j];
    }
  }
  const double denominator = n * k * (k + 1.0) - ties / (k - 1.0);
  if (!(denominator > 0.0)) {
    return Outcome<Friedman>::undefined(Text::tr("every block ties all treatments"));
  }
  Friedman out;
  double spread = 0.0;
  for (const std::int64_t sum : doubledSums) {
    out.rankSums.push_back(0.5 * static_cast<double>(sum));
    const double d = out.rankSums.back() - 0.5 * n * (k + 1.0);
    spread += d * d;
  }
  out.chiSquared = 12.0 * spread / denominator;
  out.df = k - 1.0;
  out.p = chiSquaredUpper(out.chiSquared, out.df);
  out.kendallW = out.chiSquared / (n * (k - 1.0));
  const double rest = n * (k - 1.0) - out.chiSquared;
  constexpr double kRounding = 1e-12;
  if (rest > kRounding * n * (k - 1.0)) {
    out.imanDavenport = (n - 1.0) * out.chiSquared / rest;
    out.pImanDavenport = fUpper(*out.imanDavenport, k - 1.0, (k - 1.0) * (n - 1.0));
  }
  return out;
}

}  // namespace torsio
