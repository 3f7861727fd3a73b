// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/query/collision_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>

#include "assessment/domain/people/person.h"
#include "sim/core/portable_math.h"
#include "sim/core/random.h"
#include "sim/geometry/mesh/surface_patches.h"
#include "sim/geometry/query/deformed_surface.h"
#include "tests/sim/geometry/shapes.h"
#include "tests/support/allocation_count.h"
#include "tests/support/fcl_model.h"

namespace torsio {
namespace {

using testing::allocationCount;
using testing::ellipsoid;
using testing::torus;

constexpr double kRounding_m = 1e-12;  // coordinates of 0.1 m, double precision

// A curved, uneven, non-convex closed surface: an ellipsoid with waves and a bend.
TriangleMesh wavyBody() {
  TriangleMesh mesh = ellipsoid({0.03, 0.04, 0.1}, 48, 40);
  for (Vec3& v : mesh.vertices_m) {
    v = v * (1.0 + 0.15 * std::sin(60.0 * v.z) * std::cos(80.0 * v.x));
    v.x += 4.0 * v.z * v.z;
  }
  return mesh;
}

Vec3 nearestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  return a + t * (b - a);
}

// Written apart from the tested one: the foot of the perpendicular if it lies inside, else the best edge.
double distanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = normalized(cross(b - a, c - a));
  const Vec3 foot = p - dot(p - a, n) * n;
  const bool inside = dot(cross(b - a, foot - a), n) >= 0 && dot(cross(c - b, foot - b), n) >= 0 &&
                      dot(cross(a - c, foot - c), n) >= 0;
  if (inside) {
    return norm(p - foot);
  }
  return std::min({norm(p - nearestOnSegment(p, a, b)), norm(p - nearestOnSegment(p, b, c)),
                   norm(p - nearestOnSegment(p, c, a))});
}

double bruteForceDistance(const TriangleMesh& mesh, const Vec3& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    best = std::min(
        best, distanceToTriangle(p, mesh.vertices_m[t[0]], mesh.vertices_m[t[1]], mesh.vertices_m[t[2]]));
  }
  return best;
}

// Solid angle over 4 pi (van Oosterom and Strackee 1983): 1 inside, 0 outside.
double windingNumber(const TriangleMesh& mesh, const Vec3& p) {
  double half = 0.0;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.vertices_m[t[0]] - p, b = mesh.vertices_m[t[1]] - p, c = mesh.vertices_m[t[2]] - p;
    const double na = norm(a), nb = norm(b), nc = norm(c);
    half += std::atan2(dot(a, cross(b, c)), na * nb * nc + dot(a, b) * nc + dot(b, c) * na + dot(c, a) * nb);
  }
  return half / (2.0 * kPi);
}

std::vector<Vec3> randomPoints(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const auto within = [&random](double low, double high) { return low + (high - low) * random.uniform(); };
  std::vector<Vec3> points(count);
  for (Vec3& p : points) {
    p = {within(-0.08, 0.12), within(-0.08, 0.08), within(-0.14, 0.14)};
  }
  return points;
}

TEST(CollisionMesh, AgreesWithBruteForceInsideAndOutside) {
  const TriangleMesh mesh = wavyBody();
  const CollisionMesh collision(mesh);

  std::size_t inside = 0;
  for (const Vec3& p : randomPoints(2000, 1)) {
    const SurfacePoint s = collision.closest(p);

    ASSERT_NEAR(std::abs(s.distance_m), bruteForceDistance(mesh, p), kRounding_m);
    ASSERT_NEAR(norm(p - s.position_m), std::abs(s.distance_m), kRounding_m);
    ASSERT_NEAR(norm(s.normal), 1.0, 1e-12);
    const bool insideTruth = windingNumber(mesh, p) > 0.5;
    ASSERT_EQ(s.distance_m < 0.0, insideTruth);
    inside += insideTruth ? 1 : 0;
    const TriangleMesh::Triangle& t = mesh.triangles[s.triangle];
    Vec3 q;
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_GE(s.barycentric[k], 0.0);
      q += s.barycentric[k] * mesh.vertices_m[t[k]];
    }
    ASSERT_LT(norm(q - s.position_m), kRounding_m);
  }
  EXPECT_GT(inside, 100U);
}

TEST(CollisionMesh, AgreesWithTheDistanceQueryOfFcl) {
  const TriangleMesh mesh = wavyBody();
  const CollisionMesh collision(mesh);
  const auto model = testing::fclModel(mesh);
  constexpr double kProbeRadius_m = 1e-7;
  const auto probe = std::make_shared<fcl::Sphered>(kProbeRadius_m);

  for (const Vec3& p : randomPoints(500, 2)) {
    fcl::Transform3d pose = fcl::Transform3d::Identity();
    pose.translation() = fcl::Vector3d(p.x, p.y, p.z);
    fcl::DistanceResultd result;
    fcl::distance(model.get(), fcl::Transform3d::Identity(), probe.get(), pose, fcl::DistanceRequestd(true),
                  result);

    ASSERT_NEAR(std::abs(collision.closest(p).distance_m), result.min_distance + kProbeRadius_m, 1e-9);
  }
}

std::vector<Segment> randomSegments(std::size_t count, std::uint64_t seed) {
  const std::vector<Vec3> ends = randomPoints(2 * count, seed);
  std::vector<Segment> segments(count);
  for (std::size_t i = 0; i < count; ++i) {
    // From a needle to a whole shaft.
    const double share = i % 3 == 0 ? 0.02 : 1.0;
    segments[i] = {ends[2 * i], ends[2 * i] + (ends[2 * i + 1] - ends[2 * i]) * share};
  }
  return segments;
}

TEST(CollisionMesh, FindsTheNearestPairOfASegmentAsManyPointsOnItDo) {
  const CollisionMesh collision(wavyBody());
  constexpr int kSteps = 200;
  int pierced = 0;
  for (const Segment& segment : randomSegments(300, 6)) {
    double least_m = std::numeric_limits<double>::infinity();
    bool inside = false;
    bool outside = false;
    for (int i = 0; i <= kSteps; ++i) {
      const double distance_m = collision.closest(segment.at(static_cast<double>(i) / kSteps)).distance_m;
      least_m = std::min(least_m, std::abs(distance_m));
      inside = inside || distance_m < 0.0;
      outside = outside || distance_m > 0.0;
    }
    const double step_m = norm(segment.to_m - segment.from_m) / kSteps;

    const SegmentHit hit = collision.nearest(segment, 1.0);

    ASSERT_TRUE(hit.found);
    const double distance_m = std::abs(hit.surface.distance_m);
    ASSERT_LE(distance_m, least_m + kRounding_m);
    ASSERT_GE(distance_m, least_m - step_m);
    ASSERT_NEAR(norm(segment.at(hit.along) - hit.surface.position_m), distance_m, 1e-11);
    if (inside && outside) {
      ASSERT_EQ(distance_m, 0.0);
      ++pierced;
    } else if (distance_m > 0.0) {
      ASSERT_EQ(hit.surface.distance_m < 0.0, inside);
    }
    ASSERT_TRUE(distance_m == 0.0 || !collision.nearest(segment, 0.5 * distance_m).found);
  }
  EXPECT_GT(pierced, 30);
}

TEST(CollisionMesh, AgreesWithTheCapsulesOfFcl) {
  const TriangleMesh mesh = wavyBody();
  const CollisionMesh collision(mesh);
  const auto model = testing::fclModel(mesh);
  constexpr double kRadius_m = 0.0025;
  constexpr double kFclCapsule_m = 1e-4;  // its convex solver stops early far from the surface

  int compared = 0;
  for (const Segment& segment : randomSegments(300, 7)) {
    const SegmentHit hit = collision.nearest(segment, 1.0);
    if (hit.surface.distance_m < kRadius_m + 1e-4) {
      continue;  // FCL knows no depth
    }
    const Vec3 way = segment.to_m - segment.from_m;
    const auto capsule = std::make_shared<fcl::Capsuled>(kRadius_m, norm(way));
    fcl::Transform3d pose = fcl::Transform3d::Identity();
    const fcl::Vector3d along = fcl::Vector3d(way.x, way.y, way.z).normalized();
    pose.linear() = fcl::Quaterniond::FromTwoVectors(fcl::Vector3d::UnitZ(), along).toRotationMatrix();
    const Vec3 middle = segment.at(0.5);
    pose.translation() = fcl::Vector3d(middle.x, middle.y, middle.z);
    fcl::DistanceResultd result;
    fcl::distance(model.get(), fcl::Transform3d::Identity(), capsule.get(), pose, fcl::DistanceRequestd(true),
                  result);
    ASSERT_NEAR(hit.surface.distance_m - kRadius_m, result.min_distance, kFclCapsule_m);
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TEST(CollisionMesh, FindsTheRightSideAtEdgesCornersAndOnTheSurface) {
  // A sharp body whose corners fool plain face normals: a thin tetrahedral spike.
  TriangleMesh spike{.vertices_m = {{0, 0, 0.1}, {0.01, 0, 0}, {-0.005, 0.008, 0}, {-0.005, -0.008, 0}},
                     .triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  const CollisionMesh collision(spike);

  EXPECT_NEAR(collision.closest({0, 0, 0.12}).distance_m, 0.02, kRounding_m);  // above the tip
  EXPECT_GT(collision.closest({0.004, 0.0, 0.12}).distance_m, 0.0);
  EXPECT_GT(collision.closest({0.03, 0.0, -0.01}).distance_m, 0.0);  // beyond a base corner
  EXPECT_LT(collision.closest({0, 0, 0.01}).distance_m, 0.0);
  EXPECT_NEAR(collision.closest({0, 0, 0.12}).normal.z, 1.0, 0.01);  // pseudonormal of the tip
  EXPECT_EQ(collision.closest(spike.vertices_m[2]).distance_m, 0.0);
}

TEST(CollisionMesh, TellsTheHoleOfARingFromItsInside) {
  const CollisionMesh collision(torus(0.06, 0.02, 96, 48));

  constexpr double kFacetting_m = 1e-4;  // sagitta of 96 chords on the outer circle: 0.08 (1 - cos(pi / 96))
  EXPECT_NEAR(collision.closest({0, 0, 0}).distance_m, 0.04, kFacetting_m);
  EXPECT_NEAR(collision.closest({0.06, 0, 0}).distance_m, -0.02, kFacetting_m);
  EXPECT_NEAR(collision.closest({0.1, 0, 0}).distance_m, 0.02, kFacetting_m);
}

TEST(CollisionMesh, TakesTheLowestOfEquallyNearTriangles) {
  const TriangleMesh mesh = wavyBody();
  const CollisionMesh collision(mesh);

  for (std::uint32_t v = 0; v < mesh.vertices_m.size(); v += 7) {
    const SurfacePoint s = collision.closest(mesh.vertices_m[v]);

    const auto lowest = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [v](const auto& t) {
      return std::find(t.begin(), t.end(), v) != t.end();
    });
    ASSERT_EQ(s.triangle, static_cast<std::uint32_t>(lowest - mesh.triangles.begin()));
    ASSERT_EQ(s.distance_m, 0.0);
  }
}

TEST(CollisionMesh, AnswersMirroredQueriesWithMirroredPoints) {
  TriangleMesh mirrored = wavyBody();
  for (Vec3& v : mirrored.vertices_m) {
    v.y = -v.y;
  }
  for (TriangleMesh::Triangle& t : mirrored.triangles) {
    std::swap(t[1], t[2]);
  }
  const CollisionMesh left(wavyBody());
  const CollisionMesh right(mirrored);

  for (const Vec3& p : randomPoints(200, 3)) {
    const SurfacePoint a = left.closest(p);
    const SurfacePoint b = right.closest({p.x, -p.y, p.z});
    ASSERT_NEAR(a.distance_m, b.distance_m, kRounding_m);
  }
}

TEST(CollisionMesh, GivesAnInfiniteDistanceForAPointThatIsNone) {
  const CollisionMesh collision(wavyBody());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();

  for (const Vec3& p : {Vec3{nan, 0, 0}, Vec3{0, infinity, 0}, Vec3{nan, nan, nan}, Vec3{1e200, 0, 0}}) {
    const SurfacePoint s = collision.closest(p);
    EXPECT_EQ(s.distance_m, infinity);
    EXPECT_TRUE(isFinite(s.position_m) && isFinite(s.normal));
  }
}

TEST(CollisionMesh, TakesNoMemoryInAQuery) {
  const CollisionMesh collision(wavyBody());
  const std::vector<Vec3> points = randomPoints(1000, 4);
  static_assert(noexcept(collision.closest(points[0])));

  const std::int64_t before = allocationCount();
  double sum = 0.0;
  for (const Vec3& p : points) {
    sum += collision.closest(p).distance_m;
  }
  const std::int64_t after = allocationCount();

  EXPECT_EQ(after, before);
  EXPECT_TRUE(std::isfinite(sum));
  EXPECT_GT(before, 0);  // the counter is linked in
}

TEST(CollisionMesh, RefusesLessThanATetrahedron) {
  EXPECT_ANY_THROW(CollisionMesh(TriangleMesh{}));
}

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

void expectSame(const SurfacePoint& point, const SurfacePoint& expected) {
  ASSERT_EQ(point.triangle, expected.triangle);
  ASSERT_EQ(point.distance_m, expected.distance_m);
  ASSERT_EQ(point.position_m, expected.position_m);
}

void expectSame(const SegmentHit& hit, const SegmentHit& expected) {
  ASSERT_EQ(hit.found, expected.found);
  ASSERT_EQ(hit.along, expected.along);
  ASSERT_EQ(hit.surface.triangle, expected.surface.triangle);
  ASSERT_EQ(hit.surface.distance_m, expected.surface.distance_m);
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
      expectSame(surface.closest(from, hint), surface.closest(from));
      expectSame(surface.nearest({from, to}, 0.02, hint), surface.nearest({from, to}, 0.02));
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

    expectSame(asked.closest(from), fresh.closest(from));
    expectSame(asked.nearest({from, to}, 0.02), fresh.nearest({from, to}, 0.02));
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
