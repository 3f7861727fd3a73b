// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace torsio {

/// Persons x raters, categories from 0; empty if not rated.
using CategoryRatings = std::vector<std::vector<std::optional<int>>>;

/// Whether a person or rater has an estimate, or why not.
enum class RaschStatus {
  kEstimated,
  kExtremeLow,   ///< every rating in the lowest category: minus infinity
  kExtremeHigh,  ///< every rating in the highest category: plus infinity
  kNoRatings,
};

/// Parameters without a finite estimate.
struct UnboundedParameters {
  std::vector<std::size_t> raters;  ///< whose severity, by their index
  bool thresholds = false;
};

/// The rating design, and whether a rating scale model can be estimated from it. Extreme persons and raters
/// are removed until none is left: removing one may make another extreme.
class RatingPlan {
 public:
  /// `ratings` must have rows of equal length with categories 0 to `highest`, and outlive the plan.
  RatingPlan(const CategoryRatings& ratings, int highest);

  [[nodiscard]] int highest() const noexcept { return highest_; }
  [[nodiscard]] const std::vector<RaschStatus>& persons() const noexcept { return persons_; }
  [[nodiscard]] const std::vector<RaschStatus>& raters() const noexcept { return raters_; }
  /// Returns the indices of those who were not removed.
  [[nodiscard]] std::vector<std::size_t> estimatedPersons() const;
  [[nodiscard]] std::vector<std::size_t> estimatedRaters() const;
  /// True if the rater has rated the person and neither was removed.
  [[nodiscard]] bool used(std::size_t person, std::size_t rater) const;
  /// Returns the category that the rater gave to the person; there must be one.
  [[nodiscard]] int mark(std::size_t person, std::size_t rater) const;
  /// True if all who were not removed are linked by ratings.
  [[nodiscard]] bool connected() const;
  /// Returns the parameters that the ratings leave unbounded; empty if the likelihood has one finite maximum.
  /// Exact. The plan must be connected, have two raters and use every category.
  [[nodiscard]] std::optional<UnboundedParameters> unbounded() const;

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
