// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assessment/attempt/measured_trial.h"

namespace torsio {

/// One thing that was asked for.
struct TargetCheck {
  enum class Kind {
    kTwists,   ///< so many twists were completed: value of wanted
    kUndone,   ///< an organ that came twisted lies undone, hands off: value 1 or 0 of wanted 1
    kAngle,    ///< twists let go within the tolerance: value of wanted
    kHold,     ///< seconds on target before letting go: the shortest of the twists on target
    kForce,    ///< largest force on the tissue at most the limit (RecordedLoads)
    kTorque,   ///< largest torque at most the limit
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

/// Checks a run against the rules of its exercise: the angle always (that the organ is undone, of an
/// untwisting), the number of twists, hold and limits where they are set. Of the twists only completed ones
/// count; a limit counts for everything that the tissue bore.
[[nodiscard]] std::vector<TargetCheck> targetChecks(const MeasuredTrial& run, const AttemptRules& rules);

/// What an attempt must keep to whatever else it is judged by.
struct AttemptDemands {
  std::int64_t leastTwists = 1;  ///< completed; of an exercise of twisting
  std::optional<double> forceLimit_N{};
  std::optional<double> torqueLimit_Nm{};
};

/// Whether a measured attempt (AttemptMeasures::values, number of completed twists) keeps to the demands: one
/// that does not is no success, in no row and in no learning curve. A load that is not known does not keep
/// to its limit.
[[nodiscard]] bool meetsDemands(const AttemptDemands& demands, const std::map<std::string, double>& values,
                                std::int64_t twists);

}  // namespace torsio
