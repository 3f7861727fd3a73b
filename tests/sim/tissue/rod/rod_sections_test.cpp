// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/rod_sections.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/lattice/section_lattice.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

constexpr double kLength_m = 0.24;

SectionLattice latticeOf(const TriangleMesh& mesh) {
  LatticeOptions options{.sections = 13, .mode = LatticeMode::kAutomatic};
  return {mesh, options};
}

OrganRod rodOf(const TriangleMesh& mesh, const RodDivision& division = {}) {
  const SectionLattice lattice = latticeOf(mesh);
  return rodOfOrgan(lattice, SolvedSections::solve(lattice, {}), {1e4, 0.45}, division);
}

TEST(SectionMoments, OfACircleBentAtRestFollowTheClosedForms) {
  // Over a disc, j0 = 1 + kappa y: integral 1 / j0 = 2 pi (1 - sqrt(1 - (kappa R)^2)) / kappa^2 = A';
  // integral y / j0 = (A - A') / kappa; integral y y / j0 = (A' - A) / kappa^2.
  const double radius = 0.025;
  const double kappa = 30.0;  // kappa R = 0.75
  const testing::Outline2 circle = testing::circleOutline(radius, 720);

  const SectionMoments m = momentsOf(circle, kappa, 0.0);

  const double area = kPi * radius * radius;
  const double weighted =
      2.0 * kPi * (1.0 - std::sqrt(1.0 - std::pow(kappa * radius, 2.0))) / (kappa * kappa);
  EXPECT_NEAR(m.area_m2 / weighted, 1.0, 1e-4);
  EXPECT_NEAR(m.y_m3 / ((area - weighted) / kappa), 1.0, 1e-3);
  EXPECT_NEAR(m.yy_m4 / ((weighted - area) / (kappa * kappa)), 1.0, 1e-3);
  EXPECT_NEAR(m.x_m3 / m.y_m3, 0.0, 1e-9);
  EXPECT_NEAR(m.xy_m4 / m.yy_m4, 0.0, 1e-9);
}

TEST(SectionMoments, OfAStraightSectionAreThoseOfItsPolygon) {
  // Rectangle 40 mm x 20 mm moved by (5, -3) mm: A = 8e-4, Ix = b h^3 / 12 + A d^2.
  testing::Outline2 outline = testing::rectangleOutline(0.040, 0.020, 8);
  for (auto& point : outline) {
    point = {point[0] + 0.005, point[1] - 0.003};
  }

  const SectionMoments m = momentsOf(outline, 0.0, 0.0);

  EXPECT_NEAR(m.area_m2, 8e-4, 1e-15);
  EXPECT_NEAR(m.x_m3, 4e-6, 1e-17);
  EXPECT_NEAR(m.y_m3, -2.4e-6, 1e-17);
  EXPECT_NEAR(m.xx_m4, 0.020 * std::pow(0.040, 3.0) / 12.0 + 8e-4 * 25e-6, 1e-18);
  EXPECT_NEAR(m.yy_m4, 0.040 * std::pow(0.020, 3.0) / 12.0 + 8e-4 * 9e-6, 1e-18);
  EXPECT_NEAR(m.xy_m4, 8e-4 * 0.005 * -0.003, 1e-18);
}

TEST(RodOfOrgan, AStraightTaperHasTheComplianceOfItsIntegral) {
  const TriangleMesh bar = testing::prism(testing::ellipseOutline(0.030, 0.018, 96), kLength_m, 48, 0.5);
  const SectionLattice lattice = latticeOf(bar);
  const SolvedSections sections = SolvedSections::solve(lattice, {});
  const std::vector<double> integral =
      sectionCompliances(sections.profile(), 1001, lattice.length_m(), 1e4, EndCondition::kClampedFree);

  const OrganRod rod = rodOfOrgan(lattice, sections, {1e4, 0.45});

  double compliance = 0.0;
  for (const RodElement& e : rod.elements) {
    compliance += e.length_m / e.bend_Nm2[8];
  }
  EXPECT_NEAR(compliance / integral.back(), 1.0, 1e-6);
}

TEST(RodOfOrgan, ARoundBarHasTheStiffnessesOfItsTheory) {
  // E = 2 G (1 + nu) = 29 kPa; the 96-gon has 0.99929 of the circle's area.
  const double radius = 0.025;
  const OrganRod rod = rodOf(testing::prism(testing::circleOutline(radius, 96), kLength_m, 48));
  const double area = kPi * radius * radius;
  const RodElement& e = rod.elements[10];
  EXPECT_NEAR(e.axial_N / (29e3 * area), 0.99929, 1e-4);
  EXPECT_EQ(e.stretch_N[8], 0.0) << "the axial law is neo-Hookean, in axial_N";
  EXPECT_NEAR(e.stretch_N[0] / (0.9 * 1e4 * area), 0.99929, 1e-4);
  EXPECT_NEAR(e.bend_Nm2[0] / (29e3 * area * radius * radius / 4.0), 0.99857, 2e-4);
  EXPECT_NEAR(e.bend_Nm2[8] / (1e4 * area * radius * radius / 2.0), 0.99857, 2e-4);
  EXPECT_NEAR(e.bendLimit.spread_m2[0] / (radius * radius), 0.99929, 2e-4) << "4 I / A of a circle is R^2";
  EXPECT_EQ(e.bendLimit.limit, 0.40);
  EXPECT_NEAR(norm(Vec3{e.restCurvature_per_m[0], e.restCurvature_per_m[1], e.restCurvature_per_m[2]}), 0.0,
              1e-6);
}

TEST(RodOfOrgan, ABentTubeIsBentAtRestAndKnowsItsInnerFibres) {
  const double bend = kLength_m / (0.5 * kPi);
  const double radius = 0.025;
  const OrganRod rod = rodOf(testing::bentTube(radius, bend, 0.5 * kPi, 96, 60));
  for (const RodElement& e : rod.elements) {
    const double curvature = std::hypot(e.restCurvature_per_m[0], e.restCurvature_per_m[1]);
    EXPECT_NEAR(curvature * bend, 1.0, 0.01);
    // E S = E integral u / j0 = E kappa I to second order, and 1/j0 - 1 adds (kappa R)^2 / 2 of it.
    const double coupling = std::hypot(e.coupling_Nm[6], e.coupling_Nm[7]);
    EXPECT_NEAR(coupling / (29e3 * curvature * kPi * std::pow(radius, 4.0) / 4.0), 1.012, 0.01);
  }
}

TEST(RodOfOrgan, TheRodEndsWhereTheOrganRoundsOff) {
  // A half ball of radius 20 mm falls at 45 degrees where its section has 0.707 of the radius.
  const double radius = 0.020;
  const OrganRod rod = rodOf(testing::capsule(radius, kLength_m, 64, 40));
  EXPECT_NEAR(rod.radii_m.front() / radius, 0.707, 0.12);
  EXPECT_NEAR(rod.radii_m.back() / radius, 0.707, 0.12);
  EXPECT_GT(rod.arcs_m.front(), 0.0);
}

TEST(RodOfOrgan, ANodeLiesWhereItIsAskedForAndThinPartsGetShorterElements) {
  const TriangleMesh bar = testing::prism(testing::circleOutline(0.030, 96), kLength_m, 48, 0.4);

  const OrganRod rod = rodOf(bar, {.elements = 20, .node_m = 0.0777});

  EXPECT_EQ(rod.rest.count, 21);
  EXPECT_NE(std::find(rod.arcs_m.begin(), rod.arcs_m.end(), 0.0777), rod.arcs_m.end());
  for (std::size_t i = 1; i < rod.arcs_m.size(); ++i) {
    EXPECT_GT(rod.arcs_m[i], rod.arcs_m[i - 1]);
  }
  EXPECT_GT(rod.elements.front().length_m, 1.3 * rod.elements.back().length_m);
}

TEST(RodOfOrgan, RefusesMaterialsAndDivisionsWithoutMeaning) {
  const SectionLattice lattice = latticeOf(testing::prism(testing::circleOutline(0.030, 48), kLength_m, 24));
  const SolvedSections sections = SolvedSections::solve(lattice, {});
  const auto code = [&](const RodMaterial& material, int elements) {
    return testing::refusalCode(
        [&] { return rodOfOrgan(lattice, sections, material, {.elements = elements}); });
  };
  EXPECT_EQ(code({0.0, 0.5}, 31), ErrorCode::kBadParameter);
  EXPECT_EQ(code({std::nan(""), 0.5}, 31), ErrorCode::kBadParameter);
  EXPECT_EQ(code({1e4, 0.51}, 31), ErrorCode::kBadParameter);
  EXPECT_EQ(code({1e4, -0.1}, 31), ErrorCode::kBadParameter);
  EXPECT_EQ(code({1e4, 0.5}, 1), ErrorCode::kBadParameter);
  EXPECT_EQ(code({1e4, 0.5}, kMaxRodNodes), ErrorCode::kBadParameter);
}

}  // namespace
}  // namespace torsio
