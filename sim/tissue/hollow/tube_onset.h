// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/core/portable_math.h"

namespace torsio {

/// Law of a thin wall that folds: Gent's law where it is taut, a tension field held by the bending of its
/// folds where it is slack (docs/model.md H.3). All energies are per area and over G t.
struct WallLaw {
  double gentLimit = 1.0;  ///< J_m > 0: I - 3 at which the wall locks
  double foldHold = 0.0;   ///< s = S_b / (G t) >= 0: the stress across the folds that their bending holds
};

/// Metric of the wall at one place, of a line element (dZ, R dTheta): A along, C around, B between; and what
/// the wall makes of it.
struct WallMetric {
  double a = 1.0;
  double b = 0.0;
  double c = 1.0;
};

/// Principal stretches of a metric, and how far the wall is from its natural width across the larger one.
struct WallStretch {
  double l1 = 1.0;      ///< larger squared stretch
  double x = 1.0;       ///< its root
  double y = 1.0;       ///< smaller stretch
  double det = 1.0;     ///< of the metric, at least kLeastMetric
  double half = 0.0;    ///< half the difference of the squared stretches
  double excess = 0.0;  ///< delta: natural width less y; above 0 the wall folds
};

inline constexpr double kLeastMetric = 1e-12;
inline constexpr double kLockedShare = 0.999;  ///< of J_m, beyond which Gent's law goes on with its slope

/// Computes the principal stretches of a metric. In the tick if need be: + - * / and roots only.
[[nodiscard]] inline WallStretch wallStretch(const WallMetric& m) noexcept {
  WallStretch s;
  s.half = std::sqrt(std::max((m.a - m.c) * (m.a - m.c) * 0.25 + m.b * m.b, 1e-18));
  s.l1 = 0.5 * (m.a + m.c) + s.half;
  s.det = std::max(m.a * m.c - m.b * m.b, kLeastMetric);
  s.x = std::sqrt(s.l1);
  s.y = std::sqrt(s.det / s.l1);
  s.excess = 1.0 / std::sqrt(s.x) - s.y;
  return s;
}

/// Returns I - 3 of the wall: of the folded wall with its natural width, 0 where it is slack both ways.
[[nodiscard]] inline double wallInvariant(const WallMetric& m, const WallStretch& s) noexcept {
  if (s.excess <= 0.0) {
    return m.a + m.c + 1.0 / s.det - 3.0;
  }
  return s.x < 1.0 ? 0.0 : s.l1 + 2.0 / s.x - 3.0;
}

/// Returns dW / dI over G t of Gent's law: J_m / (2 (J_m - I)), capped where the wall is locked.
[[nodiscard]] inline double gentSlope(const WallLaw& law, double invariant) noexcept {
  return 0.5 * law.gentLimit / std::max(law.gentLimit - invariant, (1.0 - kLockedShare) * law.gentLimit);
}

/// Returns -log(1 - x) for x in [0, 1), to rounding also where x is small.
[[nodiscard]] inline double logarithmOfRest(double x) noexcept {
  constexpr double kSmall = 1e-3;
  return x < kSmall ? x * (1.0 + x * (0.5 + x * (1.0 / 3.0 + x * (0.25 + x * 0.2)))) : -portableLog(1.0 - x);
}

/// Returns the energy of the wall per area over G t. Not in the tick: a logarithm.
[[nodiscard]] inline double wallEnergy(const WallLaw& law, const WallMetric& m) noexcept {
  const WallStretch s = wallStretch(m);
  const double share = wallInvariant(m, s) / law.gentLimit;
  const double inside = std::min(share, kLockedShare);
  const double beyond = std::max(share - kLockedShare, 0.0) / (1.0 - kLockedShare);
  double energy = 0.5 * law.gentLimit * (beyond + logarithmOfRest(inside));
  if (s.excess > 0.0) {
    energy += s.excess < 0.25 * law.foldHold ? 2.0 * s.excess * s.excess
                                             : law.foldHold * (s.excess - 0.125 * law.foldHold);
  }
  return energy;
}

/// Returns the derivatives of wallEnergy by A, B and C. + - * / and roots only.
[[nodiscard]] inline WallMetric wallStress(const WallLaw& law, const WallMetric& m) noexcept {
  const WallStretch s = wallStretch(m);
  const double slope = gentSlope(law, wallInvariant(m, s));
  if (s.excess <= 0.0) {
    const double inverse = 1.0 / (s.det * s.det);
    return {slope * (1.0 - m.c * inverse), 2.0 * slope * m.b * inverse, slope * (1.0 - m.a * inverse)};
  }
  const double along = 0.25 * (m.a - m.c) / s.half;
  const WallMetric larger{0.5 + along, m.b / s.half, 0.5 - along};  // d l1
  const double taut = s.x < 1.0 ? 0.0 : slope * (1.0 - 1.0 / (s.l1 * s.x));
  const double held = std::min(4.0 * s.excess, law.foldHold);  // d b / d delta
  // delta = x^(-1/2) - y, x^2 = l1, y^2 = A + C - l1 to first order of a metric of determinant l1 l2.
  const double byLarger = -0.25 / (std::sqrt(s.x) * s.l1);
  const double bySmaller = -0.5 / std::max(s.y, 1e-6);
  const double onLarger = taut + held * (byLarger - bySmaller);
  return {onLarger * larger.a + held * bySmaller, onLarger * larger.b,
          onLarger * larger.c + held * bySmaller};
}

/// A round tube at one place, unloaded: what decides when it folds.
struct TubePlace {
  double thinness = 0.05;  ///< t / R
  double slenderness = 6;  ///< L / R
  double pressure = 0.0;   ///< P = p R / (G t)
  double gentLimit = 1.0;  ///< J_m
};

/// A long round tube of fixed length, twisted without folds.
struct TautTube {
  double stretch = 1.0;  ///< lambda = r / R
  double torque = 0.0;   ///< m = T / (2 pi G t R^2)
  double excess = 0.0;   ///< delta of its wall (RelaxedWall)
};

/// Computes a taut tube at the twist rate `omega` = R dphi/dz from the balance of its hoops (docs/model.md
/// H.2).
[[nodiscard]] TautTube tautTube(double pressure, double gentLimit, double omega);

/// Returns the hoop stretch of a tube that a pressure p has widened at fixed length, from the radius R and
/// the thickness t that it has then: g (lambda^2 - lambda^-2) = p R / (G t).
[[nodiscard]] double restStretch(double pressureRtoGt, double gentLimit);

/// Returns the number of folds round a tube, at least 2: 3.7 (R / t)^(1/4) (R / L)^(1/2) of the unpressurised
/// shell, raised by pressure as runs in three dimensions show.
[[nodiscard]] int foldWaves(const TubePlace& place);

/// Returns omega = R dphi/dz at which a shell begins to fold: Donnell's formula without pressure; with
/// pressure where the smaller principal stress falls to what the bending of the folds holds, a fit to the
/// linear shell (docs/model.md H.2).
[[nodiscard]] double foldOnset(const TubePlace& place);

}  // namespace torsio
