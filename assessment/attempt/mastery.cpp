// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/mastery.h"

#include <algorithm>

#include "assessment/metrics/metric_cards.h"

namespace torsio {

namespace {

// The share as whole numbers: 0.8 x 5 must be 4, not a little more.
constexpr std::int64_t kWanted = 4;
constexpr std::int64_t kOutOf = 5;

}  // namespace

bool reaches(const MasteryRule& rule, double value) noexcept {
  return rule.atMost ? value <= rule.threshold : value >= rule.threshold;
}

MasteryProgress masteryProgress(const MasteryRule& rule, std::span<const std::optional<double>> values) {
  MasteryProgress progress;
  for (const std::optional<double>& value : values) {
    progress.last = value;
    progress.streak = value && reaches(rule, *value) ? progress.streak + 1 : 0;
    progress.met = progress.met || progress.streak >= rule.consecutive;
  }
  return progress;
}

std::int64_t wantedOnTarget(std::int64_t twists, std::int64_t least) noexcept {
  const std::int64_t counted = std::max({twists, least, std::int64_t{1}});
  return (kWanted * counted + kOutOf - 1) / kOutOf;
}

bool enoughOnTarget(std::int64_t onTarget, std::int64_t twists) noexcept {
  return onTarget >= wantedOnTarget(twists);
}

bool passesAll(std::span<const MasteryRule> rules, const std::map<std::string, double>& values,
               std::int64_t onTarget, std::int64_t twists) {
  if (rules.empty()) {
    if (const auto done = values.find(kDetorsionDoneMetric); done != values.end()) {
      return done->second > 0.0;
    }
    return enoughOnTarget(onTarget, twists);
  }
  return std::all_of(rules.begin(), rules.end(), [&](const MasteryRule& rule) {
    const auto value = values.find(rule.metric);
    return value != values.end() && reaches(rule, value->second);
  });
}

}  // namespace torsio
