// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/catalogue/quantity.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

#include "sim/core/angle.h"
#include "sim/core/contracts.h"
#include "sim/core/load_decimals.h"

namespace torsio {

namespace {

constexpr ShownUnit kNumber{"", 1.0, 0};
constexpr ShownUnit kNumber1{"", 1.0, 1};
constexpr ShownUnit kNumber2{"", 1.0, 2};
constexpr ShownUnit kPercent{"%", 100.0, 0};
constexpr ShownUnit kSeconds{"s", 1.0, 1};
constexpr ShownUnit kDegrees0{"\u00b0", kDegreesPerRadian, 0};
constexpr ShownUnit kDegrees1{"\u00b0", kDegreesPerRadian, 1};
constexpr ShownUnit kDegrees2{"\u00b0", kDegreesPerRadian, 2};
constexpr ShownUnit kNewtons{"N", 1.0, kForceDecimals};
constexpr ShownUnit kNewtonMetres{"N m", 1.0, kTorqueDecimals};
constexpr double kNoLeast = -std::numeric_limits<double>::infinity();

constexpr Direction kLower = Direction::kLowerIsBetter;
constexpr Direction kHigher = Direction::kHigherIsBetter;
constexpr Direction kNeither = Direction::kNeither;
constexpr Phrase kTask = Text::tr("task start to task end");
constexpr Phrase kHolding = Text::tr("while the organ is held");
constexpr Phrase kTouching = Text::tr("from the first contact to the last");
constexpr Phrase kStopAtTarget =
    Text::tr("Slow down before the target, and let go only while you are on it.");
constexpr Phrase kFindDirection =
    Text::tr("Turn a little and look which way the folds open before you go on.");
constexpr Phrase kGripGently =
    Text::tr("Grip more gently: tissue without blood bears only half the pressure.");
constexpr Phrase kRest = Text::tr("Rest between the stages, so that blood returns slowly.");
constexpr Phrase kPressLess = Text::tr("Press less while you turn; the grip holds the tissue.");

// clang-format off
// For an organ that starts twisted by phi_0; limits, d (hands off) and q_c come from its scene.
constexpr std::array kRows = std::to_array<QuantityRow>({
    {Quantity::kOnTarget, "twist.on_target", Text::tr("Twists on target"),
     Text::tr("Share of the twists that were let go within the tolerance of the target."),
     Text::tr("twists on target / completed twists"), "1", kPercent, kHigher, Text::tr("whole run"),
     QuantityScope::kRun, {.asked = true, .inTrend = true, .advice = kStopAtTarget}},
    {Quantity::kTargetsReached, "twist.targets_reached", Text::tr("Targets reached"),
     Text::tr("Number of the twists that were let go within the tolerance of the target."),
     Text::tr("count of completed twists with |angle at letting go - target| <= tolerance"), "count",
     kNumber, kHigher, Text::tr("whole run"), QuantityScope::kRun,
     {.kind = QuantityKind::kCount, .asked = true, .advice = kStopAtTarget}},
    {Quantity::kCompletedTwists, "twist.completed", Text::tr("Twists completed"),
     Text::tr("Number of the twists that were let go; the others are counted apart."),
     Text::tr("count of twists that were let go"), "count", kNumber, kHigher, Text::tr("whole run"),
     QuantityScope::kRun,
     {.kind = QuantityKind::kCount, .advice = Text::tr("Grip again as soon as the organ has sprung back.")}},
    {Quantity::kShortestHold, "twist.shortest_hold", Text::tr("Shortest hold on target"),
     Text::tr("How long the angle was on target before letting go, in the twist on target where that "
         "was shortest."),
     Text::tr("min over twists on target of the last stay inside target +- tolerance"), "s", kSeconds,
     kHigher, Text::tr("whole run"), QuantityScope::kRun,
     {.advice = Text::tr("Stay still on the target before you let go."), .missing = Text::tr("none")}},
    {Quantity::kTornTwists, "run.torn", Text::tr("Twists with lost samples"),
     Text::tr("How many twists the computer recorded with a gap of more than 20 ms; an untwisting "
         "counts as one."), Text::tr("count of twists with a gap of more than 20 ms"), "count", kNumber,
     kLower, Text::tr("whole run"), QuantityScope::kRun, {.kind = QuantityKind::kCount}},
    {Quantity::kTimesUnseen, "view.times_lost", Text::tr("Times out of view"),
     Text::tr("How often the tracker of the real arm, or other equipment, lost the instrument."),
     Text::tr("count of gaps: more than 20 ms and two and a half samples without a pose, or more than 0.2 s "
         "with the same pose bit for bit"), "count", kNumber, kLower, Text::tr("whole run"),
     QuantityScope::kRun, {.kind = QuantityKind::kCount}},
    {Quantity::kUnseen, "view.lost", Text::tr("Time out of view"),
     Text::tr("How long the instrument was lost in all; path and idle time leave this time out."),
     Text::tr("sum of the gaps"), "s", {"s", 1.0, 2}, kLower, Text::tr("whole run"), QuantityScope::kRun},
    {Quantity::kUnseenShare, "view.lost_share", Text::tr("Share of the time out of view"),
     Text::tr("Share of the recording in which the instrument was lost; above 5 % path and idle time are not "
         "measured."), Text::tr("sum of the gaps / time"), "1", {"%", 100.0, 1}, kLower,
     Text::tr("whole run"), QuantityScope::kRun},
    {Quantity::kTime, "time.total", Text::tr("Time"),
     Text::tr("How long a twist took, from the grip to the end of its return; of an untwisting the "
         "whole run."), Text::verbatim("t_end - t_start"), "s", kSeconds, kLower, kTask,
     QuantityScope::kHand,
     {.asked = true, .inTrend = true, .advice = Text::tr("Plan the turn before you grip, then do it without a pause.")}},
    {Quantity::kTipPath, "tip.path", Text::tr("Path of the tip"),
     Text::tr("How far the tip of the instrument travelled."),
     Text::tr("sum of |p(i+1) - p(i)|, pose filtered at 10 Hz"), "m", {"mm", 1000.0, 0}, kLower, kTask,
     QuantityScope::kHand},
    {Quantity::kAngularPath, "twist.path", Text::tr("Angular path"),
     Text::tr("How many degrees the instrument turned in all, back and forth."),
     Text::tr("sum of |angle(i+1) - angle(i)|, filtered at 10 Hz"), "rad", kDegrees0, kLower, kTask,
     QuantityScope::kGrip},
    {Quantity::kEconomy, "twist.economy", Text::tr("Economy of turning"),
     Text::tr("Share of the turning that the task needed."),
     Text::tr("|target angle| / angular path up to the end of the hold"), "1", kPercent, kHigher, kHolding,
     QuantityScope::kGrip, {.merit = {1.0, 0.1}, .advice = Text::tr("Avoid turning back and forth.")}},
    {Quantity::kIdleTime, "tip.idle", Text::tr("Idle time"),
     Text::tr("Time in which the tip hardly moved."),
     Text::tr("time with speed below 5 mm/s for at least 0.2 s"), "s", kSeconds, kLower, kTask,
     QuantityScope::kHand},
    {Quantity::kSparc, "twist.sparc", Text::tr("Smoothness (SPARC)"),
     Text::tr("Evenness of the turning; nearer 0 is smoother, about -1.4 is one clean turn."),
     Text::tr("spectral arc length of the angular speed up to 10 Hz, threshold 0.05, padding level 4"), "1",
     kNumber2, kHigher, kHolding, QuantityScope::kGrip,
     {.asked = true, .least = kNoLeast, .inTrend = true, .merit = {2.0, 0.0},
      .advice = Text::tr("Let speed rise and fall once, without stops.")}},
    {Quantity::kLdlj, "twist.ldlj", Text::tr("Smoothness (LDLJ)"),
     Text::tr("Jerkiness of the turning; compare only values with the same filter."),
     Text::tr("-ln(T^3 / peak^2 x integral of jerk^2) of the signed angular speed, filtered at 10 Hz"), "1",
     kNumber1, kHigher, kHolding, QuantityScope::kGrip, {.least = kNoLeast}},
    {Quantity::kLdljUnsigned, "twist.ldlj_unsigned", Text::tr("Smoothness (LDLJ, unsigned)"),
     Text::tr("The same of the speed without its direction, which has a kink at each reversal; to "
         "compare with programs that compute it so."),
     Text::tr("-ln(T^3 / peak^2 x integral of jerk^2) of |angular speed|, filtered at 10 Hz"), "1",
     kNumber1, kHigher, kHolding, QuantityScope::kGrip, {.least = kNoLeast}},
    {Quantity::kSubMovements, "twist.peaks", Text::tr("Sub-movements"),
     Text::tr("Number of separate pushes in the turning."),
     Text::tr("peaks of angular speed, prominence 5 % of the maximum, 0.1 s apart"), "count", kNumber,
     kLower, kHolding, QuantityScope::kGrip,
     {.kind = QuantityKind::kCount, .merit = {1.0, 2.0},
      .advice = Text::tr("One push instead of many small ones.")}},
    {Quantity::kOvershoot, "twist.overshoot", Text::tr("Overshoot"),
     Text::tr("How far the turn went beyond the target."),
     Text::tr("max of sign(target) x (angle - target) after first reaching it, at least 0"), "rad",
     kDegrees1, kLower, kHolding, QuantityScope::kGrip,
     {.asked = true, .inTrend = true, .merit = {1.0, 0.0349},
      .advice = Text::tr("Begin to slow down ten degrees before the target."),
      .moment = QuantityMoment::kFarthestTurn}},
    {Quantity::kExcursions, "twist.excursions", Text::tr("Excursions"),
     Text::tr("How often the turn left the target zone on the far side."),
     Text::tr("crossings of target + tolerance after first reaching the target"), "count", kNumber, kLower,
     kHolding, QuantityScope::kGrip, {.kind = QuantityKind::kCount, .over = OverTwists::kSum}},
    {Quantity::kTimeToTarget, "twist.time_to_target", Text::tr("Time to target"),
     Text::tr("When the target zone was first entered."), Text::tr("first time inside target +- tolerance"),
     "s", kSeconds, kLower, kHolding, QuantityScope::kGrip,
     {.merit = {1.0, 0.5},
      .advice = Text::tr("Turn in one confident movement."),
      .moment = QuantityMoment::kFromGrip}},
    {Quantity::kSettling, "twist.settling", Text::tr("Settling time"),
     Text::tr("When the target zone was entered for good."),
     Text::tr("start of the last stay inside target +- tolerance"), "s", kSeconds, kLower, kHolding,
     QuantityScope::kGrip,
     {.asked = true, .inTrend = true, .merit = {1.0, 0.5},
      .advice = Text::tr("Slow down before the target, then stay."), .moment = QuantityMoment::kFromGrip}},
    {Quantity::kTrackingRms, "twist.rmse", Text::tr("Tracking error (RMS)"),
     Text::tr("Typical distance from the prescribed course."),
     Text::tr("root of the mean of (angle - target course)^2"), "rad", kDegrees1, kLower, kHolding,
     QuantityScope::kGrip},
    {Quantity::kTrackingMean, "twist.mae", Text::tr("Tracking error (mean)"),
     Text::tr("Mean distance from the prescribed course."), Text::tr("mean of |angle - target course|"),
     "rad", kDegrees1, kLower, kHolding, QuantityScope::kGrip},
    {Quantity::kTrackingBias, "twist.bias", Text::tr("Tracking bias"),
     Text::tr("Whether the turn was ahead of or behind the course on average."),
     Text::tr("mean of angle - target course"), "rad", kDegrees1, kNeither, kHolding, QuantityScope::kGrip,
     {.least = kNoLeast}},
    {Quantity::kLag, "twist.lag", Text::tr("Lag"),
     Text::tr("How long the hand followed behind the course."),
     Text::tr("shift of at most 0.5 s that maximises the correlation"), "s", {"s", 1.0, 2}, kLower,
     kHolding, QuantityScope::kGrip, {.least = kNoLeast}},
    {Quantity::kTrackingWithoutLag, "twist.rmse_without_lag", Text::tr("Tracking error without lag"),
     Text::tr("What remains when the lag is taken out."), Text::tr("RMS error after shifting by the lag"),
     "rad", kDegrees1, kLower, kHolding, QuantityScope::kGrip},
    {Quantity::kHoldSteadiness, "twist.hold_steadiness", Text::tr("Steadiness of the hold"),
     Text::tr("How still the angle was kept."),
     Text::tr("standard deviation of the angle while holding, the hold filtered by itself at 10 Hz"), "rad",
     kDegrees2, kLower, Text::tr("hold"), QuantityScope::kGrip,
     {.asked = true, .merit = {1.0, 0.0087},
      .advice = Text::tr("Rest your forearm while you hold."), .moment = QuantityMoment::kHold}},
    {Quantity::kAxisWander, "twist.axis_wander", Text::tr("Wander about the axis"),
     Text::tr("How well the tip kept its distance from the axis of the twist."),
     Text::tr("root mean square of radius - mean radius"), "m", {"mm", 1000.0, 1}, kLower, kHolding,
     QuantityScope::kGrip},
    {Quantity::kMeanForce, "force.mean", Text::tr("Mean force"), Text::tr("Mean force on the tissue."),
     Text::tr("impulse / time, filtered at 20 Hz"), "N", kNewtons, kLower, kHolding, QuantityScope::kGrip},
    {Quantity::kPeakForce, "force.peak", Text::tr("Peak force"),
     Text::tr("Maximum force on the tissue, even if the device could not render it."),
     Text::tr("maximum of all samples, not filtered"), "N", kNewtons, kLower, kTouching,
     QuantityScope::kGrip,
     {.asked = true, .inTrend = true, .merit = {1.0, 0.2}, .advice = kPressLess,
      .moment = QuantityMoment::kPeakForce}},
    {Quantity::kDeviceForce, "force.device_peak", Text::tr("Peak force of the device"),
     Text::tr("Largest force commanded to the device."),
     Text::tr("maximum of all samples, not filtered"), "N", kNewtons, kNeither, kTouching,
     QuantityScope::kGrip},
    {Quantity::kHighForce, "force.p95", Text::tr("High force"),
     Text::tr("Force that was exceeded 5 % of the time."), Text::tr("0.95 quantile of type 7"), "N",
     kNewtons, kLower, kHolding, QuantityScope::kGrip},
    {Quantity::kForceImpulse, "force.impulse", Text::tr("Force-time integral"),
     Text::tr("Force added up over time."), Text::tr("integral of |F| dt"), "N s", {"N s", 1.0, 1}, kLower,
     kHolding, QuantityScope::kGrip},
    {Quantity::kForceRate, "force.rate", Text::tr("Largest force rate"),
     Text::tr("Most abrupt change of force."), Text::tr("max |dF/dt|, filtered at 20 Hz"), "N/s",
     {"N/s", 1.0, 1}, kLower, kHolding, QuantityScope::kGrip, {.over = OverTwists::kLargest}},
    {Quantity::kForceViolations, "force.violations", Text::tr("Force violations"),
     Text::tr("How often the allowed force was exceeded."),
     Text::tr("excursions above the limit, merged below 50 ms, ignored below 10 ms"), "count", kNumber,
     kLower, kHolding, QuantityScope::kGrip,
     {.kind = QuantityKind::kCount, .over = OverTwists::kSum, .asked = true, .advice = kPressLess,
      .moment = QuantityMoment::kPeakForce}},
    {Quantity::kForceViolationTime, "force.violation_time", Text::tr("Time above the force limit"),
     Text::tr("How long the allowed force was exceeded."), Text::tr("samples above the limit / rate"), "s",
     kSeconds, kLower, kHolding, QuantityScope::kGrip, {.over = OverTwists::kSum}},
    {Quantity::kForceExcess, "force.excess", Text::tr("Excess impulse"),
     Text::tr("Force above the limit added up over time."), Text::tr("integral of max(0, F - limit) dt"),
     "N s", {"N s", 1.0, 1}, kLower, kHolding, QuantityScope::kGrip, {.over = OverTwists::kSum}},
    {Quantity::kMeanTorque, "torque.mean", Text::tr("Mean torque"), Text::tr("Mean torque on the tissue."),
     Text::tr("impulse / time, filtered at 20 Hz"), "N m", kNewtonMetres, kLower, kHolding,
     QuantityScope::kGrip},
    {Quantity::kPeakTorque, "torque.peak", Text::tr("Peak torque"),
     Text::tr("Largest torque on the tissue."), Text::tr("maximum of all samples, not filtered"), "N m",
     kNewtonMetres, kLower, kTouching, QuantityScope::kGrip,
     {.asked = true, .advice = Text::tr("Do not turn beyond the target."), .moment = QuantityMoment::kPeakTorque}},
    {Quantity::kTorqueViolations, "torque.violations", Text::tr("Torque violations"),
     Text::tr("How often the allowed torque was exceeded."),
     Text::tr("excursions above the limit, merged below 50 ms, ignored below 10 ms"), "count", kNumber,
     kLower, kHolding, QuantityScope::kGrip, {.kind = QuantityKind::kCount, .over = OverTwists::kSum}},
    {Quantity::kReleaseRate, "torque.release_rate", Text::tr("Abruptness of release"),
     Text::tr("How suddenly the torque was let go."),
     Text::tr("largest fall of |torque| per second, filtered at 20 Hz with the hold before it"), "N m/s",
     {"N m/s", 1.0, kTorqueDecimals}, kLower, Text::tr("release"), QuantityScope::kGrip,
     {.merit = {1.0, 0.1},
      .advice = Text::tr("Turn back a little before you open the jaw."),
      .moment = QuantityMoment::kRelease}},
    {Quantity::kWorkDelivered, "work.delivered", Text::tr("Work done on the tissue"),
     Text::tr("Energy put into the organ by twisting."),
     Text::tr("integral of torque x d angle where positive; of the grip alone, torque filtered at 20 "
         "Hz, angle at 10 Hz"), "J", {"mJ", 1000.0, 1}, kLower, kHolding, QuantityScope::kGrip},
    {Quantity::kWorkLoop, "work.loop", Text::tr("Torque-angle loop"),
     Text::tr("Energy that the organ did not give back."), Text::tr("work delivered - work returned"), "J",
     {"mJ", 1000.0, 1}, kNeither, kHolding, QuantityScope::kGrip, {.least = kNoLeast}},
    {Quantity::kShearOverLimit, "shear.over_limit", Text::tr("Time of excessive shear"),
     Text::tr("How long the grasped patch was sheared beyond its limit."),
     Text::tr("samples with patch shear stress above the limit / rate"), "s", kSeconds, kLower, kHolding,
     QuantityScope::kGrip, {.over = OverTwists::kSum}},
    {Quantity::kUntwisted, "detorse.done", Text::tr("Untwisted"),
     Text::tr("Whether the organ stayed untwisted, open, perfused and intact without being held."),
     Text::tr("|phi| <= limit and patency >= least and flow >= least for d without hand and clip; jaw "
         "and force never at what tears the wall"), "1", kNumber, kHigher, kTask,
     QuantityScope::kUntwisting,
     {.kind = QuantityKind::kAnswer, .asked = true, .inTrend = true,
      .advice = Text::tr("Turn it back fully, then keep your hands off and check the blood flow.")}},
    {Quantity::kTimeToFlow, "detorse.time_to_flow", Text::tr("Time until blood flows"),
     Text::tr("When blood came back; undefined (censored at the end) where it did not."),
     Text::tr("first time from which flow >= q_c for 5 s; seconds of the hand"), "s", kSeconds, kLower,
     kTask, QuantityScope::kUntwisting,
     {.asked = true, .inTrend = true,
      .advice = Text::tr("Find the direction first, then turn without delay: time without blood counts."),
      .missing = Text::tr("blood did not come back")}},
    {Quantity::kDose, "detorse.dose", Text::tr("Ischaemic dose"),
     Text::tr("How much the organ has suffered for want of blood at most; from 1 on it is lost."),
     Text::tr("largest D"), "1", kNumber2, kLower, kTask, QuantityScope::kUntwisting,
     {.asked = true, .inTrend = true,
      .advice = Text::tr("Let blood flow return earlier, in stages if it takes long.")}},
    {Quantity::kDoseAtFlow, "detorse.dose_at_flow", Text::tr("Ischaemic dose when blood flows"),
     Text::tr("How much the organ had suffered when blood came back."),
     Text::tr("D at the time until blood flows"), "1", kNumber2, kLower, kTask, QuantityScope::kUntwisting,
     {.missing = Text::tr("blood did not come back")}},
    {Quantity::kResidual, "detorse.residual", Text::tr("Twist that remains"),
     Text::tr("How far the organ still was turned hands off."),
     Text::tr("|phi| d after hand and clip let go for the last time"), "rad", kDegrees0, kLower,
     Text::tr("after the last release"), QuantityScope::kUntwisting,
     {.asked = true, .inTrend = true, .advice = Text::tr("Turn on until nothing turns back once you let go.")}},
    {Quantity::kRelapse, "detorse.relapse", Text::tr("Relapse"),
     Text::tr("Whether the organ turned back after it was undone."),
     Text::tr("|phi| > relapse angle after it was undone"), "1", kNumber, kLower,
     Text::tr("after it was undone"), QuantityScope::kUntwisting,
     {.kind = QuantityKind::kAnswer, .asked = true,
      .advice = Text::tr("Turn slightly past the untwisted position before you let go.")}},
    {Quantity::kFirstDirection, "detorse.first_direction", Text::tr("First turn the right way"),
     Text::tr("Whether the first real turn went the right way."),
     Text::tr("sign of the first net turn of 15 degrees while held = -sign(phi_0)"), "1", kNumber, kHigher,
     kHolding, QuantityScope::kUntwisting,
     {.kind = QuantityKind::kAnswer, .asked = true, .advice = kFindDirection}},
    {Quantity::kWrongWay, "detorse.wrong_way", Text::tr("Turned the wrong way"),
     Text::tr("How far the organ was twisted beyond its initial twist."), Text::verbatim("max |phi| - |phi_0|"),
     "rad", kDegrees0, kLower, kTask, QuantityScope::kUntwisting, {.asked = true, .advice = kFindDirection}},
    {Quantity::kRegrips, "detorse.regrips", Text::tr("Re-grips"),
     Text::tr("How often the hand let go of an organ that was still twisted."),
     Text::tr("releases with |phi| > 30 degrees"), "count", kNumber, kLower, kTask,
     QuantityScope::kUntwisting,
     {.kind = QuantityKind::kCount, .asked = true, .inTrend = true,
      .advice = Text::tr("Use the whole range of your wrist before you take a new grip.")}},
    {Quantity::kLeastRegrips, "detorse.least_regrips", Text::tr("Least number of re-grips"),
     Text::tr("How often a hand that turns 155 degrees must let go at least; to read the re-grips "
         "against."), Text::tr("ceil(|phi_0| / 155 degrees) - 1"), "count", kNumber, kNeither,
     Text::tr("start"), QuantityScope::kUntwisting, {.kind = QuantityKind::kCount}},
    {Quantity::kSlipBack, "detorse.slip_back", Text::tr("Slipped back"),
     Text::tr("How far the organ turned back while the hand took a new grip."),
     Text::tr("sum of the rise of |phi| between a release and the next grip"), "rad", kDegrees0, kLower,
     Text::tr("between two grips"), QuantityScope::kUntwisting,
     {.asked = true, .inTrend = true, .advice = Text::tr("Set the clip before you let go.")}},
    {Quantity::kPeakJaw, "detorse.peak_jaw", Text::tr("Peak pressure of the jaw"),
     Text::tr("Largest pressure of the jaw on the wall."), Text::tr("max of jaw force / jaw area"), "Pa",
     {"kPa", 1e-3, 0}, kLower, kHolding, QuantityScope::kUntwisting,
     {.asked = true, .inTrend = true, .advice = kGripGently}},
    {Quantity::kPeakShear, "detorse.peak_shear", Text::tr("Peak shear of the wall"),
     Text::tr("Largest shear stress of the wall; needs the scene."),
     Text::tr("maximum over the wall and over time"), "Pa", {"kPa", 1e-3, 1}, kLower, kTask,
     QuantityScope::kUntwisting},
    {Quantity::kOverloadTime, "detorse.overload_time", Text::tr("Time of overload"),
     Text::tr("How long jaw or pull hurt the wall as it then was."),
     Text::tr("time with jaw pressure or force above limit x (1 - 0.5 min(D, 1))"), "s", kSeconds, kLower,
     kTask, QuantityScope::kUntwisting, {.asked = true, .inTrend = true, .advice = kGripGently}},
    {Quantity::kLeastPatency, "detorse.min_patency", Text::tr("Least patency"),
     Text::tr("Narrowest that the lumen was: 100 % open, 0 % closed."),
     Text::tr("min of the free cross-section at the waist"), "1", kPercent, kHigher, kTask,
     QuantityScope::kUntwisting},
    {Quantity::kVentedFirst, "detorse.vented_first", Text::tr("Let out first"),
     Text::tr("Whether the content was let out before the organ was turned."),
     Text::tr("way out open for 3 s in all before the first net turn of 15 degrees while held"), "1",
     kNumber, kHigher, kTask, QuantityScope::kUntwisting,
     {.kind = QuantityKind::kAnswer, .asked = true,
      .advice = Text::tr("Let the content out before you turn the organ.")}},
    {Quantity::kLongestStage, "detorse.longest_stage", Text::tr("Longest turn without a rest"),
     Text::tr("How far the organ was turned back at most between two rests; where the scene asks for "
         "stages."),
     Text::tr("max of |phi| where the stage began - |phi|; a stage begins where |phi| stayed within 5 "
         "degrees for the rest that is asked for"), "rad", kDegrees0, kLower, kTask,
     QuantityScope::kUntwisting, {.asked = true, .advice = kRest}},
    {Quantity::kInStages, "detorse.in_stages", Text::tr("Untwisted in stages"),
     Text::tr("Whether no turn without a rest was longer than the scene asks for."),
     Text::tr("longest turn without a rest <= stage + 15 degrees"), "1", kNumber, kHigher, kTask,
     QuantityScope::kUntwisting, {.kind = QuantityKind::kAnswer, .asked = true, .advice = kRest}},
});
// clang-format on

constexpr bool rowsAreCompleteAndOrdered() {
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    const QuantityRow& row = kRows[i];
    if (static_cast<std::size_t>(row.quantity) != i || row.id.empty() || row.name.empty() ||
        row.meaning.empty() || row.formula.empty() || row.unit.empty() || row.window.empty() ||
        (row.traits.asked && row.traits.advice.empty())) {
      return false;
    }
  }
  return kRows.size() == static_cast<std::size_t>(Quantity::kEnd);
}
static_assert(rowsAreCompleteAndOrdered(), "each quantity has one complete row, in the order of the enum");

}  // namespace

std::span<const QuantityRow> quantityRows() noexcept {
  return kRows;
}

const QuantityRow& rowOf(Quantity quantity) {
  TORSIO_EXPECTS(quantity < Quantity::kEnd);
  return kRows[static_cast<std::size_t>(quantity)];
}

std::optional<Quantity> quantityOf(std::string_view id) noexcept {
  const auto* const found =
      std::find_if(kRows.begin(), kRows.end(), [&](const QuantityRow& row) { return row.id == id; });
  return found == kRows.end() ? std::nullopt : std::optional(found->quantity);
}

std::string shownNumber(Quantity quantity, double value, int more) {
  const ShownUnit& shown = rowOf(quantity).shown;
  std::array<char, 64> digits{};
  std::snprintf(digits.data(), digits.size(), "%.*f", shown.decimals + more, value * shown.scale);
  const std::string text(digits.data());
  return text.front() == '-' ? "\u2212" + text.substr(1) : text;  // typographic minus
}

Text shownValue(Quantity quantity, double value, int more) {
  const QuantityRow& row = rowOf(quantity);
  if (row.traits.kind == QuantityKind::kAnswer) {
    return value > 0.5 ? Text::tr("yes") : Text::tr("no");
  }
  const std::string number = shownNumber(quantity, value, more);
  if (row.shown.unit.empty() || row.shown.unit == "\u00b0") {
    return number + std::string(row.shown.unit);
  }
  return Text::tr("%1 %2", number, row.shown.unit);
}

Text shownValue(Quantity quantity, const std::optional<double>& value) {
  return value ? shownValue(quantity, *value) : Text(rowOf(quantity).traits.missing);
}

Text titleWithUnit(Quantity quantity) {
  const QuantityRow& row = rowOf(quantity);
  return row.shown.unit.empty() ? Text(row.name) : Text::tr("%1 (%2)", row.name, row.shown.unit);
}

}  // namespace torsio
