// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/ratio_differences.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr std::size_t kFewValues = 2000;  // up to this many, every pair is computed directly
constexpr std::size_t kNodes = 12;
constexpr double kBoxWidth = 0.5;  // in log units

double everyPair(std::span<const double> values, std::span<const double> counts) {
  double sum = 0.0;
  for (std::size_t c = 0; c < values.size(); ++c) {
    for (std::size_t k = 0; k < c && counts[c] > 0.0; ++k) {
      sum += 2.0 * counts[c] * counts[k] * ratioDifference2(values[c], values[k]);
    }
  }
  return sum;
}

/// Values with close logarithms, as weights on Chebyshev nodes: any smooth function of the logarithm has the
/// same sum over the nodes as over the values.
struct Box {
  double first = 0.0;
  std::array<double, kNodes> nodes{};  ///< logarithm of value / first
  std::array<double, kNodes> weights{};
};

Box boxOf(std::span<const double> values, std::span<const double> counts) {
  Box box;
  box.first = values.front();
  const auto logarithm = [&](double value) { return std::log1p((value - box.first) / box.first); };
  const double width = logarithm(values.back());
  std::array<double, kNodes> barycentric{};
  for (std::size_t m = 0; m < kNodes; ++m) {
    const double angle = std::numbers::pi * (2.0 * static_cast<double>(m) + 1.0) / (2.0 * kNodes);
    box.nodes[m] = 0.5 * width * (1.0 + std::cos(angle));
    barycentric[m] = (m % 2 == 0 ? 1.0 : -1.0) * std::sin(angle);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double at = logarithm(values[i]);
    std::array<double, kNodes> share{};
    double sum = 0.0;
    std::size_t hit = kNodes;
    for (std::size_t m = 0; m < kNodes; ++m) {
      if (at == box.nodes[m]) {
        hit = m;
        break;
      }
      share[m] = barycentric[m] / (at - box.nodes[m]);
      sum += share[m];
    }
    if (hit < kNodes) {
      box.weights[hit] += counts[i];
      continue;
    }
    for (std::size_t m = 0; m < kNodes; ++m) {
      box.weights[m] += counts[i] * share[m] / sum;
    }
  }
  return box;
}

/// ((a - b) / (a + b))^2 is the squared hyperbolic tangent of half the difference of logarithms: smooth, with
/// no pole nearer than pi, so that twelve nodes on half a unit are exact to rounding.
double betweenBoxes(const Box& a, const Box& b) {
  const double apart = std::log(a.first / b.first);
  double sum = 0.0;
  for (std::size_t m = 0; m < kNodes; ++m) {
    for (std::size_t k = 0; k < kNodes; ++k) {
      const double t = std::tanh(0.5 * (apart + (a.nodes[m] - b.nodes[k])));
      sum += a.weights[m] * b.weights[k] * t * t;
    }
  }
  return sum;
}

}  // namespace

double ratioDifference2(double a, double b) {
  const double sum = a + b;
  const double ratio = sum == 0.0 ? 0.0 : (a - b) / sum;
  return ratio * ratio;
}

double sumOfRatioDifferences2(std::span<const double> values, std::span<const double> counts) {
  TORSIO_EXPECTS(values.size() == counts.size());
  if (values.size() <= kFewValues || values.front() < 0.0) {
    return everyPair(values, counts);
  }
  const std::size_t zeros = values.front() == 0.0 ? 1 : 0;
  double positive = 0.0;
  std::vector<Box> boxes;
  for (std::size_t from = zeros; from < values.size();) {
    std::size_t to = from;
    while (to < values.size() && values[to] <= values[from] * std::exp(kBoxWidth)) {
      positive += counts[to++];
    }
    boxes.push_back(boxOf(values.subspan(from, to - from), counts.subspan(from, to - from)));
    from = to;
  }
  double sum = zeros == 1 ? 2.0 * counts.front() * positive : 0.0;
  for (std::size_t a = 0; a < boxes.size(); ++a) {
    sum += betweenBoxes(boxes[a], boxes[a]);
    for (std::size_t b = 0; b < a; ++b) {
      sum += 2.0 * betweenBoxes(boxes[a], boxes[b]);
    }
  }
  return sum;
}

}  // namespace torsio
