// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metrics/metric_cards.h"

#include <algorithm>
#include <array>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr Direction kLower = Direction::kLowerIsBetter;
constexpr Direction kHigher = Direction::kHigherIsBetter;
constexpr Direction kNeither = Direction::kNeither;
constexpr std::string_view kTask = "task start to task end";
constexpr std::string_view kHolding = "while the organ is held";
constexpr std::string_view kTouching = "from the first contact to the last";

constexpr std::array kCards = std::to_array<MetricCard>({
    {"time.total", "Time", "How long the exercise took.", "t_end - t_start", "s", kTask, kLower},
    {"tip.path", "Path of the tip", "How far the tip of the instrument travelled.",
     "sum of |p(i+1) - p(i)|, pose filtered at 10 Hz", "m", kTask, kLower},
    {"twist.path", "Angular path", "How many degrees the instrument turned in all, back and forth.",
     "sum of |angle(i+1) - angle(i)|, filtered at 10 Hz", "rad", kTask, kLower},
    {"twist.economy", "Economy of turning", "Share of the turning that the task needed.",
     "|target angle| / angular path up to the end of the hold", "1", kHolding, kHigher},
    {"tip.idle", "Idle time", "Time in which the tip hardly moved.",
     "time with speed below 5 mm/s for at least 0.2 s", "s", kTask, kLower},
    {"twist.sparc", "Smoothness (SPARC)",
     "Evenness of the turning; nearer 0 is smoother, about -1.4 is one clean turn.",
     "spectral arc length of the angular speed up to 10 Hz, threshold 0.05, padding level 4", "1", kHolding,
     kHigher},
    {"twist.ldlj", "Smoothness (LDLJ)", "Jerkiness of the turning; compare only values with the same filter.",
     "-ln(T^3 / peak^2 x integral of jerk^2) of the signed angular speed, filtered at 10 Hz", "1", kHolding,
     kHigher},
    {"twist.ldlj_unsigned", "Smoothness (LDLJ, unsigned)",
     "The same of the speed without its direction, which has a kink at each turning back; to compare with "
     "programs that take that.",
     "-ln(T^3 / peak^2 x integral of jerk^2) of |angular speed|, filtered at 10 Hz", "1", kHolding, kHigher},
    {"twist.peaks", "Sub-movements", "Number of separate pushes in the turning.",
     "peaks of angular speed, prominence 5 % of the maximum, 0.1 s apart", "count", kHolding, kLower},
    {"twist.overshoot", "Overshoot", "How far the turn went beyond the target.",
     "max of sign(target) x (angle - target) after first reaching it, at least 0", "rad", kHolding, kLower},
    {"twist.excursions", "Excursions", "How often the turn left the target zone on the far side.",
     "crossings of target + tolerance after first reaching the target", "count", kHolding, kLower},
    {"twist.time_to_target", "Time to target", "When the target zone was first entered.",
     "first time inside target +- tolerance", "s", kHolding, kLower},
    {"twist.settling", "Settling time", "When the target zone was entered for good.",
     "start of the last stay inside target +- tolerance", "s", kHolding, kLower},
    {"twist.rmse", "Tracking error (RMS)", "Typical distance from the prescribed course.",
     "root of the mean of (angle - target course)^2", "rad", kHolding, kLower},
    {"twist.mae", "Tracking error (mean)", "Mean distance from the prescribed course.",
     "mean of |angle - target course|", "rad", kHolding, kLower},
    {"twist.bias", "Tracking bias", "Whether the turn was ahead of or behind the course on average.",
     "mean of angle - target course", "rad", kHolding, kNeither},
    {"twist.lag", "Lag", "How long the hand followed behind the course.",
     "shift of at most 0.5 s that maximises the correlation", "s", kHolding, kLower},
    {"twist.rmse_without_lag", "Tracking error without lag", "What remains when the lag is taken out.",
     "RMS error after shifting by the lag", "rad", kHolding, kLower},
    {"twist.hold_steadiness", "Steadiness of the hold", "How still the angle was kept.",
     "standard deviation of the angle while holding, the hold filtered by itself at 10 Hz", "rad", "hold",
     kLower},
    {"twist.axis_wander", "Wander about the axis",
     "How well the tip kept its distance from the axis of the twist.",
     "root mean square of radius - mean radius", "m", kHolding, kLower},
    {"force.mean", "Mean force", "Mean force on the tissue.", "impulse / time, filtered at 20 Hz", "N",
     kHolding, kLower},
    {"force.peak", "Peak force", "Largest force on the tissue, whatever the device could give of it.",
     "maximum of all samples, not filtered", "N", kTouching, kLower},
    {"force.device_peak", "Peak force of the device", "Largest force that the device was told to give.",
     "maximum of all samples, not filtered", "N", kTouching, kNeither},
    {"force.p95", "High force", "Force that was exceeded 5 % of the time.", "0.95 quantile of type 7", "N",
     kHolding, kLower},
    {"force.impulse", "Force-time integral", "Force added up over time.", "integral of |F| dt", "N s",
     kHolding, kLower},
    {"force.rate", "Largest force rate", "Most abrupt change of force.", "max |dF/dt|, filtered at 20 Hz",
     "N/s", kHolding, kLower},
    {"force.violations", "Force violations", "How often the allowed force was exceeded.",
     "excursions above the limit, merged below 50 ms, ignored below 10 ms", "count", kHolding, kLower},
    {"force.violation_time", "Time above the force limit", "How long the allowed force was exceeded.",
     "samples above the limit / rate", "s", kHolding, kLower},
    {"force.excess", "Excess impulse", "Force above the limit added up over time.",
     "integral of max(0, F - limit) dt", "N s", kHolding, kLower},
    {"torque.mean", "Mean torque", "Mean torque on the tissue.", "impulse / time, filtered at 20 Hz", "N m",
     kHolding, kLower},
    {"torque.peak", "Peak torque", "Largest torque on the tissue.", "maximum of all samples, not filtered",
     "N m", kTouching, kLower},
    {"torque.violations", "Torque violations", "How often the allowed torque was exceeded.",
     "excursions above the limit, merged below 50 ms, ignored below 10 ms", "count", kHolding, kLower},
    {"torque.release_rate", "Abruptness of release", "How suddenly the torque was let go.",
     "largest fall of |torque| per second, filtered at 20 Hz with the hold before it", "N m/s", "release",
     kLower},
    {"work.delivered", "Work done on the tissue", "Energy put into the organ by twisting.",
     "integral of torque x d angle where positive; of the grip alone torque filtered at 20 Hz, angle at 10 "
     "Hz",
     "J", kHolding, kLower},
    {"work.loop", "Torque-angle loop", "Energy that the organ did not give back.",
     "work delivered - work returned", "J", kHolding, kNeither},
    {"shear.over_limit", "Time of excessive shear",
     "How long the grasped patch was sheared beyond its limit.",
     "samples with patch shear stress above the limit / rate", "s", kHolding, kLower},
    // Of an organ that came twisted by phi_0; limits, d (hands off) and q_c are those of its scene.
    {"detorse.done", "Untwisted",
     "Whether the organ lay untwisted, open, supplied and whole with nobody holding it: 1 yes, 0 no.",
     "|phi| <= limit and patency >= least and flow >= least for d without hand and clip; jaw and force never "
     "at "
     "what tears the wall",
     "1", kTask, kHigher},
    {"detorse.time_to_flow", "Time until blood flows",
     "When blood came back. Undefined (censored at the end) where it did not.",
     "first time from which flow >= q_c for 5 s; seconds of the hand", "s", kTask, kLower},
    {"detorse.dose", "Ischaemic dose",
     "How much the organ has suffered for want of blood at most; from 1 on it is lost.", "largest D", "1",
     kTask, kLower},
    {"detorse.dose_at_flow", "Ischaemic dose when blood flows",
     "How much the organ had suffered when blood came back.", "D at the time until blood flows", "1", kTask,
     kLower},
    {"detorse.residual", "Twist that remains", "How far the organ still was turned hands off.",
     "|phi| d after hand and clip let go for the last time", "rad", "after the last release", kLower},
    {"detorse.relapse", "Relapse", "Whether the organ turned back after it was undone: 1 yes, 0 no.",
     "|phi| > relapse angle after it was undone", "1", "after it was undone", kLower},
    {"detorse.first_direction", "First direction",
     "Whether the first real turn went the right way: 1 yes, 0 no.",
     "sign of the first net turn of 15 degrees while held = -sign(phi_0)", "1", kHolding, kHigher},
    {"detorse.wrong_way", "Turned the wrong way", "How far the organ was turned beyond how it came.",
     "max |phi| - |phi_0|", "rad", kTask, kLower},
    {"detorse.regrips", "Re-grips", "How often the hand let go of an organ that was still twisted.",
     "releases with |phi| > 30 degrees", "count", kTask, kLower},
    {"detorse.least_regrips", "Least number of re-grips",
     "How often a hand that turns 155 degrees must let go at least; to read the re-grips against.",
     "ceil(|phi_0| / 155 degrees) - 1", "count", "start", kNeither},
    {"detorse.slip_back", "Slipped back", "How far the organ turned back while the hand took a new grip.",
     "sum of the rise of |phi| between a release and the next grip", "rad", "between two grips", kLower},
    {"detorse.peak_jaw", "Peak pressure of the jaw", "Largest pressure of the jaw on the wall.",
     "max of jaw force / jaw area", "Pa", kHolding, kLower},
    {"detorse.peak_shear", "Peak shear of the wall", "Largest shear stress of the wall; needs the scene.",
     "maximum over the wall and over time", "Pa", kTask, kLower},
    {"detorse.overload_time", "Time of overload", "How long jaw or pull hurt the wall as it then was.",
     "time with jaw pressure or force above limit x (1 - 0.5 min(D, 1))", "s", kTask, kLower},
    {"detorse.min_patency", "Least patency", "Narrowest that the lumen was: 1 open, 0 closed.",
     "min of the free cross-section at the waist", "1", kTask, kHigher},
    {"detorse.vented_first", "Let out first",
     "Whether the content was let out before the organ was turned: 1 yes, 0 no.",
     "way out open for 3 s in all before the first net turn of 15 degrees while held", "1", kTask, kHigher},
    {"detorse.longest_stage", "Longest turn without a rest",
     "How far the organ was turned back at most between two rests; where the scene asks for stages.",
     "max of |phi| where the stage began - |phi|; a stage begins where |phi| stayed within 5 degrees for the "
     "rest that is asked for",
     "rad", kTask, kLower},
    {"detorse.in_stages", "Untwisted in stages",
     "Whether no turn without a rest was longer than the scene asks for: 1 yes, 0 no.",
     "longest turn without a rest <= stage + 15 degrees", "1", kTask, kHigher},
});

}  // namespace

std::span<const MetricCard> metricCards() {
  return kCards;
}

const MetricCard& metricCard(std::string_view id) {
  const auto* found =
      std::find_if(kCards.begin(), kCards.end(), [&](const MetricCard& card) { return card.id == id; });
  TORSIO_EXPECTS(found != kCards.end());
  return *found;
}

std::string metricTitle(const std::string& metric) {
  if (metric == kOnTargetMetric) {
    return "Twists on target";
  }
  if (metric == kTargetsReachedMetric) {
    return "Targets reached";
  }
  for (const MetricCard& card : metricCards()) {
    if (card.id == metric) {
      return std::string(card.name);
    }
  }
  return metric;
}

}  // namespace torsio
