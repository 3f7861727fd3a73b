// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/mastery.h"

#include <algorithm>

namespace torsio {

namespace {

// Integer arithmetic: 0.8 x 5 must be exactly 4.
constexpr std::int64_t kWanted = 4;
constexpr std::int64_t kOutOf = 5;

}  // namespace

Text MasteryRule::text() const {
  if (!quantity) {
    return Text::tr("A quantity that this version of Torsio does not measure");
  }
  const Phrase name = rowOf(*quantity).name;
  const Text limit = shownValue(*quantity, threshold);
  return isAnswer(*quantity)          ? Text::tr("%1: %2", name, limit)
         : atMost && threshold == 0.0 ? Text::tr("%1: none", name)
         : atMost                     ? Text::tr("%1: at most %2", name, limit)
                                      : Text::tr("%1: at least %2", name, limit);
}

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

}  // namespace torsio
