// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/baseline/corotational_frames.h"
#include "sim/baseline/neo_hookean_elements.h"
#include "sim/baseline/spring_lattice.h"
#include "sim/baseline/stress_laws.h"
#include "sim/core/error.h"
#include "tests/sim/baseline/bars.h"

namespace torsio {
namespace {

constexpr ElasticConstants kConstants{4000.0, 0.45};

struct BodyCase {
  std::string name;
  std::function<std::unique_ptr<ElasticBody>(const SweptSolid&)> make;
};

class Body : public ::testing::TestWithParam<BodyCase> {
 protected:
  SweptSolid solid_ = bentBar(6, 2, 2, 0.02, 0.04, 0.5);
  std::unique_ptr<ElasticBody> body_ = GetParam().make(solid_);

  /// Every point moved by up to a millimetre, each in its own way.
  [[nodiscard]] std::vector<Vec3> disturbed() const {
    std::vector<Vec3> places = solid_.points_m;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double n = static_cast<double>(i);
      places[i] += 1e-3 * Vec3{std::sin(1.7 * n), std::sin(2.3 * n + 1.0), std::sin(3.1 * n + 2.0)};
    }
    return places;
  }
};

double& coordinate(Vec3& v, std::size_t i) {
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

double energyOf(const ElasticBody& body, std::size_t element, const std::vector<Vec3>& places,
                std::vector<Vec3>& forces) {
  double energy_J = 0.0;
  forces.resize(body.elementNodes(element).size());
  EXPECT_TRUE(body.elementForces(element, places, energy_J, forces));
  return energy_J;
}

TEST_P(Body, IsAtRestWhereItWasMade) {
  std::vector<Vec3> forces;
  for (std::size_t e = 0; e < body_->elements(); ++e) {
    EXPECT_NEAR(energyOf(*body_, e, solid_.points_m, forces), 0.0, 1e-15);
    for (const Vec3& f : forces) {
      EXPECT_NEAR(norm(f), 0.0, 1e-10);
    }
  }
}

TEST_P(Body, ForcesAreTheDerivativeOfTheEnergyAndStiffnessThatOfTheForces) {
  const std::vector<Vec3> places = disturbed();
  std::vector<Vec3> forces;
  std::vector<Vec3> above;
  std::vector<Vec3> below;
  for (const std::size_t e : {std::size_t{0}, body_->elements() / 2, body_->elements() - 1}) {
    const double scale_J = energyOf(*body_, e, places, forces);
    const std::size_t size = 3 * forces.size();
    std::vector<double> stiffness(size * size);
    body_->elementStiffness(e, places, stiffness);
    double largest = 0.0;
    for (const double k : stiffness) {
      largest = std::max(largest, std::abs(k));
    }
    for (std::size_t column = 0; column < size; ++column) {
      constexpr double kStep_m = 1e-7;
      const auto node = static_cast<std::size_t>(body_->elementNodes(e)[column / 3]);
      std::vector<Vec3> more = places;
      std::vector<Vec3> less = places;
      coordinate(more[node], column % 3) += kStep_m;
      coordinate(less[node], column % 3) -= kStep_m;
      const double slope =
          (energyOf(*body_, e, more, above) - energyOf(*body_, e, less, below)) / (2.0 * kStep_m);
      EXPECT_NEAR(coordinate(forces[column / 3], column % 3), slope, 1e-5 * scale_J / 1e-3 + 1e-8);
      for (std::size_t row = 0; row < size; ++row) {
        const double difference =
            (coordinate(above[row / 3], row % 3) - coordinate(below[row / 3], row % 3)) / (2.0 * kStep_m);
        EXPECT_NEAR(stiffness[row + size * column], difference, 1e-5 * largest) << row << ", " << column;
      }
    }
  }
}

TEST_P(Body, KeepsItsEnergyWhenMovedAsARigidBody) {
  const std::vector<Vec3> places = disturbed();
  const double energy_J = elasticEnergy_J(*body_, places);
  std::vector<Vec3> moved;
  for (const Vec3& p : places) {  // a quarter turn about z and a shift
    moved.push_back(Vec3{-p.y, p.x, p.z} + Vec3{0.3, -0.2, 0.1});
  }

  EXPECT_NEAR(elasticEnergy_J(*body_, moved) / energy_J, 1.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, Body,
                         ::testing::Values(BodyCase{"LinearWedges",
                                                    [](const SweptSolid& s) {
                                                      return std::make_unique<NeoHookeanElements>(
                                                          linearWedges(s), s.points_m, kConstants);
                                                    }},
                                           BodyCase{"QuadraticWedges",
                                                    [](const SweptSolid& s) {
                                                      return std::make_unique<NeoHookeanElements>(
                                                          quadraticWedges(s), s.points_m, kConstants);
                                                    }},
                                           BodyCase{"QuadraticTetrahedra",
                                                    [](const SweptSolid& s) {
                                                      return std::make_unique<NeoHookeanElements>(
                                                          quadraticTetrahedra(s), s.points_m, kConstants);
                                                    }},
                                           BodyCase{"Tetrahedra",
                                                    [](const SweptSolid& s) {
                                                      return std::make_unique<CorotationalTetrahedra>(
                                                          tetrahedra(s), s.points_m, kConstants);
                                                    }},
                                           BodyCase{"Springs",
                                                    [](const SweptSolid& s) {
                                                      return std::make_unique<SpringLattice>(s, kConstants);
                                                    }}),
                         [](const auto& tested) { return tested.param.name; });

TEST(CorotationalTetrahedra, WarpedStiffnessIsTheExactOneAtRestAndGivesTheSameForces) {
  const SweptSolid solid = bentBar(6, 2, 2, 0.02, 0.04, 0.5);
  const CorotationalTetrahedra body(tetrahedra(solid), solid.points_m, kConstants);
  std::vector<double> exact(144);
  std::array<Vec3, 4> forces;
  std::array<Vec3, 4> same;
  std::array<Matrix3, 16> blocks;
  double energy_J = 0.0;

  body.elementStiffness(5, solid.points_m, exact);
  body.warpedStiffness(5, solid.points_m, forces, blocks);

  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = 0; b < 4; ++b) {
      for (std::size_t i = 0; i < 9; ++i) {
        EXPECT_NEAR(blocks[4 * a + b][i], exact[3 * a + i % 3 + 12 * (3 * b + i / 3)], 1e-9);
      }
    }
  }
  std::vector<Vec3> places = solid.points_m;
  places[static_cast<std::size_t>(body.elementNodes(5)[2])] += {1e-3, 2e-3, -1e-3};
  body.warpedStiffness(5, places, forces, blocks);
  ASSERT_TRUE(body.elementForces(5, places, energy_J, same));
  for (std::size_t a = 0; a < 4; ++a) {
    EXPECT_NEAR(norm(forces[a] - same[a]), 0.0, 1e-12);
  }
}

TEST(SpringLattice, HasBothDiagonalsOfEverySide) {
  const SweptSolid solid = straightBar(4, 1, 1, 0.01, 0.01);

  const SpringLattice springs(solid, kConstants);

  // Two squares with centre: 4 spokes and 4 sides each (16), 5 along, 2 diagonals on 4 outer and 4 inner
  // sides (16).
  EXPECT_EQ(springs.lengthSprings().size(), 37U);
  EXPECT_EQ(springs.volumeSprings().size(), 12U);
}

TEST(SpringLattice, CalibrationGivesTheDisplacementTheEnergyAskedFor) {
  const SweptSolid solid = straightBar(8, 4, 2, 0.02, 0.08);
  std::vector<Vec3> turned = solid.points_m;
  for (Vec3& p : turned) {
    const double angle = 0.01 * p.z / 0.08;
    p = {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y, p.z};
  }

  const SpringLattice springs = SpringLattice(solid, kConstants).calibrated(turned, 2e-6);

  EXPECT_NEAR(elasticEnergy_J(springs, turned), 2e-6, 1e-15);
  EXPECT_THROW(static_cast<void>(springs.calibrated(solid.points_m, 1e-6)), Error);
}

TEST(ElasticBodies, RefuseConstantsWithoutMeaning) {
  const SweptSolid solid = straightBar(6, 2, 1, 0.02, 0.04);
  for (const ElasticConstants& bad :
       {ElasticConstants{0.0, 0.45}, ElasticConstants{4000.0, 0.5}, ElasticConstants{4000.0, std::nan("")}}) {
    EXPECT_THROW(CorotationalTetrahedra(tetrahedra(solid), solid.points_m, bad), Error);
    EXPECT_THROW(NeoHookeanElements(linearWedges(solid), solid.points_m, bad), Error);
    EXPECT_THROW(SpringLattice(solid, bad), Error);
  }
}

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
