// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "assessment/scoring/evaluation.h"

// Eqs. 25 and 26 over whole steps: fractions of whole numbers, rounded once. For the sources of this folder.

namespace torsio {

/// Returns the weights of the classes in thousandths, in their order.
[[nodiscard]] std::vector<std::int64_t> classWeights(const EvaluationInstrument& instrument);
/// Returns the weights of the indices over their greatest common divisor.
[[nodiscard]] std::vector<std::int64_t> indexWeights(const EvaluationInstrument& instrument);
/// Returns weights over their greatest common divisor: smaller numbers, the same shares.
[[nodiscard]] std::vector<std::int64_t> reducedWeights(std::vector<std::int64_t> weights);

/// Tells whether every product of Eqs. 25 and 26 stays under 2^53 for `n` marks of at most `maxSteps` and
/// this common denominator of the class means, so that one division of doubles rounds once.
[[nodiscard]] bool fitsDouble(std::int64_t n, std::int64_t maxSteps, double denominator,
                              std::int64_t stepsPerPoint);

/// Marks of one class for one index, as sums of whole steps.
struct ClassSums {
  std::int64_t n = 0;
  std::int64_t sum = 0;
  std::int64_t squares = 0;
};

/// What the statistics of one index are computed with, class by class.
struct IndexInput {
  std::vector<ClassSums> classes;     ///< filled by exactStatistics
  std::vector<std::int64_t> weights;  ///< 0 for a class that does not count in M
  std::vector<bool> inVariance;       ///< whether a class enters the sum of Eq. 26
  std::int64_t stepsPerPoint = 1;
  std::int64_t maxSteps = 1;  ///< largest size of a mark
};

/// Computes the statistics of one model index by index and keeps each M of Eq. 25 as a fraction of whole
/// numbers, so that Eq. 27 is rounded once. One thread at a time.
class ExactStatistics {
 public:
  ExactStatistics();
  ~ExactStatistics();
  ExactStatistics(const ExactStatistics&) = delete;
  ExactStatistics& operator=(const ExactStatistics&) = delete;

  /// Computes the statistics of the next index (Eqs. 25, 26); `values[c]`: marks of class c, steps. At least
  /// one class of a weight above 0 has a mark.
  [[nodiscard]] ScoreStatistics add(const std::vector<std::vector<std::int64_t>>& values, IndexInput in);
  /// Returns Eq. 27 over the indices so far, points; `weights`: one an index.
  [[nodiscard]] double weightedMean(std::span<const std::int64_t> weights, std::int64_t stepsPerPoint) const;

 private:
  struct Means;
  std::unique_ptr<Means> means_;
};

}  // namespace torsio
