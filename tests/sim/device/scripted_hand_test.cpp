// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/virtual/scripted_hand.h"

#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/device/virtual/pointer_device.h"
#include "sim/device/virtual/virtual_drivers.h"

namespace torsio {
namespace {

/// Grasps a bar of 40 mm radius along z and twists it by a quarter turn.
ScriptedHandOptions quarterTurn(std::uint64_t seed) {
  ScriptedHandOptions options;
  options.seed = seed;
  options.task.start_m = {0.14, 0.0, 0.20};
  options.task.graspPoint_m = {0.04, 0.0, 0.20};
  options.task.targetAngle_rad = radians(90.0);
  options.profile = handProfile(seed);
  return options;
}

std::vector<ToolState> play(ScriptedHand& hand, double duration_s) {
  std::vector<ToolState> states;
  const auto ticks = static_cast<std::int64_t>(duration_s * 1000.0);
  for (std::int64_t i = 0; i <= ticks; ++i) {
    states.push_back(toolState(hand.read(i * 1000)));
  }
  return states;
}

double angleAboutZ(const Vec3& tip_m) {
  return std::atan2(tip_m.y, tip_m.x);
}

TEST(ScriptedHand, GivesTheSameSamplesForTheSameSeedAndOthersForAnother) {
  ScriptedHand first(quarterTurn(7));
  ScriptedHand second(quarterTurn(7));
  ScriptedHand other(quarterTurn(8));

  bool anyDifference = false;
  for (std::int64_t i = 0; i < 20'000; ++i) {
    const DeviceSample a = first.read(i * 1000);
    ASSERT_EQ(a, second.read(i * 1000)) << "tick " << i;
    anyDifference = anyDifference || a != other.read(i * 1000);
  }
  EXPECT_TRUE(anyDifference);
}

TEST(ScriptedHand, CountsItsTimeFromTheFirstRead) {
  ScriptedHand early(quarterTurn(7));
  ScriptedHand late(quarterTurn(7));

  for (std::int64_t i = 0; i < 5'000; ++i) {
    DeviceSample a = early.read(i * 1000);
    const DeviceSample b = late.read(123'456'789 + i * 1000);
    a.time_us = b.time_us;
    ASSERT_EQ(a, b);
  }
}

TEST(ScriptedHand, ReachesContactGripsTwistsReleasesAndComesBack) {
  ScriptedHand hand(quarterTurn(3));
  const double end_s = hand.span_s(0)[1];
  const std::vector<ToolState> states = play(hand, end_s);

  double largestAngle_rad = 0.0;
  double gripRadius_m = 0.0;
  int closings = 0;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const Vec3& tip_m = states[i].pose.position_m;
    if (states[i].grip > 0.5 && states[i - 1].grip <= 0.5) {
      ++closings;
      gripRadius_m = std::hypot(tip_m.x, tip_m.y);
    }
    if (states[i].grip > 0.5) {
      largestAngle_rad = std::max(largestAngle_rad, angleAboutZ(tip_m));
    }
  }

  // Tip radius 2.5 mm, pressed in by 1.2 mm on the average; tremor, drift and the missed grasp point add less
  // than 2 mm, so the jaw closes in contact or within its reach of 4 mm.
  EXPECT_EQ(closings, 1);
  EXPECT_NEAR(gripRadius_m, 0.0413, 0.002);
  EXPECT_NEAR(largestAngle_rad, radians(90.0), radians(40.0));
  EXPECT_NEAR(norm(states.front().pose.position_m - Vec3{0.14, 0.0, 0.20}), 0.0, 1e-6);
  EXPECT_NEAR(norm(states.back().pose.position_m - Vec3{0.14, 0.0, 0.20}), 0.0, 1e-6);
}

TEST(ScriptedHand, TurnsTheStylusWithTheTwistAndPointsItAtTheAxis) {
  ScriptedHandOptions options = quarterTurn(3);
  options.profile.initialSkill = 1.0;
  options.profile.finalSkill = 1.0;
  ScriptedHand hand(options);
  // An expert trembles by 0.08 degrees a channel and misses the grasp point by less than 2 mm in 40.
  const double tolerance = radians(4.0);

  for (const ToolState& state : play(hand, hand.span_s(0)[1])) {
    if (state.grip < 0.5) {
      continue;
    }
    const Vec3 ahead = rotate(state.pose.orientation, {0.0, 0.0, -1.0});
    const Vec3 inwards = normalized(Vec3{-state.pose.position_m.x, -state.pose.position_m.y, 0.0});
    ASSERT_GT(dot(ahead, inwards), std::cos(tolerance));
  }
}

TEST(ScriptedHand, MovesSmoothlyWithoutASingleJump) {
  ScriptedHand hand(quarterTurn(12));
  const std::vector<ToolState> states = play(hand, 20.0);

  for (std::size_t i = 2; i < states.size(); ++i) {
    const Vec3 velocity = (states[i].pose.position_m - states[i - 1].pose.position_m) / 1e-3;
    const Vec3 before = (states[i - 1].pose.position_m - states[i - 2].pose.position_m) / 1e-3;
    ASSERT_LT(norm(velocity), 0.6) << "tick " << i;                   // m/s: an unhurried hand
    ASSERT_LT(norm(velocity - before) / 1e-3, 12.0) << "tick " << i;  // m/s^2: 1.2 g with tremor
  }
}

/// Power of `signal` (mean removed) at one frequency, by direct summation with a Hann window.
double powerAt(const std::vector<double>& signal, double frequency_Hz) {
  const double n = static_cast<double>(signal.size());
  double mean = 0.0;
  for (const double value : signal) {
    mean += value / n;
  }
  std::complex<double> total;
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const double window = 0.5 - 0.5 * std::cos(2.0 * kPi * static_cast<double>(i) / n);
    const double phase = 2.0 * kPi * frequency_Hz * static_cast<double>(i) * 1e-3;
    total += window * (signal[i] - mean) * std::polar(1.0, -phase);
  }
  return std::norm(total);
}

TEST(ScriptedHand, TremblesBetweenEightAndTwelveHertz) {
  ScriptedHandOptions options = quarterTurn(21);
  options.task.targetAngle_rad = 0.0;  // holds still for the length of a twist and a hold
  ScriptedHand hand(options);
  std::vector<double> axial_m;
  for (const ToolState& state : play(hand, hand.span_s(0)[1])) {
    if (state.grip > 0.99) {
      axial_m.push_back(state.pose.position_m.z);
    }
  }
  ASSERT_GT(axial_m.size(), 2'000U);

  double inside = 0.0;
  double outside = 0.0;
  for (double f_Hz = 3.0; f_Hz <= 40.0; f_Hz += 0.25) {
    (f_Hz > 7.0 && f_Hz < 13.0 ? inside : outside) += powerAt(axial_m, f_Hz);
  }

  EXPECT_GT(inside, 100.0 * outside);
}

TEST(ScriptedHand, GrowsSkilfulWithPracticeAlongAnExponentialCurve) {
  const HandProfile profile{.initialSkill = 0.1, .finalSkill = 0.9, .learningTime_min = 10.0};

  EXPECT_DOUBLE_EQ(skillAfter(profile, 0.0), 0.1);
  EXPECT_NEAR(skillAfter(profile, 10.0), 0.9 - 0.8 / std::exp(1.0), 1e-15);
  EXPECT_NEAR(skillAfter(profile, 1e6), 0.9, 1e-15);
}

TEST(ScriptedHand, LearnsWithinATrialByThePracticeThatItStandsFor) {
  ScriptedHandOptions options = quarterTurn(4);
  options.practiceScale = 60.0;
  ScriptedHand hand(options);

  ASSERT_GE(hand.cycles(), 2U);
  EXPECT_NEAR(hand.skill(1), skillAfter(options.profile, hand.span_s(1)[0]), 1e-15);
  EXPECT_GT(hand.skill(1), hand.skill(0));
}

TEST(ScriptedHand, ComesCloserToTheTargetAndQuickerWithPractice) {
  double errorBefore_rad = 0.0;
  double errorAfter_rad = 0.0;
  double timeBefore_s = 0.0;
  double timeAfter_s = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    ScriptedHandOptions options = quarterTurn(seed);
    const ScriptedHand before(options);
    options.practisedBefore_min = 40.0;
    const ScriptedHand after(options);
    errorBefore_rad += std::abs(before.heldAngle_rad(0) - options.task.targetAngle_rad) / 40.0;
    errorAfter_rad += std::abs(after.heldAngle_rad(0) - options.task.targetAngle_rad) / 40.0;
    timeBefore_s += (before.span_s(0)[1] - before.span_s(0)[0]) / 40.0;
    timeAfter_s += (after.span_s(0)[1] - after.span_s(0)[0]) / 40.0;
  }

  EXPECT_LT(errorAfter_rad, 0.6 * errorBefore_rad);
  EXPECT_LT(timeAfter_s, 0.8 * timeBefore_s);
}

TEST(ScriptedHand, BeginsNoTwistThatItCannotFinishAndThenSaysThatItEnded) {
  ScriptedHandOptions options = quarterTurn(9);
  options.duration_s = 60.0;
  ScriptedHand hand(options);

  EXPECT_GE(hand.cycles(), 4U);
  EXPECT_LE(hand.span_s(hand.cycles() - 1)[1], 60.0);
  EXPECT_EQ(hand.read(0).status, static_cast<std::uint32_t>(kDeviceOk));
  EXPECT_EQ(hand.read(60'000'000).status, static_cast<std::uint32_t>(kDeviceOk));
  EXPECT_EQ(hand.read(60'001'000).status, static_cast<std::uint32_t>(kDeviceEnded));
}

TEST(ScriptedHand, MirrorsItsTwistForAMirroredTarget) {
  ScriptedHandOptions options = quarterTurn(5);
  const ScriptedHand there(options);
  options.task.targetAngle_rad = -options.task.targetAngle_rad;
  ScriptedHand back(options);

  double least_rad = 0.0;
  for (const ToolState& state : play(back, back.span_s(0)[1])) {
    if (state.grip > 0.5) {
      least_rad = std::min(least_rad, angleAboutZ(state.pose.position_m));
    }
  }
  EXPECT_LT(least_rad, radians(-50.0));
  EXPECT_NEAR(there.heldAngle_rad(0) - radians(90.0), back.heldAngle_rad(0) + radians(90.0), 1e-12);
}

TEST(ScriptedHand, GraspsFromEveryDirection) {
  for (const Vec3& direction : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{0, 1, 0}, Vec3{-1, 0, 0}}) {
    ScriptedHandOptions options = quarterTurn(5);
    options.task.axisDirection = anyPerpendicular(direction);
    options.task.graspPoint_m = direction * 0.04;
    options.task.start_m = direction * 0.12;
    ScriptedHand hand(options);

    const Vec3 ahead = rotate(toolState(hand.read(0)).pose.orientation, {0.0, 0.0, -1.0});

    EXPECT_NEAR(norm(ahead + direction), 0.0, 1e-8);
  }
}

TEST(ScriptedHand, RefusesAnInvalidTask) {
  ScriptedHandOptions onTheAxis = quarterTurn(1);
  onTheAxis.task.graspPoint_m = {0.0, 0.0, 0.2};
  ScriptedHandOptions longAxis = quarterTurn(1);
  longAxis.task.axisDirection = {0.0, 0.0, 2.0};
  ScriptedHandOptions noTime = quarterTurn(1);
  noTime.duration_s = 0.0;
  ScriptedHandOptions noNumber = quarterTurn(1);
  noNumber.task.targetAngle_rad = std::nan("");

  for (const ScriptedHandOptions& bad : {onTheAxis, longAxis, noTime, noNumber}) {
    EXPECT_THROW(ScriptedHand hand(bad), Error);
  }
}

// Steps of the quantisation, at most one half each, on three axes.
constexpr double kQuantum_m = 1e-7;

TEST(IdleDevice, StaysWhereItWasPutAndIgnoresForces) {
  const Pose pose{{0.1, -0.2, 0.3}, axisAngle({0, 1, 0}, 0.5)};
  IdleDevice device(pose);

  const DeviceSample first = device.read(0);
  device.write({{3.0, 0.0, 0.0}, 0});
  const DeviceSample later = device.read(1'000'000);

  EXPECT_EQ(later.time_us, 1'000'000);
  EXPECT_EQ(first.position, later.position);
  EXPECT_EQ(first.orientation, later.orientation);
  EXPECT_NEAR(norm(toolState(later).pose.position_m - pose.position_m), 0.0, kQuantum_m);
  EXPECT_FALSE(device.capabilities().rendersForce);
}

TEST(ReplayDevice, GivesEachRecordedSampleOnceAndThenSaysThatItEnded) {
  std::vector<DeviceSample> recorded(3);
  for (std::int32_t i = 0; i < 3; ++i) {
    recorded[static_cast<std::size_t>(i)].time_us = 1000 * i;
    recorded[static_cast<std::size_t>(i)].position = {i, 2 * i, 3 * i};
  }
  ReplayDevice device(recorded, {});

  for (const DeviceSample& sample : recorded) {
    EXPECT_EQ(device.read(0), sample);
  }
  const DeviceSample after = device.read(9'000);

  EXPECT_EQ(after.status, static_cast<std::uint32_t>(kDeviceEnded));
  EXPECT_EQ(after.position, recorded.back().position);
  EXPECT_EQ(after.time_us, 9'000);
}

TEST(ReplayDevice, EndsAtOnceWithoutSamples) {
  ReplayDevice device({}, {});

  EXPECT_EQ(device.read(0).status, static_cast<std::uint32_t>(kDeviceEnded));
}

class PointerDeviceTest : public ::testing::Test {
 protected:
  /// The state after so many milliseconds of reading.
  ToolState settle(int ticks = 500) {
    DeviceSample sample;
    for (int i = 0; i < ticks; ++i) {
      sample = device.read(time_us += 1000);
    }
    return toolState(sample);
  }
  static PointerInput at(const Vec3& onPlane_m) {
    PointerInput input;
    input.present = true;
    input.onPlane_m = onPlane_m;
    return input;
  }

  PointerDevice device{Pose{{0.0, 0.0, 0.1}, {}}};
  std::int64_t time_us = 0;
};

TEST_F(PointerDeviceTest, WaitsAtItsStartUntilThePointerAppears) {
  const ToolState state = settle();

  EXPECT_NEAR(norm(state.pose.position_m - Vec3{0.0, 0.0, 0.1}), 0.0, kQuantum_m);
  EXPECT_EQ(state.status, static_cast<std::uint32_t>(kDeviceOk));
}

TEST_F(PointerDeviceTest, FollowsThePointerOnThePlaneAndTheWheelIntoThePicture) {
  PointerInput input = at({0.02, 0.03, 0.1});
  input.depth_m = 0.01;
  input.view = axisAngle({1.0, 0.0, 0.0}, radians(90.0));  // the camera looks along +y
  device.publish(input);

  const ToolState state = settle();

  EXPECT_NEAR(norm(state.pose.position_m - Vec3{0.02, 0.04, 0.1}), 0.0, 2.0 * kQuantum_m);
  const Vec3 ahead = rotate(state.pose.orientation, {0.0, 0.0, -1.0});
  EXPECT_NEAR(norm(ahead - Vec3{0.0, 1.0, 0.0}), 0.0, 1e-8);
}

TEST_F(PointerDeviceTest, TurnsTheStylusByKeysInThreeAngles) {
  PointerInput input = at({});
  input.roll_rad = radians(400.0);
  device.publish(input);
  const ToolState rolled = settle();
  input.roll_rad = 0.0;
  input.yaw_rad = radians(90.0);
  device.publish(input);
  const ToolState yawed = settle();
  input.yaw_rad = 0.0;
  input.pitch_rad = radians(90.0);
  device.publish(input);
  const ToolState pitched = settle();

  EXPECT_NEAR(rolled.roll_rad, radians(400.0), 1e-6);  // unwrapped
  EXPECT_NEAR(norm(rotate(rolled.pose.orientation, {1, 0, 0}) -
                   Vec3{std::cos(radians(40.0)), std::sin(radians(40.0)), 0.0}),
              0.0, 1e-6);
  EXPECT_NEAR(norm(rotate(yawed.pose.orientation, {0, 0, -1}) - Vec3{-1, 0, 0}), 0.0, 1e-6);
  EXPECT_NEAR(norm(rotate(pitched.pose.orientation, {0, 0, -1}) - Vec3{0, 1, 0}), 0.0, 1e-6);
}

TEST_F(PointerDeviceTest, ClosesAndOpensTheJawWithTheButton) {
  PointerInput input = at({});
  input.grip = 1.0;
  input.buttons = kButtonBookmark;
  device.publish(input);
  const ToolState closed = settle();
  input.present = false;
  device.publish(input);
  const ToolState gone = settle();

  EXPECT_NEAR(closed.grip, kPointerClosure, 1e-4);
  EXPECT_EQ(closed.buttons, static_cast<std::uint32_t>(kButtonBookmark));
  EXPECT_NEAR(gone.grip, 0.0, 1e-4);  // a pointer that left the view lets go
}

TEST_F(PointerDeviceTest, SmoothsSixtyUpdatesASecondIntoAThousandSmallSteps) {
  Vec3 before_m = settle(1).pose.position_m;
  double largest_m = 0.0;
  for (int frame = 1; frame <= 60; ++frame) {
    device.publish(at({0.003 * frame, 0.0, 0.1}));  // 3 mm a frame, 0.18 m/s
    for (int i = 0; i < 16; ++i) {
      const Vec3 tip_m = settle(1).pose.position_m;
      largest_m = std::max(largest_m, norm(tip_m - before_m));
      before_m = tip_m;
    }
  }

  // Two equal low-passes answer a step of 3 mm with at most 3 mm / (e * 15 ms) on top of the mean speed.
  EXPECT_LT(largest_m, 0.00035);
}

TEST_F(PointerDeviceTest, NeverMovesFasterThanItsSpeedLimit) {
  (void)settle(1);
  device.publish(at({0.5, 0.0, 0.1}));
  Vec3 before_m{0.0, 0.0, 0.1};
  for (int i = 0; i < 600; ++i) {
    const Vec3 tip_m = settle(1).pose.position_m;
    ASSERT_LE(norm(tip_m - before_m), kPointerSpeedLimit_m_per_s * 1e-3 + 2.0 * kQuantum_m);
    before_m = tip_m;
  }
  EXPECT_NEAR(before_m.x, 0.5, 1e-6);
}

TEST_F(PointerDeviceTest, DoesNotTurnWhatTheJawHoldsWhenTheCameraGoesRound) {
  PointerInput input = at({});
  input.grip = 1.0;
  device.publish(input);
  const ToolState before = settle();
  input.view = axisAngle({0.0, 1.0, 0.0}, 1.0);
  device.publish(input);
  const ToolState after = settle();

  EXPECT_EQ(before.pose.orientation, after.pose.orientation);
}

TEST_F(PointerDeviceTest, RepeatsItsPoseAndSaysSoForInputThatIsNotFinite) {
  device.publish(at({0.02, 0.0, 0.1}));
  const ToolState good = settle();
  for (int broken = 0; broken < 3; ++broken) {
    PointerInput input = at({0.5, 0.0, 0.1});
    (broken == 0   ? input.onPlane_m.x
     : broken == 1 ? input.view.w
                   : input.roll_rad) = std::numeric_limits<double>::quiet_NaN();
    device.publish(input);
    const ToolState state = settle(10);

    EXPECT_EQ(state.status, static_cast<std::uint32_t>(kDeviceInvalid));
    EXPECT_NEAR(norm(state.pose.position_m - good.pose.position_m), 0.0, 2.0 * kQuantum_m);
  }
}

}  // namespace
}  // namespace torsio
