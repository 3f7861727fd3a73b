// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "assessment/attempt/measured_trial.h"
#include "assessment/catalogue/quantity.h"

namespace torsio {

/// A completed twist with its result.
struct JudgedTwist {
  double error_deg = 0.0;  ///< absolute difference between angle at release and target
  bool onTarget = false;
  friend bool operator==(const JudgedTwist&, const JudgedTwist&) = default;
};

/// All measures of a recording, stored with it and with kMetricsVersion. Report, debrief, trend, mastery,
/// verdict and export use these numbers and compute none themselves.
struct AttemptMeasures {
  std::int64_t duration_us = 0;
  std::vector<JudgedTwist> twists{};              ///< completed ones, in order; empty for an untwisting
  std::int64_t unfinished = 0;                    ///< twists not completed, in no share or mean
  std::optional<double> meanAbsoluteError_deg{};  ///< empty without a completed twist
  /// Peaks of force and torque are those of the whole recording (RecordedLoads). Quantities of single twists:
  /// over the completed ones, the sum of mishaps, the maximum of peaks, otherwise the median. An untwisting
  /// has its own quantities, and loads over its grips in the same way. Undefined ones are missing.
  QuantityValues values{};

  /// Counts the completed twists released on target.
  [[nodiscard]] std::int64_t twistsOnTarget() const noexcept;
  /// Counts the twists cut off while the organ was held: by the end of the run, or by a device that was lost.
  /// The verdict counts them as missed. Twists whose release the computer lost are not among them.
  [[nodiscard]] std::int64_t twistsCutOff() const noexcept;
  friend bool operator==(const AttemptMeasures&, const AttemptMeasures&) = default;
};

/// Measures a recording by the rules of its exercise: the only source of numbers for pages, tables and files.
/// Slow: seconds for an hour.
[[nodiscard]] AttemptMeasures measureAttempt(const TrialHeader& header, std::span<const Sample> samples,
                                             const AttemptRules& rules);
/// Like the overload above, for a recording already measured by measureTwists().
[[nodiscard]] AttemptMeasures measureAttempt(const MeasuredTrial& measured);

}  // namespace torsio
