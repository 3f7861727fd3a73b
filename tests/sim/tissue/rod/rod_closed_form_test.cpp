// SPDX-License-Identifier: GPL-3.0-or-later
// The rod against closed forms of beams and rods: docs/model.md R.10.
// Bent bars against CalculiX: tests/data/calculix/README.md says how its numbers were made.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/tissue/rod/rod_solve.h"
#include "sim/tissue/rod/rod_system.h"
#include "tests/sim/tissue/rod/rod_scenes.h"

namespace torsio {
namespace {

constexpr int kClosedElements = 31;
constexpr double kClosedShear_Pa = 1e4;
constexpr double kClosedYoung_Pa = 2.9e4;  // 2 G (1 + 0.45)

std::function<EllipticSection(double)> round(double first_m, double last_m) {
  return [=](double s) {
    const double r = first_m + (last_m - first_m) * s;
    return EllipticSection{r, r, kClosedYoung_Pa, kClosedShear_Pa};
  };
}

HeldNode heldAt(int node, std::array<bool, 6> freedoms = {true, true, true, true, true, true}) {
  return {.node = node, .freedoms = freedoms};
}

/// Number of negative eigenvalues of the stiffness at `pose` (Sylvester's law of inertia).
int instabilities(const Rod& rod, const RodPose& pose, const std::vector<HeldNode>& held) {
  const auto system = std::make_unique<RodSystem>();
  assemble({.rod = &rod, .near = rod.contactPairs(), .held = held}, pose, 0.0, *system);
  return factorise(*system);
}

TEST(RodTorsion, OfStraightBarsIsTheComplianceAlongThem) {
  // Torque and turn of a section against the integral of ds/GJ, as the straight model has it; taper 1 : 1/2.
  struct Bar {
    std::function<EllipticSection(double)> at;
  };
  const EllipticSection ellipse{0.036, 0.024, kClosedYoung_Pa, kClosedShear_Pa};
  for (const Bar& bar :
       {Bar{round(0.030, 0.030)}, Bar{round(0.030, 0.015)}, Bar{[=](double) { return ellipse; }}}) {
    const Rod rod = straightRod(0.24, kClosedElements, bar.at);
    const double whole = 0.24 / torsionOver(bar.at, 0.0, 1.0);

    const TurnedRod turned = solveTurned(rod, {.angle_rad = radians(1.0)});

    EXPECT_TRUE(turned.balance.converged);
    EXPECT_NEAR(turned.torque_Nm * whole / radians(1.0), 1.0, 1e-6);
    for (int i = 1; i < kClosedElements; ++i) {
      const double share = static_cast<double>(i) / kClosedElements;
      const double part = 0.24 * share / torsionOver(bar.at, 0.0, share);
      EXPECT_NEAR(turned.turn_rad[static_cast<std::size_t>(i)] / radians(1.0), part / whole, 1e-6);
    }
  }
}

TEST(RodTorsion, OfATaperIsItsClosedForm) {
  // r = r0 (1 - s/2L): integral of 2 ds/(pi G r^4) = 2L/(pi G r0^4) * (2/3) (2^3 - 1).
  const double compliance = 2.0 * 0.24 / (kPi * kClosedShear_Pa * std::pow(0.030, 4)) * (14.0 / 3.0);
  const Rod rod = straightRod(0.24, kClosedElements, round(0.030, 0.015));

  const TurnedRod small = solveTurned(rod, {.angle_rad = radians(1.0)});
  const TurnedRod large = solveTurned(rod, {.angle_rad = kPi});

  EXPECT_NEAR(small.torque_Nm * compliance / radians(1.0), 1.0, 1e-9);
  EXPECT_NEAR(large.torque_Nm * compliance / kPi, 1.0, 1e-9);  // an element turns by its true angle
}

TEST(RodBending, OfACantileverIsTimoshenkos) {
  const Rod rod = straightRod(0.3, kClosedElements, round(0.030, 0.030));
  const EllipticSection section = round(0.030, 0.030)(0.0);
  const std::vector<HeldNode> held{heldAt(0)};
  RodPose pose = rod.rest();
  Pose hand{.position_m = {0, 0, 0.3}, .orientation = {}};
  const RodGrip grip =
      gripAt(rod, pose, kClosedElements, 0.0, hand, {.place_N_per_m = 1.0, .turn_Nm_per_rad = 0.0});
  hand.position_m.x = 0.001;

  const RodBalance balance = balanceRod(rod, &grip, hand, held, pose);

  const double force_N = -balance.load.force_N.x;
  const double sag_m = force_N * (std::pow(0.3, 3) / (3.0 * section.bending2_Nm2()) +
                                  0.3 / (0.9 * kClosedShear_Pa * section.area_m2()));
  EXPECT_TRUE(balance.converged);
  EXPECT_NEAR(pose.nodes[kClosedElements].position_m.x / sag_m, 1.0, 2e-3);
  EXPECT_NEAR(balance.held[0].force_N.x, -force_N, 1e-9);
  EXPECT_NEAR(balance.held[0].torque_Nm.y, -0.3 * force_N, 1e-4 * 0.3 * force_N);
}

TEST(RodBending, OfAForceThroughTheShearCentreDoesNotTwist) {
  // A force at the centroid twists by F e1 L / GJ, one at the shear centre (e1, 0) not at all. The force runs
  // along e2.
  constexpr double kOffset_m = 0.008;
  const EllipticSection section = round(0.030, 0.030)(0.0);
  std::vector<RodElement> elements(kClosedElements, straightElement(section, 0.3 / kClosedElements));
  for (RodElement& e : elements) {
    addShearCentre(e, kOffset_m, 0.0);
  }
  const Rod rod(elements, straightPose(0.3, kClosedElements), std::vector<double>(kClosedElements + 1, 0.0));
  const std::vector<HeldNode> held{heldAt(0)};
  const auto twist = [&](double at_m, double& force_N) {
    RodPose pose = rod.rest();
    Pose hand{.position_m = {at_m, 0, 0.3}, .orientation = {}};
    const RodGrip grip =
        gripAt(rod, pose, kClosedElements, 0.0, hand, {.place_N_per_m = 1, .turn_Nm_per_rad = 0});
    hand.position_m.y = 0.001;
    force_N = -balanceRod(rod, &grip, hand, held, pose).load.force_N.y;
    return 2.0 * pose.nodes[kClosedElements].orientation.z;
  };
  double force_N = 0.0;

  const double atCentre_rad = twist(kOffset_m, force_N);
  const double atCentroid_rad = twist(0.0, force_N);

  EXPECT_NEAR(atCentroid_rad / (-force_N * kOffset_m * 0.3 / section.torsion_Nm2()), 1.0, 1e-3);
  EXPECT_LT(std::abs(atCentre_rad), 1e-3 * std::abs(atCentroid_rad));
}

TEST(RodBending, ByTheTurnOfAnEndGivesHalfACircle) {
  const Rod rod = straightRod(0.3, kClosedElements, round(0.010, 0.010));
  const std::vector<HeldNode> held{heldAt(0),
                                   heldAt(kClosedElements, {false, false, false, true, true, true})};
  RodPose pose = rod.rest();
  RodBalance balance;

  for (int step = 1; step <= 12; ++step) {
    pose.nodes[kClosedElements].orientation = axisAngle({0, 1, 0}, kPi * step / 12);
    balance = balanceRod(rod, nullptr, {}, held, pose);
  }

  const double moment_Nm = round(0.010, 0.010)(0.0).bending2_Nm2() * kPi / 0.3;
  EXPECT_TRUE(balance.converged);
  EXPECT_NEAR(balance.held[1].torque_Nm.y / moment_Nm, 1.0, 1e-6);
  EXPECT_NEAR(norm(pose.nodes[kClosedElements].position_m - Vec3{2.0 * 0.3 / kPi, 0, 0}), 0.0, 5e-4 * 0.3);
}

/// A helix of radius 3, pitch 2 per radian and one turn, of a thin straight rod; ends held.
struct Helix {
  double length = 2.0 * kPi * std::sqrt(13.0);
  EllipticSection section{0.3, 0.3, kClosedYoung_Pa, kClosedShear_Pa};
  RodPose pose;

  Helix() {
    pose.count = kClosedElements + 1;
    // Normal inward along -x, tangent (0, 3, 2) / sqrt(13).
    const Quat first = axisAngle({1, 0, 0}, -std::atan2(3.0, 2.0)) * axisAngle({0, 0, 1}, kPi);
    for (int i = 0; i <= kClosedElements; ++i) {
      const double a = 2.0 * kPi * i / kClosedElements;
      pose.nodes[static_cast<std::size_t>(i)] = {
          .position_m = {3.0 * std::cos(a), 3.0 * std::sin(a), 2.0 * a},
          .orientation = axisAngle({0, 0, 1}, a) * first};
    }
  }
};

TEST(RodBending, OfAStraightRodIntoAHelixCarriesItsMoments) {
  Helix helix;
  std::vector<RodElement> elements(kClosedElements,
                                   straightElement(helix.section, helix.length / kClosedElements));
  for (RodElement& e : elements) {  // thin: no shear, no stretch
    for (double& a : e.stretch_N) {
      a *= 1e2;
    }
  }
  const Rod rod(elements, straightPose(helix.length, kClosedElements),
                std::vector<double>(kClosedElements + 1, 0.0));
  RodPose pose = helix.pose;
  for (std::size_t i = 1; i < kClosedElements; ++i) {  // a small fixed disturbance
    pose.nodes[i].position_m +=
        0.01 * Vec3{std::sin(3.0 * static_cast<double>(i)), std::cos(5.0 * static_cast<double>(i)), 0.0};
  }
  const std::vector<HeldNode> held{heldAt(0), heldAt(kClosedElements)};

  const RodBalance balance = balanceRod(rod, nullptr, {}, held, pose);

  ASSERT_TRUE(balance.converged);
  double bending = 0.0;
  double torsion = 0.0;
  double deviation = 0.0;
  for (std::size_t i = 0; i < kClosedElements; ++i) {
    const RodStrain strain = rodStrain(elements[i].length_m, pose.nodes[i], pose.nodes[i + 1]);
    bending += std::hypot(strain.curvature_per_m.x, strain.curvature_per_m.y) / kClosedElements;
    torsion += strain.curvature_per_m.z / kClosedElements;
    deviation = std::max(deviation, norm(pose.nodes[i].position_m - helix.pose.nodes[i].position_m));
  }
  EXPECT_NEAR(bending / (3.0 / 13.0), 1.0,
              2e-3);  // curvature r/(r^2+p^2), torsion p/(r^2+p^2): M = EI kappa, GJ tau
  EXPECT_NEAR(torsion / (2.0 / 13.0), 1.0, 2e-3);
  EXPECT_LT(deviation, 1e-3 * helix.length);
}

TEST(RodStability, OfATwistedShaftIsGreenhills) {
  // Ends clamped, free to come nearer: M L = 8.9868 E I, the first root of tan(x/2) = x/2 (Greenhill 1883).
  // L/R = 160.
  const Rod rod = straightRod(1.6, kClosedElements, round(0.010, 0.010));
  const EllipticSection section = round(0.010, 0.010)(0.0);
  const std::vector<HeldNode> held{heldAt(0), heldAt(kClosedElements, {true, true, false, true, true, true})};
  const auto unstable = [&](double twist_rad) {
    RodPose pose = rod.rest();
    for (int i = 0; i <= kClosedElements; ++i) {
      pose.nodes[static_cast<std::size_t>(i)].orientation =
          axisAngle({0, 0, 1}, twist_rad * i / kClosedElements);
    }
    return instabilities(rod, pose, held) > 0;
  };
  double below = 1.0;
  double above = 40.0;

  while (above - below > 1e-6) {
    const double middle = 0.5 * (below + above);
    (unstable(middle) ? above : below) = middle;
  }

  EXPECT_NEAR(below * section.torsion_Nm2() / section.bending1_Nm2(), 8.9868, 5e-3 * 8.9868);
}

TEST(RodStability, OfATwistedRingIsMichells) {
  // A rod straight at rest, closed to a ring and twisted: it leaves its plane at 2 pi sqrt(3) EI/GJ (Michell
  // 1889).
  constexpr int kRing = 48;
  constexpr double kRadius_m = 0.2;
  const EllipticSection section = round(0.010, 0.010)(0.0);
  const double length_m = 2.0 * kPi * kRadius_m;
  const Rod rod = straightRod(length_m, kRing, round(0.010, 0.010));
  // The ring as a whole may swing about its held tangent at no cost: its far side stays in the plane.
  const std::vector<HeldNode> held{heldAt(0), heldAt(kRing),
                                   heldAt(kRing / 2, {false, true, false, false, false, false})};
  const auto leavesItsPlane = [&](double twist_rad) {
    RodPose pose{.count = kRing + 1};
    for (int i = 0; i <= kRing; ++i) {
      const double a = 2.0 * kPi * i / kRing;
      const double out_m = 1e-3 * kRadius_m * (1.0 - std::cos(2.0 * a));  // a small fixed disturbance
      pose.nodes[static_cast<std::size_t>(i)] = {
          .position_m = {kRadius_m * (1.0 - std::cos(a)), out_m, kRadius_m * std::sin(a)},
          .orientation = axisAngle({0, 1, 0}, a) * axisAngle({0, 0, 1}, twist_rad * i / kRing)};
    }
    EXPECT_TRUE(balanceRod(rod, nullptr, {}, held, pose).converged) << twist_rad;
    // In its plane: EI (2 pi)^2 / 2L + GJ twist^2 / 2L. Out of it, twist turns into writhe: a quarter of that
    // is left.
    const double plane_J =
        0.5 * (section.bending1_Nm2() * 4.0 * kPi * kPi + section.torsion_Nm2() * twist_rad * twist_rad) /
        length_m;
    return storedEnergy_J(rod, pose, nullptr, {}) < 0.5 * plane_J;
  };
  double below = 10.0;
  double above = 20.0;

  while (above - below > 1e-3) {
    const double middle = 0.5 * (below + above);
    (leavesItsPlane(middle) ? above : below) = middle;
  }

  const double michell_rad = 2.0 * kPi * std::sqrt(3.0) * section.bending1_Nm2() / section.torsion_Nm2();
  EXPECT_NEAR(below, michell_rad, 5e-3 * michell_rad);
}

TEST(RodBendLimit, KeepsAFoldShortOfTheInsideOfTheSection) {
  // A tube of radius 20 mm folded by 170 degrees over 120 mm: even, z = kappa r = 0.49; without the limit the
  // fold sits where the tube is thinnest.
  const auto fold = [](double stiffness_N) {
    std::vector<RodElement> elements;
    for (int i = 0; i < kClosedElements; ++i) {
      const double r = i == 15 ? 0.012 : 0.020;
      elements.push_back(straightElement({r, r, kClosedYoung_Pa, kClosedShear_Pa}, 0.2 / kClosedElements));
      elements.back().bendLimit = {.spread_m2 = {r * r, 0, r * r}, .limit = 0.40, .stiffness_N = stiffness_N};
    }
    const Rod rod(elements, straightPose(0.2, kClosedElements),
                  std::vector<double>(kClosedElements + 1, 0.0));
    const std::vector<HeldNode> held{heldAt(0),
                                     heldAt(kClosedElements, {false, false, false, true, true, true})};
    RodPose pose = rod.rest();
    for (int step = 1; step <= 20; ++step) {
      pose.nodes[kClosedElements].orientation = axisAngle({0, 1, 0}, radians(170.0) * step / 20);
      EXPECT_TRUE(balanceRod(rod, nullptr, {}, held, pose).converged);
    }
    const RodStrain strain = rodStrain(0.2 / kClosedElements, pose.nodes[15], pose.nodes[16]);
    return std::abs(strain.curvature_per_m.y) * 0.012 * std::pow(strain.stretch.z, -1.5);
  };

  const double limited = fold(200.0 * kClosedYoung_Pa * kPi * 4e-4 / 4.0);
  const double unlimited = fold(0.0);

  EXPECT_GT(unlimited, 0.6);
  EXPECT_LT(limited, 0.45);
}

constexpr int kCalculixElements = 31;
constexpr double kLength_m = 0.240;
constexpr double kCalculixShear_Pa = 1e4;
constexpr double kCalculixYoung_Pa = 2.9e4;  // nu = 0.45

nlohmann::json calculix(const std::string& name) {
  std::ifstream file(std::string(TORSIO_TEST_DATA) + "/calculix/" + name + ".json");
  return nlohmann::json::parse(file);
}

/// Half axes at both ends, along e1 (in the plane of the bend) and e2.
struct CalculixBar {
  std::string name;
  double angle_rad = 0.0;
  double a0_m = 0.0, b0_m = 0.0, a1_m = 0.0, b1_m = 0.0;
};

Rod bentRod(const CalculixBar& bar, bool neoHookean) {
  const RodPose pose = bentPose(kLength_m, bar.angle_rad, kCalculixElements);
  std::vector<RodElement> elements;
  for (int i = 0; i < kCalculixElements; ++i) {
    const double s = (i + 0.5) / kCalculixElements;
    const EllipticSection section{bar.a0_m + (bar.a1_m - bar.a0_m) * s, bar.b0_m + (bar.b1_m - bar.b0_m) * s,
                                  kCalculixYoung_Pa, kCalculixShear_Pa};
    elements.push_back(curvedElement(section, bar.angle_rad / kLength_m, kLength_m / kCalculixElements));
    if (neoHookean) {
      elements.back().axial_N = elements.back().stretch_N[8];
      elements.back().stretch_N[8] = 0.0;
    }
  }
  restAt(pose, elements);
  return Rod(elements, pose, std::vector<double>(kCalculixElements + 1, 0.0));
}

double at(const std::vector<double>& arc_m, const std::vector<double>& values, double s_m) {
  const auto above = std::lower_bound(arc_m.begin() + 1, arc_m.end() - 1, s_m);
  const auto i = static_cast<std::size_t>(above - arc_m.begin());
  const double share = (s_m - arc_m[i - 1]) / (arc_m[i] - arc_m[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

class BentBar : public ::testing::TestWithParam<CalculixBar> {};

TEST_P(BentBar, HasTorqueAndProfileOfCalculix) {
  const nlohmann::json reference = calculix(GetParam().name);
  const double stiffness_Nm = reference["T"].get<double>() / reference["th"].get<double>() * 1e-3;
  const Rod rod = bentRod(GetParam(), false);

  const TurnedRod turned = solveTurned(rod, {.angle_rad = radians(0.1)});

  ASSERT_TRUE(turned.balance.converged);
  const double error = turned.torque_Nm / radians(0.1) / stiffness_Nm - 1.0;
  EXPECT_LT(std::abs(error), 0.0125) << error;
  double worst = 0.0;
  for (std::size_t k = 0; k < reference["zs"].size(); ++k) {
    const double turn = at(turned.arc_m, turned.turn_rad, reference["zs"][k].get<double>() * 1e-3);
    worst = std::max(worst, std::abs(turn / radians(0.1) - reference["prof"][k].get<double>()));
  }
  EXPECT_LT(worst, 0.0065);
  RecordProperty("torque_error_percent", std::to_string(100.0 * error));
  RecordProperty("profile_error_percent", std::to_string(100.0 * worst));
}

INSTANTIATE_TEST_SUITE_P(Calculix, BentBar,
                         ::testing::Values(CalculixBar{"bent90", kPi / 2, 0.025, 0.025, 0.025, 0.025},
                                           CalculixBar{"bent90_taper", kPi / 2, 0.032, 0.024, 0.020, 0.016},
                                           CalculixBar{"bent180", kPi, 0.020, 0.020, 0.020, 0.020}),
                         [](const ::testing::TestParamInfo<CalculixBar>& bar) { return bar.param.name; });

/// Rotation vector of a rotation matrix of less than half a turn, rows first.
Vec3 rotationVector(const nlohmann::json& r) {
  const auto m = [&r](std::size_t i, std::size_t j) { return r[i][j].get<double>(); };
  const Vec3 twiceSine{m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
  const double angle = std::atan2(0.5 * norm(twiceSine), 0.5 * (m(0, 0) + m(1, 1) + m(2, 2) - 1.0));
  return norm(twiceSine) > 1e-12 ? angle / norm(twiceSine) * twiceSine : Vec3{};
}
Vec3 rotationVector(const Quat& q) {
  const Vec3 v{q.x, q.y, q.z};
  const double sign = q.w < 0.0 ? -1.0 : 1.0;
  return norm(v) > 1e-12 ? 2.0 * sign * std::atan2(norm(v), sign * q.w) / norm(v) * v : Vec3{};
}

TEST(BentBarFinite, FollowsNeoHookeanCalculixTo90Degrees) {
  const nlohmann::json reference = calculix("bent90_finite");
  const Rod rod = bentRod({"", kPi / 2, 0.025, 0.025, 0.025, 0.025}, true);
  const RodPose& rest = rod.rest();
  const Vec3 axis = rotate(rest.nodes[kCalculixElements].orientation, {0, 0, 1});
  TurnedRod turned;

  for (const nlohmann::json& step : reference["out"]) {
    turned = solveTurned(rod, {.angle_rad = radians(step[0].get<double>())});
    const Vec3 moment_Nm{step[1][0].get<double>() * 1e-3, step[1][1].get<double>() * 1e-3,
                         step[1][2].get<double>() * 1e-3};
    ASSERT_TRUE(turned.balance.converged);
    EXPECT_NEAR(turned.torque_Nm / dot(moment_Nm, axis), 1.0, 0.012) << step[0];
    EXPECT_LT(norm(turned.end.torque_Nm - moment_Nm), 0.035 * norm(moment_Nm)) << step[0];
  }

  std::vector<double> along;
  for (std::size_t i = 0; i <= kCalculixElements; ++i) {
    const Quat turn = turned.pose.nodes[i].orientation * conjugate(rest.nodes[i].orientation);
    along.push_back(dot(rotationVector(turn), rotate(rest.nodes[i].orientation, {0, 0, 1})));
  }
  for (std::size_t k = 0; k < reference["zs"].size(); ++k) {
    const double s_m = reference["zs"][k].get<double>() * 1e-3;
    const Vec3 tangent = rotate(axisAngle({0, 1, 0}, kPi / 2 * s_m / kLength_m), {0, 0, 1});
    const double turn = dot(rotationVector(reference["R"][k]), tangent);
    EXPECT_NEAR(at(turned.arc_m, along, s_m), turn, 0.012 * kPi / 2) << s_m;
  }
}

}  // namespace
}  // namespace torsio
