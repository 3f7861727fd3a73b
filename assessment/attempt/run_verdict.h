// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "assessment/attempt/measured_trial.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/domain/study/protocol_terms.h"
#include "sim/core/text.h"

namespace torsio {

/// One thing that was asked of a run.
struct TargetCheck {
  std::optional<Quantity> quantity{};  ///< empty: of a later version of Torsio, never passed
  bool passed = false;
  std::optional<double> value{};  ///< SI; empty: not measured in this run
  double wanted = 0.0;
  bool atLeast = true;           ///< value >= wanted passes; false: value <= wanted
  std::int64_t outOf = 0;        ///< of kTargetsReached: completed twists
  std::int64_t streak = 0;       ///< of a rule of mastery: runs in a row, this one included
  std::int64_t consecutive = 0;  ///< of a rule of mastery: runs in a row needed; 0: asked of every run

  /// "Peak force: 3.31 N, at most 3.30 N".
  [[nodiscard]] Text text() const;
  friend bool operator==(const TargetCheck&, const TargetCheck&) = default;
};

/// Tells whether the values are those of an untwisting: no twists are counted there.
[[nodiscard]] bool isUntwisting(const QuantityValues& values);

/// Whether force and torque stayed within the limits. A load that is not known does not keep to its limit.
[[nodiscard]] bool withinLimits(const QuantityValues& values, const AttemptRules& rules);
/// Whether a run also completed as many twists as its exercise asks for: one that did not is no success, in
/// no row and in no learning curve.
[[nodiscard]] bool meetsDemands(const QuantityValues& values, const AttemptRules& rules);

/// What a run came to.
enum class RunOutcome : std::uint8_t { kPassed, kNotPassed, kNotJudged, kInterrupted, kRefused };
inline constexpr std::array<Term<RunOutcome>, 5> kRunOutcomes{{
    {RunOutcome::kPassed, "passed", Text::tr("passed"), "every target was reached"},
    {RunOutcome::kNotPassed, "not_passed", Text::tr("not passed"), "a target was missed"},
    {RunOutcome::kNotJudged, "not_judged", Text::tr("not judged"),
     "the computer lost samples, and nothing that was measured missed its target"},
    {RunOutcome::kInterrupted, "interrupted", Text::tr("interrupted"),
     "the program or the machine went down: kept, not counted"},
    {RunOutcome::kRefused, "refused", Text::tr("not judged (no targets)"),
     "nothing is asked of such a recording: a tracker made it"},
}};
static_assert(isWholeTable(kRunOutcomes, RunOutcome{5}));
[[nodiscard]] constexpr const auto& termsOf(RunOutcome) noexcept {
  return kRunOutcomes;
}

/// "passed", "not judged": for a table.
[[nodiscard]] inline Text wordOf(RunOutcome outcome) {
  return kRunOutcomes[static_cast<std::size_t>(outcome)].label;
}

/// The verdict on one run. Window, browser, transcript, trend, exports, learning records and command line
/// show this value and decide nothing themselves.
struct RunVerdict {
  RunOutcome outcome = RunOutcome::kRefused;
  bool torn = false;                  ///< the computer lost more than 20 ms of a twist
  std::vector<TargetCheck> checks{};  ///< everything that was asked for, rules of mastery last

  [[nodiscard]] bool passed() const noexcept { return outcome == RunOutcome::kPassed; }
  /// The verdict in one sentence.
  [[nodiscard]] Text sentence() const;
  /// What the computer had to do with it; empty: nothing.
  [[nodiscard]] Text cause() const;
  /// What to do about the cause; empty: nothing.
  [[nodiscard]] Text remedy() const;
  friend bool operator==(const RunVerdict&, const RunVerdict&) = default;
};

/// Judges a run by the values that were measured of it (AttemptMeasures::values): the angle always, or that
/// the organ of an untwisting was undone; number of twists, hold and limits where the exercise sets them; and
/// the rules of mastery. A limit counts for everything that the tissue bore.
[[nodiscard]] RunVerdict judgeRun(const QuantityValues& values, const AttemptRules& rules,
                                  bool interrupted = false);

}  // namespace torsio
