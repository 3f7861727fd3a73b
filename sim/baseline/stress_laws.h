// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "sim/baseline/elastic_body.h"

namespace torsio {

/// A 3 x 3 matrix, column by column.
using Matrix3 = std::array<double, 9>;
/// d P / d F: entry [i + 9 k] is the change of number i of P by number k of F.
using Matrix9 = std::array<double, 81>;

/// Energy a volume at rest (J/m^3) and first Piola-Kirchhoff stress P = d energy / d F (Pa).
struct StressState {
  double energy_Pa = 0.0;
  Matrix3 stress_Pa{};
};

/// Computes the compressible neo-Hookean law W = G/2 (tr F^T F - 3) - G ln J + lambda/2 (ln J)^2 for a
/// deformation gradient with J = det F > 0.
[[nodiscard]] StressState neoHookeanStress(const Matrix3& gradient, const ElasticConstants& constants);
/// Computes its tangent d P / d F, Pa.
[[nodiscard]] Matrix9 neoHookeanTangent(const Matrix3& gradient, const ElasticConstants& constants);

/// Computes the rotation R of the polar decomposition F = R S; a gradient that is turned inside out gets the
/// nearest proper rotation.
[[nodiscard]] Matrix3 rotationOf(const Matrix3& gradient);

/// Computes the corotational law, linear elasticity in the turned frame of the element: W = G |F - R|^2 +
/// lambda/2 tr(R^T F - I)^2 with F = R S (Mueller and Gross 2004). Any F.
[[nodiscard]] StressState corotationalStress(const Matrix3& gradient, const ElasticConstants& constants);
/// Computes its exact tangent d P / d F, Pa, with the turn of R.
[[nodiscard]] Matrix9 corotationalTangent(const Matrix3& gradient, const ElasticConstants& constants);

}  // namespace torsio
