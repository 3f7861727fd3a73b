// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/hollow/tube_onset.h"

#include <algorithm>
#include <cmath>

namespace torsio {

namespace {

constexpr int kHalvings = 60;
constexpr double kUnpressurised = 2.643;  // Donnell's 0.736 E (1 - nu^2)^(-5/8) over G for nu = 0.5
constexpr double kPressurised = 1.7;      // fit to the linear shell under pressure
constexpr double kMaxHelp = 0.2;  // P from which on it helps the folds no more: there strains are finite
constexpr double kWaves = 3.7;
constexpr double kMoreWaves = 0.85;
constexpr double kMoreWavesAt = 0.2;

double fourthRoot(double x) {
  return std::sqrt(std::sqrt(x));
}

// Smaller principal stress over G, negative, that the folds' own bending holds.
double heldStress(const TubePlace& place) {
  const double thin = place.thinness;
  const double alone = kUnpressurised * thin * fourthRoot(thin) / std::sqrt(place.slenderness);
  const double sixteenth = fourthRoot(fourthRoot(thin));
  const double pressed = kPressurised * thin / sixteenth * fourthRoot(std::min(place.pressure, kMaxHelp));
  const auto fourth = [](double x) { return x * x * x * x; };
  return fourthRoot(fourth(alone) + fourth(pressed));
}

}  // namespace

TautTube tautTube(double pressure, double gentLimit, double omega) {
  const WallLaw law{gentLimit, 0.0};
  const auto metric = [omega](double stretch) {
    const double along = stretch * omega;
    return WallMetric{1.0 + along * along, along * stretch, stretch * stretch};
  };
  const auto invariant = [&](double stretch) {
    const WallMetric m = metric(stretch);
    return m.a + m.c + 1.0 / (stretch * stretch) - 3.0;
  };
  // Hoop balance: what the wall holds rises with the stretch faster than what the pressure pushes.
  double low = 0.25;
  double high = 1.0 + std::sqrt(gentLimit + 4.0);
  for (int k = 0; k < kHalvings; ++k) {
    const double stretch = 0.5 * (low + high);
    const double i = invariant(stretch);
    const double held =
        2.0 * gentSlope(law, i) * (stretch * omega * omega + stretch - 1.0 / (stretch * stretch * stretch));
    const bool wide = (i >= gentLimit && stretch > 1.0) || held > pressure * stretch;
    (wide ? high : low) = stretch;
  }
  TautTube tube;
  tube.stretch = low;
  tube.torque = 2.0 * gentSlope(law, invariant(low)) * low * low * omega;
  tube.excess = wallStretch(metric(low)).excess;
  return tube;
}

double restStretch(double pressureRtoGt, double gentLimit) {
  double low = 1.0;
  double high = 1.0 + std::sqrt(gentLimit + 2.0);
  for (int k = 0; k < kHalvings; ++k) {
    const double stretch = 0.5 * (low + high);
    const double square = stretch * stretch;
    const double left = gentLimit - (square + 1.0 / square - 2.0);
    const bool wide = left <= 0.0 || gentLimit / left * (square - 1.0 / square) > pressureRtoGt;
    (wide ? high : low) = stretch;
  }
  return low;
}

int foldWaves(const TubePlace& place) {
  const double alone = kWaves * fourthRoot(1.0 / place.thinness) / std::sqrt(place.slenderness);
  const double waves = alone * (1.0 + kMoreWaves * place.pressure / (place.pressure + kMoreWavesAt));
  return std::max(2, static_cast<int>(std::lround(waves)));
}

double foldOnset(const TubePlace& place) {
  // The strain across the folds of a tube without pressure that is sheared to that stress.
  const double limit = tautTube(0.0, place.gentLimit, heldStress(place)).excess;
  double low = 0.0;
  double high = 1.0;
  while (tautTube(place.pressure, place.gentLimit, high).excess < limit && high < 64.0) {
    high *= 2.0;
  }
  for (int k = 0; k < kHalvings; ++k) {
    const double omega = 0.5 * (low + high);
    (tautTube(place.pressure, place.gentLimit, omega).excess < limit ? low : high) = omega;
  }
  return low;
}

}  // namespace torsio
