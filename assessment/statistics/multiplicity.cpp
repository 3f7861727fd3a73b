// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/multiplicity.h"

#include <algorithm>
#include <numeric>

#include "assessment/statistics/distributions.h"

namespace torsio {

namespace {

std::vector<std::size_t> ascending(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  return order;
}

/// Adjusts from the largest p down: factor(rank) x p, capped by the previous value.
template <class Factor>
std::vector<double> stepUp(std::span<const double> p, Factor factor) {
  const std::vector<std::size_t> order = ascending(p);
  std::vector<double> out(p.size());
  double smallest = 1.0;
  for (std::size_t i = order.size(); i-- > 0;) {
    smallest = std::min(smallest, factor(i + 1) * p[order[i]]);
    out[order[i]] = smallest;
  }
  return out;
}

}  // namespace

std::vector<double> adjustBonferroni(std::span<const double> p) {
  std::vector<double> out;
  for (const double value : p) {
    out.push_back(std::min(1.0, value * static_cast<double>(p.size())));
  }
  return out;
}

std::vector<double> adjustHolm(std::span<const double> p) {
  const std::vector<std::size_t> order = ascending(p);
  std::vector<double> out(p.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    largest = std::max(largest, std::min(1.0, static_cast<double>(order.size() - i) * p[order[i]]));
    out[order[i]] = largest;
  }
  return out;
}

std::vector<double> holmFactors(std::span<const double> p) {
  const std::vector<std::size_t> order = ascending(p);
  std::vector<double> out(p.size());
  double largest = 0.0;  // not capped at 1
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double step = static_cast<double>(order.size() - i);
    largest = std::max(largest, step * p[order[i]]);
    out[order[i]] = p[order[i]] > 0.0 ? std::max(step, largest / p[order[i]]) : step;
  }
  return out;
}

Interval holmInterval(double difference, double error, double df, double factor, double confidence) {
  const double reach = tQuantile(1.0 - 0.5 * (1.0 - confidence) / factor, df) * error;
  return {difference - reach, difference + reach};
}

std::vector<double> adjustHochberg(std::span<const double> p) {
  return stepUp(p, [&](std::size_t rank) { return static_cast<double>(p.size() - rank + 1); });
}

std::vector<double> adjustBenjaminiHochberg(std::span<const double> p) {
  return stepUp(p,
                [&](std::size_t rank) { return static_cast<double>(p.size()) / static_cast<double>(rank); });
}

}  // namespace torsio
