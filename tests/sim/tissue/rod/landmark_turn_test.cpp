// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/landmark_turn.h"

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/pose.h"

namespace torsio {
namespace {

const Landmarks kRest{.from = {0.01, 0, 0}, .point = {0.05, 0.03, 0.04}, .to = {0.02, 0.01, 0.10}};

Landmarks turned(double angle_rad) {
  const Vec3 axis = normalized(kRest.to - kRest.from);
  Landmarks now = kRest;
  now.point = kRest.from + rotateAbout(kRest.point - kRest.from, axis, angle_rad);
  return now;
}

TEST(LandmarkTurn, IsTheAngleAboutTheLine) {
  for (const double angle : {-2.5, -0.3, 0.0, 1.0, 3.0}) {
    EXPECT_NEAR(landmarkTurn_rad(kRest, turned(angle), 0.0), angle, 1e-12);
  }
}

TEST(LandmarkTurn, CountsWholeTurnsFromTickToTick) {
  double angle_rad = 0.0;

  for (int tick = 1; tick <= 1000; ++tick) {
    angle_rad = landmarkTurn_rad(kRest, turned(-0.01 * tick), angle_rad);
  }

  EXPECT_NEAR(angle_rad, -10.0, 1e-11);
}

TEST(LandmarkTurn, DoesNotSeeAMotionOfTheWholeWithoutTwist) {
  const Vec3 line = normalized(kRest.to - kRest.from);
  const Vec3 across = anyPerpendicular(line);  // tilting the line turns nothing about it
  const auto moved = [&](const Vec3& p) { return Vec3{0.1, -0.2, 0.3} + rotateAbout(p, across, 1.2); };
  const Landmarks now{.from = moved(kRest.from), .point = moved(kRest.point), .to = moved(kRest.to)};

  const double angle_rad = landmarkTurn_rad(kRest, now, 0.0);

  EXPECT_NEAR(angle_rad, 0.0, 1e-12);
}

TEST(LandmarkTurn, KeepsTheLastMeasurementWhereThereIsNone) {
  Landmarks onLine = kRest;
  onLine.point = kRest.from;
  const Landmarks reversed{.from = kRest.to, .point = kRest.point, .to = kRest.from};

  EXPECT_EQ(landmarkTurn_rad(kRest, onLine, 0.7), 0.7);
  EXPECT_EQ(landmarkTurn_rad(kRest, reversed, 0.7), 0.7);
}

}  // namespace
}  // namespace torsio
