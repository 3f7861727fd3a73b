// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/run_verdict.h"

#include <algorithm>

namespace torsio {

namespace {

TargetCheck checkOf(const QuantityValues& values, std::optional<Quantity> quantity, double wanted,
                    bool atLeast = true) {
  TargetCheck check{.quantity = quantity, .wanted = wanted, .atLeast = atLeast};
  check.value = quantity ? valueIn(values, *quantity) : std::nullopt;
  check.passed = check.value && (atLeast ? *check.value >= wanted : *check.value <= wanted);
  return check;
}

TargetCheck onTargetCheck(const QuantityValues& values, const AttemptRules& rules, std::int64_t cutOff) {
  const auto twists =
      cutOff + static_cast<std::int64_t>(valueIn(values, Quantity::kCompletedTwists).value_or(0.0));
  TargetCheck check = checkOf(values, Quantity::kTargetsReached,
                              static_cast<double>(wantedOnTarget(twists, rules.leastTwists)));
  check.outOf = twists;
  return check;
}

std::vector<TargetCheck> checksOf(const QuantityValues& values, const AttemptRules& rules,
                                  std::int64_t cutOff) {
  std::vector<TargetCheck> checks;
  if (isUntwisting(values)) {
    checks.push_back(checkOf(values, Quantity::kUntwisted, 1.0));
  } else {
    if (rules.leastTwists > 1) {
      checks.push_back(checkOf(values, Quantity::kCompletedTwists, static_cast<double>(rules.leastTwists)));
    }
    checks.push_back(onTargetCheck(values, rules, cutOff));
    if (rules.hold_s > 0.0) {
      checks.push_back(checkOf(values, Quantity::kShortestHold, rules.hold_s));
    }
  }
  if (rules.forceLimit_N) {
    checks.push_back(checkOf(values, Quantity::kPeakForce, *rules.forceLimit_N, false));
  }
  if (rules.torqueLimit_Nm) {
    checks.push_back(checkOf(values, Quantity::kPeakTorque, *rules.torqueLimit_Nm, false));
  }
  for (const MasteryRule& rule : rules.mastery) {
    TargetCheck check = checkOf(values, rule.quantity, rule.threshold, !rule.atMost);
    check.consecutive = rule.consecutive;
    check.streak = check.passed ? 1 : 0;
    // A rule that repeats a requirement of the exercise takes its place.
    std::erase_if(checks, [&check](const TargetCheck& one) {
      return one.quantity == check.quantity && one.wanted == check.wanted && one.atLeast == check.atLeast &&
             one.outOf == 0 && one.consecutive == 0;
    });
    checks.push_back(check);
  }
  return checks;
}

/// Formats the value, with more digits if it would look equal to the limit that it misses.
Text valueText(const TargetCheck& check, Quantity quantity) {
  constexpr int kMaxFurther = 4;
  if (!check.value) {
    return shownValue(quantity, check.value);
  }
  int further = 0;
  while (!check.passed && further < kMaxFurther && !isAnswer(quantity) &&
         shownNumber(quantity, *check.value, further) == shownNumber(quantity, check.wanted, further)) {
    ++further;
  }
  const Text value = shownValue(quantity, *check.value, further);
  return check.outOf > 0 ? Text::tr("%1 of %2", value, check.outOf) : value;
}

}  // namespace

Text TargetCheck::text() const {
  if (!quantity) {
    return Text::tr("A quantity that this version of Torsio does not measure");
  }
  const Phrase name = rowOf(*quantity).name;
  const Text own = valueText(*this, *quantity);
  const Text limit = shownValue(*quantity, wanted);
  const Text sentence = isAnswer(*quantity) ? Text::tr("%1: %2 (%3 required)", name, own, limit)
                        : atLeast           ? Text::tr("%1: %2, at least %3", name, own, limit)
                                            : Text::tr("%1: %2, at most %3", name, own, limit);
  return consecutive <= 1 ? sentence : Text::tr("%1 (%2 in a row, %3 needed)", sentence, streak, consecutive);
}

bool isUntwisting(const QuantityValues& values) {
  return !values.contains(Quantity::kCompletedTwists);
}

bool withinLimits(const QuantityValues& values, const AttemptRules& rules) {
  const auto keeps = [&values](Quantity quantity, const std::optional<double>& limit) {
    return !limit || checkOf(values, quantity, *limit, false).passed;
  };
  return keeps(Quantity::kPeakForce, rules.forceLimit_N) &&
         keeps(Quantity::kPeakTorque, rules.torqueLimit_Nm);
}

bool meetsDemands(const QuantityValues& values, const AttemptRules& rules) {
  const bool enough =
      isUntwisting(values) ||
      checkOf(values, Quantity::kCompletedTwists, static_cast<double>(rules.leastTwists)).passed;
  return enough && withinLimits(values, rules);
}

Text RunVerdict::sentence() const {
  switch (outcome) {
    case RunOutcome::kPassed:
      return Text::tr("Passed: every target was reached");
    case RunOutcome::kNotPassed:
      return Text::tr("Not passed yet");
    case RunOutcome::kNotJudged:
      return Text::tr("Not judged: the computer was too busy");
    case RunOutcome::kInterrupted:
      return Text::tr("Interrupted: counts as failed unless it is excused");
    case RunOutcome::kRefused:
      break;
  }
  return Text::tr("Not judged: such a recording has no requirements");
}

Text RunVerdict::cause() const {
  if (!torn) {
    return {};
  }
  return outcome == RunOutcome::kNotJudged
             ? Text::tr(
                   "This is not your fault: the computer lost part of this run, so not all of it could be "
                   "measured.")
             : Text::tr("The computer lost part of this run. The verdict rests on what could be measured.");
}

Text RunVerdict::remedy() const {
  return torn ? Text(Text::tr("Close other programs at this station, then repeat the run.")) : Text();
}

RunVerdict judgeRun(const QuantityValues& values, const AttemptRules& rules, bool interrupted,
                    std::int64_t cutOff) {
  RunVerdict verdict;
  const std::optional<double> torn = valueIn(values, Quantity::kTornTwists);
  if (!torn) {
    return verdict;  // of a tracker
  }
  verdict.torn = *torn > 0.0;
  verdict.checks = checksOf(values, rules, cutOff);
  const auto all = [&verdict](auto&& holds) {
    return std::all_of(verdict.checks.begin(), verdict.checks.end(), holds);
  };
  // A measured miss is a miss, even if samples were lost.
  const bool missed = !all([](const TargetCheck& check) { return check.passed || !check.value; });
  verdict.outcome = interrupted                                                  ? RunOutcome::kInterrupted
                    : all([](const TargetCheck& check) { return check.passed; }) ? RunOutcome::kPassed
                    : verdict.torn && !missed                                    ? RunOutcome::kNotJudged
                                                                                 : RunOutcome::kNotPassed;
  return verdict;
}

RunVerdict judgeRun(const AttemptMeasures& measures, const AttemptRules& rules, bool interrupted) {
  return judgeRun(measures.values, rules, interrupted, measures.twistsCutOff());
}

}  // namespace torsio
