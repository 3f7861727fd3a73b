// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/finite_element_bar.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/base/portable_math.h"

namespace torsio {
namespace {

constexpr double kRadius_m = 0.02;
constexpr double kLength_m = 6.0 * kRadius_m;  // slenderness of the published comparison
constexpr double kShear_Pa = 5000.0;

/// Torsion constant J / R^4 of the regular polygon, from the conformal-map series.
constexpr double kTorsion12 = 1.425364842;
constexpr double kTorsion24 = 1.534238759;

FiniteElementBar roundBar(BarElement element, int points, int rings, int layers, double poisson) {
  return {regularOutline(points, kRadius_m), kLength_m, element, {rings, layers}, {kShear_Pa, poisson}};
}

double toFourth(double x) {
  return x * x * x * x;
}

/// Polar moment of the regular polygon: N triangles of R^4 sin(a) (2 + cos(a)) / 12 with a = 2 pi / N.
double polarMoment_m4(int points) {
  const double a = 2.0 * kPi / points;
  return points * toFourth(kRadius_m) * std::sin(a) * (2.0 + std::cos(a)) / 12.0;
}

/// Stiffness over the G J / H of the same polygon, less 1.
double excessStiffness(const FiniteElementBar& bar, double torsion) {
  return bar.linearTorque_Nm(1.0) * kLength_m / (kShear_Pa * torsion * toFourth(kRadius_m)) - 1.0;
}

/// The published excesses carry two or three digits; a tenth of the value tells P1 locking from a fault.
constexpr double kTenth = 0.1;

TEST(FiniteElementBar, WedgesTwistARegularPolygonWithItsPolarMoment) {
  for (const double poisson : {0.0, 0.30, 0.45, 0.499}) {
    const FiniteElementBar bar = roundBar(BarElement::kWedge6, 24, 2, 6, poisson);
    const double angle_rad = 0.3;

    const double torque_Nm = bar.linearTorque_Nm(angle_rad);

    // u = theta z (-y, x) lies in the element, and no point of the mesh warps: T = G Ip theta, any nu.
    const double expected_Nm = kShear_Pa * polarMoment_m4(24) * angle_rad / kLength_m;
    EXPECT_NEAR(torque_Nm / expected_Nm, 1.0, 1e-9) << "nu " << poisson;
  }
}

TEST(FiniteElementBar, WedgesExceedTheTorsionConstantByTheWarpingTheyCannotShow) {
  const FiniteElementBar bar = roundBar(BarElement::kWedge6, 24, 2, 6, 0.45);

  // Ip / J of the 24-gon is 1.000678.
  EXPECT_NEAR(excessStiffness(bar, kTorsion24), 0.00068, 0.00001);
}

TEST(FiniteElementBar, CoarseTetrahedraAreNearlyTwiceTooStiff) {
  const FiniteElementBar bar = roundBar(BarElement::kTetrahedron4, 12, 2, 10, 0.45);

  EXPECT_NEAR(excessStiffness(bar, kTorsion12), 0.92, kTenth * 0.92);
}

TEST(FiniteElementBar, CoarseTetrahedraLockLessWhenTheTissueIsCompressible) {
  const FiniteElementBar bar = roundBar(BarElement::kTetrahedron4, 12, 2, 10, 0.30);

  EXPECT_NEAR(excessStiffness(bar, kTorsion12), 0.57, kTenth * 0.57);
}

TEST(FiniteElementBar, TwelveThousandTetrahedraAreStillASixthTooStiff) {
  const FiniteElementBar bar = roundBar(BarElement::kTetrahedron4, 24, 4, 24, 0.45);

  ASSERT_EQ(bar.mesh().cells.size(), 12096U);
  EXPECT_NEAR(excessStiffness(bar, kTorsion24), 0.165, kTenth * 0.165);
}

TEST(FiniteElementBar, TetrahedraFillTheBar) {
  const BarMesh mesh = roundBar(BarElement::kTetrahedron4, 12, 3, 4, 0.45).mesh();
  double volume_m3 = 0.0;
  for (const auto& cell : mesh.cells) {
    const auto at = [&](int k) {
      return mesh.points[static_cast<std::size_t>(cell[static_cast<std::size_t>(k)])];
    };
    const double six = dot(at(1) - at(0), cross(at(2) - at(0), at(3) - at(0)));
    EXPECT_GT(std::abs(six), 0.0);
    volume_m3 += std::abs(six) / 6.0;
  }

  // Area of the 12-gon: 12 triangles of R^2 sin(30 degrees) / 2.
  EXPECT_NEAR(volume_m3 / (3.0 * kRadius_m * kRadius_m * kLength_m), 1.0, 1e-12);
}

TEST(FiniteElementBar, LinearTorqueIsProportionalToTheAngle) {
  const FiniteElementBar bar = roundBar(BarElement::kWedge6, 12, 2, 4, 0.45);

  EXPECT_DOUBLE_EQ(bar.linearTorque_Nm(-0.5), -0.5 * bar.linearTorque_Nm(1.0));
  EXPECT_EQ(bar.linearTorque_Nm(0.0), 0.0);
}

}  // namespace
}  // namespace torsio
