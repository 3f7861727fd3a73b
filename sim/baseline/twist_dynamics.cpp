// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/twist_dynamics.h"

#include <cmath>

#include "sim/core/portable_math.h"

namespace torsio {

double criticalDrag_per_s(const ElasticConstants& constants, double density_kg_per_m3, double length_m) {
  return kPi * std::sqrt(constants.shearModulus_Pa / density_kg_per_m3) / length_m;
}

std::vector<double> nodeMasses(const SolidMesh& tetrahedra, std::span<const Vec3> rest_m,
                               double density_kg_per_m3) {
  std::vector<double> masses(rest_m.size());
  const std::vector<double> volumes_m3 = tetrahedronVolumes(tetrahedra, rest_m);
  for (std::size_t c = 0; c < tetrahedra.cells(); ++c) {
    for (const int node : tetrahedra.cell(c)) {
      masses[static_cast<std::size_t>(node)] += 0.25 * density_kg_per_m3 * volumes_m3[c];
    }
  }
  return masses;
}

double endInertia(const TwistEnds& ends, std::span<const Vec3> rest_m, std::span<const double> masses_kg) {
  double inertia = 0.0;
  for (const int node : ends.turned) {
    const auto i = static_cast<std::size_t>(node);
    const Vec3 motion = cross(ends.axis, rest_m[i] - ends.axisPoint_m);
    inertia += masses_kg[i] * dot(motion, motion);
  }
  return inertia;
}

}  // namespace torsio
