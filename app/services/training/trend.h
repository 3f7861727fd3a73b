// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/training/attempts.h"
#include "assessment/attempt/competence.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

struct TrendPoint {
  TrialId trialId{};
  std::int64_t attempt = 1;
  std::int64_t startedUtc_us = 0;
  std::optional<double> value{};
  std::optional<AttemptMode> mode{};
  bool counted = false;
  RunOutcome outcome = RunOutcome::kNotPassed;
};

struct TrendCurvePoint {
  double attempt = 0.0;
  double value = 0.0;
  double lower = 0.0;  ///< 95 % band of the mean curve
  double upper = 0.0;
};

/// A trainee's progress at one module.
struct Trend {
  ModuleId moduleId{};
  std::string moduleTitle{};
  /// The chosen one, or the first with a scale among those of the mastery rules.
  Quantity quantity = Quantity::kOnTarget;
  std::vector<Quantity> offered{};  ///< quantities available for the module, in catalogue order
  bool untwisting = false;          ///< there are only quantities of untwisting, none of twists
  bool lowerIsBetter = true;
  std::vector<TrendPoint> points{};
  std::optional<double> threshold{};
  std::optional<double> distance{};  ///< from the last value to the threshold; at most 0: reached
  std::vector<TrendCurvePoint> curve{};
  std::optional<double> asymptote{};
  std::string noCurveReason{};     ///< set if curve is empty
  CompetenceVerdict competence{};  ///< level, design and error rates
  std::optional<std::int64_t> attemptsLeft{};
};

/// kTrialViewOwn, the actor's attempts. `quantity`: if empty, the first of the module's mastery rules with a
/// scale, not only yes and no. Throws Error{kBadParameter} for a module outside the trainee's curriculum.
[[nodiscard]] Trend trend(SessionContext& session, const PersonId& personId, const ModuleId& moduleId,
                          std::optional<Quantity> quantity = {});

}  // namespace torsio
