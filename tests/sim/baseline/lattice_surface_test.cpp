// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/lattice_surface.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "tests/sim/baseline/bars.h"

namespace torsio {
namespace {

LatticePlaces bar(int ridges, int layers, double radius_m, double length_m) {
  LatticePlaces places{ridges, layers + 1, {}};
  for (const std::vector<Vec3>& outline : straightOutlines(ridges, layers, radius_m, length_m)) {
    places.places_m.insert(places.places_m.end(), outline.begin(), outline.end());
  }
  return places;
}

template <typename Move>
LatticePlaces mapped(LatticePlaces places, const Move& move) {
  for (Vec3& p : places.places_m) {
    p = move(p);
  }
  return places;
}

TEST(LatticePlaces, EncloseTheVolumeOfTheirPolygon) {
  // Area of the 12-gon: 3 R^2.
  EXPECT_NEAR(latticeVolume_m3(bar(12, 5, 0.02, 0.1)), 3.0 * 0.02 * 0.02 * 0.1, 1e-18);
}

TEST(LatticePlaces, RootMeanSquareDistanceOfAShiftIsTheShift) {
  const LatticePlaces rest = bar(8, 3, 0.02, 0.1);
  const LatticePlaces moved = mapped(rest, [](const Vec3& p) { return p + Vec3{0.003, 0.0, 0.004}; });

  EXPECT_NEAR(rootMeanSquareDistance_m(rest, moved), 0.005, 1e-15);
}

TEST(LatticePlaces, ARigidMotionIsNeitherRoughNorSwollen) {
  const LatticePlaces rest = bar(8, 3, 0.02, 0.1);
  const LatticePlaces moved = mapped(rest, [](const Vec3& p) {
    return Vec3{-p.y, p.x, p.z} + Vec3{0.1, 0.2, 0.3};
  });

  EXPECT_NEAR(largestRadiusChange(rest, moved), 0.0, 1e-12);
  EXPECT_NEAR(roughness_m(rest, moved), 0.0, 1e-15);
}

TEST(LatticePlaces, EvenSwellingIsARadiusChangeAndNotRough) {
  const LatticePlaces rest = bar(8, 4, 0.02, 0.1);
  const LatticePlaces swollen = mapped(rest, [](const Vec3& p) { return Vec3{1.1 * p.x, 1.1 * p.y, p.z}; });

  EXPECT_NEAR(largestRadiusChange(rest, swollen), 0.1, 1e-12);
  EXPECT_NEAR(roughness_m(rest, swollen), 0.0, 1e-15);
}

TEST(LatticePlaces, TeethOfAMillimetreAreTwoMillimetresRough) {
  const LatticePlaces rest = bar(8, 4, 0.02, 0.1);
  LatticePlaces rough = rest;
  for (std::size_t i = 0; i < rough.places_m.size(); ++i) {
    const double sign = (i % 8 + i / 8) % 2 == 0 ? 1.0 : -1.0;
    Vec3& p = rough.places_m[i];
    p += (sign * 1e-3 / 0.02) * Vec3{p.x, p.y, 0.0};
  }

  // + 1 mm against a mean of - 1 mm over the four neighbours.
  EXPECT_NEAR(roughness_m(rest, rough), 2e-3, 1e-12);
}

TEST(MarkerAnchor, FollowsItsThreeKeyPoints) {
  const LatticePlaces rest = bar(8, 4, 0.02, 0.1);
  LatticePlaces now = rest;
  now.places_m[3] += {0.0, 0.0, 0.006};
  MarkerAnchor marker{.rest_m = {0.02, 0.0, 0.05}, .points = {3, 4, 11}, .weights = {0.5, 0.25, 0.25}};

  const Vec3 place = markerPlace_m(marker, rest, now, {}, 0.0);

  EXPECT_NEAR(norm(place - Vec3{0.02, 0.0, 0.053}), 0.0, 1e-15);
}

TEST(MarkerAnchor, BeyondTheFreeEndTurnsWithItAndBeyondTheFixedEndStays) {
  const LatticePlaces rest = bar(8, 4, 0.02, 0.1);
  const AxisFrame end{{0.0, 0.0, 0.1}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  MarkerAnchor marker{.part = LatticePart::kFreeCap, .rest_m = {0.03, 0.0, 0.15}};

  EXPECT_NEAR(norm(markerPlace_m(marker, rest, rest, end, kPi / 2.0) - Vec3{0.0, 0.03, 0.15}), 0.0, 1e-12);
  marker.part = LatticePart::kFixedCap;
  EXPECT_EQ(norm(markerPlace_m(marker, rest, rest, end, kPi / 2.0) - marker.rest_m), 0.0);
}

/// The forearm between elbow and wrist; the hand beyond is a cap.
struct Forearm {
  TriangleMesh mesh = importMesh(
      std::filesystem::path(TORSIO_SOURCE_DIR) / "assets" / "organs" / "forearm.ply", {.scale_m = 1e-3});
  SectionLattice lattice{mesh, LatticeOptions{.ridges = 36,
                                              .sections = 37,
                                              .mode = LatticeMode::kStraightAxis,
                                              .freeEnd_m = {0.0, 0.0, 0.262},
                                              .freeCut = {0.0, 0.0, 1.0},
                                              .ridgeZero = {1.0, 0.0, 0.0}}};
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
