// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "sim/geometry/mesh/iso_surface.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_thinning.h"

namespace torsio {
namespace {

/// A ball of voxels that are all or nothing: stairs.
TriangleMesh stairs() {
  const SampleGrid grid{{-24.0, -24.0, -24.0}, 1.0, {49, 49, 49}};
  return isoSurface(grid, [](std::size_t z, std::span<double> layer) {
    for (std::size_t n = 0; n < layer.size(); ++n) {
      const auto at = [](std::size_t i) { return static_cast<double>(i) - 24.0; };
      layer[n] = norm(Vec3{at(n % 49), at(n / 49), at(z)}) < 20.0 ? -1.0 : 1.0;
    }
  });
}

double unevenness(const TriangleMesh& ball) {
  double sum = 0.0;
  for (const Vec3& v : ball.vertices_m) {
    sum += std::pow(norm(v) - 20.0, 2);
  }
  return std::sqrt(sum / static_cast<double>(ball.vertices_m.size()));
}

TEST(SmoothedMesh, LosesItsStairsAndNotItsVolume) {
  TriangleMesh ball = stairs();
  const double volume = signedVolume_m3(ball);
  const double before = unevenness(ball);

  smooth(ball, 20);

  EXPECT_NEAR(signedVolume_m3(ball) / volume, 1.0, 2e-3);
  EXPECT_LT(unevenness(ball), 0.7 * before);
  EXPECT_TRUE(checkMesh(ball).closed());
}

}  // namespace
}  // namespace torsio
