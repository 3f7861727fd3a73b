// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metrics/metric_cards.h"

#include <algorithm>
#include <array>

#include "sim/base/contracts.h"

namespace torsio {

namespace {

constexpr Direction kLower = Direction::kLowerIsBetter;
constexpr Direction kHigher = Direction::kHigherIsBetter;
constexpr Direction kNeither = Direction::kNeither;
constexpr std::string_view kTask = "task start to task end";
constexpr std::string_view kHolding = "while the organ is held";

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
     "-ln(T^3 / peak^2 x integral of jerk^2) of the angular speed, filtered at 10 Hz", "1", kHolding,
     kHigher},
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
     "standard deviation of the angle while holding", "rad", "hold", kLower},
    {"twist.axis_wander", "Wander about the axis",
     "How well the tip kept its distance from the axis of the twist.",
     "root mean square of radius - mean radius", "m", kHolding, kLower},
    {"force.mean", "Mean force", "Mean force on the tissue.", "impulse / time, filtered at 20 Hz", "N",
     kHolding, kLower},
    {"force.peak", "Peak force", "Largest force on the tissue.", "maximum, filtered at 20 Hz", "N", kHolding,
     kLower},
    {"force.peak_raw", "Peak force, unfiltered", "Largest single sample.", "maximum", "N", kHolding, kLower},
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
    {"torque.peak", "Peak torque", "Largest torque on the tissue.", "maximum, filtered at 20 Hz", "N m",
     kHolding, kLower},
    {"torque.violations", "Torque violations", "How often the allowed torque was exceeded.",
     "excursions above the limit, merged below 50 ms, ignored below 10 ms", "count", kHolding, kLower},
    {"torque.release_rate", "Abruptness of release", "How suddenly the torque was let go.",
     "largest fall of |torque| per second", "N m/s", "release", kLower},
    {"work.delivered", "Work done on the tissue", "Energy put into the organ by twisting.",
     "integral of torque x d angle where positive", "J", kHolding, kLower},
    {"work.loop", "Torque-angle loop", "Energy that the organ did not give back.",
     "work delivered - work returned", "J", kHolding, kNeither},
    {"shear.over_limit", "Time of excessive shear",
     "How long the grasped patch was sheared beyond its limit.",
     "samples with patch shear stress above the limit / rate", "s", kHolding, kLower},
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
