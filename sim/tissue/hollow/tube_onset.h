// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

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
  double excess = 0.0;   ///< delta of its wall (relaxed_wall.h)
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
