// SPDX-License-Identifier: GPL-3.0-or-later
// Bent bars against CalculiX: tests/data/calculix/README.md says how its numbers were made.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/tissue/rod/rod_solve.h"
#include "tests/sim/tissue/rod/rod_shapes.h"

namespace torsio {
namespace {

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
