// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/exercise.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/random.h"
#include "sim/servo/contact_coupling.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {
namespace {

constexpr double kTipRadius_m = 0.0025;
constexpr double kArc_m = 0.200;
// The bar is a prism of 72 sides: its torsional stiffness lies 0.4 % below the circle's (inscribed polygon,
// area ratio squared), its surface at most 40 um inside.
constexpr double kPolygon = 0.006;
constexpr double kFlat_m = 4e-5;
// Sums of a dozen rounded doubles around one.
constexpr double kRounding = 1e-12;

const Scene& scene() {
  static const Scene kScene = barScene();
  return kScene;
}

/// Stylus towards the axis: shaft outwards.
Quat inwards(double angle_rad) {
  return axisAngle({0.0, 0.0, 1.0}, angle_rad) * axisAngle({0.0, 1.0, 0.0}, 0.5 * kPi);
}

/// The tool on the surface of the bar, pressed in by `depth_m`, `angle_rad` round it.
ToolState onSurface(double angle_rad, double depth_m, double grip = 0.0, double z_m = kArc_m) {
  ToolState tool;
  const double radius_m = kBarRadius_m + kTipRadius_m - depth_m;
  tool.pose.position_m = {radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad), z_m};
  tool.pose.orientation = inwards(angle_rad);
  tool.grip = grip;
  return tool;
}

class ExerciseTest : public ::testing::Test {
 protected:
  ExerciseStep step(const ToolState& tool) { return exercise.step(tool); }
  /// Held still until the coupling has come to rest: 20 ticks are 40 of its time constants.
  ExerciseStep settled(const ToolState& tool) {
    ExerciseStep answer;
    for (int i = 0; i < 20; ++i) {
      answer = step(tool);
    }
    return answer;
  }
  /// Touches, closes the jaw and holds; the angle is 0.
  void gripAt(double angle_rad, TwistDrive drive = TwistDrive::kTangential) {
    exercise = Exercise({.drive = drive}, scene());
    (void)step(onSurface(angle_rad, 0.001));
    (void)step(onSurface(angle_rad, 0.001, 1.0));
    ASSERT_EQ(exercise.phase(), ExercisePhase::kTwisting);
  }
  /// Turns the gripped tool in steps of a degree.
  ExerciseStep turn(double from_rad, double to_rad) {
    const double step_rad = to_rad > from_rad ? radians(1.0) : radians(-1.0);
    ExerciseStep answer;
    for (double a = from_rad; (to_rad - a) * step_rad > 0.0; a += step_rad) {
      answer = step(onSurface(a, 0.001, 1.0));
    }
    return step(onSurface(to_rad, 0.001, 1.0));
  }

  Exercise exercise{{}, scene()};
};

TEST_F(ExerciseTest, GivesNoForceOutOfContact) {
  Random random(1);
  for (int i = 0; i < 2'000; ++i) {
    ToolState tool;
    const double radius_m = kBarRadius_m + kTipRadius_m + 0.0045 + 0.1 * random.uniform();
    const double angle_rad = 2.0 * kPi * random.uniform();
    tool.pose.position_m = {radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad),
                            0.3 * random.uniform()};
    tool.pose.orientation = inwards(angle_rad);
    tool.grip = random.uniform();

    const ExerciseStep answer = step(tool);

    ASSERT_EQ(answer.response, TwistResponse{});
    ASSERT_EQ(answer.phase, ExercisePhase::kTracking);
    ASSERT_TRUE(exercise.organ().atRest());
  }
}

TEST_F(ExerciseTest, PushesBackAlongTheNormalInContactAndDeformsNothing) {
  const ExerciseStep answer = step(onSurface(0.0, 0.001));
  const ExerciseStep steady = settled(onSurface(0.0, 0.001));

  EXPECT_EQ(answer.phase, ExercisePhase::kContact);
  EXPECT_EQ(answer.events, static_cast<std::uint32_t>(kEventTouched));
  EXPECT_EQ(answer.contact, static_cast<std::uint32_t>(kContactJaw));
  EXPECT_NEAR(answer.response.depth_m, 0.001, kFlat_m);
  // 400 N/m times 1 mm, outwards along x; at the onset the coupling's damper adds to it, up to 500 N/m.
  EXPECT_GT(answer.response.force_N.x, steady.response.force_N.x);
  EXPECT_LE(answer.response.force_N.x, 0.5);
  EXPECT_NEAR(steady.response.force_N.x, 0.4, 400.0 * kFlat_m);
  EXPECT_NEAR(steady.response.force_N.z, 0.0, 1e-9);
  EXPECT_EQ(answer.response.torque_Nm, 0.0);
  EXPECT_TRUE(exercise.organ().atRest());
}

TEST_F(ExerciseTest, TellsTheShaftFromTheJaw) {
  // Stylus across the bar: the tip is 60 mm past it, the shaft lies 1 mm deep in its side.
  ToolState tool;
  tool.pose.position_m = {kBarRadius_m + kTipRadius_m - 0.001, -0.060, kArc_m};
  tool.pose.orientation = axisAngle({1.0, 0.0, 0.0}, -0.5 * kPi);  // shaft along +y

  const ExerciseStep first = step(tool);
  const ExerciseStep steady = settled(tool);
  tool.pose.position_m.x += 0.010;
  const ExerciseStep left = step(tool);

  EXPECT_EQ(first.contact, static_cast<std::uint32_t>(kContactShaft));
  EXPECT_EQ(first.events, static_cast<std::uint32_t>(kEventTouched | kEventShaftTouched));
  EXPECT_EQ(first.phase, ExercisePhase::kContact);
  EXPECT_NEAR(steady.response.force_N.x, 0.4, 400.0 * kFlat_m);
  EXPECT_EQ(steady.response.depth_m, 0.0);  // of the tip
  EXPECT_NEAR(steady.patches[1].depth_m, 0.0008, kFlat_m);
  EXPECT_NEAR(steady.patches[1].point_m.x, kBarRadius_m, kFlat_m);
  EXPECT_NEAR(steady.patches[1].point_m.y, 0.0, 0.002);  // anywhere on the facet that faces +x
  EXPECT_EQ(steady.patches[0], ContactPatch{});
  EXPECT_EQ(left.events, static_cast<std::uint32_t>(kEventLeft | kEventShaftLeft));
  EXPECT_EQ(left.response, TwistResponse{});
}

TEST_F(ExerciseTest, GripsOnlyWhatLiesBetweenTheBlades) {
  // The bar lies beside the jaw, behind the open blade, nearer than the reach of 4 mm.
  const auto beside = [](double grip) {
    ToolState tool;
    const double across_m = kBarRadius_m + 0.0055;
    tool.pose.position_m = {across_m, -0.010, kArc_m};
    // Shaft along +y, blades in the plane of x and y.
    tool.pose.orientation = axisAngle({1.0, 0.0, 0.0}, -0.5 * kPi) * axisAngle({0.0, 0.0, 1.0}, 0.5 * kPi);
    tool.grip = grip;
    return tool;
  };
  const ToolShape shape = toolShape(beside(0.0), scene().instrument);
  const bool bladeTowardsBar =
      shape.blades[0].to_m.x < shape.tip_m.x || shape.blades[1].to_m.x < shape.tip_m.x;
  ASSERT_TRUE(bladeTowardsBar);
  const std::optional<SurfacePoint> besideJaw = tissueInMouth(shape, beside(0.0), scene(), {});
  const std::optional<SurfacePoint> ahead = tissueInMouth(
      toolShape(onSurface(0.0, -0.002), scene().instrument), onSurface(0.0, -0.002), scene(), {});
  const std::optional<SurfacePoint> away = tissueInMouth(
      toolShape(onSurface(0.0, -0.005), scene().instrument), onSurface(0.0, -0.005), scene(), {});

  ASSERT_TRUE(ahead.has_value());
  EXPECT_NEAR(norm(ahead->position_m - Vec3{kBarRadius_m, 0.0, kArc_m}), 0.0, 0.002);
  EXPECT_FALSE(away.has_value());
  // 10 mm before the hinge the blade stands 4.7 mm from the middle of the jaw, the bar 5.5 mm.
  EXPECT_FALSE(besideJaw.has_value());
}

TEST_F(ExerciseTest, GivesWayUnderTheTipByTheForceOverTheStiffness) {
  const ExerciseStep steady = settled(onSurface(0.0, 0.001));

  const ContactPatch& patch = steady.patches[0];
  EXPECT_NEAR(patch.depth_m * kSurfaceStiffness_N_per_m, norm(steady.response.force_N), 1e-12);
  EXPECT_NEAR(patch.depth_m, 0.0008, kFlat_m);  // 4/5 of the penetration
  EXPECT_EQ(patch.toolRadius_m, kTipRadius_m);
  EXPECT_EQ(patch.radius_m, kPatchShare * kTipRadius_m);
}

TEST_F(ExerciseTest, KeepsTheContactSpringBelowTheDevicesStiffness) {
  exercise = Exercise({.maxStiffness_N_per_m = 100.0}, scene());

  const ExerciseStep first = step(onSurface(0.0, 0.001));
  const ExerciseStep steady = settled(onSurface(0.0, 0.001));

  EXPECT_LE(norm(first.response.force_N), 0.1);
  EXPECT_NEAR(norm(steady.response.force_N), 0.08, 100.0 * kFlat_m);  // 4/5 of the device's 100 N/m
}

TEST_F(ExerciseTest, EndsTheContactForceAtTheSurfaceAndTheContactALittleAbove) {
  (void)step(onSurface(0.0, 0.001));

  const ExerciseStep justAbove = step(onSurface(0.0, -0.0003));
  const ExerciseStep above = step(onSurface(0.0, -0.0010));

  EXPECT_EQ(justAbove.phase, ExercisePhase::kContact);
  EXPECT_EQ(justAbove.response.force_N, Vec3{});
  EXPECT_EQ(above.phase, ExercisePhase::kTracking);
  EXPECT_EQ(above.events, static_cast<std::uint32_t>(kEventLeft));
}

TEST_F(ExerciseTest, GripsOnlyByClosingTheJawNearTheSurface) {
  (void)step(onSurface(0.0, -0.002));  // open, within the reach of 4 mm, not touching

  const ExerciseStep first = step(onSurface(0.0, -0.002, 1.0));
  const ExerciseStep second = step(onSurface(0.0, -0.002, 1.0));

  EXPECT_EQ(first.phase, ExercisePhase::kContact);  // Fig. 6: contact comes before twisting
  EXPECT_EQ(second.phase, ExercisePhase::kTwisting);
  EXPECT_EQ(second.events, static_cast<std::uint32_t>(kEventGripped));
  EXPECT_NEAR(second.response.graspArc_m, kArc_m, 1e-9);
  EXPECT_EQ(second.response.angle_rad, 0.0);
}

TEST_F(ExerciseTest, GripsNothingWhenTheJawArrivesClosedOrClosesTooFarAway) {
  (void)step(onSurface(0.0, -0.010));
  (void)step(onSurface(0.0, -0.010, 1.0));  // closed 10 mm away
  ExerciseStep answer;
  for (int i = 0; i < 10; ++i) {
    answer = step(onSurface(0.0, 0.001, 1.0));
  }

  EXPECT_EQ(answer.phase, ExercisePhase::kContact);
}

TEST_F(ExerciseTest, GripsWithTheButtonLikeWithTheJaw) {
  ToolState tool = onSurface(0.0, 0.001);
  (void)step(tool);
  tool.buttons = kButtonGrip;
  (void)step(tool);

  EXPECT_EQ(exercise.phase(), ExercisePhase::kTwisting);
}

TEST_F(ExerciseTest, TurnsTheOrganWithTheTipRoundItsAxis) {
  gripAt(0.0);

  const ExerciseStep answer = turn(0.0, radians(90.0));

  const double expected_Nm = barStiffness_Nm(kArc_m) * radians(90.0);
  EXPECT_NEAR(answer.response.angle_rad, radians(90.0), kRounding);
  EXPECT_NEAR(answer.response.torque_Nm, expected_Nm, kPolygon * expected_Nm);
  // The tool feels torque over arm against its motion: it stands at +y and moved towards -x.
  const double force_N = answer.response.torque_Nm / (kBarRadius_m + kTipRadius_m - 0.001);
  EXPECT_NEAR(answer.response.force_N.x, force_N, 1e-6);
  EXPECT_NEAR(answer.response.force_N.y, 0.0, 1e-6);
}

TEST_F(ExerciseTest, CountsMoreThanOneTurn) {
  gripAt(0.0);

  const ExerciseStep answer = turn(0.0, radians(540.0));

  EXPECT_NEAR(answer.response.angle_rad, radians(540.0), 1e-9);
}

TEST_F(ExerciseTest, TurnsTheOrganWithTheStylusWhenItIsDrivenByRoll) {
  gripAt(0.0, TwistDrive::kRoll);
  ToolState tool = onSurface(0.0, 0.001, 1.0);
  ExerciseStep answer;
  for (int degrees = 1; degrees <= 400; ++degrees) {
    // A swing across the axis must not count as a turn about it.
    const Quat swing = axisAngle({1.0, 0.0, 0.0}, 0.3 * std::sin(0.05 * degrees));
    tool.pose.orientation = swing * axisAngle({0.0, 0.0, 1.0}, radians(degrees)) * inwards(0.0);
    answer = step(tool);
  }

  EXPECT_NEAR(answer.response.angle_rad, radians(400.0), 1e-9);
  EXPECT_EQ(answer.phase, ExercisePhase::kTwisting);
}

TEST_F(ExerciseTest, HoldsTheOrganByRollWhetherTheTipStaysOrGoesRound) {
  gripAt(0.0, TwistDrive::kRoll);
  ExerciseStep answer;
  for (int degrees = 1; degrees <= 90; ++degrees) {
    ToolState tool = onSurface(radians(degrees), 0.001, 1.0);
    tool.pose.orientation = axisAngle({0.0, 0.0, 1.0}, radians(degrees)) * inwards(0.0);
    answer = step(tool);
  }

  EXPECT_EQ(answer.phase, ExercisePhase::kTwisting);
  EXPECT_NEAR(answer.response.angle_rad, radians(90.0), 1e-9);
}

TEST_F(ExerciseTest, ATurnByRollDoesNotPushTheShaftIntoWhatItHolds) {
  // The tip stays where it gripped while the stylus turns about the bar's axis: against the bar it is carried
  // round, and its shaft points outwards at any angle.
  gripAt(0.0, TwistDrive::kRoll);
  ToolState tool = onSurface(0.0, 0.001, 1.0);
  std::uint32_t contact = kContactNone;
  std::uint32_t events = kEventNone;
  double across_N = 0.0;
  for (int degrees = 1; degrees <= 180; ++degrees) {
    tool.pose.orientation = axisAngle({0.0, 0.0, 1.0}, radians(degrees)) * inwards(0.0);
    const ExerciseStep answer = step(tool);
    contact |= answer.contact;
    events |= answer.events;
    across_N = std::max(across_N, std::abs(answer.response.force_N.x));
  }

  EXPECT_EQ(contact, static_cast<std::uint32_t>(kContactHeld));
  EXPECT_EQ(events, static_cast<std::uint32_t>(kEventNone));
  EXPECT_LT(across_N, 1e-9);
}

TEST_F(ExerciseTest, MeasuresThePureRollExactly) {
  gripAt(0.0, TwistDrive::kRoll);
  ToolState tool = onSurface(0.0, 0.001, 1.0);
  for (const double angle_rad : {0.5, 1.0, 0.2, -1.0}) {
    tool.pose.orientation = axisAngle({0.0, 0.0, 1.0}, angle_rad) * inwards(0.0);
    EXPECT_NEAR(step(tool).response.angle_rad, angle_rad, kRounding);
  }
}

TEST_F(ExerciseTest, AnswersMirroredMotionWithMirroredTorqueAndForce) {
  gripAt(0.0);
  std::vector<ExerciseStep> there;
  for (int i = 0; i <= 120; ++i) {
    there.push_back(step(onSurface(radians(i), 0.001, 1.0)));
  }
  gripAt(0.0);
  for (int i = 0; i <= 120; ++i) {
    const TwistResponse back = step(onSurface(radians(-i), 0.001, 1.0)).response;
    const TwistResponse& forth = there[static_cast<std::size_t>(i)].response;

    ASSERT_NEAR(back.angle_rad, -forth.angle_rad, kRounding);
    ASSERT_NEAR(back.torque_Nm, -forth.torque_Nm, kRounding);
    ASSERT_NEAR(back.force_N.x, forth.force_N.x, 1e-9);
    ASSERT_NEAR(back.force_N.y, -forth.force_N.y, 1e-9);
  }
}

TEST_F(ExerciseTest, ReturnsElasticallyAfterTheReleaseAndThenTracks) {
  gripAt(0.0);
  (void)turn(0.0, radians(90.0));
  ToolState away = onSurface(radians(90.0), -0.05);

  const ExerciseStep released = step(away);
  double before_rad = released.response.angle_rad;
  int ticks = 1;
  ExerciseStep answer = released;
  while (answer.phase == ExercisePhase::kReleased) {
    answer = step(away);
    ++ticks;
    ASSERT_LT(answer.response.angle_rad, before_rad);
    ASSERT_GE(answer.response.angle_rad, 0.0);
    ASSERT_EQ(answer.response.force_N, Vec3{});
    ASSERT_EQ(answer.response.torque_Nm, 0.0);
    before_rad = answer.response.angle_rad;
  }

  EXPECT_TRUE(released.events & kEventReleased);
  EXPECT_EQ(answer.phase, ExercisePhase::kTracking);
  EXPECT_EQ(answer.events, static_cast<std::uint32_t>(kEventReturned));
  EXPECT_TRUE(exercise.organ().atRest());
  // ln(pi/2 / 1e-3) time constants of 120 ms.
  EXPECT_NEAR(ticks, 120.0 * std::log(kPi / 2.0 / kAtRest_rad), 2.0);
}

TEST_F(ExerciseTest, LetsGoWhenAViewAsksAndGripsOnlyAfterTheJawOpenedAgain) {
  gripAt(0.0);
  (void)turn(0.0, radians(20.0));
  exercise.apply({ServoCommand::Kind::kReleaseTissue});
  const ExerciseStep released = step(onSurface(radians(20.0), 0.001, 1.0));
  ExerciseStep answer = released;
  for (int i = 0; i < 2'000; ++i) {
    answer = step(onSurface(radians(20.0), 0.001, 1.0));
  }
  const ExercisePhase stillClosed = answer.phase;
  (void)step(onSurface(radians(20.0), 0.001, 0.0));
  (void)step(onSurface(radians(20.0), 0.001, 1.0));

  EXPECT_EQ(released.phase, ExercisePhase::kReleased);
  EXPECT_EQ(stillClosed, ExercisePhase::kContact);
  EXPECT_EQ(exercise.phase(), ExercisePhase::kTwisting);
}

TEST_F(ExerciseTest, LetsGoWhenTheDeviceIsLost) {
  for (const std::uint32_t status : {kDeviceLost, kDeviceUncalibrated, kDeviceEnded}) {
    gripAt(0.0);
    ToolState tool = onSurface(0.0, 0.001, 1.0);
    tool.status = status;

    EXPECT_EQ(step(tool).phase, ExercisePhase::kReleased);
  }
}

TEST_F(ExerciseTest, PullsTheJawBackToTheSectionAndSlipsOffBeyondItsWay) {
  gripAt(0.0);

  const ExerciseStep pulled = step(onSurface(0.0, 0.001 - 0.010, 1.0));
  const ExerciseStep along = step(onSurface(0.0, 0.001, 1.0, kArc_m + 0.010));
  const ExerciseStep slipped = step(onSurface(0.0, 0.001 - 0.021, 1.0));

  // 100 N/m over 10 mm.
  EXPECT_NEAR(pulled.response.force_N.x, -1.0, 1e-9);
  EXPECT_NEAR(along.response.force_N.z, -1.0, 1e-9);
  EXPECT_EQ(slipped.phase, ExercisePhase::kReleased);
  EXPECT_EQ(slipped.events, static_cast<std::uint32_t>(kEventReleased | kEventSlipped));
}

TEST_F(ExerciseTest, StartsANewContactWhereTheJawOpened) {
  gripAt(0.0);
  (void)turn(0.0, radians(90.0));

  // Open jaw, still pressed in: no kick. A millimetre deeper the twisted surface is felt, its force normal:
  // the round section looks the same.
  const ExerciseStep released = step(onSurface(radians(90.0), 0.001));
  const ExerciseStep deeper = step(onSurface(radians(90.0), 0.002));

  EXPECT_EQ(released.phase, ExercisePhase::kReleased);
  EXPECT_NEAR(released.response.depth_m, 0.001, kFlat_m);
  EXPECT_EQ(norm(released.response.force_N), 0.0);
  EXPECT_GT(deeper.response.force_N.y, 0.4 - 400.0 * kFlat_m);  // more at the onset
  EXPECT_LE(deeper.response.force_N.y, 0.5 + 500.0 * kFlat_m);
  EXPECT_NEAR(deeper.response.force_N.x, 0.0, 0.03);  // a facet may tilt by 2.5 degrees
}

TEST_F(ExerciseTest, TouchesAsBeforeOnceTheJawIsOut) {
  gripAt(0.0);
  (void)step(onSurface(0.0, 0.001));   // let go, deep in
  (void)step(onSurface(0.0, -0.002));  // out
  for (int i = 0; i < 2000; ++i) {
    (void)step(onSurface(0.0, -0.002));
  }

  const ExerciseStep touched = step(onSurface(0.0, 0.001));

  EXPECT_GT(norm(touched.response.force_N), 0.4 - 400.0 * kFlat_m);
}

TEST_F(ExerciseTest, RefusesToTwistAHeldSection) {
  (void)step(onSurface(0.0, 0.001, 0.0, 0.0));
  for (int i = 0; i < 5; ++i) {
    const ExerciseStep answer = step(onSurface(0.0, 0.001, 1.0, 0.0));
    ASSERT_TRUE(std::isfinite(norm(answer.response.force_N)));
    ASSERT_TRUE(std::isfinite(answer.response.torque_Nm));
  }
}

TEST_F(ExerciseTest, KeepsItsRulesUnderRandomMotion) {
  Random random(7);
  ToolState tool = onSurface(0.0, 0.0);
  ExercisePhase before = ExercisePhase::kTracking;
  double angle_rad = 0.0;
  double depth_m = 0.0;
  int grips = 0;
  for (int i = 0; i < 8'000; ++i) {
    angle_rad += 0.02 * random.normal();
    depth_m += 0.001 * random.normal() - 0.002 * depth_m;
    tool = onSurface(angle_rad, depth_m, random.bounded(2) == 0 ? tool.grip : random.uniform(),
                     0.25 * random.uniform());
    if (random.bounded(4'000) == 0) {
      tool.status = kDeviceLost;
    }

    const ExerciseStep answer = step(tool);

    ASSERT_TRUE(std::isfinite(answer.response.angle_rad) && std::isfinite(answer.response.torque_Nm) &&
                isFinite(answer.response.force_N));
    ASSERT_GE(answer.response.depth_m, 0.0);
    switch (answer.phase) {
      case ExercisePhase::kTracking:
        ASSERT_EQ(answer.response, TwistResponse{}) << "tick " << i;
        ASSERT_NE(before, ExercisePhase::kTwisting);
        break;
      case ExercisePhase::kContact:
        ASSERT_EQ(answer.response.angle_rad, 0.0);
        ASSERT_EQ(answer.response.torque_Nm, 0.0);
        ASSERT_NE(before, ExercisePhase::kTwisting);
        break;
      case ExercisePhase::kTwisting:
        grips += before == ExercisePhase::kTwisting ? 0 : 1;
        ASSERT_TRUE(before == ExercisePhase::kContact || before == ExercisePhase::kTwisting);
        break;
      case ExercisePhase::kReleased:
        ASSERT_EQ(answer.response.torque_Nm, 0.0);
        ASSERT_TRUE(before == ExercisePhase::kTwisting || before == ExercisePhase::kReleased);
        break;
    }
    before = answer.phase;
  }
  EXPECT_GT(grips, 10);
}

TEST_F(ExerciseTest, ContinuesFromACopyBitForBit) {
  gripAt(0.3);
  (void)turn(0.3, 1.0);
  Exercise copy = exercise;
  for (int i = 0; i < 100; ++i) {
    const ToolState tool = onSurface(1.0 + 0.01 * i, 0.001, i < 80 ? 1.0 : 0.0);
    ASSERT_EQ(step(tool).response, copy.step(tool).response);
  }
}

TEST_F(ExerciseTest, IgnoresTheCommandsForHollowOrgansOnASolidOne) {
  gripAt(0.3);
  Exercise commanded = exercise;
  for (int i = 0; i < 100; ++i) {
    commanded.apply({ServoCommand::Kind::kHoldOrgan, 1.0});
    commanded.apply({ServoCommand::Kind::kVent, 1.0});
    commanded.apply({ServoCommand::Kind::kCheckFlow, 1.0});
    const ToolState tool = onSurface(0.3 + 0.01 * i, 0.001, i < 80 ? 1.0 : 0.0);
    ASSERT_EQ(commanded.step(tool).response, step(tool).response);
    ASSERT_EQ(commanded.organ(), exercise.organ());
  }
}

TEST(Exercise, RefusesAnInvalidStiffness) {
  EXPECT_THROW(Exercise({.maxStiffness_N_per_m = 0.0}, scene()), Error);
  EXPECT_THROW(Exercise({.maxStiffness_N_per_m = std::nan("")}, scene()), Error);
  EXPECT_THROW(Exercise({.tickPeriod_us = 0}, scene()), Error);
}

}  // namespace
}  // namespace torsio
