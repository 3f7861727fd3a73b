// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/values.h"

namespace torsio {

// Only equal values tie: values that come from subtraction must be integers (exactGains).

struct MannWhitney {
  double u = 0.0;            ///< pairs with x > y, ties count half
  double superiority = 0.0;  ///< P(X > Y) = u / (n1 n2), ties count half
  double cliffDelta = 0.0;
  bool ties = false;
  double zCorrected = 0.0;  ///< tie-corrected, with continuity correction
  double pCorrected = 0.0;
  double z = 0.0;
  double pNormal = 0.0;
  /// Number of arrangements in the exact conditional distribution given the ties; empty above 2^53.
  std::optional<std::int64_t> arrangements;
  std::optional<std::int64_t> countTwoSided;  ///< arrangements at least as far from the middle
  std::optional<std::int64_t> countGreater;   ///< arrangements with u at least as large
  std::optional<double> pExact;               ///< two-sided
  std::optional<double> pGreater;
  double hodgesLehmann = 0.0;                     ///< median of all x - y
  std::optional<Interval> hodgesLehmannInterval;  ///< exact, without ties only
};
/// Compares two groups by the Mann-Whitney test. Undefined for an empty group or if all values are equal.
[[nodiscard]] Outcome<MannWhitney> mannWhitney(std::span<const double> x, std::span<const double> y,
                                               double confidence = kDefaultConfidence);

/// Random arrangements instead of all, where these are too many to count.
struct MonteCarlo {
  std::uint64_t seed = 1;
  std::int64_t draws = 99'999;
  std::int64_t mostAdditions =
      2'000'000'000;  ///< limit of additions for exact counting; beyond, arrangements are drawn at random
};

struct PermutationTest {
  std::int64_t count = 0;  ///< arrangements at least as extreme, two-sided
  std::int64_t total = 0;
  double p = 0.0;      ///< count / total; for random arrangements (count + 1) / (total + 1)
  bool exact = true;   ///< every arrangement was counted; otherwise `total` random ones
  double error = 0.0;  ///< standard error of p by random sampling; 0 if exact
};
/// Tests the difference of means of integers over all arrangements, by dynamic programming; never pass
/// differences of doubles. If there are too many arrangements, random ones are drawn. Undefined for an empty
/// group or if the sums overflow.
[[nodiscard]] Outcome<PermutationTest> permutationTest(std::span<const std::int64_t> x,
                                                       std::span<const std::int64_t> y,
                                                       const MonteCarlo& otherwise = {});
/// Tests paired differences over all sign changes, in the same way.
[[nodiscard]] Outcome<PermutationTest> pairedPermutationTest(std::span<const std::int64_t> differences,
                                                             const MonteCarlo& otherwise = {});

struct SignedRank {
  double v = 0.0;         ///< sum of the ranks of positive differences
  std::size_t n = 0;      ///< differences other than zero
  std::size_t zeros = 0;  ///< left out (Wilcoxon)
  double pTwoSided = 0.0;
  double pGreater = 0.0;
  bool exact = true;           ///< every sign change was counted; otherwise random ones
  double error = 0.0;          ///< standard error of pTwoSided by random sampling; 0 if exact
  double hodgesLehmann = 0.0;  ///< median of the pairwise means of differences
};
/// Tests paired differences by Wilcoxon's signed ranks, exact also with ties and for up to a thousand pairs.
/// If there are too many sign changes, random ones are drawn. `differences` must be free of rounding noise;
/// their order does not matter. Undefined if all are zero.
[[nodiscard]] Outcome<SignedRank> signedRank(std::span<const double> differences,
                                             const MonteCarlo& otherwise = {});

struct DunnPair {
  std::size_t first = 0;
  std::size_t second = 0;
  double difference = 0.0;  ///< mean rank of the second minus that of the first
  double error = 0.0;
  double z = 0.0;
  double p = 0.0;
  double pHolm = 0.0;
};

struct KruskalWallis {
  double h = 0.0;
  double hUncorrected = 0.0;
  double tieCorrection = 1.0;
  double tieTerm = 0.0;
  double df = 0.0;
  double p = 0.0;
  std::vector<double> meanRanks;  ///< of the groups with values
  double epsilonSquared = 0.0;    ///< H / (N - 1)
  double etaSquaredH = 0.0;       ///< (H - k + 1) / (N - k); some call this epsilon squared
  std::optional<std::int64_t> exactCount;
  std::optional<std::int64_t> exactTotal;
  std::optional<double> pExact;  ///< for at most two million arrangements
  std::vector<DunnPair> pairs;   ///< on the joint ranks
};
/// Compares groups by the Kruskal-Wallis test; empty groups are left out. Undefined for fewer than two groups
/// with values, or if all values are equal.
[[nodiscard]] Outcome<KruskalWallis> kruskalWallis(const Groups& groups);

struct Friedman {
  std::vector<double> rankSums;
  double chiSquared = 0.0;
  double df = 0.0;
  double p = 0.0;
  double kendallW = 0.0;
  std::optional<double> imanDavenport;  ///< F; empty if all blocks rank alike (W = 1)
  std::optional<double> pImanDavenport;
};
/// Compares treatments within blocks by Friedman's test. `values`: blocks (raters) x treatments (models).
/// Undefined if every block ties all treatments.
[[nodiscard]] Outcome<Friedman> friedman(const NumberTable& values);

}  // namespace torsio
