// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/rank_tests.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "assessment/statistics/binomial_count.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"
#include "assessment/statistics/pair_order.h"
#include "sim/core/random.h"

namespace torsio {

namespace {

constexpr std::int64_t kTableLimit = 50'000'000;  // cells of a counting table
constexpr std::int64_t kMaxRankHalvings = 1'000;  // of a probability that must not vanish

/// Number of subsets of `size` integers by sum: counts[sum - offset], by dynamic programming.
struct SubsetSums {
  std::vector<std::int64_t> counts;
  std::int64_t offset = 0;
  std::int64_t total = 0;
};

std::optional<SubsetSums> subsetSums(std::vector<std::int64_t> values, std::size_t size,
                                     std::int64_t mostAdditions = std::numeric_limits<std::int64_t>::max()) {
  const std::optional<std::int64_t> total =
      binomialCount(static_cast<std::int64_t>(values.size()), static_cast<std::int64_t>(size));
  if (!total) {
    return std::nullopt;
  }
  const std::int64_t low = *std::min_element(values.begin(), values.end());
  for (std::int64_t& value : values) {
    value -= low;
  }
  std::sort(values.begin(), values.end());
  std::vector<std::int64_t> below(values.size() + 1, 0);  // sums of the smallest values
  std::partial_sum(values.begin(), values.end(), below.begin() + 1);
  const std::int64_t largest = below.back() - below[values.size() - size];
  if ((largest + 1) * static_cast<std::int64_t>(size + 1) > kTableLimit ||
      (largest + 1) * static_cast<std::int64_t>(size + 1) > mostAdditions / std::ssize(values)) {
    return std::nullopt;
  }
  const auto width = static_cast<std::size_t>(largest) + 1;
  std::vector<std::vector<std::int64_t>> table(size + 1, std::vector<std::int64_t>(width, 0));
  table[0][0] = 1;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t left = values.size() - 1 - i;
    const std::size_t fewest = size > left ? size - left : 1;  // with fewer, `size` is out of reach
    for (std::size_t taken = std::min(size, i + 1); taken >= fewest; --taken) {
      // The other values taken are at most the largest before this one.
      const auto reach = static_cast<std::size_t>(below[i] - below[i + 1 - taken]);
      const std::int64_t* from = table[taken - 1].data();
      std::int64_t* to = table[taken].data() + values[i];
      for (std::size_t sum = 0; sum <= reach; ++sum) {
        to[sum] += from[sum];
      }
    }
  }
  return SubsetSums{table[size], low * static_cast<std::int64_t>(size), *total};
}

void addExactMannWhitney(const std::optional<SubsetSums>& sums, const DoubledRanks& ranks, std::size_t n1,
                         std::int64_t doubledSum, MannWhitney& out) {
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

double medianDifference(std::span<const double> x, std::span<const double> y) {
  const PairDifferences all(x, y);
  return medianBy(all.count(), [&](std::int64_t rank) { return all.at(rank); });
}

/// Interval from the order statistics of the differences by the exact distribution of U without ties.
std::optional<Interval> shiftInterval(const std::optional<SubsetSums>& sums, const DoubledRanks& ranks,
                                      std::span<const double> x, std::span<const double> y,
                                      double confidence) {
  if (!sums || ranks.tieTerm != 0) {
    return std::nullopt;
  }
  const double tail = 0.5 * (1.0 - confidence);
  // Without ties the doubled rank sums are even and U = (sum - smallest) / 2.
  const auto smallest = static_cast<std::int64_t>(x.size() * (x.size() + 1));
  double below = 0.0;
  std::int64_t c = 0;
  const PairDifferences all(x, y);
  for (; c <= all.count(); ++c) {
    const std::int64_t sum = smallest + 2 * c - sums->offset;
    below +=
        static_cast<double>(sums->counts[static_cast<std::size_t>(sum)]) / static_cast<double>(sums->total);
    if (below > tail) {
      break;  // c is the smallest U with P(U <= c) > tail
    }
  }
  if (c == 0) {
    return std::nullopt;
  }
  return Interval{all.at(c - 1), all.at(all.count() - c)};
}

}  // namespace

Outcome<MannWhitney> mannWhitney(std::span<const double> x, std::span<const double> y, double confidence) {
  if (const std::optional<Text> reason = beyondArithmetic(x, y)) {
    return Outcome<MannWhitney>::undefined(*reason);
  }
  if (x.empty() || y.empty()) {
    return Outcome<MannWhitney>::undefined(Text::tr("a group is empty"));
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
    return Outcome<MannWhitney>::undefined(Text::tr("all values are the same"));
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
  const std::optional<SubsetSums> sums = subsetSums(ranks.ranks, x.size());
  addExactMannWhitney(sums, ranks, x.size(), doubledSum, out);
  out.hodgesLehmann = medianDifference(x, y);
  out.hodgesLehmannInterval = shiftInterval(sums, ranks, x, y, confidence);
  return out;
}

namespace {

/// Sets a p value from random arrangements. The observed one counts among them, so p is never 0.
void setRandom(std::int64_t count, std::int64_t draws, PermutationTest& out) {
  out.exact = false;
  out.count = count;
  out.total = draws;
  out.p = static_cast<double>(count + 1) / static_cast<double>(draws + 1);
  out.error = std::sqrt(out.p * (1.0 - out.p) / static_cast<double>(draws + 1));
}

/// Draws random subsets of `size` and sums them, relative to the sum of the smallest values.
Outcome<PermutationTest> randomSplits(std::vector<std::int64_t> values, std::size_t first,
                                      const MonteCarlo& choice) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const std::int64_t low = *least;
  const double n = static_cast<double>(values.size());
  constexpr double kLargest = 9e18;
  if ((static_cast<double>(*most) - static_cast<double>(low)) * n * n > kLargest) {
    return Outcome<PermutationTest>::undefined(Text::tr("the numbers are too large to add up exactly"));
  }
  for (std::int64_t& value : values) {
    value -= low;
  }
  const std::int64_t total = std::accumulate(values.begin(), values.end(), std::int64_t{0});
  std::int64_t sum =
      std::accumulate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first), std::int64_t{0});
  const std::size_t size = std::min(first, values.size() - first);
  if (size != first) {
    sum = total - sum;
  }
  std::sort(values.begin(), values.end());  // p does not depend on the order of the lines
  const auto distanceOf = [&](std::int64_t of) {
    return std::abs(std::ssize(values) * of - static_cast<std::int64_t>(size) * total);
  };
  const std::int64_t observed = distanceOf(sum);
  Random random(choice.seed);
  std::int64_t count = 0;
  for (std::int64_t draw = 0; draw < choice.draws; ++draw) {
    std::int64_t drawn = 0;
    for (std::size_t i = 0; i < size; ++i) {
      std::swap(values[i], values[i + random.bounded(values.size() - i)]);
      drawn += values[i];
    }
    count += distanceOf(drawn) >= observed ? 1 : 0;
  }
  PermutationTest out;
  setRandom(count, choice.draws, out);
  return out;
}

}  // namespace

Outcome<PermutationTest> permutationTest(std::span<const std::int64_t> x, std::span<const std::int64_t> y,
                                         const MonteCarlo& otherwise) {
  if (x.empty() || y.empty()) {
    return Outcome<PermutationTest>::undefined(Text::tr("a group is empty"));
  }
  std::vector<std::int64_t> all(x.begin(), x.end());
  all.insert(all.end(), y.begin(), y.end());
  const std::optional<SubsetSums> sums = subsetSums(all, x.size(), otherwise.mostAdditions);
  if (!sums) {
    return randomSplits(std::move(all), x.size(), otherwise);
  }
  const std::int64_t total = std::accumulate(all.begin(), all.end(), std::int64_t{0});
  const auto n = static_cast<std::int64_t>(all.size());
  const auto n1 = static_cast<std::int64_t>(x.size());
  // The difference of means orders like n * sum - n1 * total, an integer.
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

/// Number of the 2^n sign choices by sum of the positive values.
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

/// Counts how often random signs bring the sum of the positive values as far from its middle as `doubled`
/// (twice that sum minus the total), and how often to `positive` or more.
struct RandomSigns {
  std::int64_t two = 0;
  std::int64_t greater = 0;
};

/// The order of the magnitudes does not matter.
RandomSigns randomSigns(std::vector<std::int64_t> magnitudes, std::int64_t positive,
                        const MonteCarlo& choice) {
  std::sort(magnitudes.begin(), magnitudes.end());
  const std::int64_t total = std::accumulate(magnitudes.begin(), magnitudes.end(), std::int64_t{0});
  const std::int64_t observed = std::abs(2 * positive - total);
  Random random(choice.seed);
  RandomSigns out;
  constexpr int kBits = 64;
  for (std::int64_t draw = 0; draw < choice.draws; ++draw) {
    std::int64_t sum = 0;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < magnitudes.size(); ++i) {
      bits = i % kBits == 0 ? random.next() : bits >> 1U;
      sum += -static_cast<std::int64_t>(bits & 1U) & magnitudes[i];
    }
    out.two += std::abs(2 * sum - total) >= observed ? 1 : 0;
    out.greater += sum >= positive ? 1 : 0;
  }
  return out;
}

/// True if twice the sum of magnitudes does not overflow.
bool canBeAdded(const std::vector<std::int64_t>& magnitudes) {
  constexpr double kLargest = 4e18;
  return std::accumulate(magnitudes.begin(), magnitudes.end(), 0.0,
                         [](double sum, std::int64_t m) { return sum + static_cast<double>(m); }) < kLargest;
}

}  // namespace

Outcome<PermutationTest> pairedPermutationTest(std::span<const std::int64_t> differences,
                                               const MonteCarlo& otherwise) {
  if (differences.empty()) {
    return Outcome<PermutationTest>::undefined(Text::tr("there are no pairs"));
  }
  std::vector<std::int64_t> magnitudes;
  for (const std::int64_t d : differences) {
    magnitudes.push_back(std::abs(d));
  }
  if (!canBeAdded(magnitudes)) {
    return Outcome<PermutationTest>::undefined(Text::tr("the numbers are too large to add up exactly"));
  }
  std::int64_t positive = 0;
  for (const std::int64_t d : differences) {
    positive += std::max<std::int64_t>(d, 0);
  }
  const std::optional<std::vector<std::int64_t>> counts = signSums(magnitudes);
  PermutationTest out;
  if (!counts) {
    setRandom(randomSigns(magnitudes, positive, otherwise).two, otherwise.draws, out);
    return out;
  }
  const auto total = static_cast<std::int64_t>(counts->size()) - 1;
  const std::int64_t observed = std::abs(2 * positive - total);
  out.total = std::int64_t{1} << differences.size();
  for (std::size_t sum = 0; sum < counts->size(); ++sum) {
    if (std::abs(2 * static_cast<std::int64_t>(sum) - total) >= observed) {
      out.count += (*counts)[sum];
    }
  }
  out.p = static_cast<double>(out.count) / static_cast<double>(out.total);
  return out;
}

namespace {

/// Probability of each sum of the positive ranks over all sign choices; empty: too many additions. Only sums
/// of positive numbers: the relative error stays below the number of ranks times 1.2e-16.
std::vector<double> signProbabilities(const std::vector<std::int64_t>& ranks, std::int64_t mostAdditions) {
  const std::int64_t total = std::accumulate(ranks.begin(), ranks.end(), std::int64_t{0});
  if (total * std::ssize(ranks) > mostAdditions || std::ssize(ranks) > kMaxRankHalvings) {
    return {};
  }
  std::vector<double> p(static_cast<std::size_t>(total) + 1, 0.0);
  p[0] = 1.0;
  std::size_t reached = 0;
  for (const std::int64_t rank : ranks) {
    const auto step = static_cast<std::size_t>(rank);
    reached += step;
    for (std::size_t sum = reached; sum > 0; --sum) {
      p[sum] = 0.5 * (p[sum] + (sum >= step ? p[sum - step] : 0.0));
    }
    p[0] *= 0.5;
  }
  return p;
}

void setSignedRankP(const std::vector<std::int64_t>& ranks, std::int64_t doubledV,
                    const MonteCarlo& otherwise, SignedRank& out) {
  const std::vector<double> probabilities = signProbabilities(ranks, otherwise.mostAdditions);
  if (probabilities.empty()) {
    const RandomSigns random = randomSigns(ranks, doubledV, otherwise);
    PermutationTest test;
    setRandom(random.greater, otherwise.draws, test);
    out.pGreater = test.p;
    setRandom(random.two, otherwise.draws, test);
    out.pTwoSided = test.p;
    out.error = test.error;
    out.exact = false;
    return;
  }
  const std::int64_t total = std::ssize(probabilities) - 1;
  const std::int64_t observed = std::abs(2 * doubledV - total);
  double two = 0.0;
  double greater = 0.0;
  for (std::int64_t sum = 0; sum <= total; ++sum) {
    const double p = probabilities[static_cast<std::size_t>(sum)];
    two += std::abs(2 * sum - total) >= observed ? p : 0.0;
    greater += sum >= doubledV ? p : 0.0;
  }
  out.pTwoSided = std::min(1.0, two);
  out.pGreater = std::min(1.0, greater);
}

}  // namespace

Outcome<SignedRank> signedRank(std::span<const double> differences, const MonteCarlo& otherwise) {
  if (const std::optional<Text> reason = beyondArithmetic(differences)) {
    return Outcome<SignedRank>::undefined(*reason);
  }
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
    return Outcome<SignedRank>::undefined(differences.empty() ? Text::tr("there are no pairs")
                                                              : Text::tr("every difference is zero"));
  }
  const DoubledRanks ranks = doubledRanks(magnitudes);
  std::int64_t doubledV = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] > 0.0) {
      doubledV += ranks.ranks[i];
    }
  }
  out.v = 0.5 * static_cast<double>(doubledV);
  setSignedRankP(ranks.ranks, doubledV, otherwise, out);
  out.hodgesLehmann = medianOfPairMeans(kept);
  return out;
}

}  // namespace torsio
