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

/// Dependence of attempts as estimated from records.
struct EstimatedDependence {
  AttemptDependence dependence{};
  std::int64_t attempts = 0;
  std::int64_t people = 0;
};

/// Fewest attempts and people from which a dependence is estimated.
inline constexpr std::int64_t kMinDependenceAttempts = 400;
inline constexpr std::int64_t kMinDependencePeople = 10;

/// Estimates how attempts of one person depend on each other, by moments: how much more often two attempts of
/// one session, and two successive ones, both fail than two of different sessions of the same person. People
/// may have different failure rates; learning makes the estimates larger. Empty with too few attempts,
/// people, or pairs that differ.
[[nodiscard]] std::optional<EstimatedDependence> estimateDependence(std::span<const SessionOutcomes> people);

}  // namespace torsio
