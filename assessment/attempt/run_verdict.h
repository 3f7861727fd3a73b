// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "assessment/attempt/attempt_measures.h"
#include "assessment/attempt/measured_trial.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/domain/study/protocol_terms.h"
#include "sim/core/text.h"

namespace torsio {

/// One requirement on a run.
struct TargetCheck {
  std::optional<Quantity> quantity{};  ///< empty: of a later version, never passed
  bool passed = false;
  std::optional<double> value{};  ///< SI; empty: not measured in this run
  double wanted = 0.0;
  bool atLeast = true;           ///< value >= wanted passes; otherwise value <= wanted
  std::int64_t outOf = 0;        ///< for kTargetsReached: twists, those cut off included
  std::int64_t streak = 0;       ///< for a mastery rule: successive runs including this one
  std::int64_t consecutive = 0;  ///< for a mastery rule: required successive runs; 0: required in every run

  /// Returns "Peak force: 3.31 N, at most 3.30 N".
  [[nodiscard]] Text text() const;
  friend bool operator==(const TargetCheck&, const TargetCheck&) = default;
};

/// Returns whether the values are those of an untwisting, which has no twists.
[[nodiscard]] bool isUntwisting(const QuantityValues& values);

/// Returns whether force and torque stayed within the limits. An unknown load does not meet its limit.
[[nodiscard]] bool withinLimits(const QuantityValues& values, const AttemptRules& rules);
/// Returns whether a run is within the limits and has the required number of completed twists; otherwise it
/// is never a success and enters no streak or learning curve.
[[nodiscard]] bool meetsDemands(const QuantityValues& values, const AttemptRules& rules);

/// Outcome of a run.
enum class RunOutcome : std::uint8_t { kPassed, kNotPassed, kNotJudged, kInterrupted, kRefused };
inline constexpr std::array<Term<RunOutcome>, 5> kRunOutcomes{{
    {RunOutcome::kPassed, "passed", Text::tr("passed"), "every target was reached"},
    {RunOutcome::kNotPassed, "not_passed", Text::tr("not passed"), "a target was missed"},
    {RunOutcome::kNotJudged, "not_judged", Text::tr("not judged"),
     "the computer lost samples, and nothing that was measured missed its target"},
    {RunOutcome::kInterrupted, "interrupted", Text::tr("interrupted"),
     "ended before its time: failed for competence unless excused"},
    {RunOutcome::kRefused, "refused", Text::tr("not judged (no targets)"),
     "nothing is asked of such a recording: a tracker made it"},
}};
static_assert(isWholeTable(kRunOutcomes, RunOutcome{5}));
[[nodiscard]] constexpr const auto& termsOf(RunOutcome) noexcept {
  return kRunOutcomes;
}

/// Returns "passed", "not judged" ..., for tables.
[[nodiscard]] inline Text wordOf(RunOutcome outcome) {
  return kRunOutcomes[static_cast<std::size_t>(outcome)].label;
}

/// The verdict on one run. Window, browser, transcript, trend, exports, learning records and command line
/// show this value and decide nothing themselves.
struct RunVerdict {
  RunOutcome outcome = RunOutcome::kRefused;
  bool torn = false;                  ///< more than 20 ms of a twist were lost
  std::vector<TargetCheck> checks{};  ///< all requirements, mastery rules last

  [[nodiscard]] bool passed() const noexcept { return outcome == RunOutcome::kPassed; }
  /// Describes the verdict in one sentence.
  [[nodiscard]] Text sentence() const;
  /// Describes the computer's part in it; empty: none.
  [[nodiscard]] Text cause() const;
  /// Describes the remedy for the cause; empty: none.
  [[nodiscard]] Text remedy() const;
  friend bool operator==(const RunVerdict&, const RunVerdict&) = default;
};

/// Judges a run by its measures (AttemptMeasures::values): always the angle, or that the organ was untwisted;
/// number of twists, hold and limits if the exercise sets them; and the mastery rules. Limits apply to
/// everything done to the tissue. `cutOff`: AttemptMeasures::twistsCutOff(), counted as missed.
[[nodiscard]] RunVerdict judgeRun(const QuantityValues& values, const AttemptRules& rules,
                                  bool interrupted = false, std::int64_t cutOff = 0);
[[nodiscard]] RunVerdict judgeRun(const AttemptMeasures& measures, const AttemptRules& rules,
                                  bool interrupted = false);

}  // namespace torsio
