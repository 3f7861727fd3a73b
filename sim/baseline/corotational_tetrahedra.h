// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "sim/baseline/elastic_body.h"
#include "sim/baseline/stress_laws.h"

namespace torsio {

/// Finite elements as interactive simulators use them: linear tetrahedra, linear elasticity in the turned
/// frame of each. They lock: a coarse bar is much too stiff in torsion.
class CorotationalTetrahedra final : public ElasticBody {
 public:
  /// Prepares the elements. Throws Error{kBadParameter} for the constants.
  CorotationalTetrahedra(SolidMesh mesh, std::span<const Vec3> rest_m, const ElasticConstants& constants);

  [[nodiscard]] std::size_t elements() const noexcept override { return mesh_.cells(); }
  [[nodiscard]] std::span<const int> elementNodes(std::size_t element) const noexcept override {
    return mesh_.cell(element);
  }
  [[nodiscard]] bool elementForces(std::size_t element, std::span<const Vec3> places_m, double& energy_J,
                                   std::span<Vec3> forces_N) const override;
  void elementStiffness(std::size_t element, std::span<const Vec3> places_m,
                        std::span<double> stiffness) const override;

  /// Computes forces and the stiffness that interactive simulators use, R K R^T with the rotation held
  /// still: never indefinite. `blocks`: 16 matrices, the one of nodes a and b at [4 a + b].
  void warpedStiffness(std::size_t element, std::span<const Vec3> places_m, std::span<Vec3> forces_N,
                       std::span<Matrix3> blocks) const;

  [[nodiscard]] double volume_m3(std::size_t element) const noexcept { return volumes_m3_[element]; }

 private:
  [[nodiscard]] Matrix3 gradientOf(std::size_t element, std::span<const Vec3> places_m) const;

  SolidMesh mesh_;
  ElasticConstants constants_;
  std::vector<double> volumes_m3_;
  std::vector<std::array<Vec3, 4>> gradients_;  ///< of the shape functions by the place at rest, 1/m
};

}  // namespace torsio
