// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/merit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "assessment/catalogue/quantity.h"
#include "assessment/statistics/quantiles.h"

namespace torsio {

namespace {

constexpr double kSmallestSize = 1e-9;

}  // namespace

double merit(Quantity quantity, double own, double expert) {
  const QuantityRow& row = rowOf(quantity);
  const MeritWeight& weight = row.traits.merit;
  const bool higher = row.direction == Direction::kHigherIsBetter;
  // Smoothness measures are negative; closer to 0 is better.
  const bool negative = own < 0.0 || expert < 0.0;
  const double a = std::max(std::abs(own) + weight.floor, kSmallestSize);
  const double b = std::max(std::abs(expert) + weight.floor, kSmallestSize);
  return weight.weight * (higher && !negative ? std::log(a / b) : std::log(b / a));
}

std::vector<QuantityMerit> meritsAgainst(const MeasuredTrial& own, const MeasuredTrial& expert) {
  const std::vector<const MeasuredTwist*> twists = own.completed();
  std::vector<QuantityMerit> all;
  for (const QuantityRow& row : quantityRows()) {
    if (row.traits.merit.weight == 0.0) {
      continue;
    }
    const std::optional<double> reference = quantile(expert.valuesOf(row.quantity), 0.5);
    const std::optional<double> mine = quantile(own.valuesOf(row.quantity), 0.5);
    if (!reference || !mine) {
      continue;
    }
    QuantityMerit judged{
        .quantity = row.quantity, .expert = *reference, .merit = merit(row.quantity, *mine, *reference)};
    bool first = true;
    for (std::size_t i = 0; i < twists.size(); ++i) {
      const std::optional<double> value =
          twists[i]->metrics ? twists[i]->metrics->valueOf(row.quantity) : std::nullopt;
      if (!value) {
        continue;
      }
      const TwistMerit found{i, *value, merit(row.quantity, *value, *reference)};
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
                   [](const QuantityMerit& a, const QuantityMerit& b) { return a.merit > b.merit; });
  return all;
}

}  // namespace torsio
