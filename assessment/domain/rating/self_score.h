// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"

namespace torsio {

/// One row of a self-assessment.
struct SelfScoreLine {
  RubricRevisionId rubricRevisionId{};
  std::string rowCode{};
  std::int64_t score_steps = 0;
  friend bool operator==(const SelfScoreLine&, const SelfScoreLine&) = default;
};

/// A trainee's self-assessment of one of their trials. Append-only; a correction is the next version.
struct SelfScore {
  SelfScoreId id{};
  TrialId trialId{};
  TraineeId traineeId{};
  std::int64_t version = 1;             ///< 1, 2, 3 ... of this trial and trainee
  RubricRevisionId rubricRevisionId{};  ///< empty: the overall mark only
  std::int64_t score_steps = 0;
  ScoreScale scale{.lo = 10, .hi = 100, .stepsPerPoint = 10};
  std::vector<SelfScoreLine> rows{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

}  // namespace torsio
