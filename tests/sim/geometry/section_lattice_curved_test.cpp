// SPDX-License-Identifier: GPL-3.0-or-later
// Bent, domed and branching organs, and the organs shipped with Torsio.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "sim/core/portable_math.h"
#include "sim/geometry/lattice/section_lattice.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/mesh/nearest_on_triangle.h"
#include "tests/support/allocation_count.h"
#include "tests/support/procedural_mesh.h"

namespace torsio {
namespace {

using testing::areaOf;
using testing::centroidOf;

double sectionArea(const SectionLattice& lattice, int j) {
  return areaOf({lattice.outline_m(j).begin(), lattice.outline_m(j).end()});
}

double distanceFromMesh(const TriangleMesh& mesh, const Vec3& p) {
  NearestOnTriangle nearest;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto here = nearestOnTriangle(p, {mesh.vertices_m[a], mesh.vertices_m[b], mesh.vertices_m[c]});
    if (here.distance2 < nearest.distance2) {
      nearest = here;
    }
  }
  return std::sqrt(nearest.distance2);
}

TEST(CurvedLattice, FollowsTheAxisOfABentTube) {
  constexpr double kBend_m = 0.06;
  const TriangleMesh mesh = testing::bentTube(0.02, kBend_m, kPi / 2, 48, 80);

  const SectionLattice lattice(mesh, LatticeOptions{.ridgeZero = {0, 1, 0}});

  // Chords of 80 rings and the smoothing of the axis take less than a ten-thousandth.
  EXPECT_NEAR(lattice.length_m(), kBend_m * kPi / 2, 1e-5);
  for (int k = 0; k <= 50; ++k) {
    const double turn = kPi / 2 * k / 50;
    const AxisFrame frame = lattice.frameAt(lattice.length_m() * k / 50);
    const Vec3 centre{kBend_m * (1.0 - std::cos(turn)), 0, kBend_m * std::sin(turn)};
    EXPECT_LT(norm(frame.centre_m - centre), 5e-5) << k;
    // The smoothing keeps the ends where they are and straightens the last millimetre: 0.6 degrees.
    const double tolerance = k == 0 || k == 50 ? 0.012 : 5e-3;
    EXPECT_LT(norm(frame.tangent - Vec3{std::sin(turn), 0, std::cos(turn)}), tolerance) << k;
    // The normal of the plane of the bend does not turn about the axis.
    EXPECT_LT(norm(frame.e1 - Vec3{0, 1, 0}), 1e-9) << k;
  }
}

TEST(CurvedLattice, KeepsTheAreaOfASectionRoundTheBend) {
  const TriangleMesh mesh = testing::jTube(0.02, 0.12, 0.04, 48, 80);
  const double area = areaOf(testing::circleOutline(0.02, 48));

  const SectionLattice lattice(mesh, {});

  EXPECT_NEAR(lattice.length_m(), 0.12 + kPi * 0.04 + 0.04, 1e-3);
  for (int j = 0; j < lattice.sections(); ++j) {
    EXPECT_NEAR(sectionArea(lattice, j), area, 0.01 * area) << j;
  }
}

TEST(CurvedLattice, MeetsEverySectionOnceWithEveryRidge) {
  const TriangleMesh mesh = testing::jTube(0.02, 0.12, 0.04, 48, 80);
  LatticeOptions options{.ridges = 36};
  for (const RidgeSpacing spacing : {RidgeSpacing::kArcLength, RidgeSpacing::kAngle}) {
    options.spacing = spacing;

    const SectionLattice lattice(mesh, options);

    for (int j = 0; j < lattice.sections(); ++j) {
      const AxisFrame frame = lattice.frameAt(lattice.sectionArc_m(j));
      double turned = 0.0;
      for (int ridge = 0; ridge < lattice.ridges(); ++ridge) {
        const Vec3 a = lattice.keyPoint_m(ridge, j) - frame.centre_m;
        const Vec3 b = lattice.keyPoint_m((ridge + 1) % lattice.ridges(), j) - frame.centre_m;
        const double angle = std::atan2(dot(a, frame.e2), dot(a, frame.e1));
        const double next = std::atan2(dot(b, frame.e2), dot(b, frame.e1));
        const double step = std::remainder(next - angle, 2.0 * kPi);
        EXPECT_GT(step, 0.0) << ridge << " " << j;
        turned += step;
      }
      EXPECT_NEAR(turned, 2.0 * kPi, 1e-9) << j;
    }
  }
}

TEST(CurvedLattice, StartsRidgeZeroWhereAsked) {
  const TriangleMesh mesh = testing::bentTube(0.02, 0.06, kPi / 2, 48, 80);
  LatticeOptions options;
  // Towards the inside of the bend, half-way round.
  options.ridgeZero = {std::cos(kPi / 4), 0, -std::sin(kPi / 4)};
  options.ridgeZeroFraction = 0.5;

  const SectionLattice lattice(mesh, options);

  const AxisFrame middle = lattice.frameAt(0.5 * lattice.length_m());
  EXPECT_LT(norm(middle.e1 - options.ridgeZero), 1e-3);
  const int j = lattice.sections() / 2;
  const Vec3 towards = normalized(lattice.keyPoint_m(0, j) - middle.centre_m);
  EXPECT_GT(dot(towards, options.ridgeZero), 0.999);
  // It stays on the inside at both ends: the harmonic angle knows the symmetry.
  EXPECT_GT(dot(normalized(lattice.keyPoint_m(0, 0) - lattice.frameAt(0).centre_m), Vec3{1, 0, 0}), 0.99);
}

TEST(CurvedLattice, FindsTheFootOfAPointOnItsAxis) {
  const TriangleMesh mesh = testing::jTube(0.02, 0.12, 0.04, 32, 60);
  const SectionLattice lattice(mesh, {});
  // Up to three quarters of the smallest radius of curvature the foot is unique.
  constexpr double kAside_m = 0.025;

  for (int k = 1; k < 200; ++k) {
    const double arc = lattice.length_m() * k / 200;
    const AxisFrame frame = lattice.frameAt(arc);
    for (const double angle : {0.3, 2.0, 4.4}) {
      const Vec3 aside = kAside_m * (std::cos(angle) * frame.e1 + std::sin(angle) * frame.e2);
      EXPECT_NEAR(lattice.nearestArc_m(frame.centre_m + aside), arc, 1e-9) << k << " " << angle;
    }
  }
}

TEST(CurvedLattice, AnswersInTheTickWithoutTakingMemory) {
  const TriangleMesh mesh = testing::jTube(0.02, 0.12, 0.04, 32, 60);
  const SectionLattice lattice(mesh, {});
  const std::int64_t before = testing::allocationCount();

  double sum = 0.0;
  for (int k = 0; k < 100; ++k) {
    const double arc = lattice.nearestArc_m({0.001 * k, 0.02, 0.1});
    sum += lattice.frameAt(arc).centre_m.z;
  }

  EXPECT_EQ(testing::allocationCount(), before);
  EXPECT_GT(sum, 0.0);
}

TEST(CurvedLattice, FindsTheTipsOfADomedOrgan) {
  const TriangleMesh mesh = testing::capsule(0.03, 0.15, 48, 80);

  const SectionLattice lattice(mesh, {});

  // The tips reach to where the normal leaves the axis by 30 degrees, 26 mm from the ball's centre, and an
  // edge length further; rings are 3 mm apart.
  EXPECT_NEAR(lattice.length_m(), 0.15 + 2 * 0.03 * std::cos(kPi / 6), 0.008);
  EXPECT_LT(norm(lattice.frameAt(0.0).tangent - Vec3{0, 0, 1}), 1e-6);
  EXPECT_NEAR(sectionArea(lattice, 12), areaOf(testing::circleOutline(0.03, 48)), 1e-8);
}

TEST(CurvedLattice, TakesTheCapRadiusThatIsGiven) {
  const TriangleMesh mesh = testing::capsule(0.03, 0.15, 48, 80);
  LatticeOptions options{.fixedEnd_m = {0, 0, -0.03}, .freeEnd_m = {0, 0, 0.18}, .capRadius_m = 0.008};

  const SectionLattice lattice(mesh, options);

  EXPECT_LT(std::sqrt(sectionArea(lattice, 0) / kPi), 0.013);
  EXPECT_GT(lattice.length_m(), 0.198);
}

TEST(CurvedLattice, KnowsWhichVertexIsTwistedAndWhichFollows) {
  const TriangleMesh mesh = testing::capsule(0.03, 0.15, 48, 80);

  const SectionLattice lattice(mesh, {});

  for (std::size_t v = 0; v < mesh.vertices_m.size(); ++v) {
    const LatticeCoordinate c = lattice.vertexCoordinates()[v];
    switch (lattice.vertexParts()[v]) {
      case LatticePart::kFixedCap:
        EXPECT_EQ(c.arc_m, 0.0);
        EXPECT_LT(mesh.vertices_m[v].z, 0.0);
        break;
      case LatticePart::kFreeCap:
        EXPECT_EQ(c.arc_m, lattice.length_m());
        EXPECT_GT(mesh.vertices_m[v].z, 0.15);
        break;
      case LatticePart::kSide:
        EXPECT_GT(c.arc_m, 0.0);
        EXPECT_LT(c.arc_m, lattice.length_m());
        break;
    }
  }
}

TEST(AutomaticLattice, CutsBarsByPlanesAndTheRestByTheField) {
  LatticeOptions options{.mode = LatticeMode::kAutomatic};
  const auto straight = [&](const TriangleMesh& mesh) { return SectionLattice(mesh, options).straight(); };

  EXPECT_TRUE(straight(testing::prism(testing::circleOutline(0.03, 48), 0.2, 20)));
  EXPECT_TRUE(straight(testing::prism(testing::rectangleOutline(0.05, 0.03, 5), 0.2, 8, 0.5)));
  EXPECT_TRUE(straight(testing::prism(testing::letterC(0.03, 0.012, 24), 0.2, 20)));
  EXPECT_TRUE(
      straight(testing::turned(testing::prism(testing::starOutline(5, 0.04, 0.02), 0.2, 20), {1, 1, 0}, 1)));
  EXPECT_FALSE(straight(testing::bentTube(0.02, 0.3, 0.5, 48, 40)));
  EXPECT_FALSE(straight(testing::jTube(0.02, 0.12, 0.04, 48, 60)));
  EXPECT_FALSE(straight(testing::capsule(0.03, 0.15, 48, 60)));
}

class ShippedOrgan : public ::testing::TestWithParam<const char*> {
 protected:
  static TriangleMesh mesh() {
    return importMesh(std::filesystem::path(TORSIO_SOURCE_DIR) / "assets/organs" / GetParam());
  }
};

TEST_P(ShippedOrgan, HasALatticeOnItsSurface) {
  const TriangleMesh organ = mesh();

  // Throws unless every level is one loop and no section crosses itself.
  const SectionLattice lattice(organ, LatticeOptions{.ridges = 24, .sections = 33});

  EXPECT_GT(lattice.length_m(), 0.15);
  for (int j = 0; j < lattice.sections(); ++j) {
    EXPECT_GT(sectionArea(lattice, j), 1e-5) << j;
    const auto outline = lattice.outline_m(j);
    const auto centroid = centroidOf({outline.begin(), outline.end()});
    // The axis is smoothed; it passes the centroids within half a millimetre.
    EXPECT_LT(std::hypot(centroid[0], centroid[1]), 5e-4) << j;
  }
  for (int j = 0; j < lattice.sections(); j += 8) {
    for (int ridge = 0; ridge < lattice.ridges(); ridge += 5) {
      EXPECT_LT(distanceFromMesh(organ, lattice.keyPoint_m(ridge, j)), 1e-12) << ridge << " " << j;
    }
  }
}

TEST_P(ShippedOrgan, FindsItsVerticesAgain) {
  const TriangleMesh organ = mesh();
  const SectionLattice lattice(organ, {});

  double farthest = 0.0;
  for (std::size_t v = 0; v < organ.vertices_m.size(); v += 23) {
    if (lattice.vertexParts()[v] != LatticePart::kSide) {
      continue;
    }
    const LatticePoint p = lattice.surfacePoint(lattice.vertexCoordinates()[v]);
    farthest = std::max(farthest, norm(p.position_m - organ.vertices_m[v]));
  }

  // Coordinates are interpolated between 400 levels; edges are 2 to 4 mm long.
  EXPECT_LT(farthest, 2e-4);
}

TEST_P(ShippedOrgan, IsCutWithoutDelay) {
  const TriangleMesh organ = mesh();
  const auto start = std::chrono::steady_clock::now();

  const SectionLattice lattice(organ, LatticeOptions{.ridges = 36, .sections = 25});

  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  // 0.05 to 0.1 s on one core of 2023; the limit leaves room for a loaded machine and sanitizers.
  EXPECT_LT(seconds, 10.0);
  EXPECT_EQ(lattice.patches(), 24 * 36);
}

INSTANTIATE_TEST_SUITE_P(Assets, ShippedOrgan,
                         ::testing::Values("forearm.ply", "stomach.ply", "intestine.ply"),
                         [](const auto& file) { return std::filesystem::path(file.param).stem().string(); });

TEST(CurvedLattice, EndsBeforeTheThumbOfAnArm) {
  const TriangleMesh arm = importMesh(std::filesystem::path(TORSIO_SOURCE_DIR) / "assets/organs/forearm.ply");

  const SectionLattice lattice(arm, {});

  // The wrist lies at 262 mm, the web of the thumb at about 320 mm, the middle finger ends at 443 mm.
  EXPECT_GT(lattice.length_m(), 0.262);
  EXPECT_LT(lattice.length_m(), 0.330);
  for (std::size_t v = 0; v < arm.vertices_m.size(); ++v) {
    if (arm.vertices_m[v].z < 0.35) {
      continue;
    }
    EXPECT_EQ(lattice.vertexParts()[v], LatticePart::kFreeCap) << v;
  }
}

}  // namespace
}  // namespace torsio
