// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"

namespace torsio {

/// A run scored by a panel, used to calibrate raters.
struct ReferenceRun {
  TrialId trialId{};
  std::int64_t position = 0;
  RubricRevisionId rubricRevisionId{};
  double panel_steps = 0.0;  ///< mean of the panel, steps of the rubric's overall scale
  std::int64_t panelRaters = 1;
  std::string setBy{};
  std::int64_t setUtc_us = 0;
  bool demonstration = false;
};

/// Withdrawal of a reference run, which is then no longer handed out.
struct ReferenceWithdrawal {
  TrialId trialId{};
  std::string reason{};
  std::string withdrawnBy{};
  std::int64_t withdrawnUtc_us = 0;
};

/// A rater's calibration score of a reference run, given before real ones. Append-only.
struct CalibrationScore {
  CalibrationScoreId id{};
  RaterId raterId{};
  TrialId referenceTrialId{};
  RubricRevisionId rubricRevisionId{};  ///< empty: the overall mark only
  std::int64_t score_steps = 0;
  ScoreScale scale{.lo = 10, .hi = 100, .stepsPerPoint = 10};
  double panelOffset_steps = 0.0;  ///< rater minus panel
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

}  // namespace torsio
