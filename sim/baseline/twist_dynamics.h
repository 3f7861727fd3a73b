// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "sim/baseline/elastic_body.h"
#include "sim/baseline/swept_solid.h"
#include "sim/core/vec3.h"

namespace torsio {

/// What a model in motion needs beside its elasticity.
struct DynamicsOptions {
  double frame_s = 1.0 / 60.0;
  double density_kg_per_m3 = 1000.0;  ///< of tissue: with G 4 kPa a twist runs 2 m/s
  /// Damping against the surroundings, a share of the momentum a second; 0: none.
  double drag_per_s = 0.0;
};

/// Returns the drag that just keeps the slowest twist of the bar from swinging: 2 omega with omega = (pi / 2)
/// sqrt(G / density) / length.
[[nodiscard]] double criticalDrag_per_s(const ElasticConstants& constants, double density_kg_per_m3,
                                        double length_m);

/// Returns the mass of each node: a quarter of each of its tetrahedra, kg.
[[nodiscard]] std::vector<double> nodeMasses(const SolidMesh& tetrahedra, std::span<const Vec3> rest_m,
                                             double density_kg_per_m3);

/// Returns the moment of inertia of the turned end about its axis, kg m^2.
[[nodiscard]] double endInertia(const TwistEnds& ends, std::span<const Vec3> rest_m,
                                std::span<const double> masses_kg);

}  // namespace torsio
