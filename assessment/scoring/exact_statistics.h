// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "assessment/scoring/evaluation.h"

// Eqs. 25 and 26 over whole steps as integer fractions, rounded once. Private to this folder.

namespace torsio {

/// Returns the class weights in thousandths, in order.
[[nodiscard]] std::vector<std::int64_t> classWeights(const EvaluationInstrument& instrument);
/// Returns the index weights divided by their greatest common divisor.
[[nodiscard]] std::vector<std::int64_t> indexWeights(const EvaluationInstrument& instrument);
/// Divides weights by their greatest common divisor.
[[nodiscard]] std::vector<std::int64_t> reducedWeights(std::vector<std::int64_t> weights);

/// True if every product of Eqs. 25 and 26 stays below 2^53 for `n` marks of at most `maxSteps` and this
/// common denominator of the class means, so that one division of doubles rounds once.
[[nodiscard]] bool fitsDouble(std::int64_t n, std::int64_t maxSteps, double denominator,
                              std::int64_t stepsPerPoint);

/// Sums of one class's marks for one index, in steps.
struct ClassSums {
  std::int64_t n = 0;
  std::int64_t sum = 0;
  std::int64_t squares = 0;
};

/// Input of the statistics of one index, by class.
struct IndexInput {
  std::vector<ClassSums> classes;     ///< filled by exactStatistics
  std::vector<std::int64_t> weights;  ///< 0: the class does not count in M
  std::vector<bool> inVariance;       ///< whether a class enters the sum of Eq. 26
  std::int64_t stepsPerPoint = 1;
  std::int64_t maxSteps = 1;  ///< largest magnitude of a mark
};

/// Computes the statistics of one model index by index, keeping each M of Eq. 25 as an integer fraction so
/// that Eq. 27 is rounded once. Not thread-safe.
class ExactStatistics {
 public:
  ExactStatistics();
  ~ExactStatistics();
  ExactStatistics(const ExactStatistics&) = delete;
  ExactStatistics& operator=(const ExactStatistics&) = delete;

  /// Computes the statistics of the next index (Eqs. 25, 26); `values[c]`: marks of class c in steps. At
  /// least one class of nonzero weight must have a mark.
  [[nodiscard]] ScoreStatistics add(const std::vector<std::vector<std::int64_t>>& values, IndexInput in);
  /// Returns Eq. 27 over the indices added so far, in points; `weights`: one per index.
  [[nodiscard]] double weightedMean(std::span<const std::int64_t> weights, std::int64_t stepsPerPoint) const;

 private:
  struct Means;
  std::unique_ptr<Means> means_;
};

}  // namespace torsio
