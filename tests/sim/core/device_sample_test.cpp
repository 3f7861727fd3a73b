// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/device_sample.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "sim/core/random.h"

namespace torsio {
namespace {

// The double nearest to a multiple of the step may lie a little off it.
constexpr double kRounding = 1e-12;

DeviceReading randomReading(Random& random) {
  DeviceReading reading;
  reading.time_us = static_cast<std::int64_t>(random.bounded(1'000'000'000));
  reading.pose.position_m = {random.normal(), random.normal(), random.normal()};
  reading.pose.orientation =
      normalized(Quat{random.normal(), random.normal(), random.normal(), random.normal()});
  reading.roll_rad = 20.0 * random.normal();
  reading.grip = random.uniform();
  reading.buttons = static_cast<std::uint32_t>(random.bounded(8));
  return reading;
}

TEST(DeviceSample, RoundTripsWithinHalfAStep) {
  Random random(1);
  for (int i = 0; i < 10'000; ++i) {
    const DeviceReading reading = randomReading(random);

    const ToolState tool = toolState(quantize(reading, {}));

    const Vec3 off_m = tool.pose.position_m - reading.pose.position_m;
    for (const double axis_m : {off_m.x, off_m.y, off_m.z}) {
      ASSERT_LE(std::abs(axis_m), 0.5 * kPositionStep_m + kRounding);
    }
    const Quat& q = tool.pose.orientation;
    const Quat& p = reading.pose.orientation;
    // Normalising moves a component by at most the error of the norm, two half steps.
    for (const double part : {q.w - p.w, q.x - p.x, q.y - p.y, q.z - p.z}) {
      ASSERT_LE(std::abs(part), 1.5 * kOrientationStep);
    }
    ASSERT_NEAR(norm(q), 1.0, 1e-15);
    ASSERT_LE(std::abs(tool.roll_rad - reading.roll_rad), 0.5 * kRollStep_rad + kRounding);
    ASSERT_LE(std::abs(tool.grip - reading.grip), 0.5 * kGripStep);
    ASSERT_EQ(tool.time_us, reading.time_us);
    ASSERT_EQ(tool.buttons, reading.buttons);
  }
}

TEST(DeviceSample, QuantisedValuesReadBackUnchanged) {
  // What was recorded and decoded once is the same integer when quantised again (position, roll and grip;
  // the quaternion was normalised).
  Random random(2);
  for (int i = 0; i < 1'000; ++i) {
    const DeviceSample once = quantize(randomReading(random), {});
    const ToolState tool = toolState(once);
    DeviceReading reading;
    reading.pose = tool.pose;
    reading.roll_rad = tool.roll_rad;
    reading.grip = tool.grip;

    const DeviceSample twice = quantize(reading, {});

    ASSERT_EQ(twice.position, once.position);
    ASSERT_EQ(twice.roll, once.roll);
    ASSERT_EQ(twice.grip, once.grip);
  }
}

TEST(DeviceSample, RoundsHalfAwayFromZero) {
  DeviceReading reading;
  reading.grip = 2.5 * kGripStep;
  EXPECT_EQ(quantize(reading, {}).grip, 3);
  reading.grip = -2.5 * kGripStep;
  EXPECT_EQ(quantize(reading, {}).grip, -3);
}

TEST(DeviceSample, RepeatsThePreviousPoseForAReadingThatIsNotFiniteOrOutOfRange) {
  Random random(3);
  const DeviceSample previous = quantize(randomReading(random), {});
  DeviceReading notANumber = randomReading(random);
  notANumber.pose.position_m.y = std::numeric_limits<double>::quiet_NaN();
  DeviceReading infinite = randomReading(random);
  infinite.roll_rad = std::numeric_limits<double>::infinity();
  DeviceReading farAway = randomReading(random);
  farAway.pose.position_m.x = 300.0;
  DeviceReading badTurn = randomReading(random);
  badTurn.pose.orientation.z = std::numeric_limits<double>::infinity();

  for (const DeviceReading& bad : {notANumber, infinite, farAway, badTurn}) {
    const DeviceSample sample = quantize(bad, previous);

    EXPECT_EQ(sample.position, previous.position);
    EXPECT_EQ(sample.orientation, previous.orientation);
    EXPECT_EQ(sample.roll, previous.roll);
    EXPECT_EQ(sample.grip, previous.grip);
    EXPECT_EQ(sample.status, static_cast<std::uint32_t>(kDeviceInvalid));
    EXPECT_EQ(sample.time_us, bad.time_us);
  }
}

TEST(DeviceSample, RefusesAnInvalidOrientation) {
  Random random(4);
  const DeviceSample previous = quantize(randomReading(random), {});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Quat& orientation : {Quat{nan, 0.0, 0.0, 1.0}, Quat{0.0, 0.0, 0.0, 0.0}}) {
    DeviceReading reading = randomReading(random);
    reading.pose.orientation = orientation;

    const DeviceSample sample = quantize(reading, previous);

    EXPECT_EQ(sample.orientation, previous.orientation);
    EXPECT_EQ(sample.position, previous.position);
    EXPECT_NE(sample.status & kDeviceInvalid, 0U);
  }
}

TEST(DeviceSample, KeepsTheDriversOwnStatus) {
  DeviceReading reading;
  reading.status = kDeviceWarm;
  EXPECT_EQ(quantize(reading, {}).status, static_cast<std::uint32_t>(kDeviceWarm));
}

}  // namespace
}  // namespace torsio
