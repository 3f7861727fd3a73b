// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/shapiro_wilk.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <vector>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"

namespace torsio {

namespace {

double polynomial(std::initializer_list<double> coefficients, double x) {
  double value = 0.0;
  for (auto it = std::rbegin(coefficients); it != std::rend(coefficients); ++it) {
    value = value * x + *it;
  }
  return value;
}

/// Royston's approximate weights of the upper half, largest first.
std::vector<double> shapiroWeights(std::size_t count) {
  const double n = static_cast<double>(count);
  const std::size_t half = count / 2;
  std::vector<double> m;
  double squares = 0.0;
  for (std::size_t i = 1; i <= half; ++i) {
    m.push_back(normalQuantile((static_cast<double>(i) - 0.375) / (n + 0.25)));
    squares += 2.0 * m.back() * m.back();
  }
  const double root = 1.0 / std::sqrt(n);
  const double length = std::sqrt(squares);
  const double first =
      polynomial({0.0, 0.221157, -0.147981, -2.07119, 4.434685, -2.706056}, root) - m[0] / length;
  std::vector<double> a;
  a.push_back(first);
  std::size_t from = 1;
  double rest = squares - 2.0 * m[0] * m[0];
  double share = 1.0 - 2.0 * first * first;
  if (count > 5) {
    const double second =
        polynomial({0.0, 0.042981, -0.293762, -1.752461, 5.682633, -3.582633}, root) - m[1] / length;
    a.push_back(second);
    from = 2;
    rest -= 2.0 * m[1] * m[1];
    share -= 2.0 * second * second;
  }
  const double factor = std::sqrt(rest / share);
  for (std::size_t i = from; i < half; ++i) {
    a.push_back(-m[i] / factor);
  }
  return a;
}

}  // namespace

Outcome<NormalityTest> shapiroWilk(std::span<const double> values) {
  if (const std::optional<Text> reason = beyondArithmetic(values)) {
    return Outcome<NormalityTest>::undefined(*reason);
  }
  if (values.size() < 4 || values.size() > 5000) {
    return Outcome<NormalityTest>::undefined(Text::tr("the test is made for 4 to 5000 values"));
  }
  std::vector<double> x(values.begin(), values.end());
  std::sort(x.begin(), x.end());
  const double squares = squaresBeyondRounding(x);
  if (squares == 0.0) {
    return Outcome<NormalityTest>::undefined(Text::tr("the values do not vary"));
  }
  const std::vector<double> a = shapiroWeights(x.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i] * (x[x.size() - 1 - i] - x[i]);
  }
  NormalityTest out;
  out.w = sum * sum / squares;
  const double n = static_cast<double>(x.size());
  double z = std::log(1.0 - out.w);
  if (x.size() <= 11) {
    const double gamma = -2.273 + 0.459 * n;
    if (z >= gamma) {
      return NormalityTest{out.w, 1e-99};
    }
    const double mean = polynomial({0.5440, -0.39978, 0.025054, -6.714e-4}, n);
    const double deviation = std::exp(polynomial({1.3822, -0.77857, 0.062767, -0.0020322}, n));
    z = (-std::log(gamma - z) - mean) / deviation;
  } else {
    const double logN = std::log(n);
    const double mean = polynomial({-1.5861, -0.31082, -0.083751, 0.0038915}, logN);
    const double deviation = std::exp(polynomial({-0.4803, -0.082676, 0.0030302}, logN));
    z = (z - mean) / deviation;
  }
  out.p = normalUpper(z);
  return out;
}

}  // namespace torsio
