// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/hollow/fold_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "sim/core/angle.h"
#include "sim/core/portable_math.h"

namespace torsio {

namespace {

constexpr std::size_t kSteps = FoldDepths::kSteps;
constexpr int kSamples = 64;  // of a wave: the sum over a period converges faster than any power
constexpr int kAmplitudeHalvings = 40;

/// Amplitudes over v = sqrt(1 / slack^2 - 1), in which they begin as a straight line.
struct AmplitudeTable {
  double most = 0.0;
  std::array<double, kSteps + 1> amplitudes{};
  FoldDepths rounded;
};

double excessOf(double perimeter) {
  return std::sqrt(std::max(perimeter * perimeter - 1.0, 0.0));
}

AmplitudeTable tableOf(int waves) {
  AmplitudeTable table;
  table.most = excessOf(foldedPerimeter(waves, kDeepestFold));
  for (std::size_t k = 1; k <= kSteps; ++k) {
    const double excess = table.most * static_cast<double>(k) / static_cast<double>(kSteps);
    double low = 0.0;
    double high = kDeepestFold;
    for (int i = 0; i < kAmplitudeHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      (excessOf(foldedPerimeter(waves, middle)) < excess ? low : high) = middle;
    }
    table.amplitudes[k] = 0.5 * (low + high);
    table.rounded.depths[k] = static_cast<float>(table.amplitudes[k]);
  }
  table.rounded.each = static_cast<float>(static_cast<double>(kSteps) / table.most);
  return table;
}

using Tables = std::array<AmplitudeTable, kMaxDrawnWaves - kMinDrawnWaves + 1>;

const AmplitudeTable& tableFor(int waves) {
  static const Tables kTables = [] {
    Tables tables;
    for (int n = kMinDrawnWaves; n <= kMaxDrawnWaves; ++n) {
      tables[static_cast<std::size_t>(n - kMinDrawnWaves)] = tableOf(n);
    }
    return tables;
  }();
  return kTables[static_cast<std::size_t>(drawnWaves(waves) - kMinDrawnWaves)];
}

double secondOrder(double waves) {
  return 0.5 + 0.25 * waves * waves;
}

}  // namespace

int drawnWaves(int waves) noexcept {
  return std::clamp(waves, kMinDrawnWaves, kMaxDrawnWaves);
}

double foldedPerimeter(int waves, double amplitude) noexcept {
  const double n = waves;
  double sum = 0.0;
  for (int k = 0; k < kSamples; ++k) {
    const SinCos a = portableSinCos(kTurn * (k + 0.5) / kSamples);
    const double rise = -n * amplitude * a.sin;
    const double round =
        1.0 - amplitude * a.cos + amplitude * amplitude * secondOrder(n) * (a.cos * a.cos - a.sin * a.sin);
    const double across = (1.0 + amplitude * a.cos) * round;
    sum += std::sqrt(rise * rise + across * across);
  }
  return sum / kSamples;
}

double foldAmplitude(int waves, double slack) noexcept {
  if (slack >= 1.0) {
    return 0.0;
  }
  const AmplitudeTable& table = tableFor(waves);
  const double excess = slack > 0.0 ? std::sqrt(1.0 / (slack * slack) - 1.0) : table.most;
  if (excess >= table.most) {
    return kDeepestFold;
  }
  const double at = excess / table.most * static_cast<double>(kSteps);
  const std::size_t cell = std::min(static_cast<std::size_t>(at), kSteps - 1);
  const double share = at - static_cast<double>(cell);
  return table.amplitudes[cell] + share * (table.amplitudes[cell + 1] - table.amplitudes[cell]);
}

const FoldDepths& foldDepths(int waves) noexcept {
  return tableFor(waves).rounded;
}

FoldPhase foldPhase(const FoldWaves& folds) noexcept {
  if (folds.amplitude == 0.0) {
    return {};
  }
  const SinCos a = portableSinCos(folds.waves * folds.crest_rad);
  return {folds.amplitude * a.cos, folds.amplitude * a.sin};
}

RoundWave roundWave(int waves, double round_rad) noexcept {
  const SinCos a = portableSinCos(waves * round_rad);
  return {a.cos, a.sin};
}

FoldedPoint foldedPoint(int waves, const FoldPhase& phase, const RoundWave& round) noexcept {
  const double n = waves;
  const double up = phase.even * round.cos + phase.odd * round.sin;
  const double aside = phase.even * round.sin - phase.odd * round.cos;
  return {1.0 + up, aside * (secondOrder(n) * up - 1.0) / n};
}

}  // namespace torsio
