// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/centreline.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/core/portable_math.h"
#include "sim/core/random.h"

namespace torsio {
namespace {

/// A helix of radius a and rise 2 pi b a turn, by angle.
Vec3 helix(double angle) {
  return {0.03 * std::cos(angle), 0.03 * std::sin(angle), 0.02 * angle};
}

std::vector<Vec3> helixPoints(int count, double turns) {
  std::vector<Vec3> points;
  for (int i = 0; i <= count; ++i) {
    points.push_back(helix(2.0 * kPi * turns * i / count));
  }
  return points;
}

TEST(Centreline, LeavesAStraightLineAsItIs) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 30; ++i) {
    points.push_back({0.01 * i * i, -0.02 * i * i, 0.005 * i * i});
  }
  std::vector<double> arcs;

  const Centreline line = Centreline::curved(points, 0.02, 256, {0, 0, 1}, 0.0, arcs);

  const double length = norm(points.back() - points.front());
  EXPECT_NEAR(line.length_m(), length, 1e-13);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(arcs[i], norm(points[i] - points.front()), 1e-12);
    EXPECT_LT(norm(line.frameAt(arcs[i]).centre_m - points[i]), 1e-12);
  }
  EXPECT_LT(norm(line.frameAt(0.0).e1 - line.frameAt(length).e1), 1e-12);
}

TEST(Centreline, KeepsTheRadiusOfABendWhenItSmoothes) {
  std::vector<double> arcs;
  std::vector<Vec3> circle;
  for (int i = 0; i <= 400; ++i) {
    const double angle = kPi * i / 400;
    circle.push_back({0.05 * std::cos(angle), 0.05 * std::sin(angle), 0.0});
  }

  const Centreline line = Centreline::curved(circle, 0.003, 256, {0, 0, 1}, 0.0, arcs);

  // One Gaussian of 3 mm would pull the bend in by s^2 / (2 r) = 0.09 mm; twice leaves a hundredth of it.
  for (int k = 20; k <= 80; ++k) {
    EXPECT_NEAR(norm(line.frameAt(line.length_m() * k / 100).centre_m), 0.05, 2e-6);
  }
}

TEST(Centreline, TakesTheStepsOfTheMeshOutOfALine) {
  Random random(3);
  std::vector<Vec3> points;
  for (int i = 0; i <= 400; ++i) {
    points.push_back({2e-4 * random.normal(), 2e-4 * random.normal(), 0.0005 * i});
  }
  std::vector<double> arcs;

  const Centreline line = Centreline::curved(points, 0.003, 256, {1, 0, 0}, 0.0, arcs);

  EXPECT_NEAR(line.length_m(), 0.2, 2e-3);  // the raw polyline is 1.2 times as long
  for (int k = 5; k < 95; ++k) {
    EXPECT_GT(line.frameAt(line.length_m() * k / 100).tangent.z, 0.99);
  }
}

TEST(Centreline, HasOrthonormalFramesThatDoNotTurnAboutIt) {
  std::vector<double> arcs;

  const Centreline line = Centreline::curved(helixPoints(2000, 2.0), 0.001, 512, {0, 0, 1}, 0.5, arcs);

  // The rotation-minimising frame lags behind the Frenet frame by the integral of the torsion:
  // tau = b / (a^2 + b^2) for the helix of radius a = 30 mm and rise b = 20 mm a radian.
  const double torsion = 0.02 / (0.03 * 0.03 + 0.02 * 0.02);
  const auto againstFrenet = [&](double arc) {
    const AxisFrame f = line.frameAt(arc);
    const Vec3 inwards = normalized(Vec3{-f.centre_m.x, -f.centre_m.y, 0});
    const Vec3 normal = normalized(inwards - dot(inwards, f.tangent) * f.tangent);
    return std::atan2(dot(normal, f.e2), dot(normal, f.e1));
  };
  double last = againstFrenet(0.1 * line.length_m());
  for (int k = 11; k <= 90; ++k) {
    const double arc = line.length_m() * k / 100;
    const AxisFrame f = line.frameAt(arc);
    EXPECT_NEAR(norm(f.tangent), 1.0, 1e-14);
    EXPECT_NEAR(norm(f.e1), 1.0, 1e-14);
    EXPECT_NEAR(dot(f.e1, f.tangent), 0.0, 1e-14);
    EXPECT_LT(norm(cross(f.e1, f.e2) - f.tangent), 1e-13);
    const double here = againstFrenet(arc);
    EXPECT_NEAR(std::remainder(here - last, 2.0 * kPi), torsion * line.length_m() / 100, 2e-3) << k;
    last = here;
  }
}

TEST(Centreline, PutsE1WhereAsked) {
  std::vector<double> arcs;

  const Centreline line = Centreline::curved(helixPoints(2000, 1.0), 0.001, 256, {0, 0, 1}, 0.5, arcs);

  const AxisFrame middle = line.frameAt(0.5 * line.length_m());
  const Vec3 up{0, 0, 1};
  const Vec3 across = normalized(up - dot(up, middle.tangent) * middle.tangent);
  EXPECT_LT(norm(middle.e1 - across), 1e-12);
}

TEST(Centreline, IsSmoothBetweenItsStations) {
  std::vector<double> arcs;
  const Centreline line = Centreline::curved(helixPoints(400, 1.0), 0.001, 64, {0, 0, 1}, 0.0, arcs);
  constexpr double kStep = 1e-7;

  for (int i = 1; i < 64; ++i) {
    const double station = line.length_m() * i / 64;
    const AxisFrame before = line.frameAt(station - kStep);
    const AxisFrame after = line.frameAt(station + kStep);
    EXPECT_LT(norm(after.centre_m - before.centre_m), 3 * kStep);
    EXPECT_LT(norm(after.tangent - before.tangent), 1e-4);  // curvature is 23 / m: 5e-6 expected
    EXPECT_LT(norm(after.e1 - before.e1), 1e-4);
  }
}

TEST(Centreline, ClampsWhatLiesBeyondItsEnds) {
  std::vector<double> arcs;
  const Centreline line = Centreline::curved(helixPoints(100, 0.5), 0.001, 64, {0, 0, 1}, 0.0, arcs);

  EXPECT_EQ(line.frameAt(-1.0).centre_m, line.frameAt(0.0).centre_m);
  EXPECT_EQ(line.frameAt(9.0).centre_m, line.frameAt(line.length_m()).centre_m);
  EXPECT_EQ(line.nearestArc_m(helix(0.0) + Vec3{0, -0.01, -0.01}), 0.0);
  EXPECT_EQ(line.nearestArc_m(helix(kPi) + Vec3{0, -0.01, 0.01}), line.length_m());
}

TEST(Centreline, MeasuresHeightsAlongAStraightAxisWhateverTheCentresDo) {
  std::vector<Vec3> centres;
  for (int i = 0; i <= 20; ++i) {
    centres.push_back({0.01 * std::sin(0.3 * i), 0.0, 0.01 * i});
  }

  const Centreline line = Centreline::straightAlong({0, 0, 1}, 0.2, centres, {0, 1, 0});

  EXPECT_TRUE(line.straight());
  for (int i = 0; i <= 20; ++i) {
    EXPECT_LT(norm(line.frameAt(0.01 * i).centre_m - centres[static_cast<std::size_t>(i)]), 1e-15);
    EXPECT_EQ(line.frameAt(0.01 * i + 0.003).tangent, (Vec3{0, 0, 1}));
    EXPECT_EQ(line.frameAt(0.01 * i + 0.003).e1, (Vec3{0, 1, 0}));
  }
  EXPECT_NEAR(line.nearestArc_m({0.5, -0.3, 0.0777}), 0.0777, 1e-15);
}

}  // namespace
}  // namespace torsio
