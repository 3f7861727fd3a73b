// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "sim/baseline/elastic_body.h"

namespace torsio {

/// The accuracy reference: wedges, linear or quadratic, or quadratic tetrahedra, isoparametric, of
/// compressible neo-Hookean material, total Lagrangian. Wedges are integrated at 6 points across and 3 along,
/// tetrahedra at 4. Quadratic elements hold torsion, bending and warping; they do not lock.
class NeoHookeanElements final : public ElasticBody {
 public:
  /// Prepares the integration points. `mesh`: linearWedges, quadraticWedges or
  /// quadraticTetrahedra. Throws Error{kBadMesh} when
  /// an element is folded at rest, Error{kBadParameter} for the constants.
  NeoHookeanElements(SolidMesh mesh, std::span<const Vec3> rest_m, const ElasticConstants& constants);

  [[nodiscard]] std::size_t elements() const noexcept override { return mesh_.cells(); }
  [[nodiscard]] std::span<const int> elementNodes(std::size_t element) const noexcept override {
    return mesh_.cell(element);
  }
  [[nodiscard]] bool elementForces(std::size_t element, std::span<const Vec3> places_m, double& energy_J,
                                   std::span<Vec3> forces_N) const override;
  void elementStiffness(std::size_t element, std::span<const Vec3> places_m,
                        std::span<double> stiffness) const override;

 private:
  /// Derivatives of the shape functions by the place at rest, and the volume that the point stands for.
  struct IntegrationPoint {
    std::array<Vec3, kMaxElementNodes> gradients;
    double volume_m3 = 0.0;
  };
  SolidMesh mesh_;
  ElasticConstants constants_;
  std::size_t pointsPerElement_ = 0;
  std::vector<IntegrationPoint> points_;
};

}  // namespace torsio
