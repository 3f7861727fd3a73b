// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/merit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "assessment/metrics/metric_cards.h"
#include "assessment/statistics/quantiles.h"

namespace torsio {

namespace {

constexpr std::array<MeritCriterion, 9> kCriteria{{{"twist.time_to_target", 0.5},
                                                   {"twist.settling", 0.5},
                                                   {"twist.overshoot", 0.0349},
                                                   {"twist.hold_steadiness", 0.0087},
                                                   {"twist.sparc", 0.0, 2.0},
                                                   {"twist.economy", 0.1},
                                                   {"twist.peaks", 2.0},
                                                   {"force.peak", 0.2},
                                                   {"torque.release_rate", 0.1}}};
constexpr double kSmallestSize = 1e-9;

}  // namespace

std::span<const MeritCriterion> meritCriteria() {
  return kCriteria;
}

double merit(const MeritCriterion& criterion, double own, double expert) {
  const bool higher = metricCard(criterion.metric).direction == Direction::kHigherIsBetter;
  // Both smoothness measures are negative, nearer 0 is better.
  const bool negative = own < 0.0 || expert < 0.0;
  const double a = std::max(std::abs(own) + criterion.floor, kSmallestSize);
  const double b = std::max(std::abs(expert) + criterion.floor, kSmallestSize);
  return criterion.weight * (higher && !negative ? std::log(a / b) : std::log(b / a));
}

std::vector<CriterionMerit> meritsAgainst(const MeasuredTrial& own, const MeasuredTrial& expert) {
  const std::vector<const MeasuredTwist*> twists = own.completed();
  std::vector<CriterionMerit> all;
  for (const MeritCriterion& criterion : meritCriteria()) {
    const std::optional<double> reference = quantile(expert.valuesOf(criterion.metric), 0.5);
    const std::optional<double> mine = quantile(own.valuesOf(criterion.metric), 0.5);
    if (!reference || !mine) {
      continue;
    }
    CriterionMerit judged{
        .metric = criterion.metric, .expert = *reference, .merit = merit(criterion, *mine, *reference)};
    bool first = true;
    for (std::size_t i = 0; i < twists.size(); ++i) {
      if (!twists[i]->metrics || !twists[i]->metrics->at(criterion.metric)) {
        continue;
      }
      const double value = *twists[i]->metrics->at(criterion.metric);
      const TwistMerit found{i, value, merit(criterion, value, *reference)};
      if (first || found.merit > judged.best.merit) {
        judged.best = found;
      }
      if (first || found.merit < judged.worst.merit) {
        judged.worst = found;
      }
      first = false;
    }
    all.push_back(judged);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const CriterionMerit& a, const CriterionMerit& b) { return a.merit > b.merit; });
  return all;
}

}  // namespace torsio
