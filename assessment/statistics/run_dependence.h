// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "assessment/statistics/cusum.h"

namespace torsio {

/// Outcomes of one person's attempts by session, oldest first; true: failed.
using SessionOutcomes = std::vector<std::vector<bool>>;

/// How attempts depend on each other, as far as records tell.
struct EstimatedDependence {
  /// Upper bounds of 95 % of both correlations, so that what is printed after a few hundred attempts is not
  /// too good by chance; empty: too few attempts, people, or pairs that differ.
  std::optional<AttemptDependence> dependence{};
  std::int64_t attempts = 0;
  std::int64_t people = 0;
  /// How many attempts the session of a typical attempt has: the mean length of sessions, each counted once
  /// for every attempt in it, rounded up; 0 without attempts. Long sessions make false passes likelier than
  /// short ones.
  std::int64_t runsOfSession = 0;
};

/// Fewest attempts and people from which a dependence is estimated.
inline constexpr std::int64_t kMinDependenceAttempts = 400;
inline constexpr std::int64_t kMinDependencePeople = 10;

/// Estimates how attempts of one person depend on each other, by moments: how much more often two attempts of
/// one session, and two successive ones, both fail than two of different sessions of the same person. People
/// may have different failure rates; learning makes the estimates larger.
[[nodiscard]] EstimatedDependence estimateDependence(std::span<const SessionOutcomes> people);

}  // namespace torsio
