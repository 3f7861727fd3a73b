// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/stress_laws.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace torsio {
namespace {

constexpr ElasticConstants kTissue{4000.0, 0.45};
constexpr Matrix3 kIdentity{1, 0, 0, 0, 1, 0, 0, 0, 1};

struct Law {
  std::string name;
  StressState (*stress)(const Matrix3&, const ElasticConstants&);
  Matrix9 (*tangent)(const Matrix3&, const ElasticConstants&);
};

class StressLaw : public ::testing::TestWithParam<Law> {};

Matrix3 product(const Matrix3& a, const Matrix3& b) {
  Matrix3 c{};
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t k = 0; k < 3; ++k) {
        c[row + 3 * column] += a[row + 3 * k] * b[k + 3 * column];
      }
    }
  }
  return c;
}

/// A turn of 1.1 rad about (2, -1, 3) / sqrt(14), by Rodrigues' formula.
Matrix3 someRotation() {
  const double n = std::sqrt(14.0);
  const std::array<double, 3> a{2.0 / n, -1.0 / n, 3.0 / n};
  const double c = std::cos(1.1);
  const double s = std::sin(1.1);
  const Matrix3 skew{0, a[2], -a[1], -a[2], 0, a[0], a[1], -a[0], 0};
  Matrix3 r{};
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      r[row + 3 * column] =
          (row == column ? c : 0.0) + (1.0 - c) * a[row] * a[column] + s * skew[row + 3 * column];
    }
  }
  return r;
}

/// A stretched, sheared and turned state.
Matrix3 someGradient() {
  return product(someRotation(), {1.2, 0.3, -0.1, 0.05, 0.9, 0.2, -0.15, 0.1, 1.1});
}

TEST_P(StressLaw, HasNoEnergyAndNoStressAtRestHoweverTurned) {
  for (const Matrix3& f : {kIdentity, someRotation()}) {
    const StressState state = GetParam().stress(f, kTissue);

    EXPECT_NEAR(state.energy_Pa, 0.0, 1e-9);
    for (const double p : state.stress_Pa) {
      EXPECT_NEAR(p, 0.0, 1e-9);
    }
  }
}

TEST_P(StressLaw, StressIsTheDerivativeOfTheEnergy) {
  const Matrix3 f = someGradient();
  const StressState state = GetParam().stress(f, kTissue);

  for (std::size_t i = 0; i < 9; ++i) {
    constexpr double kStep = 1e-5;
    Matrix3 more = f;
    Matrix3 less = f;
    more[i] += kStep;
    less[i] -= kStep;
    const double difference =
        (GetParam().stress(more, kTissue).energy_Pa - GetParam().stress(less, kTissue).energy_Pa) /
        (2.0 * kStep);
    EXPECT_NEAR(state.stress_Pa[i], difference, 1e-4) << "number " << i;
  }
}

TEST_P(StressLaw, TangentIsTheDerivativeOfTheStressAndSymmetric) {
  const Matrix3 f = someGradient();
  const Matrix9 tangent = GetParam().tangent(f, kTissue);

  for (std::size_t k = 0; k < 9; ++k) {
    constexpr double kStep = 1e-6;
    Matrix3 more = f;
    Matrix3 less = f;
    more[k] += kStep;
    less[k] -= kStep;
    const Matrix3 above = GetParam().stress(more, kTissue).stress_Pa;
    const Matrix3 below = GetParam().stress(less, kTissue).stress_Pa;
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_NEAR(tangent[i + 9 * k], (above[i] - below[i]) / (2.0 * kStep), 1e-3) << i << ", " << k;
      EXPECT_NEAR(tangent[i + 9 * k], tangent[k + 9 * i], 1e-7) << i << ", " << k;
    }
  }
}

TEST_P(StressLaw, IsObjective) {
  const Matrix3 f = someGradient();
  const Matrix3 r = someRotation();
  const StressState still = GetParam().stress(f, kTissue);

  const StressState turned = GetParam().stress(product(r, f), kTissue);

  // W(R F) = W(F), P(R F) = R P(F)
  EXPECT_NEAR(turned.energy_Pa, still.energy_Pa, 1e-9 * still.energy_Pa);
  const Matrix3 expected = product(r, still.stress_Pa);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(turned.stress_Pa[i], expected[i], 1e-8);
  }
}

TEST_P(StressLaw, SmallStrainIsHookesLaw) {
  constexpr double kStrain = 1e-7;
  Matrix3 f = kIdentity;
  f[0] += kStrain;  // stretch along x
  f[3] += kStrain;  // shear xy

  const Matrix3 stress = GetParam().stress(f, kTissue).stress_Pa;

  // lambda = 2 G nu / (1 - 2 nu) = 36000 Pa; sxx = (lambda + 2 G) e, syy = lambda e, sxy = G gamma
  EXPECT_NEAR(stress[0], 44000.0 * kStrain, 1e-8);
  EXPECT_NEAR(stress[4], 36000.0 * kStrain, 1e-8);
  EXPECT_NEAR(stress[3], 4000.0 * kStrain, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(All, StressLaw,
                         ::testing::Values(Law{"NeoHookean", neoHookeanStress, neoHookeanTangent},
                                           Law{"Corotational", corotationalStress, corotationalTangent}),
                         [](const auto& tested) { return tested.param.name; });

TEST(RotationOf, TurnsAStretchedStateBack) {
  const Matrix3 r = someRotation();
  const Matrix3 stretch{1.3, 0.1, 0.0, 0.1, 0.8, 0.05, 0.0, 0.05, 1.1};  // symmetric, positive

  const Matrix3 found = rotationOf(product(r, stretch));

  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(found[i], r[i], 1e-14);
  }
}

TEST(RotationOf, GivesAProperRotationForAnElementTurnedInsideOut) {
  const Matrix3 found = rotationOf({1, 0, 0, 0, 1, 0, 0, 0, -0.2});

  const double det = found[0] * (found[4] * found[8] - found[7] * found[5]) -
                     found[3] * (found[1] * found[8] - found[7] * found[2]) +
                     found[6] * (found[1] * found[5] - found[4] * found[2]);
  EXPECT_NEAR(det, 1.0, 1e-12);
}

}  // namespace
}  // namespace torsio
