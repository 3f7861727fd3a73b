// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/attempt/measured_trial.h"

namespace torsio {

/// One thing that was asked for.
struct TargetCheck {
  enum class Kind {
    kUndone,   ///< an organ that came twisted lies undone, hands off: value 1 or 0 of wanted 1
    kAngle,    ///< twists let go within the tolerance: value of wanted
    kHold,     ///< seconds on target before letting go: the shortest of the twists on target
    kForce,    ///< peak force below the limit
    kTorque,   ///< peak torque below the limit
    kMastery,  ///< a rule of the module: `metric`
  };
  Kind kind = Kind::kAngle;
  std::string metric{};  ///< of kMastery: id
  bool passed = false;
  std::optional<double> value{};  ///< SI; empty: not defined in this run
  double wanted = 0.0;
  bool atLeast = true;           ///< value >= wanted passes; false: value <= wanted
  std::int64_t streak = 0;       ///< of kMastery: in a row, this one included
  std::int64_t consecutive = 1;  ///< of kMastery: in a row needed
};

/// Checks a run against the rules of its exercise: the angle always (that the organ
/// is undone, of an untwisting), hold and limits where they are set. Only
/// completed twists count.
[[nodiscard]] std::vector<TargetCheck> targetChecks(const MeasuredTrial& run, const AttemptRules& rules);

}  // namespace torsio
