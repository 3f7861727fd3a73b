// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/swept_solid.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "tests/sim/baseline/bars.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

double sumOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Volume within the faces that only one tetrahedron has, by the divergence theorem.
double boundaryVolume_m3(const SolidMesh& mesh, const std::vector<Vec3>& points) {
  std::map<std::array<int, 3>, std::array<int, 3>> faces;
  constexpr std::array<std::array<std::size_t, 3>, 4> kFaces{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  for (std::size_t c = 0; c < mesh.cells(); ++c) {
    for (const auto& f : kFaces) {
      const std::array<int, 3> face{mesh.cell(c)[f[0]], mesh.cell(c)[f[1]], mesh.cell(c)[f[2]]};
      std::array<int, 3> key = face;
      std::sort(key.begin(), key.end());
      if (faces.erase(key) == 0) {
        faces.emplace(key, face);
      }
    }
  }
  double six = 0.0;
  for (const auto& entry : faces) {
    const std::array<int, 3>& face = entry.second;
    const auto at = [&](std::size_t k) { return points[static_cast<std::size_t>(face[k])]; };
    six += dot(at(0), cross(at(1), at(2)));
  }
  return six / 6.0;
}

TEST(SweptSolid, TetrahedraFillAPolygonalBar) {
  const SweptSolid bar = straightBar(12, 4, 3, 0.02, 0.12);

  const std::vector<double> volumes = tetrahedronVolumes(tetrahedra(bar), bar.points_m);

  // 4 layers of 12 + 2 rings of 24 triangles, 3 tetrahedra a prism. Area of the 12-gon: 3 R^2.
  EXPECT_EQ(volumes.size(), 4U * 60U * 3U);
  EXPECT_GT(*std::min_element(volumes.begin(), volumes.end()), 0.0);
  EXPECT_NEAR(sumOf(volumes) / (3.0 * 0.02 * 0.02 * 0.12), 1.0, 1e-12);
}

TEST(SweptSolid, TetrahedraOfABentBarShareTheirFacesAndFillIt) {
  const SweptSolid bar = bentBar(36, 36, 4, 0.025, 0.24, kPi / 2.0);
  const SolidMesh mesh = tetrahedra(bar);

  const std::vector<double> volumes = tetrahedronVolumes(mesh, bar.points_m);

  // 36 layers of 252 triangles. What is left over between cells would be missing from the faces.
  EXPECT_EQ(mesh.cells(), 27216U);
  EXPECT_GT(*std::min_element(volumes.begin(), volumes.end()), 0.0);
  EXPECT_NEAR(sumOf(volumes) / boundaryVolume_m3(mesh, bar.points_m), 1.0, 1e-12);
  // Pappus: area of the 36-gon (18 R^2 sin 10 degrees) times the way of its centroid. Prisms of 2.5 degrees
  // in place of the arc: sin(x) cos(x) / x with x = 1.25 degrees is 1 - 3.17e-4.
  const double expected_m3 = 18.0 * 0.025 * 0.025 * std::sin(kPi / 18.0) * 0.24;
  EXPECT_NEAR(sumOf(volumes) / expected_m3, 1.0 - 3.17e-4, 1e-6);
}

TEST(SweptSolid, LinearWedgesAreTheTrianglesOfEachLayer) {
  const SweptSolid bar = straightBar(8, 3, 2, 0.02, 0.06);

  const SolidMesh wedges = linearWedges(bar);

  ASSERT_EQ(wedges.cells(), 3U * (8U + 16U));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(wedges.cell(0)[k + 3] - wedges.cell(0)[k], bar.pointsPerSection());
  }
}

TEST(SweptSolid, QuadraticWedgesHaveTheirMiddlesOnTheGrid) {
  const SweptSolid bar = straightBar(8, 4, 2, 0.02, 0.08);

  const SolidMesh wedges = quadraticWedges(bar);

  ASSERT_EQ(wedges.cells(), 2U * 4U);
  ASSERT_EQ(wedges.nodesPerCell, 18);
  const auto at = [&](std::size_t k) { return bar.points_m[static_cast<std::size_t>(wedges.cell(0)[k])]; };
  EXPECT_NEAR(norm(at(3) - 0.5 * (at(0) + at(1))), 0.0, 1e-15);   // a spoke is straight
  EXPECT_NEAR(norm(at(6) - 0.5 * (at(0) + at(12))), 0.0, 1e-15);  // so is the way along
  EXPECT_NEAR(norm(at(4) - Vec3{0.0, 0.0, 0.0}), 0.02, 1e-15);    // the outline's middle is on the circle
}

TEST(SweptSolid, QuadraticTetrahedraFillTheirWedgesWithMiddlesBetweenTheirCorners) {
  const SweptSolid bar = straightBar(8, 4, 2, 0.02, 0.08);

  const SolidMesh mesh = quadraticTetrahedra(bar);

  ASSERT_EQ(mesh.nodesPerCell, kQuadraticTetrahedronNodes);
  ASSERT_EQ(mesh.cells(), 3U * quadraticWedges(bar).cells());
  double volume_m3 = 0.0;
  for (std::size_t c = 0; c < mesh.cells(); ++c) {
    const auto at = [&](std::size_t k) { return bar.points_m[static_cast<std::size_t>(mesh.cell(c)[k])]; };
    const double own_m3 = dot(cross(at(1) - at(0), at(2) - at(0)), at(3) - at(0)) / 6.0;
    EXPECT_GT(own_m3, 0.0);
    volume_m3 += own_m3;
    std::size_t middle = 4;
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t m = k + 1; m < 4; ++m) {
        // On the outline the middle lies on the circle, 1 - cos(45 degrees) of the radius from the chord.
        EXPECT_LT(norm(at(middle++) - 0.5 * (at(k) + at(m))), 0.3 * 0.02);
      }
    }
  }
  // Four corners of a square of half a diagonal of 20 mm, 80 mm long.
  EXPECT_NEAR(volume_m3, 2.0 * 0.02 * 0.02 * 0.08, 1e-15);
  const SweptSolid odd = straightBar(9, 4, 2, 0.02, 0.08);
  EXPECT_THROW(static_cast<void>(quadraticTetrahedra(odd)), Error);
}

TEST(SweptSolid, QuadraticWedgesRefuseALatticeThatTheyCannotPair) {
  const SweptSolid bar = straightBar(9, 4, 2, 0.02, 0.08);

  EXPECT_THROW(static_cast<void>(quadraticWedges(bar)), Error);
}

TEST(SweptSolid, RefusesAnOutlineThatIsNotStarShaped) {
  std::vector<std::vector<Vec3>> outlines;
  for (const double z : {0.0, 1.0}) {  // a thin U: its centroid lies outside
    outlines.push_back(
        {{0, 0, z}, {10, 0, z}, {10, 10, z}, {9, 10, z}, {9, 1, z}, {1, 1, z}, {1, 10, z}, {0, 10, z}});
  }

  const Error error = testing::refusal([&] { return sweptSolid(outlines, {0.0, 0.0, 1.0}, 2); });
  EXPECT_EQ(error.code(), ErrorCode::kBadMesh);
  EXPECT_EQ(error.where(), "section 1 to the next");
}

TEST(SweptSolid, RefusesNumbersWithoutMeaning) {
  const auto outlines = straightOutlines(6, 2, 0.02, 0.06);
  const auto one = std::vector<std::vector<Vec3>>{outlines.front()};
  auto uneven = outlines;
  uneven[1].pop_back();
  auto broken = outlines;
  broken[2][3].y = std::nan("");

  EXPECT_THROW(static_cast<void>(sweptSolid(outlines, {0, 0, 1}, 0)), Error);
  EXPECT_THROW(static_cast<void>(sweptSolid(one, {0, 0, 1}, 1)), Error);
  EXPECT_THROW(static_cast<void>(sweptSolid(uneven, {0, 0, 1}, 1)), Error);
  EXPECT_THROW(static_cast<void>(sweptSolid(broken, {0, 0, 1}, 1)), Error);
  EXPECT_THROW(static_cast<void>(sweptSolid(outlines, {0, 0, 1}, 100'000)), Error);
}

}  // namespace
}  // namespace torsio
