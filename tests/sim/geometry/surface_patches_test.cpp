// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/surface_patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/random.h"
#include "sim/geometry/query/collision_mesh.h"
#include "sim/geometry/query/deformed_surface.h"
#include "tests/sim/geometry/shapes.h"
#include "tests/support/allocation_count.h"

namespace torsio {
namespace {

TEST(SurfacePatches, HoldEveryTriangleOnceAndEveryVertexWithinTheirRadius) {
  const TriangleMesh mesh = testing::torus(0.06, 0.02, 96, 48);
  const SurfacePatches patches(mesh);

  std::vector<int> seen(mesh.triangles.size(), 0);
  for (const SurfacePatches::Group& group : patches.groups()) {
    const Vec3 groupSeed_m = mesh.vertices_m[group.seed];
    for (const SurfacePatches::Patch& patch : patches.patches().subspan(group.firstPatch, group.patchCount)) {
      const auto vertices = patches.vertices(patch);
      for (const SurfacePatches::Facet& facet : patches.facets(patch)) {
        ++seen[facet.triangle];
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t vertex = vertices[facet.corner[k]];
          ASSERT_EQ(vertex, mesh.triangles[facet.triangle][k]);
          const Vec3& v = mesh.vertices_m[vertex];
          ASSERT_LE(norm(v - mesh.vertices_m[patch.seed]), patch.radius_m);
          ASSERT_LE(norm(v - groupSeed_m), group.radius_m);
        }
      }
    }
  }
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
  EXPECT_EQ(patches.patches().size(), mesh.triangles.size() / 32);
}

/// A bend and a stretch of the body, as places of its vertices.
struct Bent {
  std::vector<Vec3> places_m;
  static Vec3 at(const void* self, std::uint32_t vertex) noexcept {
    return static_cast<const Bent*>(self)->places_m[vertex];
  }
};

TEST(DeformedSurface, AnswersLikeAMeshThatWasBuiltFromTheMovedVertices) {
  TriangleMesh mesh = testing::ellipsoid({0.03, 0.04, 0.1}, 64, 48);
  const SurfacePatches patches(mesh);
  for (Vec3& v : mesh.vertices_m) {
    const double turn = 8.0 * v.z;
    v = {std::cos(turn) * v.x - std::sin(turn) * v.y, std::sin(turn) * v.x + std::cos(turn) * v.y, 1.1 * v.z};
    v.x += 3.0 * v.z * v.z;
  }
  const Bent bent{mesh.vertices_m};
  const CollisionMesh built(mesh);
  Random random(8);
  const auto within = [&random](double low, double high) { return low + (high - low) * random.uniform(); };
  for (int i = 0; i < 1'000; ++i) {
    const Vec3 from{within(-0.08, 0.12), within(-0.08, 0.08), within(-0.14, 0.14)};
    const Vec3 to = from + Vec3{random.normal(), random.normal(), random.normal()} * 0.05;
    DeformedSurface surface(patches, {&bent, &Bent::at});

    const std::int64_t before = testing::allocationCount();
    const SurfacePoint point = surface.closest(from);
    const SegmentHit hit = surface.nearest({from, to}, 0.01);
    ASSERT_EQ(testing::allocationCount(), before);

    const SurfacePoint expected = built.closest(from);
    ASSERT_NEAR(point.distance_m, expected.distance_m, 1e-12);
    ASSERT_NEAR(norm(point.normal - expected.normal), 0.0, 1e-6);
    const SegmentHit expectedHit = built.nearest({from, to}, 0.01);
    ASSERT_EQ(hit.found, expectedHit.found);
    if (!hit.found) {
      continue;
    }
    ASSERT_NEAR(hit.surface.distance_m, expectedHit.surface.distance_m, 1e-12);
  }
}

TEST(DeformedSurface, AnswersTheSameWhateverTriangleASearchBeginsWith) {
  const TriangleMesh mesh = testing::ellipsoid({0.03, 0.04, 0.1}, 64, 48);
  const SurfacePatches patches(mesh);
  const Bent rest{mesh.vertices_m};
  const CollisionMesh built(mesh);
  DeformedSurface deformed(patches, {&rest, &Bent::at});
  Random random(10);
  for (int i = 0; i < 500; ++i) {
    const Vec3 from{0.05 * random.normal(), 0.05 * random.normal(), 0.1 * random.normal()};
    const Vec3 to = from + Vec3{random.normal(), random.normal(), random.normal()} * 0.05;
    const auto hint = static_cast<std::uint32_t>(random.bounded(mesh.triangles.size() + 2));
    const auto compare = [&](auto& surface) {
      const SurfacePoint point = surface.closest(from, hint);
      const SegmentHit hit = surface.nearest({from, to}, 0.02, hint);

      const SurfacePoint expected = surface.closest(from);
      const SegmentHit expectedHit = surface.nearest({from, to}, 0.02);
      ASSERT_EQ(point.triangle, expected.triangle);
      ASSERT_EQ(point.distance_m, expected.distance_m);
      ASSERT_EQ(point.position_m, expected.position_m);
      ASSERT_EQ(hit.found, expectedHit.found);
      ASSERT_EQ(hit.along, expectedHit.along);
      ASSERT_EQ(hit.surface.triangle, expectedHit.surface.triangle);
      ASSERT_EQ(hit.surface.distance_m, expectedHit.surface.distance_m);
    };
    compare(built);
    compare(deformed);
  }
}

TEST(DeformedSurface, AnswersTheSameHoweverManyQueriesWereAskedBefore) {
  const TriangleMesh mesh = testing::ellipsoid({0.03, 0.04, 0.1}, 96, 64);  // more vertices than are kept
  const SurfacePatches patches(mesh);
  const Bent rest{mesh.vertices_m};
  Random random(9);
  DeformedSurface asked(patches, {&rest, &Bent::at});
  for (int i = 0; i < 500; ++i) {
    const Vec3 from{0.08 * random.normal(), 0.08 * random.normal(), 0.1 * random.normal()};
    const Vec3 to = from + Vec3{random.normal(), random.normal(), random.normal()} * 0.05;
    DeformedSurface fresh(patches, {&rest, &Bent::at});

    const SurfacePoint point = asked.closest(from);
    const SegmentHit hit = asked.nearest({from, to}, 0.02);

    const SurfacePoint expected = fresh.closest(from);
    const SegmentHit expectedHit = fresh.nearest({from, to}, 0.02);
    ASSERT_EQ(point.distance_m, expected.distance_m);
    ASSERT_EQ(point.triangle, expected.triangle);
    ASSERT_EQ(hit.found, expectedHit.found);
    ASSERT_EQ(hit.along, expectedHit.along);
    ASSERT_EQ(hit.surface.triangle, expectedHit.surface.triangle);
    ASSERT_EQ(hit.surface.distance_m, expectedHit.surface.distance_m);
  }
}

TEST(DeformedSurface, FindsNothingForAPointThatIsNone) {
  const TriangleMesh mesh = testing::ellipsoid({0.03, 0.04, 0.1}, 32, 24);
  const SurfacePatches patches(mesh);
  const Bent rest{mesh.vertices_m};
  DeformedSurface surface(patches, {&rest, &Bent::at});
  const double nan = std::numeric_limits<double>::quiet_NaN();

  EXPECT_FALSE(surface.nearest({{nan, 0, 0}, {0, 0, 0.1}}, 0.01).found);
  EXPECT_EQ(surface.closest({nan, nan, nan}).distance_m, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace torsio
