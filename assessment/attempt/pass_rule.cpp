// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/pass_rule.h"

#include <algorithm>

#include "assessment/attempt/mastery.h"

namespace torsio {

namespace {

using Kind = TargetCheck::Kind;

TargetCheck angleCheck(const std::vector<const MeasuredTwist*>& twists) {
  const std::int64_t hits =
      std::count_if(twists.begin(), twists.end(), [](const MeasuredTwist* twist) { return twist->onTarget; });
  const std::int64_t wanted = wantedOnTarget(std::ssize(twists));
  return {.kind = Kind::kAngle,
          .passed = hits >= wanted,
          .value = static_cast<double>(hits),
          .wanted = static_cast<double>(wanted)};
}

TargetCheck holdCheck(const std::vector<const MeasuredTwist*>& twists, double wanted_s) {
  std::optional<double> shortest;
  for (const MeasuredTwist* twist : twists) {
    if (twist->onTarget) {
      shortest = std::min(shortest.value_or(twist->held_s), twist->held_s);
    }
  }
  return {.kind = Kind::kHold,
          .passed = shortest && *shortest >= wanted_s,
          .value = shortest,
          .wanted = wanted_s};
}

TargetCheck limitCheck(Kind kind, const std::vector<double>& peaks, double most) {
  TargetCheck check{.kind = kind, .wanted = most, .atLeast = false};
  if (!peaks.empty()) {
    check.value = *std::max_element(peaks.begin(), peaks.end());
    check.passed = *check.value <= most;
  }
  return check;
}

TargetCheck undoneCheck(const MeasuredTrial& run) {
  TargetCheck check{.kind = Kind::kUndone, .metric = kDetorsionDoneMetric, .wanted = 1.0};
  const std::vector<double> done = run.valuesOf(kDetorsionDoneMetric);
  if (!done.empty()) {
    check.value = done.front();
    check.passed = done.front() >= check.wanted;
  }
  return check;
}

}  // namespace

std::vector<TargetCheck> targetChecks(const MeasuredTrial& run, const AttemptRules& rules) {
  const std::vector<const MeasuredTwist*> twists = run.completed();
  std::vector<TargetCheck> checks{run.detorsion ? undoneCheck(run) : angleCheck(twists)};
  if (rules.hold_s > 0.0 && !run.detorsion) {
    checks.push_back(holdCheck(twists, rules.hold_s));
  }
  if (rules.forceLimit_N) {
    checks.push_back(limitCheck(Kind::kForce, run.valuesOf("force.peak"), *rules.forceLimit_N));
  }
  if (rules.torqueLimit_Nm) {
    checks.push_back(limitCheck(Kind::kTorque, run.valuesOf("torque.peak"), *rules.torqueLimit_Nm));
  }
  return checks;
}

}  // namespace torsio
