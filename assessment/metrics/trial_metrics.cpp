// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metrics/trial_metrics.h"

#include <algorithm>
#include <cmath>

#include "assessment/metrics/loading.h"
#include "assessment/metrics/movement.h"
#include "assessment/metrics/signal.h"
#include "assessment/metrics/tracking.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr double kRate_Hz = 1000.0;

/// The trial on a uniform grid, raw and filtered.
struct Prepared {
  std::size_t n = 0;
  std::size_t lost = 0;
  std::vector<Vec3> tip;
  std::vector<double> angle;  // filtered
  std::vector<double> angleRaw, target, force, torque, shear;
  std::vector<TracePhase> phase;
  std::vector<double> tipSpeed;
};

void checkList(const std::vector<double>& list, std::size_t n, Phrase name) {
  if (!list.empty() && list.size() != n) {
    throw Error(ErrorCode::kBadData, Text::verbatim("the lists of a trial differ in length"), name,
                Text::verbatim("Read the run again."));
  }
  for (const double value : list) {
    if (!std::isfinite(value)) {
      throw Error(ErrorCode::kBadData, Text::verbatim("a trial holds a value that is not a number"), name,
                  Text::verbatim("Record the trial again."));
    }
  }
}

void check(const TrialTrace& trace) {
  const std::size_t n = trace.times_us.size();
  if (n < 2) {
    throw Error(ErrorCode::kBadData, Text::verbatim("a run has fewer than two samples"), Text::tr("run"),
                Text::verbatim("Record it again."));
  }
  if (trace.phase.size() != n || (!trace.tip_m.empty() && trace.tip_m.size() != n)) {
    throw Error(ErrorCode::kBadData, Text::verbatim("the lists of a trial differ in length"), Text::tr("run"),
                Text::verbatim("Read the run again."));
  }
  checkList(trace.angle_rad, n, Text::verbatim("angle"));
  checkList(trace.targetAngle_rad, n, Text::verbatim("target angle"));
  checkList(trace.force_N, n, Text::verbatim("force"));
  checkList(trace.deviceForce_N, n, Text::verbatim("force of the device"));
  checkList(trace.torque_Nm, n, Text::verbatim("torque"));
  checkList(trace.patchShear_Pa, n, Text::verbatim("patch shear"));
  for (const Vec3& tip : trace.tip_m) {
    if (!isFinite(tip)) {
      throw Error(ErrorCode::kBadData, Text::verbatim("a trial holds a value that is not a number"),
                  Text::verbatim("tip"), Text::verbatim("Record the trial again."));
    }
  }
}

bool uniform(const std::vector<std::int64_t>& times_us) {
  for (std::size_t i = 1; i < times_us.size(); ++i) {
    if (times_us[i] - times_us[i - 1] != 1000) {
      return false;
    }
  }
  return true;
}

std::vector<double> onGrid(const TrialTrace& trace, const std::vector<double>& list, bool alreadyUniform) {
  if (list.empty() || alreadyUniform) {
    return list;
  }
  return resampleUniform(trace.times_us, {list}, kRate_Hz).channels[0];
}

std::vector<double> filtered(std::vector<double> list, double cutoff_Hz) {
  if (list.empty()) {
    return list;
  }
  return lowPass(list, cutoff_Hz, kRate_Hz);
}

Prepared prepare(const TrialTrace& trace) {
  check(trace);
  Prepared out;
  const bool grid = uniform(trace.times_us);
  if (!grid) {
    out.lost = resampleUniform(trace.times_us, {}, kRate_Hz).lost;
  }
  for (const std::size_t sample : samplesInForce(trace.times_us, kRate_Hz)) {
    out.phase.push_back(trace.phase[sample]);
    if (!trace.targetAngle_rad.empty()) {
      out.target.push_back(trace.targetAngle_rad[sample]);
    }
  }
  out.n = out.phase.size();
  out.angleRaw = onGrid(trace, trace.angle_rad, grid);
  out.angle = filtered(out.angleRaw, kPoseCutoff_Hz);
  out.force = onGrid(trace, trace.force_N, grid);
  out.torque = onGrid(trace, trace.torque_Nm, grid);
  out.shear = onGrid(trace, trace.patchShear_Pa, grid);
  if (trace.tip_m.empty()) {
    return out;
  }
  std::vector<std::vector<double>> axes(3);
  for (const Vec3& tip : trace.tip_m) {
    axes[0].push_back(tip.x);
    axes[1].push_back(tip.y);
    axes[2].push_back(tip.z);
  }
  std::vector<std::vector<double>> rates;
  for (std::vector<double>& axis : axes) {
    axis = filtered(onGrid(trace, axis, grid), kPoseCutoff_Hz);
    rates.push_back(derivative(axis, kRate_Hz));
  }
  for (std::size_t i = 0; i < out.n; ++i) {
    out.tip.push_back({axes[0][i], axes[1][i], axes[2][i]});
    out.tipSpeed.push_back(norm(Vec3{rates[0][i], rates[1][i], rates[2][i]}));
  }
  return out;
}

/// Finds the longest range of samples whose phase satisfies `test`: [first, last).
template <class Test>
std::pair<std::size_t, std::size_t> longest(const std::vector<TracePhase>& phase, Test test) {
  std::pair<std::size_t, std::size_t> best{0, 0};
  for (std::size_t i = 0; i < phase.size();) {
    std::size_t end = i;
    while (end < phase.size() && test(phase[end])) {
      ++end;
    }
    if (end - i > best.second - best.first) {
      best = {i, end};
    }
    i = std::max(end, i + 1);
  }
  return best;
}

bool isHeld(TracePhase phase) {
  return phase == TracePhase::kTwisting || phase == TracePhase::kHolding;
}

template <class T>
std::span<const T> part(const std::vector<T>& list, std::pair<std::size_t, std::size_t> stretch) {
  if (list.empty()) {
    return {};
  }
  return std::span<const T>(list).subspan(stretch.first, stretch.second - stretch.first);
}

class Measurer {
 public:
  Measurer(const TrialTrace& trace, const Prepared& signals, const TrialTargets& targets, TrialMetrics& out)
      : trace_(trace), s_(signals), targets_(targets), out_(out), held_(longest(signals.phase, isHeld)) {}

  void run() {
    set(Quantity::kTime, static_cast<double>(s_.n - 1) / kRate_Hz);
    if (!s_.tip.empty()) {
      set(Quantity::kTipPath, pathLength(s_.tip));
      set(Quantity::kIdleTime, idleTime(s_.tipSpeed, kIdleTip_m_per_s, kRate_Hz));
    }
    if (!s_.angle.empty()) {
      set(Quantity::kAngularPath, angularPath(s_.angle));
    }
    measurePeaks();
    if (held_.second - held_.first < 2) {
      return;
    }
    if (!s_.angle.empty()) {
      measureTurn();
    }
    measureLoads();
  }

 private:
  void set(Quantity quantity, Outcome<double> value) { out_.set(quantity, std::move(value)); }

  /// Filters a part of the trial separately: filtering the whole trial would smear the release into the end
  /// of the hold.
  [[nodiscard]] static std::vector<double> calm(const std::vector<double>& raw,
                                                std::pair<std::size_t, std::size_t> stretch,
                                                double cutoff_Hz) {
    const std::span<const double> signal = part(raw, stretch);
    return filtered({signal.begin(), signal.end()}, cutoff_Hz);
  }

  /// Unfiltered: limits apply to these peaks, and a filter would flatten them.
  void measurePeaks() {
    const auto largest = [this](Quantity quantity, const std::vector<double>& list) {
      double most = 0.0;
      for (const double value : list) {
        most = std::max(most, std::abs(value));
      }
      if (!list.empty()) {
        set(quantity, most);
      }
    };
    largest(Quantity::kPeakForce, trace_.force_N);
    largest(Quantity::kDeviceForce, trace_.deviceForce_N);
    largest(Quantity::kPeakTorque, trace_.torque_Nm);
  }

  void measureTurn() {
    const std::vector<double> angle = calm(s_.angleRaw, held_, kPoseCutoff_Hz);
    std::vector<double> speed = derivative(angle, kRate_Hz);
    set(Quantity::kLdlj, logDimensionlessJerk(speed, kRate_Hz));  // signed: the absolute value would have a
                                                                  // kink at each reversal
    for (double& value : speed) {
      value = std::abs(value);
    }
    set(Quantity::kLdljUnsigned, logDimensionlessJerk(speed, kRate_Hz));
    set(Quantity::kSparc, spectralArcLength(speed, kRate_Hz));
    set(Quantity::kSubMovements, static_cast<double>(speedPeaks(speed, kRate_Hz).size()));
    const double target_rad = s_.target.empty() ? targets_.target_rad : s_.target[held_.second - 1];
    if (target_rad != 0.0) {
      set(Quantity::kEconomy, economy(std::abs(target_rad), angularPath(angle)));
      const TargetApproach approach = targetApproach(angle, target_rad, targets_.tolerance_rad, kRate_Hz);
      set(Quantity::kOvershoot, approach.overshoot);
      set(Quantity::kExcursions, static_cast<double>(approach.excursions));
      set(Quantity::kTimeToTarget, approach.timeToTarget);
      set(Quantity::kSettling, approach.settling);
    }
    const std::span<const double> course = part(s_.target, held_);
    if (std::any_of(course.begin(), course.end(), [&](double target) { return target != target_rad; })) {
      const Outcome<TrackingError> error = trackingError(angle, course, kRate_Hz);
      set(Quantity::kTrackingRms, error->rmse);
      set(Quantity::kTrackingMean, error->mae);
      set(Quantity::kTrackingBias, error->bias);
      set(Quantity::kLag, error->lag_s);
      set(Quantity::kTrackingWithoutLag, error->rmseWithoutLag);
    }
    const auto still = longest(s_.phase, [](TracePhase phase) { return phase == TracePhase::kHolding; });
    set(Quantity::kHoldSteadiness, holdSteadiness(calm(s_.angleRaw, still, kPoseCutoff_Hz)));
    if (targets_.axisPoint_m && !s_.tip.empty()) {
      set(Quantity::kAxisWander, axisWander(part(s_.tip, held_), *targets_.axisPoint_m, targets_.axis));
    }
  }

  void measureLoads() {
    if (!s_.force.empty()) {
      const std::vector<double> force = calm(s_.force, held_, kForceCutoff_Hz);
      const Outcome<Loading> load = loadingOf(force, kRate_Hz);
      set(Quantity::kMeanForce, load->mean);
      set(Quantity::kHighForce, load->p95);
      set(Quantity::kForceImpulse, load->impulse);
      set(Quantity::kForceRate, load->largestRate);
      if (targets_.forceLimit_N) {
        const Violations violations = violationsOf(force, *targets_.forceLimit_N, kRate_Hz);
        set(Quantity::kForceViolations, static_cast<double>(violations.count));
        set(Quantity::kForceViolationTime, violations.time_s);
        set(Quantity::kForceExcess, violations.excessImpulse);
      }
    }
    if (!s_.torque.empty()) {
      const std::vector<double> torque = calm(s_.torque, held_, kForceCutoff_Hz);
      std::vector<double> magnitude;
      for (const double value : torque) {
        magnitude.push_back(std::abs(value));
      }
      const Outcome<Loading> load = loadingOf(magnitude, kRate_Hz);
      set(Quantity::kMeanTorque, load->mean);
      if (targets_.torqueLimit_Nm) {
        set(Quantity::kTorqueViolations,
            static_cast<double>(violationsOf(magnitude, *targets_.torqueLimit_Nm, kRate_Hz).count));
      }
      const auto letGo = longest(s_.phase, [](TracePhase phase) { return phase == TracePhase::kReleasing; });
      set(Quantity::kReleaseRate, releaseRate(part(filtered(s_.torque, kForceCutoff_Hz), letGo), kRate_Hz));
      if (!s_.angle.empty()) {
        const Outcome<TwistWork> work = twistWork(torque, calm(s_.angleRaw, held_, kPoseCutoff_Hz));
        set(Quantity::kWorkDelivered, work->delivered_J);
        set(Quantity::kWorkLoop, work->loop_J);
      }
    }
    if (!s_.shear.empty() && targets_.shearLimit_Pa) {
      set(Quantity::kShearOverLimit,
          violationsOf(part(s_.shear, held_), *targets_.shearLimit_Pa, kRate_Hz).time_s);
    }
  }

  const TrialTrace& trace_;
  const Prepared& s_;
  const TrialTargets& targets_;
  TrialMetrics& out_;
  std::pair<std::size_t, std::size_t> held_;
};

}  // namespace

MetricValues::MetricValues(std::initializer_list<QuantityScope> scopes) {
  for (const QuantityRow& row : quantityRows()) {
    if (std::find(scopes.begin(), scopes.end(), row.scope) != scopes.end()) {
      values_.emplace(row.quantity, Outcome<double>::undefined(Text::tr("not applicable")));
    }
  }
}

const Outcome<double>& MetricValues::at(Quantity quantity) const {
  const auto found = values_.find(quantity);
  TORSIO_EXPECTS(found != values_.end());
  return found->second;
}

void MetricValues::set(Quantity quantity, Outcome<double> value) {
  const auto found = values_.find(quantity);
  TORSIO_EXPECTS(found != values_.end());
  found->second = std::move(value);
}

std::optional<double> MetricValues::valueOf(Quantity quantity) const {
  const auto found = values_.find(quantity);
  return found != values_.end() && found->second ? std::optional(*found->second) : std::nullopt;
}

void MetricValues::explainMissing(const Text& reason) {
  for (auto& [quantity, value] : values_) {
    if (!value) {
      value = Outcome<double>::undefined(reason);
    }
  }
}

TrialMetrics measureTrial(const TrialTrace& trace, const TrialTargets& targets) {
  TORSIO_EXPECTS(targets.tolerance_rad > 0.0);
  const Prepared signals = prepare(trace);
  TrialMetrics out;
  out.lostSamples = signals.lost;
  out.poseCutoff_Hz = kPoseCutoff_Hz;
  out.forceCutoff_Hz = kForceCutoff_Hz;
  Measurer(trace, signals, targets, out).run();
  return out;
}

}  // namespace torsio
