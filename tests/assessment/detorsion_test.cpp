// SPDX-License-Identifier: GPL-3.0-or-later
// An untwisting built tick by tick, with metrics calculated by hand.
#include "assessment/metrics/detorsion.h"

#include <vector>

#include <gtest/gtest.h>

#include "sim/core/error.h"

namespace torsio {
namespace {

/// Ticks built stage by stage, one per millisecond; angles in degrees.
class Untwisting {
 public:
  explicit Untwisting(double start_deg) {
    now_.angle_rad = radians(start_deg);
    now_.flow = 0.2;
    now_.patency = 0.3;
  }

  /// State from here on.
  DetorsionTick& now() { return now_; }
  Untwisting& hand(bool holds) {
    now_.held = holds;
    return *this;
  }
  Untwisting& clip(bool holds) {
    now_.clipped = holds;
    return *this;
  }
  Untwisting& blood(double flow, double patency) {
    now_.flow = flow;
    now_.patency = patency;
    return *this;
  }
  /// Adds `count` ticks with an even turn to an angle, reached by the last of them.
  Untwisting& turnTo(double angle_deg, int count) {
    const double from_rad = now_.angle_rad;
    for (int i = 1; i <= count; ++i) {
      now_.angle_rad =
          i == count ? radians(angle_deg) : from_rad + (radians(angle_deg) - from_rad) * i / count;
      add();
    }
    return *this;
  }
  Untwisting& pass(int count) {
    for (int i = 0; i < count; ++i) {
      add();
    }
    return *this;
  }

  [[nodiscard]] DetorsionMetrics measured(const DetorsionRules& rules = {}) const {
    return measureDetorsion(ticks, rules);
  }

  std::vector<DetorsionTick> ticks;

 private:
  void add() {
    now_.time_us = 1000 * std::ssize(ticks);
    ticks.push_back(now_);
  }

  DetorsionTick now_;
};

/// Starts at 200 degrees left or right, is turned to 40 in one grip of 2 s, clipped, gripped again, turned to
/// 10 and released; blood returns 1 s before the end of the first turn.
Untwisting rightWay(double sign) {
  Untwisting run(sign * 200.0);
  run.pass(1000).hand(true).turnTo(sign * 120.0, 1000).blood(0.6, 0.9).turnTo(sign * 40.0, 1000);
  run.clip(true).hand(false).pass(500).hand(true).pass(500).clip(false).turnTo(sign * 10.0, 1000);
  run.blood(0.95, 1.0).hand(false);
  return run;
}

TEST(Detorsion, ACorrectRunMeasuresTheSameOnBothSides) {
  for (const double sign : {1.0, -1.0}) {
    Untwisting run = rightWay(sign);
    run.pass(10'000);

    const DetorsionMetrics got = run.measured();

    EXPECT_EQ(got.start_rad, radians(sign * 200.0));
    EXPECT_EQ(*got.at(Quantity::kFirstDirection), 1.0);
    EXPECT_EQ(*got.at(Quantity::kWrongWay), 0.0);
    EXPECT_EQ(*got.at(Quantity::kTimeToFlow), 2.0);    // 1 s of looking, 1 s of turning
    EXPECT_EQ(*got.at(Quantity::kRegrips), 1.0);       // at 40 degrees; the last release, at 10, is none
    EXPECT_EQ(*got.at(Quantity::kLeastRegrips), 1.0);  // ceil(200 / 155) - 1
    EXPECT_EQ(*got.at(Quantity::kSlipBack), 0.0);      // clipped
    EXPECT_EQ(*got.at(Quantity::kLeastPatency), 0.3);
    EXPECT_EQ(*got.at(Quantity::kResidual), radians(10.0));
    EXPECT_EQ(*got.at(Quantity::kUntwisted), 1.0);
    EXPECT_EQ(*got.at(Quantity::kRelapse), 0.0);
    EXPECT_DOUBLE_EQ(got.done_s.value(), 15.0);  // let go at 5 s
  }
}

TEST(Detorsion, AnInitialTurnInTheWrongDirectionIsMeasured) {
  // 200 degrees become 260, by 20 in a first grip and 40 in a second: the first 15 decide.
  Untwisting run(200.0);
  run.pass(10).hand(true).turnTo(220.0, 100).hand(false).pass(100).hand(true).turnTo(260.0, 100);
  run.turnTo(0.0, 500);

  const DetorsionMetrics got = run.measured();

  EXPECT_EQ(*got.at(Quantity::kFirstDirection), 0.0);
  EXPECT_NEAR(*got.at(Quantity::kWrongWay), radians(60.0), 1e-12);
}

TEST(Detorsion, SmallHeldTurnsAddUpToADirectionAndFreeTurnsDoNot) {
  // Held turns of 10 degrees each towards 0; between them the organ slips back by 12 while free.
  Untwisting run(200.0);
  run.pass(10).hand(true).pass(1).turnTo(190.0, 100).hand(false).turnTo(202.0, 100);
  const Untwisting once = run;
  run.hand(true).pass(1).turnTo(192.0, 100);

  EXPECT_FALSE(once.measured().at(Quantity::kFirstDirection));
  EXPECT_EQ(*run.measured().at(Quantity::kFirstDirection), 1.0);
}

TEST(Detorsion, SlippingBackBetweenGripsAddsUp) {
  // From 200 to 150, back to 165 before the next grip (15); to 100, 95 at the next (0); to 80, back to 100,
  // not gripped again. Releases at 150, 100 and 80, all above 30 degrees.
  Untwisting run(200.0);
  run.pass(10).hand(true).turnTo(150.0, 100).hand(false).turnTo(165.0, 100);
  run.hand(true).pass(1).turnTo(100.0, 100).hand(false).turnTo(95.0, 100);
  run.hand(true).pass(1).turnTo(80.0, 100).hand(false).turnTo(100.0, 100);

  const DetorsionMetrics got = run.measured();

  EXPECT_NEAR(*got.at(Quantity::kSlipBack), radians(15.0), 1e-12);
  EXPECT_EQ(*got.at(Quantity::kRegrips), 3.0);
}

TEST(Detorsion, AReleaseByALostDeviceIsNoRegrip) {
  Untwisting run(200.0);
  run.pass(10).hand(true).turnTo(150.0, 100);
  run.now().handGone = true;
  run.hand(false).pass(100);

  EXPECT_EQ(*run.measured().at(Quantity::kRegrips), 0.0);
}

TEST(Detorsion, IfBloodNeverReturnsItsTimesAreUndefined) {
  // .5 for 4.999 s is not 5 s.
  Untwisting run(200.0);
  run.pass(2000).blood(0.5, 0.5).pass(4999).blood(0.49, 0.5);
  run.now().dose = 0.4;
  run.pass(1000);
  const DetorsionMetrics never = run.measured();
  run.blood(0.5, 0.5).pass(5000);
  const DetorsionMetrics atLast = run.measured();

  EXPECT_FALSE(never.at(Quantity::kTimeToFlow));
  EXPECT_FALSE(never.at(Quantity::kTimeToFlow).reason().str().empty());
  EXPECT_FALSE(never.at(Quantity::kDoseAtFlow));
  EXPECT_EQ(*never.at(Quantity::kDose), 0.4);
  EXPECT_EQ(*atLast.at(Quantity::kTimeToFlow), 7.999);
  EXPECT_EQ(*atLast.at(Quantity::kDoseAtFlow), 0.4);
}

TEST(Detorsion, ATissueAlwaysSuppliedHasBloodFromTheStart) {
  Untwisting run(90.0);
  run.blood(0.99, 0.9).pass(6000);

  EXPECT_EQ(*run.measured().at(Quantity::kTimeToFlow), 0.0);
}

TEST(Detorsion, ARelapseAfterSuccessIsBoth) {
  Untwisting run = rightWay(1.0);
  run.pass(10'000).turnTo(91.0, 1000);
  const DetorsionMetrics back = run.measured();
  Untwisting less = rightWay(1.0);
  less.pass(10'000).turnTo(89.0, 1000);

  EXPECT_EQ(*back.at(Quantity::kUntwisted), 1.0);
  EXPECT_EQ(*back.at(Quantity::kRelapse), 1.0);
  EXPECT_EQ(*back.at(Quantity::kResidual), radians(10.0));  // 10 s after the last release
  EXPECT_EQ(*less.measured().at(Quantity::kRelapse), 0.0);
}

TEST(Detorsion, AnOrganWithTheClipOnIsNotHandsOff) {
  Untwisting run(200.0);
  run.pass(10).hand(true).turnTo(0.0, 1000).clip(true).hand(false).blood(1.0, 1.0).pass(20'000);

  const DetorsionMetrics got = run.measured();

  EXPECT_EQ(*got.at(Quantity::kUntwisted), 0.0);
  EXPECT_FALSE(got.at(Quantity::kResidual));
  EXPECT_FALSE(got.at(Quantity::kRelapse));
  EXPECT_FALSE(got.done_s);
}

TEST(Detorsion, ARecordingThatEndsTooEarlyIsNotDoneAndHasNoResidual) {
  Untwisting early = rightWay(1.0);
  early.pass(9'999);

  const DetorsionMetrics got = early.measured();

  EXPECT_EQ(*got.at(Quantity::kUntwisted), 0.0);
  EXPECT_FALSE(got.at(Quantity::kResidual));
  EXPECT_EQ(*got.at(Quantity::kDose), 0.0);  // so far, all the same
}

TEST(Detorsion, WaitingAfterwardsDoesNotReduceTheDose) {
  Untwisting run(200.0);
  run.pass(100);
  run.now().dose = 0.95;
  run.pass(100);
  run.now().dose = 0.8;  // supplied tissue recovers
  run.pass(100);

  EXPECT_EQ(*run.measured().at(Quantity::kDose), 0.95);
}

TEST(Detorsion, AngleLumenAndBloodMustAllBeRight) {
  const auto done = [](double angle_deg, double flow, double patency) {
    Untwisting run(200.0);
    run.pass(10).hand(true).turnTo(angle_deg, 1000).hand(false).blood(flow, patency).pass(10'000);
    return *run.measured().at(Quantity::kUntwisted);
  };

  EXPECT_EQ(done(15.0, 0.8, 0.8), 1.0);
  EXPECT_EQ(done(-15.0, 0.8, 0.8), 1.0);
  EXPECT_EQ(done(15.1, 0.8, 0.8), 0.0);
  EXPECT_EQ(done(15.0, 0.79, 0.8), 0.0);
  EXPECT_EQ(done(15.0, 0.8, 0.79), 0.0);
}

TEST(Detorsion, ATornOrganIsNotUndone) {
  // One tick is enough: sound tissue tears at 660 kPa or 10 N, at a dose of .5 at three quarters of that.
  const auto done = [](double jaw_Pa, double force_N, double dose) {
    Untwisting run(200.0);
    run.now().dose = dose;
    run.pass(10).hand(true).turnTo(0.0, 1000);
    run.now().jaw_Pa = jaw_Pa;
    run.now().force_N = force_N;
    run.pass(1);
    run.now().jaw_Pa = run.now().force_N = 0.0;
    run.hand(false).blood(1.0, 1.0).pass(10'000);
    return *run.measured().at(Quantity::kUntwisted);
  };

  EXPECT_EQ(done(659e3, 0.0, 0.0), 1.0);
  EXPECT_EQ(done(660e3, 0.0, 0.0), 0.0);
  EXPECT_EQ(done(500e3, 0.0, 0.5), 0.0);
  EXPECT_EQ(done(0.0, 9.9, 0.0), 1.0);
  EXPECT_EQ(done(0.0, 7.6, 0.5), 0.0);
}

TEST(Detorsion, OverloadLimitsDependOnTheTissuesDose) {
  // Sound tissue bears 330 kPa and 10 N; at a dose of .5 three quarters of that, 247.5 kPa and 7.5 N.
  Untwisting run(200.0);
  run.now().jaw_Pa = 400e3;
  run.pass(100).hand(true).pass(20);  // only the second interval counts: 20 ms
  run.now().jaw_Pa = 300e3;
  run.pass(30);  // less than 330
  run.now().dose = 0.5;
  run.pass(40);  // more than 247.5: 40 ms
  run.now().jaw_Pa = 0.0;
  run.now().force_N = 7.4;
  run.pass(50);
  run.now().force_N = 7.6;
  run.pass(60);  // 60 ms
  run.now().force_N = 0.0;
  run.pass(10);

  const DetorsionMetrics got = run.measured();

  EXPECT_NEAR(*got.at(Quantity::kOverloadTime), 0.120, 1e-12);
  EXPECT_EQ(*got.at(Quantity::kPeakJaw), 400e3);
  EXPECT_FALSE(got.at(Quantity::kPeakShear));
}

TEST(Detorsion, TheWallsStressRequiresTheScene) {
  Untwisting run(200.0);
  run.now().shear_Pa = 4e3;
  run.pass(10);
  run.now().shear_Pa = 9e3;
  run.pass(10);
  run.now().shear_Pa = 1e3;
  run.pass(10);

  EXPECT_EQ(*run.measured().at(Quantity::kPeakShear), 9e3);
  EXPECT_FALSE(run.measured().at(Quantity::kPeakJaw));  // never held
}

TEST(Detorsion, VentingCountsOnlyBeforeTheTurn) {
  Untwisting before(200.0);
  before.pass(10).hand(true).turnTo(190.0, 100);
  Untwisting after = before;
  before.now().venting = true;
  before.pass(3001).turnTo(100.0, 100);
  after.turnTo(100.0, 100);
  const Untwisting never = after;
  after.now().venting = true;
  after.pass(4000);
  const DetorsionRules vented{.vent = true};

  EXPECT_EQ(*before.measured(vented).at(Quantity::kVentedFirst), 1.0);
  EXPECT_EQ(*after.measured(vented).at(Quantity::kVentedFirst), 0.0);
  EXPECT_EQ(*never.measured(vented).at(Quantity::kVentedFirst), 0.0);
  EXPECT_FALSE(before.measured().at(Quantity::kVentedFirst));
}

TEST(Detorsion, AVentClosedAtOnceReleasesNothing) {
  const auto opened = [](int first, int second) {
    Untwisting run(200.0);
    run.pass(10).now().venting = true;
    run.pass(first).now().venting = false;
    run.pass(500).now().venting = true;
    run.pass(second).now().venting = false;
    run.hand(true).turnTo(100.0, 100);
    return *run.measured({.vent = true}).at(Quantity::kVentedFirst);
  };

  EXPECT_EQ(opened(1, 0), 0.0);
  EXPECT_EQ(opened(1500, 1499), 0.0);
  EXPECT_EQ(opened(1500, 1500), 1.0);  // together two thirds have escaped
}

// 720 degrees in two stages of 360 with five minutes of rest between them; sixty seconds of tissue time per
// second.
constexpr TurnStages kWholeTurns{radians(360.0), 300.0};

TEST(Detorsion, AnOrganThatRestsAfterAWholeTurnIsUndoneInStages) {
  const DetorsionRules rules{.stages = kWholeTurns};
  Untwisting run(-720.0);
  run.pass(1).hand(true).turnTo(-365.0, 2000).hand(false).clip(true).pass(5000);
  run.clip(false).hand(true).turnTo(0.0, 2000);

  EXPECT_NEAR(*run.measured(rules).at(Quantity::kLongestStage), radians(365.0), 1e-9);
  EXPECT_EQ(*run.measured(rules).at(Quantity::kInStages), 1.0);
}

TEST(Detorsion, AShortOrMovingRestStartsNoStage) {
  const DetorsionRules rules{.stages = kWholeTurns};
  Untwisting hasty(720.0);
  hasty.pass(1).hand(true).turnTo(365.0, 2000).pass(4900).turnTo(0.0, 2000);
  Untwisting slow(720.0);
  slow.hand(true).turnTo(0.0, 30000);

  EXPECT_NEAR(*hasty.measured(rules).at(Quantity::kLongestStage), radians(720.0), 1e-9);
  EXPECT_EQ(*hasty.measured(rules).at(Quantity::kInStages), 0.0);
  EXPECT_EQ(*slow.measured(rules).at(Quantity::kInStages), 0.0);
}

TEST(Detorsion, TurningBackDuringTheRestBelongsToTheStage) {
  const DetorsionRules rules{.stages = kWholeTurns};
  Untwisting run(400.0);
  run.pass(1).hand(true).turnTo(200.0, 1000).hand(false).turnTo(390.0, 1000).hand(true).turnTo(100.0, 1000);

  EXPECT_NEAR(*run.measured(rules).at(Quantity::kLongestStage), radians(300.0), 1e-9);
}

TEST(Detorsion, StagesAreUndefinedIfNoneAreRequired) {
  Untwisting run(720.0);
  run.hand(true).turnTo(0.0, 1000);

  EXPECT_FALSE(run.measured().at(Quantity::kInStages));
  EXPECT_FALSE(run.measured().at(Quantity::kLongestStage));
}

TEST(StagedTurn, IsDueBeforeTheHandLeavesTheStageUntilItHasRested) {
  StagedTurn staged(kWholeTurns, 60.0);
  staged.take(0.0, radians(720.0));
  EXPECT_FALSE(staged.due());
  staged.take(0.5, radians(520.0));
  EXPECT_FALSE(staged.due());
  staged.take(1.0, radians(370.0));
  EXPECT_TRUE(staged.due());
  staged.take(4.0, radians(369.0));
  EXPECT_NEAR(staged.still_s(), 180.0, 1e-9);
  staged.take(6.1, radians(369.0));
  EXPECT_FALSE(staged.due());
  EXPECT_NEAR(staged.stage_rad(), 0.0, 1e-12);
  EXPECT_NEAR(staged.longest_rad(), radians(351.0), 1e-12);
  StagedTurn nearlyDone(kWholeTurns, 60.0);
  nearlyDone.take(0.0, radians(360.0));
  nearlyDone.take(1.0, radians(50.0));
  EXPECT_FALSE(nearlyDone.due());  // the rest belongs to the same stage
}

TEST(Detorsion, TheLeastNumberOfRegripsFollowsFromTurnsOf155Degrees) {
  EXPECT_EQ(leastRegrips(radians(90.0)), 0.0);
  EXPECT_EQ(leastRegrips(radians(155.0)), 0.0);
  EXPECT_EQ(leastRegrips(radians(180.0)), 1.0);
  EXPECT_EQ(leastRegrips(radians(310.0)), 1.0);
  EXPECT_EQ(leastRegrips(radians(-360.0)), 2.0);
  EXPECT_EQ(leastRegrips(radians(540.0)), 3.0);
  EXPECT_EQ(leastRegrips(radians(720.0)), 4.0);
  EXPECT_EQ(leastRegrips(0.0), 0.0);
}

TEST(Detorsion, HasAValueOrAReasonForEachOfItsQuantities) {
  Untwisting run(0.0);
  run.pass(2);

  const DetorsionMetrics got = run.measured();

  for (const auto& [quantity, value] : got.all()) {
    EXPECT_TRUE(isOfUntwisting(quantity) && (value || !value.reason().str().empty())) << idOf(quantity);
  }
  EXPECT_EQ(got.all().size(), 18U);
  EXPECT_FALSE(got.at(Quantity::kFirstDirection));  // it did not come twisted
}

TEST(Detorsion, GapsAndRepeatedTimesAreRejected) {
  Untwisting run(200.0);
  run.pass(100);
  std::vector<DetorsionTick> gap = run.ticks;
  for (std::size_t i = 50; i < gap.size(); ++i) {
    gap[i].time_us += 20'001;
  }
  std::vector<DetorsionTick> standing = run.ticks;
  standing[50].time_us = standing[49].time_us;

  EXPECT_THROW(static_cast<void>(measureDetorsion(gap, {})), Error);
  EXPECT_THROW(static_cast<void>(measureDetorsion(standing, {})), Error);
  EXPECT_THROW(static_cast<void>(measureDetorsion({run.ticks.data(), 1}, {})), Error);
}

}  // namespace
}  // namespace torsio
