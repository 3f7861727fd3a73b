// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/lattice_skin.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/mesh_import.h"

namespace torsio {
namespace {

/// The forearm between elbow and wrist; the hand beyond is a cap.
struct Forearm {
  TriangleMesh mesh = importMesh(
      std::filesystem::path(TORSIO_SOURCE_DIR) / "assets" / "organs" / "forearm.ply", {.scale_m = 1e-3});
  SectionLattice lattice{mesh, [] {
                           LatticeOptions options;
                           options.ridges = 36;
                           options.sections = 37;
                           options.mode = LatticeMode::kStraightAxis;
                           options.freeEnd_m = {0.0, 0.0, 0.262};
                           options.freeCut = {0.0, 0.0, 1.0};
                           options.ridgeZero = {1.0, 0.0, 0.0};
                           return options;
                         }()};
};

TEST(LatticeSkin, FollowsKeyPointsThatTurnAsOneAndTurnsTheHandWithThem) {
  const Forearm arm;
  const LatticeSkin skin(arm.mesh, arm.lattice);
  const AxisFrame end = arm.lattice.frameAt(arm.lattice.length_m());
  // A quarter turn about the axis, x to y, of everything.
  LatticePlaces turned = restPlaces(arm.lattice);
  const auto quarter = [&](const Vec3& place) {
    const Vec3 from = place - end.centre_m;
    return end.centre_m + dot(from, end.tangent) * end.tangent + cross(end.tangent, from);
  };
  for (Vec3& place : turned.places_m) {
    place = quarter(place);
  }
  std::vector<Vec3> shown(arm.mesh.vertices_m.size());

  skin.deform(turned, 0.5 * kPi, shown);

  int caps = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    caps += arm.lattice.vertexParts()[i] == LatticePart::kFreeCap ? 1 : 0;
    if (arm.lattice.vertexParts()[i] != LatticePart::kFixedCap) {
      EXPECT_LT(norm(shown[i] - quarter(arm.mesh.vertices_m[i])), 1e-12);
    }
  }
  EXPECT_GT(caps, 100);
}

TEST(LatticeSkin, LeavesTheOrganAtRestWhereTheKeyPointsAre) {
  const Forearm arm;
  const LatticeSkin skin(arm.mesh, arm.lattice);
  std::vector<Vec3> shown(arm.mesh.vertices_m.size());

  skin.deform(restPlaces(arm.lattice), 0.0, shown);

  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_LT(norm(shown[i] - arm.mesh.vertices_m[i]), 1e-12);
  }
}

}  // namespace
}  // namespace torsio
