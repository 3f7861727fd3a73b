// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace torsio {

/// Persons x raters, categories from 0; empty where a rater has not rated a person.
using CategoryRatings = std::vector<std::vector<std::optional<int>>>;

/// Why a person or a rater has no estimate of its own.
enum class RaschStatus {
  kEstimated,
  kExtremeLow,   ///< every rating in the lowest category: minus infinity
  kExtremeHigh,  ///< every rating in the highest category: plus infinity
  kNoRatings,
};

/// Who has rated whom, and whether a rating scale model can be estimated from it. Extreme persons and raters
/// are set aside until none is left: without one, another may have become extreme.
class RatingPlan {
 public:
  /// `ratings` has rows of equal length with categories from 0 to `highest` and outlives the plan.
  RatingPlan(const CategoryRatings& ratings, int highest);

  [[nodiscard]] int highest() const noexcept { return highest_; }
  [[nodiscard]] const std::vector<RaschStatus>& persons() const noexcept { return persons_; }
  [[nodiscard]] const std::vector<RaschStatus>& raters() const noexcept { return raters_; }
  /// Numbers of those who are not set aside.
  [[nodiscard]] std::vector<std::size_t> estimatedPersons() const;
  [[nodiscard]] std::vector<std::size_t> estimatedRaters() const;
  /// True when the rater has rated the person and neither is set aside.
  [[nodiscard]] bool used(std::size_t person, std::size_t rater) const;
  /// The category that the rater gave to the person; there is one (contract).
  [[nodiscard]] int mark(std::size_t person, std::size_t rater) const;
  /// True when all that are not set aside are linked by ratings.
  [[nodiscard]] bool connected() const;
  /// Names what the ratings leave free to grow without end, "rater 3 and the thresholds"; empty when the
  /// likelihood has one finite maximum. Exact. The plan is connected, has two raters and uses every category
  /// (contract of the caller).
  [[nodiscard]] std::optional<std::string> unbounded() const;

 private:
  [[nodiscard]] std::vector<int> personRatings(std::size_t person) const;
  [[nodiscard]] std::vector<int> raterRatings(std::size_t rater) const;
  bool judge(RaschStatus& status, const std::vector<int>& marks, bool person) const;

  const CategoryRatings& ratings_;
  int highest_;
  std::vector<RaschStatus> persons_;
  std::vector<RaschStatus> raters_;
};

}  // namespace torsio
