// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_crossings.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/procedural_mesh.h"

namespace torsio {
namespace {

/// Both meshes as one, corners renumbered.
TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.vertices_m.size());
  a.vertices_m.insert(a.vertices_m.end(), b.vertices_m.begin(), b.vertices_m.end());
  for (const TriangleMesh::Triangle& t : b.triangles) {
    a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  return a;
}

TriangleMesh triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {{a, b, c}, {{0, 1, 2}}};
}

TEST(CrossingTriangles, ATriangleThroughAnotherIsOnePair) {
  const TriangleMesh flat = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(crossingTriangles(together(flat, triangle({0.2, 0.2, -1}, {0.2, 0.2, 1}, {5, 5, 1}))),
            (std::vector<TrianglePair>{{0, 1}}));
  EXPECT_TRUE(crossingTriangles(together(flat, triangle({2, 2, -1}, {2, 2, 1}, {5, 5, 1}))).empty());
  EXPECT_TRUE(crossingTriangles(together(flat, triangle({0.2, 0.2, 0}, {0.2, 0.2, 1}, {5, 5, 1}))).empty())
      << "touching is not cutting";
}

TEST(CrossingTriangles, NeighboursOnASurfaceAreNotCompared) {
  // Two triangles that share corner 0; the edge of the second runs through the first.
  const TriangleMesh fan{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, -1}, {0.3, 0.3, 1}},
                         {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_TRUE(crossingTriangles(fan).empty());
}

TEST(CrossingTriangles, AClosedSurfaceAtRestHasNone) {
  EXPECT_TRUE(crossingTriangles(testing::capsule(0.02, 0.2, 48, 40)).empty());
  EXPECT_TRUE(crossingTriangles(testing::jTube(0.02, 0.1, 0.05, 32, 60)).empty());
  EXPECT_TRUE(crossingTriangles({}).empty());
}

TEST(CrossingTriangles, AreThoseThatEveryPairByItselfGives) {
  const TriangleMesh bar = testing::capsule(0.02, 0.1, 16, 12);
  const TriangleMesh both =
      together(bar, testing::shifted(testing::turned(bar, {1, 0, 0}, 1.1), {0.007, 0.03, 0.04}));
  std::vector<TrianglePair> expected;
  for (std::uint32_t i = 0; i < both.triangles.size(); ++i) {
    for (std::uint32_t j = i + 1; j < both.triangles.size(); ++j) {
      if (!crossingTriangles({both.vertices_m, {both.triangles[i], both.triangles[j]}}).empty()) {
        expected.emplace_back(i, j);
      }
    }
  }

  EXPECT_EQ(crossingTriangles(both), expected);
  EXPECT_GT(expected.size(), 20U);
}

}  // namespace
}  // namespace torsio
