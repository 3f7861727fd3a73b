// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/angle.h"

#include <gtest/gtest.h>

namespace torsio {
namespace {

TEST(Angle, ConvertsTheAnglesOfACircle) {
  // A half turn is pi, a right angle pi / 2.
  EXPECT_EQ(radians(0.0), 0.0);
  EXPECT_EQ(radians(90.0), kPi / 2.0);
  EXPECT_EQ(radians(-180.0), -kPi);
  EXPECT_EQ(degrees(kPi), 180.0);
  EXPECT_EQ(degrees(-2.0 * kPi), -360.0);
}

TEST(Angle, GivesBackDegreesWithinRounding) {
  for (int whole = -360; whole <= 360; ++whole) {
    EXPECT_DOUBLE_EQ(degrees(radians(whole)), whole);
  }
}

TEST(Angle, ScalesAnAxisInDegreesWithinRounding) {
  // 1 radian = 57.29577951308232 degrees.
  EXPECT_DOUBLE_EQ(kDegreesPerRadian, 57.29577951308232);
  EXPECT_DOUBLE_EQ(1.25 * kDegreesPerRadian, degrees(1.25));
}

}  // namespace
}  // namespace torsio
