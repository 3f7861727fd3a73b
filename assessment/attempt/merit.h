// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "assessment/attempt/measured_trial.h"

namespace torsio {

/// A quantity on which a hand can be praised or corrected.
struct MeritCriterion {
  std::string_view metric;  ///< id of a card
  double floor = 0.0;   ///< difference that nobody can see, so that a ratio to nearly nothing says nothing
  double weight = 1.0;  ///< larger for a metric that is a logarithm already and moves little
};

/// The criteria of a debrief.
[[nodiscard]] std::span<const MeritCriterion> meritCriteria();

/// Returns how much better `own` is than `expert`: a weighted logarithm of their ratio, 0 when they are
/// equal, negative when worse.
[[nodiscard]] double merit(const MeritCriterion& criterion, double own, double expert);

/// One value of one twist beside the expert's.
struct TwistMerit {
  std::size_t twist = 0;  ///< position among the completed twists
  double value = 0.0;     ///< of that twist, SI
  double merit = 0.0;
};

/// One criterion over a whole run.
struct CriterionMerit {
  std::string_view metric;
  double expert = 0.0;  ///< median over the expert's twists
  double merit = 0.0;   ///< of the median over the run's twists
  TwistMerit best{};
  TwistMerit worst{};
};

/// Compares a run with the expert's by every criterion that is defined for both, best first. Only completed
/// twists count, on both sides.
[[nodiscard]] std::vector<CriterionMerit> meritsAgainst(const MeasuredTrial& own,
                                                        const MeasuredTrial& expert);

}  // namespace torsio
