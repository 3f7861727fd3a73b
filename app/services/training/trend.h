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

/// A trainee's way at one module.
struct Trend {
  ModuleId moduleId{};
  std::string moduleTitle{};
  /// The chosen one, or the first with a scale among those of the mastery rules.
  Quantity quantity = Quantity::kOnTarget;
  std::vector<Quantity> offered{};  ///< what the module can be followed by, in the order of the catalogue
  bool untwisting = false;          ///< organs are undone: there are quantities of untwisting, none of twists
  bool lowerIsBetter = true;
  std::vector<TrendPoint> points{};
  std::optional<double> threshold{};
  std::optional<double> distance{};  ///< to the threshold from the last value; at most 0: reached
  std::vector<TrendCurvePoint> curve{};
  std::optional<double> asymptote{};
  std::string noCurveReason{};     ///< in words, when curve is empty
  CompetenceVerdict competence{};  ///< level, design and error rates
  std::optional<std::int64_t> attemptsLeft{};
};

/// kTrialViewOwn, own attempts only. `quantity`: empty: the first of the module's mastery rules that has
/// a scale, not only yes and no. Throws Error{kBadParameter} for a module that is not in the trainee's
/// curriculum.
[[nodiscard]] Trend trend(SessionContext& session, const PersonId& personId, const ModuleId& moduleId,
                          std::optional<Quantity> quantity = {});

}  // namespace torsio
