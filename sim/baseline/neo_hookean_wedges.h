// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "sim/baseline/elastic_body.h"

namespace torsio {

/// The accuracy reference: wedges, linear or quadratic (isoparametric), of compressible neo-Hookean material,
/// total Lagrangian, integrated at 6 points across and 3 along. Quadratic wedges hold torsion, bending and
/// warping; they do not lock.
class NeoHookeanWedges final : public ElasticBody {
 public:
  /// Prepares the integration points. `mesh`: linearWedges or quadraticWedges. Throws Error{kBadMesh} when
  /// an element is folded at rest, Error{kBadParameter} for the constants.
  NeoHookeanWedges(SolidMesh mesh, std::span<const Vec3> rest_m, const ElasticConstants& constants);

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
    std::array<Vec3, kMostElementNodes> gradients;
    double volume_m3 = 0.0;
  };
  SolidMesh mesh_;
  ElasticConstants constants_;
  std::vector<IntegrationPoint> points_;  ///< kPointsPerWedge an element
};

}  // namespace torsio
