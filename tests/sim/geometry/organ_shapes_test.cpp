// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/anatomy/curves.h"
#include "sim/anatomy/forearm.h"
#include "sim/anatomy/remesh.h"
#include "sim/anatomy/stomach.h"
#include "sim/anatomy/tube.h"
#include "sim/core/portable_math.h"
#include "sim/core/random.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/query/collision_mesh.h"
#include "tests/sim/geometry/shapes.h"

namespace torsio {
namespace {

TEST(MonotoneCurve, PassesThroughItsPointsWithoutOvershoot) {
  const MonotoneCurve curve({0, 1, 3, 4, 6}, {0, 0, 5, 5, 2});

  EXPECT_DOUBLE_EQ(curve(3), 5.0);
  EXPECT_DOUBLE_EQ(curve(6), 2.0);
  EXPECT_EQ(curve(-1), 0.0);
  EXPECT_EQ(curve(9), 2.0);
  for (double x = 0.0; x < 1.0; x += 0.05) {
    EXPECT_EQ(curve(x), 0.0);
  }
  for (double x = 3.0; x < 4.0; x += 0.05) {
    EXPECT_DOUBLE_EQ(curve(x), 5.0);
  }
  for (double x = 1.0; x < 3.0; x += 0.05) {
    EXPECT_GE(curve(x + 0.05), curve(x));
  }
}

TEST(SplineCurve, RunsStraightThroughPointsOnALine) {
  const SplineCurve straight({{0, 0, 0}, {1, 2, 0}, {2, 4, 0}, {3, 6, 0}, {4, 8, 0}});
  EXPECT_NEAR(straight.chordLength(), 4.0 * std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(norm(straight(0.3 * straight.chordLength()) - Vec3{1.2, 2.4, 0.0}), 0.0, 1e-12);
}

TEST(FramesAlong, AreOrthonormalEquidistantAndDoNotSpin) {
  // A quarter circle of radius 50: 25 pi long; a frame in its plane stays in its plane.
  std::vector<Vec3> points;
  for (int i = 0; i <= 16; ++i) {
    points.push_back({50.0 * std::cos(kPi * i / 32), 50.0 * std::sin(kPi * i / 32), 0.0});
  }

  const std::vector<CurveFrame> frames = framesAlong(SplineCurve(points), 101, {1, 0, 0});

  constexpr double kSpline = 1e-3;  // 16 cubic pieces against the circle
  EXPECT_NEAR(frames.back().arc, 25.0 * kPi, kSpline);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const CurveFrame& f = frames[k];
    ASSERT_NEAR(norm(f.e1), 1.0, 1e-12);
    ASSERT_NEAR(norm(cross(f.e1, f.e2) - f.tangent), 0.0, 1e-12);
    ASSERT_NEAR(f.e1.z, 0.0, 1e-9);
    ASSERT_NEAR(norm(f.e1 - normalized(f.centre)), 0.0, kSpline);
    if (k > 0) {
      ASSERT_NEAR(norm(f.centre - frames[k - 1].centre), frames.back().arc / 100, kSpline);
    }
  }
}

TEST(ClosedTube, HasTheVolumeOfItsSections) {
  // A straight ellipse 20 x 12 mm thick, 100 mm long, with half ellipsoids of height 8 at the ends.
  const SplineCurve line({{0, 0, 0}, {0, 0, 30}, {0, 0, 60}, {0, 0, 100}});
  const auto flat = [](double, double) { return 0.0; };

  const TriangleMesh tube = closedTube(
      framesAlong(line, 60, {1, 0, 0}), 120, {.first = 1.0, .last = 1.0},
      [](double) {
        return SectionSize{10.0, 6.0};
      },
      flat);

  const MeshReport report = checkMesh(tube);
  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_EQ(report.genus(), 0);
  const double exact = kPi * 10 * 6 * 100 + 4.0 / 3.0 * kPi * 10 * 6 * 8;
  EXPECT_NEAR(report.volume_m3 / exact, 1.0, 0.005);  // 120 sides, 6 rings a dome
  EXPECT_NEAR(report.largestSide_m(), 116.0, 1e-9);
}

TEST(ZeroSurface, OfABallHasItsVolumeAndGenus) {
  const SampleGrid grid{{-1.3, -1.3, -1.3}, 0.1, {27, 27, 27}};

  const TriangleMesh ball = zeroSurface(grid, 1.0, [](const Vec3& p) { return norm(p) - 1.0; });

  const MeshReport report = checkMesh(ball);
  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_EQ(report.genus(), 0);
  EXPECT_NEAR(report.volume_m3, 4.0 / 3.0 * kPi, 0.03);  // inscribed facets of 0.1
}

TEST(ZeroSurface, IsClosedAndManifoldForNoiseToo) {
  Random random(7);
  std::vector<double> noise(20 * 20 * 20);
  for (double& v : noise) {
    v = random.uniform() - 0.5;
  }
  const SampleGrid grid{{0, 0, 0}, 1.0, {20, 20, 20}};
  constexpr double kNeverSkip = 1e9;

  const TriangleMesh mesh = zeroSurface(grid, kNeverSkip, [&noise](const Vec3& p) {
    const auto i = [](double x) { return static_cast<std::size_t>(std::lround(x)); };
    const bool border = std::min({p.x, p.y, p.z}) < 0.5 || std::max({p.x, p.y, p.z}) > 18.5;
    return border ? 1.0 : noise[(i(p.z) * 20 + i(p.y)) * 20 + i(p.x)];
  });

  const MeshReport report = checkMesh(mesh);
  EXPECT_GT(report.triangles, 10000U);
  EXPECT_EQ(report.boundaryEdges, 0U);
  EXPECT_TRUE(report.manifold());
  EXPECT_TRUE(report.oriented());
}

TEST(Remeshed, KeepsShapeAndTopologyAndEvensTheEdges) {
  const TriangleMesh fine = testing::torus(60.0, 20.0, 160, 60);
  constexpr double kEdge = 5.0;

  const TriangleMesh mesh = remeshed(fine, [](const Vec3&) { return kEdge; });

  const MeshReport report = checkMesh(mesh);
  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_EQ(report.genus(), 1);
  EXPECT_NEAR(report.volume_m3 / signedVolume_m3(fine), 1.0, 0.02);
  EXPECT_EQ(report.degenerateFaces, 0U);
  const CollisionMesh surface(fine);
  for (const Vec3& v : mesh.vertices_m) {
    ASSERT_LT(std::abs(surface.closest(v).distance_m), 1e-9);
  }
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double edge = norm(mesh.vertices_m[t[k]] - mesh.vertices_m[t[(k + 1) % 3]]);
      ASSERT_GT(edge, 0.5 * kEdge);
      ASSERT_LT(edge, 1.6 * kEdge);
    }
  }
}

TEST(MakeArm, FollowsThePersonsMeasures) {
  // A woman of ANSUR II: forearm, palm, breadth and fingers shorter (finger lengths scaled by 72.4 / 76.8).
  ArmMeasures woman;
  woman.forearmLength_mm = 236.0;
  for (double& girth : woman.girth_mm) {
    girth *= 155.0 / 176.0;
  }
  woman.palmLength_mm = 108.7;
  woman.handBreadth_mm = 78.2;
  woman.handThickness_mm = 26.0;
  for (double& finger : woman.fingerLength_mm) {
    finger *= 72.4 / 76.8;
  }

  const Arm arm = makeArm(woman);

  const MeshReport report = checkMesh(arm.surface);
  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_EQ(report.genus(), 0);
  EXPECT_DOUBLE_EQ(arm.wrist_m.z, 0.236);
  EXPECT_NEAR(report.volume_m3, 1.526e-3 * (155.0 * 155.0) / (176.0 * 176.0) * 236.0 / 262.0, 0.1e-3);
  EXPECT_NEAR(report.boxMin_m.z, 0.0, 2e-5);  // the elbow's disc; smoothing moves its rim by some micrometres
}

TEST(MakeArm, HasTheWristThatItIsGiven) {
  ArmMeasures slim;
  setWrist(slim, 56.0, 40.0);

  const Arm arm = makeArm(slim);

  const CollisionMesh skin(arm.surface);
  const auto reach_mm = [&skin, &arm](const Vec3& way) {
    double inside_m = 0.0;
    double outside_m = 0.06;
    for (int i = 0; i < 40; ++i) {
      const double r = 0.5 * (inside_m + outside_m);
      // Below the wrist bones.
      (skin.closest(arm.wrist_m + Vec3{0, 0, -0.045} + r * way).distance_m < 0.0 ? inside_m : outside_m) = r;
    }
    return 1000.0 * inside_m;
  };
  EXPECT_NEAR(reach_mm({0, 1, 0}) + reach_mm({0, -1, 0}), 40.0, 2.5);
  EXPECT_NEAR(reach_mm({1, 0, 0}) + reach_mm({-1, 0, 0}), 56.0, 3.0);
  // A slimmer wrist belongs to a slimmer forearm.
  ArmMeasures usual;
  EXPECT_NEAR(slim.girth_mm[2] / usual.girth_mm[2], slim.girth_mm[8] / usual.girth_mm[8], 1e-12);
  EXPECT_EQ(slim.widthToDepth[0], usual.widthToDepth[0]);
}

}  // namespace
}  // namespace torsio
