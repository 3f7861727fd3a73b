// SPDX-License-Identifier: GPL-3.0-or-later
// Elements whose end or jaw is turned to an angle: against CalculiX (tests/data/calculix/README.md), and the
// rod against them.
#include "sim/baseline/reference_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/baseline/corotational_frames.h"
#include "sim/baseline/swept_solid.h"
#include "sim/core/error.h"
#include "sim/tissue/rod/rod_solve.h"
#include "tests/sim/baseline/bars.h"
#include "tests/sim/tissue/rod/rod_scenes.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

constexpr double kSolidRadius_m = 0.025;
constexpr double kSolidLength_m = 0.240;
constexpr ElasticConstants kSolidConstants{10000.0, 0.45};

nlohmann::json calculixOf(const std::string& name) {
  std::ifstream file(std::string(TORSIO_TEST_DATA) + "/calculix/" + name + ".json");
  return nlohmann::json::parse(file);
}

SweptSolid bentBy90(int points, int layers) {
  return bentBar(points, layers, 2, kSolidRadius_m, kSolidLength_m, kPi / 2.0);
}

TEST(ReferenceSolid, HasTorqueAndProfileOfCalculixOnABentBar) {
  const nlohmann::json calculix = calculixOf("bent90");  // stations every 6 mm
  ReferenceSolid bar(bentBy90(24, 40), kSolidConstants, {});

  bar.turnTo(radians(1.0));

  EXPECT_NEAR(1e3 * bar.torque_Nm() / radians(1.0), 49.48, 0.01 * 49.48);
  const std::vector<double> turns = sectionTurns_rad(bar.solid(), bar.pose().places_m);
  double worst = 0.0;
  for (std::size_t j = 0; j < turns.size(); ++j) {
    worst = std::max(worst, std::abs(turns[j] / radians(1.0) - calculix["prof"][j].get<double>()));
  }
  EXPECT_LT(worst, 0.01);
  RecordProperty("torque_Nmm_per_rad", std::to_string(1e3 * bar.torque_Nm() / radians(1.0)));
  RecordProperty("profile_error", std::to_string(worst));
}

TEST(ReferenceSolid, QuadraticTetrahedraSayTheSameAsWedges) {
  ReferenceSolid bar(bentBy90(24, 40), kSolidConstants, {}, {}, ReferenceElements::kTetrahedra);

  bar.turnTo(radians(1.0));

  // Two elements of different kinds, and CalculiX with a third (C3D20R), on one bent bar.
  EXPECT_NEAR(1e3 * bar.torque_Nm() / radians(1.0), 49.48, 0.01 * 49.48);
  RecordProperty("torque_Nmm_per_rad", std::to_string(1e3 * bar.torque_Nm() / radians(1.0)));
}

/// What is left of a rotation beside a swing of `tangent`.
double turnAlong(const nlohmann::json& r, const Vec3& tangent) {
  const auto m = [&r](std::size_t i, std::size_t j) { return r[i][j].get<double>(); };
  const Vec3 twiceSine{m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
  const double angle = std::atan2(0.5 * norm(twiceSine), 0.5 * (m(0, 0) + m(1, 1) + m(2, 2) - 1.0));
  const double along = norm(twiceSine) > 0.0 ? dot(twiceSine, tangent) / norm(twiceSine) : 0.0;
  return 2.0 * std::atan2(std::sin(0.5 * angle) * along, std::cos(0.5 * angle));
}

TEST(ReferenceSolid, FollowsNeoHookeanCalculixTo90Degrees) {
  const nlohmann::json calculix = calculixOf("bent90_finite");  // 28 layers
  ReferenceSolid bar(bentBy90(16, 28), kSolidConstants, {});
  const Vec3 axis = bar.ends().axis;
  double worst = 0.0;

  for (const nlohmann::json& step : calculix["out"]) {
    bar.turnTo(radians(step[0].get<double>()));

    const Vec3 moment_Nm{step[1][0].get<double>() * 1e-3, step[1][1].get<double>() * 1e-3,
                         step[1][2].get<double>() * 1e-3};
    const double error = bar.torque_Nm() / dot(moment_Nm, axis) - 1.0;
    EXPECT_LT(std::abs(error), 0.03) << step[0];
    worst = std::max(worst, std::abs(error));
  }

  const std::vector<double> turns = sectionTurns_rad(bar.solid(), bar.pose().places_m);
  double profile = 0.0;
  for (std::size_t j = 0; j < turns.size(); ++j) {
    const double expected = turnAlong(calculix["R"][j], sectionTangent(bar.solid(), static_cast<int>(j)));
    profile = std::max(profile, std::abs(turns[j] - expected) / (kPi / 2.0));
  }
  EXPECT_LT(profile, 0.03);
  RecordProperty("torque_error", std::to_string(worst));
  RecordProperty("profile_error", std::to_string(profile));
}

TEST(ReferenceSolid, AnAngleNeedsTheTorqueThatLeadsToIt) {
  ReferenceSolid turned(bentBy90(12, 12), kSolidConstants, jawAt(0.6));
  turned.turnTo(radians(20.0));
  ReferenceSolid loaded(bentBy90(12, 12), kSolidConstants, jawAt(0.6));

  loaded.load(turned.torque_Nm());

  EXPECT_NEAR(loaded.pose().angle_rad / radians(20.0), 1.0, 1e-6);
  EXPECT_NEAR(loaded.energy_J() / turned.energy_J(), 1.0, 1e-6);
  EXPECT_LT(norm(loaded.pose().way_m - turned.pose().way_m), 1e-7);
}

TEST(ReferenceSolid, AnAngleOfZeroIsRest) {
  ReferenceSolid bar(bentBy90(12, 12), kSolidConstants, {});
  bar.turnTo(radians(5.0));

  bar.turnTo(0.0);

  EXPECT_EQ(bar.torque_Nm(), 0.0);
  EXPECT_EQ(bar.pose().places_m, bar.solid().points_m);
}

TEST(JawEnds, HoldTheSectionsWithinHalfARadiusAndLetTheirPlaceFree) {
  const SweptSolid bar = bentBy90(24, 40);  // a section every 6 mm; half a radius is 12.4 mm

  const TwistEnds ends = twistEnds(bar, jawAt(0.5));

  ASSERT_EQ(ends.turned.size(), 5U * static_cast<std::size_t>(bar.pointsPerSection()));
  EXPECT_EQ(ends.turned.front(), 18 * bar.pointsPerSection());
  EXPECT_TRUE(ends.placeFree);
  EXPECT_LT(norm(ends.axis - Vec3{std::sin(kPi / 4.0), 0.0, std::cos(kPi / 4.0)}), 1e-12);
  EXPECT_LT(norm(ends.axisPoint_m - bar.centre_m(20)), 1e-12);
}

TEST(JawEnds, LieBetweenSectionsWhereTheGraspDoes) {
  const SweptSolid bar = bentBy90(24, 40);

  const TwistEnds ends = twistEnds(bar, jawAt(20.4 / 40.0));  // sections 18.34 to 22.46

  ASSERT_EQ(ends.turned.size(), 4U * static_cast<std::size_t>(bar.pointsPerSection()));
  EXPECT_EQ(ends.turned.front(), 19 * bar.pointsPerSection());
  const double at = kPi / 2.0 * 20.4 / 40.0;
  EXPECT_LT(norm(ends.axis - Vec3{std::sin(at), 0.0, std::cos(at)}), 1e-3);
}

TEST(TwistEnds, OfASpanHoldAndTurnTheTipsBeyondIt) {
  const SweptSolid bar = bentBy90(24, 40);

  const TwistEnds ends = twistEnds(bar, {.span = {0.06, 0.89}});  // nearest: sections 2 and 36

  EXPECT_EQ(ends.held.size(), 3U * static_cast<std::size_t>(bar.pointsPerSection()));
  EXPECT_EQ(ends.turned.size(), 5U * static_cast<std::size_t>(bar.pointsPerSection()));
  EXPECT_LT(norm(ends.axisPoint_m - bar.centre_m(36)), 1e-12);
  const double at = kPi / 2.0 * 36.0 / 40.0;
  EXPECT_LT(norm(ends.axis - Vec3{std::sin(at), 0.0, std::cos(at)}), 1e-12);
  EXPECT_FALSE(ends.placeFree);
  EXPECT_THROW(static_cast<void>(twistEnds(bar, {.span = {0.9, 0.1}})), Error);
}

TEST(JawEnds, RefuseAGraspOutsideTheOrganOrOnTheHeldEnd) {
  const SweptSolid bar = bentBy90(12, 12);

  for (const double grasp : {0.0, -0.5, 1.01, std::nan(""), 0.02}) {
    EXPECT_THROW(static_cast<void>(twistEnds(bar, jawAt(grasp))), Error) << grasp;
  }
}

TEST(ReferenceSolid, AJawOnAStraightBarTwistsWhatLiesBeforeIt) {
  const SweptSolid bar = straightBar(24, 48, 2, kSolidRadius_m, kSolidLength_m);
  ReferenceSolid gripped(bar, kSolidConstants, jawAt(0.5));  // a section every 5 mm: the jaw begins at 110 mm

  gripped.turnTo(radians(0.5));

  const double expected_Nm =
      kSolidConstants.shearModulus_Pa * 0.5 * kPi * std::pow(kSolidRadius_m, 4) / 0.110 * radians(0.5);
  EXPECT_NEAR(gripped.torque_Nm() / expected_Nm, 1.0, 2e-3);
  const std::vector<double> turns = sectionTurns_rad(bar, gripped.pose().places_m);
  EXPECT_NEAR(turns[22], radians(0.5), 1e-9);
  EXPECT_NEAR(turns[48], radians(0.5), 1e-7);  // beyond the jaw nothing carries torque
}

/// The rod of the same bar: 40 elements, so that its jaw has the sections of the elements' jaw.
Rod bentRodOf(int elements) {
  const RodPose pose = bentPose(kSolidLength_m, kPi / 2.0, elements);
  const double young_Pa = 2.0 * kSolidConstants.shearModulus_Pa * (1.0 + kSolidConstants.poissonRatio);
  const EllipticSection section{kSolidRadius_m, kSolidRadius_m, young_Pa, kSolidConstants.shearModulus_Pa};
  std::vector<RodElement> chain;
  for (int i = 0; i < elements; ++i) {
    chain.push_back(curvedElement(section, kPi / 2.0 / kSolidLength_m, kSolidLength_m / elements));
    chain.back().axial_N = std::exchange(chain.back().stretch_N[8], 0.0);
  }
  restAt(pose, chain);
  return Rod(chain, pose, std::vector<double>(static_cast<std::size_t>(elements) + 1, 0.0));
}

TEST(ReferenceSolid, AgreesWithTheRodThatAJawTurns) {
  constexpr int kLayers = 40;
  const Rod rod = bentRodOf(kLayers);
  for (const double grasp : {0.5, 0.8}) {
    ReferenceSolid bar(bentBy90(16, kLayers), kSolidConstants, jawAt(grasp));
    for (const double angle_deg : {1.0, 30.0, 60.0, 90.0}) {
      const TurnedRod turned = solveTurned(rod, {.angle_rad = radians(angle_deg),
                                                 .node = static_cast<int>(std::lround(grasp * kLayers)),
                                                 .holdsPlace = false,
                                                 .halfWidth_m = 0.5 * kSolidRadius_m});
      ASSERT_TRUE(turned.balance.converged) << angle_deg;

      bar.turnTo(radians(angle_deg));

      const std::string at = std::to_string(grasp) + " of the length, " + std::to_string(angle_deg) + " deg";
      EXPECT_NEAR(turned.torque_Nm / bar.torque_Nm(), 1.0, 0.02) << at;
      EXPECT_NEAR(turned.balance.energy_J / bar.energy_J(), 1.0, 0.02) << at;
      const std::vector<double> turns = sectionTurns_rad(bar.solid(), bar.pose().places_m);
      for (std::size_t j = 0; j < turns.size(); ++j) {
        EXPECT_NEAR(turned.turn_rad[j], turns[j], 0.01 * radians(angle_deg)) << at << ", section " << j;
      }
      const std::size_t node = static_cast<std::size_t>(std::lround(grasp * kLayers));
      const Vec3 way_m = turned.pose.nodes[node].position_m - bar.ends().axisPoint_m;
      EXPECT_LT(norm(way_m - bar.pose().way_m), 0.1 * norm(bar.pose().way_m)) << at;
    }
  }
}

/// Torque of tetrahedra turned by ten degrees over that of the reference, less 1, per torsion constant.
double excessOfTetrahedra(int points, const std::optional<double>& grasp, double reference_Nm) {
  const SweptSolid solid = bentBar(points, 20, points / 6, kSolidRadius_m, kSolidLength_m, kPi / 2.0);
  const CorotationalTetrahedra body(tetrahedra(solid), solid.points_m, kSolidConstants);
  const TwistEnds ends = twistEnds(solid, jawAt(grasp));
  Equilibrium newton(body, ends, solid.points_m);
  TwistPose pose{solid.points_m};
  turnEnd(ends, solid.points_m, radians(0.1), pose);
  static_cast<void>(newton.keepAngle(pose));
  pose = turnedOn(solid, ends, pose, 100.0);
  const double ofPolygon = (points == 12 ? kTorsion12 : kTorsion24) / (0.5 * kPi);
  return newton.keepAngle(pose).torque_Nm / (ofPolygon * reference_Nm) - 1.0;
}

TEST(ReferenceSolid, TetrahedraTurnedByAnEndAndByAJawAreAlikeTooStiff) {
  ReferenceSolid end(bentBy90(16, 20), kSolidConstants, {});
  ReferenceSolid jaw(bentBy90(16, 20), kSolidConstants, jawAt(0.6));
  end.turnTo(radians(10.0));
  jaw.turnTo(radians(10.0));

  for (const auto& [points, excess] : {std::pair{12, 0.64}, std::pair{24, 0.42}}) {
    const double atEnd = excessOfTetrahedra(points, std::nullopt, end.torque_Nm());
    const double atJaw = excessOfTetrahedra(points, 0.6, jaw.torque_Nm());

    // No number is published for a bend; straight bars of 10 and 24 layers are 92 and 16.5 % too stiff
    // (equilibrium_test.cpp), here there are 20. What two ways of turning must share is the excess.
    EXPECT_NEAR(atEnd, excess, 0.1 * excess) << points;
    EXPECT_NEAR(atJaw, atEnd, 0.1 * atEnd) << points;
  }
}

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
