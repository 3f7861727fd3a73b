// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/detorsion.h"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "sim/servo/exercise.h"
#include "tests/sim/servo/bar_scene.h"
#include "tests/support/allocation_count.h"

namespace torsio {
namespace {

constexpr double kTip_m = 0.0025;
constexpr double kHand_rad = radians(155.0);  // what one hand turns

const Scene& tube() {
  static const Scene kScene = hollowScene(twistedTube());
  return kScene;
}

/// A hand on a hollow bar.
class Detorser {
 public:
  explicit Detorser(const Scene& scene, std::uint64_t seed = 1, TwistDrive drive = TwistDrive::kTangential)
      : exercise({.drive = drive}, scene, seed) {}

  ExerciseStep step(double hand_rad, double grip, double height_m = 0.2, double depth_m = 0.001) {
    tool_.time_us = ticks_++ * 1000;
    const double radius_m = kBarRadius_m + kTip_m - depth_m;
    tool_.pose.position_m = {radius_m * std::cos(hand_rad), radius_m * std::sin(hand_rad), height_m};
    tool_.pose.orientation = axisAngle({0.0, 0.0, 1.0}, hand_rad) * axisAngle({0.0, 1.0, 0.0}, 0.5 * kPi);
    tool_.grip = grip;
    hand_rad_ = hand_rad;
    const ExerciseStep answer = exercise.step(tool_);
    events |= answer.events;
    return answer;
  }
  void grip(double height_m = 0.2) {
    step(0.0, 0.0, height_m);
    step(0.0, 1.0, height_m);
  }
  /// Turns on by degrees; returns the last answer.
  ExerciseStep turn(double by_rad, double grip = 1.0) {
    const int steps = static_cast<int>(std::ceil(std::abs(by_rad) / radians(1.0)));
    const double from_rad = hand_rad_;
    ExerciseStep answer;
    for (int i = 1; i <= steps; ++i) {
      answer = step(from_rad + by_rad * i / steps, grip);
    }
    return answer;
  }
  void letGo() {
    step(hand_rad_, 0.0);
    step(hand_rad_, 0.0);
  }
  /// Lets time pass, the hand away.
  void wait(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 1000.0); ++i) {
      step(0.0, 0.0, 0.2, -0.05);
    }
  }
  void holdOrgan(bool held) { exercise.apply({ServoCommand::Kind::kHoldOrgan, held ? 1.0 : 0.0}); }
  /// Takes off the clip in a new grip, turns, and sets the clip again, or not.
  ExerciseStep turnInAGrip(double by_rad, bool clipped = true) {
    grip();
    holdOrgan(false);
    const ExerciseStep last = turn(by_rad);
    holdOrgan(clipped);
    letGo();
    return last;
  }
  void vent(bool open) { exercise.apply({ServoCommand::Kind::kVent, open ? 1.0 : 0.0}); }
  void check(FlowCheck check) {
    exercise.apply({ServoCommand::Kind::kCheckFlow, static_cast<double>(check)});
  }
  void press(std::uint32_t buttons) { tool_.buttons = buttons; }
  [[nodiscard]] double angle_rad() const { return exercise.organ().twist.graspAngle_rad; }
  [[nodiscard]] const HollowPose& pose() const { return exercise.organ().hollow; }

  Exercise exercise;
  std::uint32_t events = kEventNone;

 private:
  ToolState tool_;
  double hand_rad_ = 0.0;
  std::int64_t ticks_ = 0;
};

TEST(Detorsion, KeepsTheTwistThroughEveryGripAndContinuesFromIt) {
  Detorser hand(tube());

  hand.grip();
  const double gripped_rad = hand.angle_rad();
  hand.turn(-radians(60.0));

  EXPECT_DOUBLE_EQ(gripped_rad, radians(270.0));
  EXPECT_NEAR(hand.angle_rad(), radians(210.0), 1e-9);
  EXPECT_EQ(hand.exercise.phase(), ExercisePhase::kTwisting);
}

TEST(Detorsion, RelapsesWhereItIsLetGoAt200DegreesAndStaysAt60) {
  Detorser loose(tube());
  Detorser held(tube());

  loose.grip();
  loose.turn(-radians(70.0));
  loose.letGo();
  loose.wait(3.0);
  for (int i = 0; i < 2; ++i) {  // two grips, clipped between
    held.turnInAGrip(-radians(105.0), i == 0);
  }
  const double left_rad = held.angle_rad();
  held.wait(3.0);

  EXPECT_DOUBLE_EQ(loose.angle_rad(), radians(270.0));
  EXPECT_TRUE(loose.events & kEventRelapsing);
  // Of the two ticks after the jaw has opened the wall has used some to settle, which is the other way.
  EXPECT_NEAR(left_rad, radians(60.0), radians(0.1));
  EXPECT_LE(held.angle_rad(), left_rad);
  EXPECT_FALSE(held.events & kEventRelapsing);
}

TEST(Detorsion, RelapsesAtTheRateThatAWholeRelapseTakes) {
  Detorser hand(tube());

  hand.grip();
  hand.turn(-radians(120.0));  // 150 degrees left
  hand.letGo();
  const double before_rad = hand.angle_rad();
  hand.wait(0.5);

  // (270 - 90) degrees in 3 s.
  EXPECT_NEAR(hand.angle_rad() - before_rad, radians(30.0), 1e-9);
}

TEST(Detorsion, NeedsFourGripsFor540Degrees) {
  const Scene cord = hollowScene(twistedCord(radians(540.0)));
  Detorser hand(cord);

  int grips = 0;
  while (std::abs(hand.angle_rad()) > radians(15.0) && grips < 10) {
    hand.turnInAGrip(-std::min(kHand_rad, hand.angle_rad()));
    hand.wait(0.2);
    ++grips;
  }

  EXPECT_EQ(grips, 4);  // 540 / 155 = 3.5
}

TEST(Detorsion, HoldsByFrictionAloneWhereNothingRelapses) {
  const Scene cord = hollowScene(twistedCord(radians(540.0)));
  Detorser hand(cord);

  hand.grip();
  hand.turn(-kHand_rad);
  hand.letGo();
  const double left_rad = hand.angle_rad();
  hand.wait(5.0);

  EXPECT_NEAR(left_rad, radians(385.0), 1e-9);
  EXPECT_EQ(hand.angle_rad(), left_rad);
}

TEST(Detorsion, UntwistsAsFarAsFrictionAllows) {
  Detorsion slippery = twistedCord(radians(540.0));
  slippery.base.stickShare = 0.05;  // of the torque at 540 degrees: 27 degrees
  const Scene cord = hollowScene(slippery);
  Detorser hand(cord);

  for (int i = 0; i < 3; ++i) {
    hand.turnInAGrip(-radians(153.0), i < 2);  // to 81 degrees, below which it settles
  }
  hand.wait(30.0);

  EXPECT_NEAR(hand.angle_rad(), radians(27.0), radians(0.1));
}

TEST(Detorsion, KeepsTheMobilePartInAClipWhileTheHandTurnsBack) {
  Detorser hand(tube());

  hand.grip();
  hand.turn(-radians(70.0));
  hand.press(kButtonSecond);
  hand.turn(0.001);
  const double clipped_rad = hand.angle_rad();
  const ExerciseStep sliding = hand.turn(radians(25.0));
  const double slid_rad = hand.angle_rad();
  hand.press(0);
  hand.turn(0.001);
  hand.press(kButtonSecond);
  hand.turn(-radians(1.0));

  EXPECT_TRUE(hand.events & kEventClipped);
  EXPECT_TRUE(hand.events & kEventUnclipped);
  EXPECT_EQ(slid_rad, clipped_rad);
  EXPECT_EQ(sliding.response.torque_Nm, 0.0);
  EXPECT_NEAR(hand.angle_rad(), clipped_rad - radians(1.0), 1e-9);  // goes on from where it was
}

TEST(Detorsion, AHandTurnsNoFurtherThanAWristAndTurnsBackAtOnce) {
  for (const TwistDrive drive : {TwistDrive::kTangential, TwistDrive::kRoll}) {
    const Scene cord = hollowScene(twistedCord(radians(540.0)));
    Detorser hand(cord, 1, drive);

    hand.grip();
    const ExerciseStep end = hand.turn(-radians(400.0));
    const double most_rad = hand.angle_rad();
    hand.turn(radians(100.0));
    const double back_rad = hand.angle_rad();
    hand.turn(radians(100.0));

    EXPECT_FALSE(drive == TwistDrive::kRoll && (end.contact & kContactShaft) != 0);  // it stays outside
    EXPECT_NEAR(most_rad, radians(540.0 - 155.0), 1e-9);
    EXPECT_NEAR(back_rad, radians(540.0 - 55.0), 1e-9);
    EXPECT_NEAR(hand.angle_rad(), radians(540.0), 1e-9);  // there and back is one way of the wrist
  }
}

TEST(Detorsion, AJawThatSlidesFarRoundAClippedOrganSlipsOff) {
  Detorser hand(tube());

  hand.grip();
  hand.turn(-radians(150.0));
  hand.holdOrgan(true);
  hand.turn(0.001);
  const double clipped_rad = hand.angle_rad();
  hand.turn(radians(29.0));
  const ExercisePhase before = hand.exercise.phase();
  hand.turn(radians(100.0));

  EXPECT_EQ(before, ExercisePhase::kTwisting);
  EXPECT_NE(hand.exercise.phase(), ExercisePhase::kTwisting);
  EXPECT_TRUE(hand.events & kEventSlipped);
  EXPECT_EQ(hand.angle_rad(), clipped_rad);
}

TEST(Detorsion, StaysFiniteAtAnyWinding) {
  Detorser hand(tube());

  ExerciseStep last;
  for (int i = 0; i < 30; ++i) {
    last = hand.turnInAGrip(radians(150.0));
  }

  EXPECT_GT(hand.angle_rad(), radians(4000.0));
  EXPECT_TRUE(std::isfinite(last.response.torque_Nm) && std::isfinite(norm(last.response.force_N)));
  EXPECT_TRUE(std::isfinite(hand.pose().reading.pressure_Pa));
  EXPECT_GE(hand.pose().reading.patency, 0.0);
  EXPECT_GE(hand.pose().reading.flow, 0.0);
}

TEST(Detorsion, SetsAClipOnlyInContact) {
  Detorser hand(tube());

  hand.wait(0.01);
  hand.press(kButtonSecond);
  hand.wait(0.01);

  EXPECT_FALSE(hand.pose().clipped);
}

TEST(Detorsion, GripsTheMobilePartOnly) {
  Detorser hand(tube());
  constexpr double kWrung_m = 0.100;  // of 140 mm
  const OrganState start = tube().hollow->start(1);
  const double neck_m = kBarRadius_m * (1.0 - tube().hollow->sectionAt(kWrung_m, start).radius);

  hand.step(0.0, 0.0, kWrung_m, neck_m + 0.001);
  hand.step(0.0, 1.0, kWrung_m, neck_m + 0.001);

  EXPECT_NE(hand.exercise.phase(), ExercisePhase::kTwisting);
}

TEST(Detorsion, HandFeelsTheWallAndTheRelapse) {
  Detorser hand(tube());
  const HollowOrgan& organ = *tube().hollow;
  const double pressure_Pa = organ.detorsion().wall.pressure_Pa;

  hand.grip();
  const ExerciseStep above = hand.turn(-radians(100.0));
  hand.holdOrgan(true);
  hand.letGo();
  hand.grip();
  hand.holdOrgan(false);
  const ExerciseStep below = hand.turn(-radians(100.0));

  EXPECT_NEAR(above.response.torque_Nm,
              organ.torque_Nm(radians(170.0), pressure_Pa) - 0.3 * organ.peakTorque_Nm(pressure_Pa), 1e-9);
  EXPECT_NEAR(below.response.torque_Nm, organ.torque_Nm(radians(70.0), pressure_Pa), 1e-9);
  EXPECT_GT(below.response.torque_Nm, 0.0);
}

TEST(Detorsion, MeetsNoMoreThanTheCapWhereTheTorqueFallsWithTheAngle) {
  Detorser hand(tube());

  hand.grip();
  ExerciseStep before = hand.turn(-radians(1.0));
  double steepest_N_per_m = 0.0;
  for (int i = 0; i < 1400; ++i) {
    const ExerciseStep now = hand.turn(-radians(0.1));
    const double way_m = radians(0.1) * (kBarRadius_m + kTip_m - 0.001);
    const double change_N = norm(now.response.force_N) - norm(before.response.force_N);
    steepest_N_per_m = std::max(steepest_N_per_m, std::abs(change_N) / way_m);
    before = now;
  }

  EXPECT_LT(steepest_N_per_m, kStiffnessCap_N_per_m);
}

TEST(Detorsion, BruisesWhereTheJawPressesLongTooHardAndTearsWhereItPressesTwiceAsHard) {
  Detorsion hard = twistedTube();
  hard.limits.jawArea_m2 = 15e-6;  // 400 kPa when closed
  Detorsion harder = twistedTube();
  harder.limits.jawArea_m2 = 8e-6;  // 750 kPa
  const Scene bruising = hollowScene(hard);
  const Scene tearing = hollowScene(harder);
  Detorser first(bruising);
  Detorser second(tearing);

  first.grip();
  for (int i = 0; i < 250; ++i) {
    first.step(0.0, 1.0);
  }
  const int early = first.pose().markCount;
  for (int i = 0; i < 100; ++i) {
    first.step(0.0, 1.0);
  }
  second.grip();
  for (int i = 0; i < 5000; ++i) {
    second.step(0.0, 1.0);
  }

  EXPECT_EQ(early, 0);
  ASSERT_EQ(first.pose().markCount, 1);
  EXPECT_FALSE(first.pose().marks[0].torn);
  EXPECT_NEAR(first.pose().marks[0].arc_m, 0.2, 1e-3);
  EXPECT_NEAR(first.pose().jaw_Pa, 400e3, 1.0);
  EXPECT_TRUE(first.events & kEventBruised);
  EXPECT_FALSE(first.events & kEventTorn);
  EXPECT_TRUE(second.events & kEventTorn);
  EXPECT_TRUE(second.pose().marks[0].torn);
  EXPECT_EQ(second.pose().markCount, 2);
  // e^(-3) of 2 mmHg is left after 5 s.
  EXPECT_NEAR(second.pose().reading.pressure_Pa, 2.0 * kPascalsPerMmHg * std::exp(-3.0), 0.2);
}

TEST(Detorsion, BruisesIschaemicTissueAtHalfThePressure) {
  Detorsion lost = twistedTube();
  lost.limits.jawArea_m2 = 30e-6;  // 200 kPa
  lost.start.since_s = 100.0 * 3600.0;
  lost.start.least_rad = radians(720.0);
  lost.start.most_rad = radians(720.0);
  const Scene scene = hollowScene(lost);
  Detorser hand(scene);

  hand.grip();
  for (int i = 0; i < 400; ++i) {
    hand.step(0.0, 1.0);
  }

  EXPECT_GE(hand.pose().reading.dose, 1.0);
  EXPECT_EQ(hand.pose().markCount, 1);
}

TEST(Detorsion, LetsContentOutByAFirstOrderLagAndOpensTheWayForBlood) {
  Detorser hand(tube());

  hand.vent(true);
  hand.wait(3.0);
  hand.vent(false);
  hand.wait(0.001);
  const double closed_Pa = hand.pose().reading.pressure_Pa;
  hand.wait(1.0);

  // 0.5 + 1.5 e^-1 mmHg.
  EXPECT_NEAR(closed_Pa, kPascalsPerMmHg * (0.5 + 1.5 * std::exp(-1.0)), 0.1);
  EXPECT_EQ(hand.pose().reading.pressure_Pa, closed_Pa);
  EXPECT_FALSE(hand.pose().venting);
}

TEST(Detorsion, FollowsTheGasLawUntilTheContentIsLetOut) {
  Detorsion wall = twistedTube();
  wall.wall.sealed = true;
  const Scene scene = hollowScene(wall);
  const double start_Pa = wall.wall.pressure_Pa;
  const double gas_J = scene.hollow->gas_J(radians(270.0), start_Pa);
  Detorser hand(scene);
  Detorser given(tube());

  hand.grip();
  hand.turn(-radians(150.0));
  given.grip();
  given.turn(-radians(150.0));
  const double half_Pa = hand.pose().reading.pressure_Pa;
  hand.turn(radians(150.0));
  const double back_Pa = hand.pose().reading.pressure_Pa;
  hand.vent(true);
  hand.wait(20.0);
  hand.vent(false);
  hand.wait(0.1);
  const double vented_Pa = hand.pose().reading.pressure_Pa;
  hand.grip();
  hand.turn(-radians(150.0));

  // Undone the organ holds more: the pressure falls, and is there again when the turn is back.
  EXPECT_LT(half_Pa, 0.98 * start_Pa);
  EXPECT_NEAR(half_Pa, scene.hollow->sealedPressure_Pa(radians(120.0), gas_J), 1e-9);
  EXPECT_NEAR(back_Pa, start_Pa, 0.01);
  EXPECT_EQ(given.pose().reading.pressure_Pa, start_Pa);
  EXPECT_NEAR(vented_Pa, wall.wall.ventedPressure_Pa, 0.02 * start_Pa);
  EXPECT_LT(hand.pose().reading.pressure_Pa, vented_Pa);
}

TEST(Detorsion, VentsOnlyWhereTheSceneHasAVent) {
  Detorsion shut = twistedTube();
  shut.wall.vent = false;
  const Scene scene = hollowScene(shut);
  Detorser hand(scene);

  hand.vent(true);
  hand.wait(1.0);

  EXPECT_FALSE(hand.pose().venting);
  EXPECT_EQ(hand.pose().reading.pressure_Pa, shut.wall.pressure_Pa);
}

TEST(Detorsion, RestoresTheBloodInTheScenesOwnTime) {
  Detorsion lain = twistedCord(radians(540.0));
  lain.start.since_s = 3600.0;
  const Scene scene = hollowScene(lain);
  Detorser hand(scene);

  const double before = hand.pose().reading.flow;
  for (int i = 0; i < 4; ++i) {
    hand.turnInAGrip(-radians(135.0));
  }
  hand.wait(10.0);

  // 540 degrees leave 1 - 85^-1 35 1.5^1.28 = .31 of the flow; 10 s are ten time constants of 60 s.
  EXPECT_LT(before, 0.5);
  EXPECT_NEAR(hand.pose().reading.flow, 1.0, 1e-3);
  EXPECT_EQ(hand.pose().reading.patency, 1.0);
  EXPECT_GT(hand.pose().scaled_s, 600.0);
}

TEST(Detorsion, AnswersACheckAfterItsTimeWithItsErrorAndBreaksOffWhenTheHandTurns) {
  Detorser hand(tube());
  Detorser again(tube());
  Detorser other(tube(), 2);

  for (Detorser* each : {&hand, &again, &other}) {
    each->check(FlowCheck::kDoppler);
    each->wait(4.9);
    EXPECT_EQ(each->pose().check.done, FlowCheck::kNone);
    each->wait(0.2);
  }
  const FlowReading told = hand.pose().check;
  hand.check(FlowCheck::kTouch);
  hand.grip();
  hand.turn(-radians(5.0));

  EXPECT_EQ(told.done, FlowCheck::kDoppler);
  EXPECT_EQ(told.done_us, 5'000'000);
  EXPECT_EQ(told.count, 1);
  EXPECT_TRUE(hand.events & kEventChecked);
  EXPECT_EQ(told, again.pose().check);
  EXPECT_NE(told.flow, other.pose().check.flow);
  EXPECT_EQ(hand.pose().check.running, FlowCheck::kNone);
  EXPECT_EQ(hand.pose().check.count, 1);  // the touch was broken off
}

TEST(Detorsion, ChecksHaveTheirStatedDeviation) {
  const Scene scene = hollowScene(twistedCord(radians(400.0)));
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kTrials = 400;

  for (int i = 0; i < kTrials; ++i) {
    OrganState organ = scene.hollow->stateAt(radians(400.0));
    DetorsionStep step(1000);
    std::uint32_t events = kEventNone;
    step.begin(static_cast<std::uint64_t>(i));
    step.check(FlowCheck::kDoppler);
    step.step(*scene.hollow, {.time_us = 0}, organ, events);
    step.step(*scene.hollow, {.time_us = 5'000'000}, organ, events);
    const double error = organ.hollow.check.flow - organ.hollow.reading.flow;
    sum += error;
    squares += error * error;
  }

  EXPECT_NEAR(sum / kTrials, 0.0, 3.0 * 0.08 / std::sqrt(kTrials));
  EXPECT_NEAR(std::sqrt(squares / kTrials), 0.08, 0.08 * 3.0 / std::sqrt(2.0 * kTrials));
}

TEST(Detorsion, DrawsTheTwistFromTheSeedOfTheTrial) {
  Detorsion drawn = twistedCord(radians(360.0));
  drawn.start.most_rad = radians(720.0);
  drawn.start.step_rad = radians(90.0);
  drawn.start.sign = -1;
  drawn.start.oppositeShare = 0.2;
  const Scene scene = hollowScene(drawn);

  int opposite = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const double angle_deg = degrees(scene.hollow->start(seed).twist.graspAngle_rad);
    opposite += angle_deg > 0.0 ? 1 : 0;
    EXPECT_GE(std::abs(angle_deg), 360.0 - 1e-9);
    EXPECT_LE(std::abs(angle_deg), 720.0 + 1e-9);
    EXPECT_NEAR(std::abs(angle_deg), 90.0 * std::round(std::abs(angle_deg) / 90.0), 1e-9);
  }

  EXPECT_NEAR(opposite, 200, 38);  // three standard deviations
  EXPECT_NE(detorsionSeed("a"), detorsionSeed("b"));
  EXPECT_EQ(detorsionSeed("a"), detorsionSeed("a"));
}

TEST(Detorsion, AllocatesNothingInTheTick) {
  Detorser hand(tube());
  hand.grip();

  const auto before = testing::allocationCount();
  hand.turn(-radians(30.0));
  hand.letGo();

  EXPECT_EQ(testing::allocationCount(), before);
}

}  // namespace
}  // namespace torsio
