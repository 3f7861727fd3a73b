// SPDX-License-Identifier: GPL-3.0-or-later
// A bar with a stub on its side, which belongs to no section.
#include "sim/geometry/lattice/side_branch.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "tests/support/organ_like_shapes.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

constexpr double kBarRadius_m = 0.02;
constexpr double kStubRadius_m = 0.008;

/// Along z, with a stub along +x at the middle.
TriangleMesh barWithStub() {
  const TriangleMesh mesh =
      testing::shapes::surfaceOf({-0.03, -0.03, -0.11}, {0.06, 0.03, 0.11}, 0.003, [](const Vec3& p) {
        const double bar = testing::shapes::bar(p, {0, 0, -0.08}, {0, 0, 0.08}, kBarRadius_m);
        const double stub = testing::shapes::bar(p, {0.01, 0, 0}, {0.045, 0, 0}, kStubRadius_m);
        return testing::shapes::joined(bar, stub, 0.003);
      });
  return requireOrgan(mesh, "bar with stub");
}

LatticeOptions withBranch() {
  return {.fixedEnd_m = {0, 0, -0.1},
          .freeEnd_m = {0, 0, 0.1},
          .ridgeZero = {1, 0, 0},
          .ridgeZeroFraction = 0.3,
          .branchRoot_m = {0.021, 0, 0},
          .branchCut = {1, 0, 0}};
}

bool onStub(const Vec3& p) {
  return p.x >= 0.021;
}

std::string refusalOfBranch(const Vec3& root_m, const Vec3& cut) {
  LatticeOptions options = withBranch();
  options.branchRoot_m = root_m;
  options.branchCut = cut;
  const std::optional<Error> error =
      testing::errorOf([&] { const SectionLattice lattice(barWithStub(), options); });
  EXPECT_TRUE(!error || error->code() == ErrorCode::kBadParameter);
  return error ? error->what() : "";
}

TEST(SideBranch, LeavesTheOrganClosedWithoutIt) {
  const TriangleMesh whole = barWithStub();

  const TrimmedOrgan trimmed(whole, {0.021, 0, 0}, {1, 0, 0});

  const MeshReport report = checkMesh(trimmed.mesh());
  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_EQ(report.genus(), 0);
  EXPECT_LT(report.boxMax_m.x, 0.022);
  const double stub_m3 = kPi * kStubRadius_m * kStubRadius_m * (0.045 - 0.021) +
                         2.0 / 3.0 * kPi * kStubRadius_m * kStubRadius_m * kStubRadius_m;
  EXPECT_NEAR(signedVolume_m3(whole) - report.volume_m3, stub_m3, 0.06 * stub_m3);
}

TEST(SideBranch, ChangesNoSection) {
  const SectionLattice lattice(barWithStub(), withBranch());

  ASSERT_NEAR(lattice.length_m(), 0.2, 0.006);
  for (int j = 3; j + 3 < lattice.sections(); ++j) {
    double farthest_m = 0.0;
    for (const Point2& p : lattice.outline_m(j)) {
      farthest_m = std::max(farthest_m, std::hypot(p[0], p[1]));
    }
    // The fillet at the root of the stub stays, two millimetres of it.
    EXPECT_LT(farthest_m, kBarRadius_m + 0.002) << j;
    const AxisFrame frame = lattice.frameAt(lattice.sectionArc_m(j));
    EXPECT_LT(std::hypot(frame.centre_m.x, frame.centre_m.y), 0.001) << j;
  }
}

TEST(SideBranch, StandsOnThePlacesOfItsRoot) {
  const TriangleMesh mesh = barWithStub();
  const SectionLattice lattice(mesh, withBranch());

  ASSERT_EQ(lattice.vertexCoordinates().size(), mesh.vertices_m.size());
  int branch = 0;
  for (std::size_t v = 0; v < mesh.vertices_m.size(); ++v) {
    const Vec3& p = mesh.vertices_m[v];
    if (!onStub(p)) {
      continue;
    }
    ++branch;
    const LatticeCoordinate& at = lattice.vertexCoordinates()[v];
    EXPECT_EQ(lattice.vertexParts()[v], LatticePart::kSide);
    EXPECT_NEAR(at.arc_m, 0.5 * lattice.length_m() + p.z, 0.006);
    // Half the width of the root, seen from the axis.
    EXPECT_LT(std::abs(std::remainder(at.angle_rad, 2.0 * kPi)), 0.6);
    EXPECT_GE(at.angle_rad, 0.0);
    EXPECT_LT(at.angle_rad, 2.0 * kPi);
  }
  EXPECT_GT(branch, 100);
}

TEST(SideBranch, HasPointsOfTheWholeSurfaceOnlyAlsoAtItsRoot) {
  const TriangleMesh mesh = barWithStub();
  const SectionLattice lattice(mesh, withBranch());

  for (int k = 0; k < 24; ++k) {
    const LatticePoint point = lattice.surfacePoint({0.5 * lattice.length_m(), 2.0 * kPi * k / 24.0});

    ASSERT_LT(point.triangle, mesh.triangles.size());
    const TriangleMesh::Triangle& corners = mesh.triangles[point.triangle];
    Vec3 there;
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_GE(point.barycentric[c], -1e-9);
      there += point.barycentric[c] * mesh.vertices_m[corners[c]];
    }
    EXPECT_LT(norm(there - point.position_m), 1e-9) << k;
  }
}

TEST(SideBranch, IsRefusedWhereThereIsNone) {
  EXPECT_THAT(refusalOfBranch({0.2, 0, 0}, {1, 0, 0}), ::testing::HasSubstr("nothing of the organ"));
  EXPECT_THAT(refusalOfBranch({0, 0, 0.02}, {0, 0, 1}), ::testing::HasSubstr("more than a tenth"));
}

}  // namespace
}  // namespace torsio
