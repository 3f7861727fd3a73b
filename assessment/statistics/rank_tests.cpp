// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/rank_tests.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"
#include "assessment/statistics/multiplicity.h"

namespace torsio {

namespace {

constexpr std::int64_t kCountLimit = std::int64_t{1} << 53;  // counts stay exact as doubles
constexpr std::int64_t kTableLimit = 50'000'000;             // cells of a counting table
constexpr std::int64_t kEnumerationLimit = 2'000'000;

/// n over k, or nothing beyond 2^53.
std::optional<std::int64_t> choose(std::int64_t n, std::int64_t k) {
  std::int64_t value = 1;
  for (std::int64_t i = 1; i <= std::min(k, n - k); ++i) {
    const std::int64_t factor = n - i + 1;
    if (value > std::numeric_limits<std::int64_t>::max() / factor) {
      return std::nullopt;
    }
    value = value * factor / i;
    if (value > kCountLimit) {
      return std::nullopt;
    }
  }
  return value;
}

/// How many subsets of `size` of the whole numbers have each sum: counts[sum - offset], by dynamic
/// programming.
struct SubsetSums {
  std::vector<std::int64_t> counts;
  std::int64_t offset = 0;
  std::int64_t total = 0;
};

std::optional<SubsetSums> subsetSums(std::vector<std::int64_t> values, std::size_t size) {
  const std::optional<std::int64_t> total =
      choose(static_cast<std::int64_t>(values.size()), static_cast<std::int64_t>(size));
  if (!total) {
    return std::nullopt;
  }
  const std::int64_t low = *std::min_element(values.begin(), values.end());
  std::int64_t largest = 0;
  for (std::int64_t& value : values) {
    value -= low;
  }
  std::sort(values.begin(), values.end(), std::greater<>());
  for (std::size_t i = 0; i < size; ++i) {
    largest += values[i];
  }
  if ((largest + 1) * static_cast<std::int64_t>(size + 1) > kTableLimit) {
    return std::nullopt;
  }
  const auto width = static_cast<std::size_t>(largest) + 1;
  std::vector<std::vector<std::int64_t>> table(size + 1, std::vector<std::int64_t>(width, 0));
  table[0][0] = 1;
  for (const std::int64_t value : values) {
    const auto step = static_cast<std::size_t>(value);
    for (std::size_t taken = size; taken >= 1; --taken) {
      for (std::size_t sum = width; sum-- > step;) {
        table[taken][sum] += table[taken - 1][sum - step];
      }
    }
  }
  return SubsetSums{table[size], low * static_cast<std::int64_t>(size), *total};
}

void addExactMannWhitney(const DoubledRanks& ranks, std::size_t n1, std::int64_t doubledSum,
                         MannWhitney& out) {
  const std::optional<SubsetSums> sums = subsetSums(ranks.ranks, n1);
  if (!sums) {
    return;
  }
  const auto n = static_cast<std::int64_t>(ranks.ranks.size());
  // The middle of the doubled rank sums is n1 (N + 1).
  const std::int64_t middle = static_cast<std::int64_t>(n1) * (n + 1);
  const std::int64_t distance = std::abs(doubledSum - middle);
  std::int64_t two = 0;
  std::int64_t greater = 0;
  for (std::size_t i = 0; i < sums->counts.size(); ++i) {
    const std::int64_t sum = sums->offset + static_cast<std::int64_t>(i);
    if (std::abs(sum - middle) >= distance) {
      two += sums->counts[i];
    }
    if (sum >= doubledSum) {
      greater += sums->counts[i];
    }
  }
  out.arrangements = sums->total;
  out.countTwoSided = two;
  out.countGreater = greater;
  out.pExact = static_cast<double>(two) / static_cast<double>(sums->total);
  out.pGreater = static_cast<double>(greater) / static_cast<double>(sums->total);
}

/// Order statistics of the differences that the exact distribution of U without ties leaves uncertain.
std::optional<Interval> shiftInterval(const DoubledRanks& ranks, std::size_t n1, std::size_t n2,
                                      std::vector<double> differences, double confidence) {
  const std::optional<SubsetSums> sums = subsetSums(ranks.ranks, n1);
  if (!sums || ranks.tieTerm != 0) {
    return std::nullopt;
  }
  const double tail = 0.5 * (1.0 - confidence);
  // Without ties the doubled rank sums are even and U = (sum - smallest) / 2.
  const auto smallest = static_cast<std::int64_t>(n1 * (n1 + 1));
  double below = 0.0;
  std::size_t c = 0;
  for (; c <= n1 * n2; ++c) {
    const std::int64_t sum = smallest + 2 * static_cast<std::int64_t>(c) - sums->offset;
    below +=
        static_cast<double>(sums->counts[static_cast<std::size_t>(sum)]) / static_cast<double>(sums->total);
    if (below > tail) {
      break;  // c is the smallest U with P(U <= c) > tail
    }
  }
  if (c == 0) {
    return std::nullopt;
  }
  std::sort(differences.begin(), differences.end());
  return Interval{differences[c - 1], differences[differences.size() - c]};
}

}  // namespace

Outcome<MannWhitney> mannWhitney(std::span<const double> x, std::span<const double> y, double confidence) {
  if (x.empty() || y.empty()) {
    return Outcome<MannWhitney>::undefined("a group is empty");
  }
  std::vector<double> all(x.begin(), x.end());
  all.insert(all.end(), y.begin(), y.end());
  const DoubledRanks ranks = doubledRanks(all);
  const double n1 = static_cast<double>(x.size());
  const double n2 = static_cast<double>(y.size());
  const double n = n1 + n2;
  const double ties = static_cast<double>(ranks.tieTerm);
  const double variance = n1 * n2 / 12.0 * (n + 1.0 - ties / (n * (n - 1.0)));
  if (!(variance > 0.0)) {
    return Outcome<MannWhitney>::undefined("all values are the same");
  }
  const std::int64_t doubledSum = std::accumulate(
      ranks.ranks.begin(), ranks.ranks.begin() + static_cast<std::ptrdiff_t>(x.size()), std::int64_t{0});
  MannWhitney out;
  out.u = 0.5 * static_cast<double>(doubledSum) - 0.5 * n1 * (n1 + 1.0);
  out.superiority = out.u / (n1 * n2);
  out.cliffDelta = 2.0 * out.superiority - 1.0;
  out.ties = ranks.tieTerm > 0;
  const double distance = out.u - 0.5 * n1 * n2;
  const double sign = distance > 0.0 ? 1.0 : distance < 0.0 ? -1.0 : 0.0;
  out.z = distance / std::sqrt(variance);
  out.pNormal = std::min(1.0, normalTwoSided(out.z));
  out.zCorrected = (distance - 0.5 * sign) / std::sqrt(variance);
  out.pCorrected = std::min(1.0, normalTwoSided(out.zCorrected));
  addExactMannWhitney(ranks, x.size(), doubledSum, out);
  std::vector<double> differences;
  for (const double a : x) {
    for (const double b : y) {
      differences.push_back(a - b);
    }
  }
  out.hodgesLehmann = medianOf(differences);
  out.hodgesLehmannInterval = shiftInterval(ranks, x.size(), y.size(), differences, confidence);
  return out;
}

Outcome<PermutationTest> permutationTest(std::span<const std::int64_t> x, std::span<const std::int64_t> y) {
  if (x.empty() || y.empty()) {
    return Outcome<PermutationTest>::undefined("a group is empty");
  }
  std::vector<std::int64_t> all(x.begin(), x.end());
  all.insert(all.end(), y.begin(), y.end());
  const std::optional<SubsetSums> sums = subsetSums(all, x.size());
  if (!sums) {
    return Outcome<PermutationTest>::undefined("there are too many arrangements to count");
  }
  const std::int64_t total = std::accumulate(all.begin(), all.end(), std::int64_t{0});
  const auto n = static_cast<std::int64_t>(all.size());
  const auto n1 = static_cast<std::int64_t>(x.size());
  // The difference of means orders like n * sum - n1 * total, a whole number.
  const auto distanceOf = [&](std::int64_t sum) { return std::abs(n * sum - n1 * total); };
  const std::int64_t observed = distanceOf(std::accumulate(x.begin(), x.end(), std::int64_t{0}));
  PermutationTest out;
  out.total = sums->total;
  for (std::size_t i = 0; i < sums->counts.size(); ++i) {
    if (distanceOf(sums->offset + static_cast<std::int64_t>(i)) >= observed) {
      out.count += sums->counts[i];
    }
  }
  out.p = static_cast<double>(out.count) / static_cast<double>(out.total);
  return out;
}

namespace {

/// How many of the 2^n sign choices give each sum of the positive ones.
std::optional<std::vector<std::int64_t>> signSums(const std::vector<std::int64_t>& magnitudes) {
  const std::int64_t total = std::accumulate(magnitudes.begin(), magnitudes.end(), std::int64_t{0});
  if (magnitudes.size() > 52 || total > kTableLimit) {
    return std::nullopt;
  }
  std::vector<std::int64_t> counts(static_cast<std::size_t>(total) + 1, 0);
  counts[0] = 1;
  for (const std::int64_t magnitude : magnitudes) {
    for (std::size_t sum = counts.size(); sum-- > static_cast<std::size_t>(magnitude);) {
      counts[sum] += counts[sum - static_cast<std::size_t>(magnitude)];
    }
  }
  return counts;
}

}  // namespace

Outcome<PermutationTest> pairedPermutationTest(std::span<const std::int64_t> differences) {
  if (differences.empty()) {
    return Outcome<PermutationTest>::undefined("there are no pairs");
  }
  std::vector<std::int64_t> magnitudes;
  std::int64_t positive = 0;
  for (const std::int64_t d : differences) {
    magnitudes.push_back(std::abs(d));
    positive += std::max<std::int64_t>(d, 0);
  }
  const std::optional<std::vector<std::int64_t>> counts = signSums(magnitudes);
  if (!counts) {
    return Outcome<PermutationTest>::undefined("there are too many sign changes to count");
  }
  const auto total = static_cast<std::int64_t>(counts->size()) - 1;
  const std::int64_t observed = std::abs(2 * positive - total);
  PermutationTest out;
  out.total = std::int64_t{1} << differences.size();
  for (std::size_t sum = 0; sum < counts->size(); ++sum) {
    if (std::abs(2 * static_cast<std::int64_t>(sum) - total) >= observed) {
      out.count += (*counts)[sum];
    }
  }
  out.p = static_cast<double>(out.count) / static_cast<double>(out.total);
  return out;
}

Outcome<SignedRank> signedRank(std::span<const double> differences) {
  SignedRank out;
  std::vector<double> kept;
  std::vector<double> magnitudes;
  for (const double d : differences) {
    if (d == 0.0) {
      ++out.zeros;
      continue;
    }
    kept.push_back(d);
    magnitudes.push_back(std::abs(d));
  }
  out.n = kept.size();
  if (kept.empty()) {
    return Outcome<SignedRank>::undefined("every difference is zero");
  }
  const DoubledRanks ranks = doubledRanks(magnitudes);
  const std::optional<std::vector<std::int64_t>> counts = signSums(ranks.ranks);
  if (!counts) {
    return Outcome<SignedRank>::undefined("there are too many differences to count");
  }
  std::int64_t doubledV = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] > 0.0) {
      doubledV += ranks.ranks[i];
    }
  }
  out.v = 0.5 * static_cast<double>(doubledV);
  const auto total = static_cast<std::int64_t>(counts->size()) - 1;
  const std::int64_t observed = std::abs(2 * doubledV - total);
  std::int64_t two = 0;
  std::int64_t greater = 0;
  for (std::size_t sum = 0; sum < counts->size(); ++sum) {
    if (std::abs(2 * static_cast<std::int64_t>(sum) - total) >= observed) {
      two += (*counts)[sum];
    }
    if (static_cast<std::int64_t>(sum) >= doubledV) {
      greater += (*counts)[sum];
    }
  }
  const double choices = std::ldexp(1.0, static_cast<int>(kept.size()));
  out.pTwoSided = static_cast<double>(two) / choices;
  out.pGreater = static_cast<double>(greater) / choices;
  std::vector<double> means;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    for (std::size_t j = i; j < kept.size(); ++j) {
      means.push_back(0.5 * (kept[i] + kept[j]));
    }
  }
  out.hodgesLehmann = medianOf(means);
  return out;
}

namespace {

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

  /// H orders like the sum of squared rank sums over group sizes: a whole number times the common multiple.
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
    const std::optional<std::int64_t> ways = choose(seated, static_cast<std::int64_t>(group.size()));
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

Outcome<KruskalWallis> kruskalWallis(const Groups& groups) {
  using Undefined = Outcome<KruskalWallis>;
  if (groups.size() < 2) {
    return Undefined::undefined("there are fewer than two groups");
  }
  std::vector<double> all;
  for (const std::vector<double>& group : groups) {
    if (group.empty()) {
      return Undefined::undefined("a group is empty");
    }
    all.insert(all.end(), group.begin(), group.end());
  }
  const DoubledRanks ranks = doubledRanks(all);
  const double n = static_cast<double>(all.size());
  const double k = static_cast<double>(groups.size());
  KruskalWallis out;
  out.tieTerm = static_cast<double>(ranks.tieTerm);
  out.tieCorrection = 1.0 - out.tieTerm / (n * n * n - n);
  if (!(out.tieCorrection > 0.0)) {
    return Undefined::undefined("all values are the same");
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
  return out;
}

Outcome<Friedman> friedman(const NumberTable& values) {
  if (values.rows() < 2 || values.columns() < 2) {
    return Outcome<Friedman>::undefined("the test needs at least two blocks and two treatments");
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
    return Outcome<Friedman>::undefined("every block ties all treatments");
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
