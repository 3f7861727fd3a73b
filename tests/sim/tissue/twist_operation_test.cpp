// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/twist_operation.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/angle.h"
#include "sim/base/error.h"
#include "sim/base/pose.h"
#include "tests/sim/tissue/twist_bars.h"

namespace torsio {
namespace {

TwistOperation about(const Vec3& from, const Vec3& to, TwistProfile profile) {
  TwistOperation operation;
  operation.axis = TwistAxis::kStraight;
  operation.axisFrom_m = from;
  operation.axisTo_m = to;
  operation.profile = profile;
  return operation;
}

/// Turns everything near the origin as one body: the ramp is over far below it.
TwistOperation rigid(const Vec3& axis, double ratio = 1.0) {
  TwistOperation operation = about({}, axis, TwistProfile::kRamp);
  operation.from = -20.0;
  operation.to = 20.0;
  operation.peak = -19.0;
  operation.ratio = ratio;
  return operation;
}

TwistModelOptions with(std::vector<TwistOperation> operations) {
  TwistModelOptions options;
  options.operations = std::move(operations);
  options.warping = false;
  return options;
}

/// Largest length that a 3 x 3 matrix, given as the images of the unit vectors, makes of a unit vector.
double spectralNorm(const std::array<Vec3, 3>& columns) {
  const auto times = [&](const Vec3& x) { return x.x * columns[0] + x.y * columns[1] + x.z * columns[2]; };
  const auto transposed = [&](const Vec3& y) {
    return Vec3{dot(columns[0], y), dot(columns[1], y), dot(columns[2], y)};
  };
  Vec3 x{0.6, 0.5, 0.4};
  for (int i = 0; i < 200; ++i) {
    x = normalized(transposed(times(x)));
  }
  return norm(times(x));
}

TEST(TwistOperation, ARampRisesStraightAndStaysBeyondItsPeak) {
  TwistOperation ramp = about({}, {0, 0, 1}, TwistProfile::kRamp);
  ramp.from = 0.2;

  EXPECT_EQ(profileShare(ramp, 0.1, 0.6), 0.0);
  EXPECT_NEAR(profileShare(ramp, 0.3, 0.6), 0.25, 1e-15);
  EXPECT_EQ(profileShare(ramp, 0.6, 0.6), 1.0);
  EXPECT_EQ(profileShare(ramp, 5.0, 0.6), 1.0);
  EXPECT_NEAR(profileSlope(ramp, 0.3, 0.6), 2.5, 1e-14);
  EXPECT_EQ(profileSlope(ramp, 0.7, 0.6), 0.0);
  EXPECT_EQ(profileSlope(ramp, 0.1, 0.6), 0.0);
}

TEST(TwistOperation, ATentFallsBackToZeroAtItsOtherEnd) {
  TwistOperation tent = about({}, {0, 0, 1}, TwistProfile::kTent);

  EXPECT_NEAR(profileShare(tent, 0.3, 0.6), 0.5, 1e-15);
  EXPECT_NEAR(profileShare(tent, 0.8, 0.6), 0.5, 1e-15);
  EXPECT_EQ(profileShare(tent, 1.2, 0.6), 0.0);
  EXPECT_NEAR(profileSlope(tent, 0.8, 0.6), -2.5, 1e-14);
}

TEST(TwistOperation, SmoothProfilesHaveTheSlopeOfTheirShares) {
  for (const TwistProfile profile : {TwistProfile::kSmoothRamp, TwistProfile::kSmoothTent}) {
    const TwistOperation operation = about({}, {0, 0, 1}, profile);
    constexpr double kStep = 1e-6;
    for (double x = 0.03; x < 1.0; x += 0.05) {
      const double slope =
          (profileShare(operation, x + kStep, 0.61) - profileShare(operation, x - kStep, 0.61)) /
          (2.0 * kStep);
      EXPECT_NEAR(profileSlope(operation, x, 0.61), slope, 1e-7);
    }
    EXPECT_EQ(profileShare(operation, 0.61, 0.61), 1.0);
    EXPECT_EQ(profileSlope(operation, 0.61, 0.61), 0.0);
  }
}

TEST(TwistOperation, RefusesWhatCannotBeTurned) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refusal = [](auto&& change) {
    TwistOperation operation = about({}, {0, 0, 0.1}, TwistProfile::kRamp);
    change(operation);
    try {
      checkOperations(std::vector<TwistOperation>{TwistOperation{}, operation});
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadParameter);
      return error.where();
    }
    return std::string();
  };
  const std::string second = "twist operation 2";

  EXPECT_EQ(refusal([](auto&) {}), "");
  EXPECT_EQ(refusal([](auto& o) { o.axisTo_m = {0, 0, 1e-4}; }), second);
  EXPECT_EQ(refusal([&](auto& o) { o.axisTo_m = {0, nan, 1}; }), second);
  EXPECT_EQ(refusal([](auto& o) { o.from = 0.5, o.to = 0.5; }), second);
  EXPECT_EQ(refusal([&](auto& o) { o.to = nan; }), second);
  EXPECT_EQ(refusal([](auto& o) { o.peak = 1.5; }), second);
  EXPECT_EQ(refusal([](auto& o) { o.from = 0.2, o.peak = 0.2; }), second);
  EXPECT_EQ(refusal([](auto& o) { o.ratio = 0.0; }), second);
  EXPECT_EQ(refusal([&](auto& o) { o.ratio = nan; }), second);
  EXPECT_EQ(refusal([](auto& o) { o.to = 1.5; }), "") << "along an axis a fraction may leave 0..1";
  EXPECT_EQ(refusal([](auto& o) { o.to = 1.5, o.coordinate = TwistCoordinate::kArc; }), second);
}

TEST(TwistPattern, OperationsAreComposedInTheListedOrderAndNeverAdded) {
  // ||AB - BA|| and ||AB - (A + B - 1)|| about perpendicular axes, spectral norm.
  const std::vector<std::array<double, 3>> table{{10, 0.030, 0.030}, {30, 0.267, 0.268}, {90, 1.732, 2.0}};
  const Bar xThenY = roundBar(with({rigid({1, 0, 0}), rigid({0, 1, 0})}));
  const Bar yThenX = roundBar(with({rigid({0, 1, 0}), rigid({1, 0, 0})}));
  const std::array<Vec3, 3> units{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  for (const auto& [degrees, commutator, sum] : table) {
    const TwistState state{0.1, radians(degrees)};
    std::array<Vec3, 3> difference;
    std::array<Vec3, 3> added;
    for (std::size_t i = 0; i < 3; ++i) {
      // Given: the two turns by hand.
      const Vec3 x = rotateAbout(units[i], units[0], radians(degrees));
      const Vec3 xy = rotateAbout(x, units[1], radians(degrees));
      EXPECT_NEAR(norm(xThenY.model.toDeformed_m(units[i], state) - xy), 0.0, 1e-15);
      difference[i] = xThenY.model.toDeformed_m(units[i], state) - yThenX.model.toDeformed_m(units[i], state);
      added[i] = xy - (x + rotateAbout(units[i], units[1], radians(degrees)) - units[i]);
    }
    EXPECT_NEAR(spectralNorm(difference), commutator, 8e-4);  // the table's last digit
    EXPECT_NEAR(spectralNorm(added), sum, 8e-4);
  }
}

TEST(TwistPattern, EachOperationScalesWithTheGraspAngleByItsRatio) {
  const Bar bar = roundBar(with({rigid({1, 0, 0}, 0.5), rigid({0, 1, 0}, -2.0)}));
  const Vec3 p{0.01, 0.02, 0.03};

  const Vec3 moved = bar.model.toDeformed_m(p, {0.1, 0.4});

  const Vec3 expected = rotateAbout(rotateAbout(p, {1, 0, 0}, 0.2), {0, 1, 0}, -0.8);
  EXPECT_NEAR(norm(moved - expected), 0.0, 1e-16);
}

TEST(TwistPattern, AboutAStraightAxisEveryVolumeIsKeptEvenOnABentOrgan) {
  const Bar bar = bentBar(with({about({0.0, 0.0, 0.0}, {0.162, 0.0, 0.054}, TwistProfile::kSmoothTent)}));
  const TwistState state{0.5 * bar.length_m(), kPi};

  const TwistSummary summary = bar.model.summary(state);

  EXPECT_NEAR(summary.minDeterminant, 1.0, 1e-7);  // central differences over 1e-5 of the length
  EXPECT_NEAR(summary.maxDeterminant, 1.0, 1e-6);
  EXPECT_NEAR(summary.maxRadiusGrowth, 1.0, 1e-12);
}

TEST(TwistPattern, AboutTheCentrelineOfABentOrganTheVolumeChangesWithTheOffset) {
  const Bar bar = bentBar();
  const TwistState state{bar.length_m(), kPi};

  const TwistSummary summary = bar.model.summary(state);

  // det = (1 - k u') / (1 - k u) with k r = 1/3: at most (1 + 1/3) / (1 - 1/3) = 2 and at least 1/2.
  EXPECT_GT(summary.maxDeterminant, 1.8);
  EXPECT_LT(summary.maxDeterminant, 2.1);
  EXPECT_GT(summary.minDeterminant, 0.48);
  EXPECT_LT(summary.minDeterminant, 0.56);
}

TEST(TwistPattern, AnElasticTwistAboutItsOwnStraightAxisIsTheTwistAboutTheCentreline) {
  const Vec3 top{0.0, 0.0, kBarLength_m};
  for (const EndCondition ends : {EndCondition::kClampedFree, EndCondition::kBothHeld}) {
    TwistModelOptions options = with({about({}, top, TwistProfile::kElastic)});
    options.ends = ends;
    const Bar straight = roundBar(options, 0.7);
    options.operations.clear();
    const Bar centreline = roundBar(options, 0.7);
    const TwistState state{0.6 * kBarLength_m, 1.3};
    // The straight table is linear between 257 nodes along the axis: 3e-5 of the angle.
    EXPECT_NEAR(straight.model.torque_Nm(state) / centreline.model.torque_Nm(state), 1.0, 1e-4);
    for (const Vec3& p : centreline.mesh.vertices_m) {
      EXPECT_NEAR(norm(straight.model.toDeformed_m(p, state) - centreline.model.toDeformed_m(p, state)), 0.0,
                  4e-6);
    }
  }
}

TEST(TwistPattern, OnlyTheStatedPartOfAPartialTwistTurns) {
  TwistOperation part;
  part.from = 0.55;
  const Bar bar = roundBar(with({part}));
  const double l = bar.length_m();
  const TwistState state{0.9 * l, 2.0};

  EXPECT_EQ(bar.model.angleAt(0.3 * l, state), 0.0);
  EXPECT_EQ(bar.model.angleAt(0.55 * l, state), 0.0);
  EXPECT_NEAR(bar.model.angleAt(0.725 * l, state), 1.0, 1e-9);
  EXPECT_EQ(bar.model.angleAt(0.9 * l, state), 2.0);
  EXPECT_EQ(bar.model.angleAt(l, state), 2.0);
  // A third of the length turns: 1 / 0.35 of the stiffness of the whole.
  EXPECT_NEAR(bar.model.graspCompliance(0.9 * l) / roundBar().model.graspCompliance(l), 0.35, 1e-6);
}

TEST(TwistPattern, SeveralOperationsActLikeSpringsOnOneShaft) {
  TwistOperation half;
  half.ratio = 0.5;
  const Bar one = roundBar(with({}));
  const Bar two = roundBar(with({half, half}));
  const TwistState state{kBarLength_m, 1.0};

  // The same motion (0.5 + 0.5); each spring holds half the angle with half the leverage: 1/4 + 1/4.
  EXPECT_NEAR(
      norm(two.model.toDeformed_m({0.03, 0.0, 0.2}, state) - one.model.toDeformed_m({0.03, 0.0, 0.2}, state)),
      0.0, 1e-16);
  EXPECT_NEAR(two.model.torque_Nm(state) / one.model.torque_Nm(state), 0.5, 1e-12);
}

TEST(TwistPattern, AGivenProfileMeetsThePapersTwistRateToo) {
  // On a bar that grows wider towards its free end the paper's H theta falls, its twist rate does not vanish.
  TwistOperation part;
  part.profile = TwistProfile::kRamp;
  part.from = 0.5;
  TwistModelOptions options = with({part});
  options.formulation = Formulation::kPaper;
  const Bar paper = roundBar(options, 2.0);
  options.formulation = Formulation::kSaintVenant;
  const Bar usual = roundBar(options, 2.0);

  // The same energy with a twist rate that the cone makes 1.5 times as large.
  EXPECT_NEAR(usual.model.graspCompliance(kBarLength_m) / paper.model.graspCompliance(kBarLength_m),
              1.0 / 1.5, 5e-3);
}

TEST(TwistPattern, AHingeAcrossTheOrganBendsItLikeARod) {
  TwistOperation hinge = about({-0.05, 0.0, 0.125}, {0.05, 0.0, 0.125}, TwistProfile::kRamp);
  hinge.coordinate = TwistCoordinate::kArc;
  hinge.from = 0.3;
  hinge.peak = 0.7;
  const Bar bar = roundBar(with({hinge}));

  // E I = 3 G (Ip / 2) over 0.4 of the length; Ip = J of a circle.
  const double polar = 0.5 * kPi * std::pow(kBarRadius_m, 4);
  const double expected = 1.5 * kBarShear_Pa * polar / (0.4 * kBarLength_m);
  EXPECT_NEAR(1.0 / bar.model.graspCompliance(0.9 * kBarLength_m) / expected, 1.0,
              0.01);  // ramp ends between nodes
}

TEST(TwistPattern, TheGraspForcePullsAgainstTheMotionOfTheWholePattern) {
  TwistOperation own;
  TwistOperation hinge = about({-0.05, 0.0, 0.06}, {0.05, 0.0, 0.06}, TwistProfile::kSmoothRamp);
  hinge.coordinate = TwistCoordinate::kArc;
  hinge.from = 0.1;
  hinge.peak = 0.6;
  hinge.ratio = 0.3;
  const Bar bar = roundBar(with({own, hinge}));
  const TwistState state{0.9 * kBarLength_m, 0.7};
  const Vec3 rest{0.0, 0.038, 0.9 * kBarLength_m};
  const Vec3 grip = bar.model.toDeformed_m(rest, state);

  const Vec3 force = bar.model.graspForce_N(state, grip);

  // Virtual work: force . d grip = - torque d angle.
  constexpr double kStep = 1e-6;
  const Vec3 way =
      (bar.model.toDeformed_m(rest, {state.graspArc_m, state.graspAngle_rad + kStep}) - grip) / kStep;
  EXPECT_NEAR(dot(force, way) / bar.model.torque_Nm(state), -1.0, 1e-4);
  EXPECT_NEAR(norm(cross(force, way)) / (norm(force) * norm(way)), 0.0, 1e-4);
}

TEST(TwistPattern, TheGraspFrameFollowsTheAxisOfTheStrongestOperation) {
  const Bar bar = roundBar(with({rigid({1, 0, 0}, 0.5), rigid({0, 1, 0}, -2.0)}));

  const AxisFrame frame = bar.model.graspFrame(0.1);

  EXPECT_EQ(frame.tangent, (Vec3{0, 1, 0}));
  EXPECT_NEAR(norm(frame.centre_m), 0.0, 1e-15) << "the foot of (0, 0, 0.1) on the y axis";
  EXPECT_NEAR(norm(cross(frame.e1, frame.e2) - frame.tangent), 0.0, 1e-15);
}

TEST(TwistPattern, ToRestUndoesEveryListOfOperations) {
  TwistOperation own;
  TwistOperation hinge = about({0.0, -0.05, 0.09}, {0.0, 0.05, 0.09}, TwistProfile::kSmoothRamp);
  hinge.coordinate = TwistCoordinate::kArc;
  hinge.from = 0.2;
  hinge.peak = 0.8;
  hinge.ratio = 0.3;
  const TwistOperation chord = about({0.02, 0.01, 0.0}, {0.05, 0.0, 0.09}, TwistProfile::kSmoothTent);
  const std::vector<std::pair<std::vector<TwistOperation>, double>> lists{
      {{own}, 1e-12},  {{chord}, 1e-15},     {{own, chord}, 1e-12},
      {{hinge}, 1e-9}, {{own, hinge}, 1e-9}, {{hinge, own}, 1e-9}};
  for (const auto& [list, tolerance] : lists) {
    const Bar bar = bentBar(with(list), 1.2);
    const TwistState state{0.7 * bar.length_m(), 1.0};
    double worst = 0.0;
    for (std::size_t v = 0; v < bar.mesh.vertices_m.size(); v += 7) {
      const Vec3& p = bar.mesh.vertices_m[v];
      worst = std::max(worst, norm(bar.model.toRest_m(bar.model.toDeformed_m(p, state), state) - p));
    }
    EXPECT_LT(worst, tolerance) << list.size();
  }
}

TEST(TwistPattern, AnElasticTwistNeedsAnOrganAlongItsAxis) {
  TwistOperation beside = about({0.0, 0.0, 1.0}, {0.0, 0.0, 2.0}, TwistProfile::kElastic);
  try {
    (void)roundBar(with({beside}));
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadParameter);
    EXPECT_EQ(error.where(), "twist operation 1");
  }
}

}  // namespace
}  // namespace torsio
