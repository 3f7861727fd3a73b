// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "assessment/attempt/measured_trial.h"

namespace torsio {

/// Returns how much better `own` is than `expert`: a weighted logarithm of their ratio; 0 if equal, negative
/// if worse. Weight and floor come from the quantity's row.
[[nodiscard]] double merit(Quantity quantity, double own, double expert);

/// A twist's value compared with the expert's.
struct TwistMerit {
  std::size_t twist = 0;  ///< index among the completed twists
  double value = 0.0;     ///< of this twist, SI
  double merit = 0.0;
};

/// One quantity over a whole run.
struct QuantityMerit {
  Quantity quantity{};
  double expert = 0.0;  ///< median over the expert's twists
  double merit = 0.0;   ///< for the median over the run's twists
  TwistMerit best{};
  TwistMerit worst{};
};

/// Compares a run with the expert's by every quantity that has a weight and is defined for both, best first.
/// Uses completed twists only, on both sides.
[[nodiscard]] std::vector<QuantityMerit> meritsAgainst(const MeasuredTrial& own, const MeasuredTrial& expert);

}  // namespace torsio
