// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/pass_rule.h"

#include <algorithm>

#include "assessment/attempt/mastery.h"
#include "assessment/metrics/metric_cards.h"

namespace torsio {

namespace {

using Kind = TargetCheck::Kind;

TargetCheck numberCheck(std::int64_t completed, std::int64_t least) {
  return {.kind = Kind::kTwists,
          .passed = completed >= least,
          .value = static_cast<double>(completed),
          .wanted = static_cast<double>(least)};
}

TargetCheck angleCheck(const std::vector<const MeasuredTwist*>& twists, std::int64_t least) {
  const std::int64_t hits =
      std::count_if(twists.begin(), twists.end(), [](const MeasuredTwist* twist) { return twist->onTarget; });
  const std::int64_t wanted = wantedOnTarget(std::ssize(twists), least);
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

bool isWithin(const std::optional<double>& peak, double most) {
  return peak && *peak <= most;
}

TargetCheck limitCheck(Kind kind, const std::optional<double>& peak, double most) {
  return {.kind = kind, .passed = isWithin(peak, most), .value = peak, .wanted = most, .atLeast = false};
}

std::optional<double> valueOf(const std::map<std::string, double>& values, const char* metric) {
  const auto found = values.find(metric);
  return found == values.end() ? std::nullopt : std::optional(found->second);
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
  std::vector<TargetCheck> checks;
  if (run.detorsion) {
    checks.push_back(undoneCheck(run));
  } else {
    if (rules.leastTwists > 1) {
      checks.push_back(numberCheck(std::ssize(twists), rules.leastTwists));
    }
    checks.push_back(angleCheck(twists, rules.leastTwists));
  }
  if (rules.hold_s > 0.0 && !run.detorsion) {
    checks.push_back(holdCheck(twists, rules.hold_s));
  }
  if (rules.forceLimit_N) {
    checks.push_back(limitCheck(Kind::kForce, run.loads.tissueForce_N, *rules.forceLimit_N));
  }
  if (rules.torqueLimit_Nm) {
    checks.push_back(limitCheck(Kind::kTorque, run.loads.torque_Nm, *rules.torqueLimit_Nm));
  }
  return checks;
}

bool meetsDemands(const AttemptDemands& demands, const std::map<std::string, double>& values,
                  std::int64_t twists) {
  const bool untwisting = values.contains(kDetorsionDoneMetric);
  return (untwisting || twists >= demands.leastTwists) &&
         (!demands.forceLimit_N || isWithin(valueOf(values, kPeakForceMetric), *demands.forceLimit_N)) &&
         (!demands.torqueLimit_Nm || isWithin(valueOf(values, kPeakTorqueMetric), *demands.torqueLimit_Nm));
}

}  // namespace torsio
