// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "assessment/attempt/measured_trial.h"
#include "assessment/catalogue/quantity.h"

namespace torsio {

/// One completed twist, judged.
struct JudgedTwist {
  double error_deg = 0.0;  ///< absolute, of the angle at letting go against the target in force
  bool onTarget = false;
  friend bool operator==(const JudgedTwist&, const JudgedTwist&) = default;
};

/// Everything that is derived from one recording and kept beside it, with kMetricsVersion. Report, debrief,
/// trend, mastery, verdict and export read these numbers and compute none of their own.
struct AttemptMeasures {
  std::int64_t duration_us = 0;
  std::vector<JudgedTwist> twists{};  ///< completed ones, in their order; none of an untwisting
  std::int64_t unfinished = 0;        ///< twists that were not completed, counted apart
  /// The next three: empty without a completed twist.
  std::optional<double> meanAbsoluteError_deg{};
  std::optional<double> peakTorque_Nm{};  ///< largest magnitude of any sample, not filtered
  std::optional<double>
      peakForce_N{};  ///< largest on the tissue, of any sample: what a limit is held against
  /// Peaks of force and torque are those of the whole recording (RecordedLoads). A quantity
  /// of single twists: over the completed ones, the sum of mishaps, the largest of peaks, else the median. Of
  /// an untwisting its own quantities, and loads over its grips in the same way. What is not defined is
  /// missing.
  QuantityValues values{};

  /// Number of completed twists that were released on target.
  [[nodiscard]] std::int64_t twistsOnTarget() const noexcept;
  friend bool operator==(const AttemptMeasures&, const AttemptMeasures&) = default;
};

/// Measures a recording by the rules of its exercise: the one function through which every page, table and
/// file gets its numbers. Slow: seconds for an hour.
[[nodiscard]] AttemptMeasures measureAttempt(const TrialHeader& header, std::span<const Sample> samples,
                                             const AttemptRules& rules);
/// Does the same with a recording that measureTwists has measured already.
[[nodiscard]] AttemptMeasures measureAttempt(const MeasuredTrial& measured);

}  // namespace torsio
