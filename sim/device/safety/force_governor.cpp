// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/safety/force_governor.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::uint32_t kNotReady = kDeviceUncalibrated | kDeviceLost | kDeviceEnded;

void require(bool good, Phrase what, double value) {
  if (good) {
    return;
  }
  throw Error(ErrorCode::kBadParameter, Text::tr("%1, got %2", what, std::to_string(value)),
              Text::tr("force governor"), Text::tr("Check the limits that the device reports"));
}

/// How far `x` lies outside [low, high].
double outside(double x, double low, double high) noexcept {
  return x < low ? low - x : (x > high ? x - high : 0.0);
}

/// Shortens `force` to `limit_N` and sets `bit`; the direction is kept.
void clampNorm(Vec3& force_N, double limit_N, std::uint32_t bit, std::uint32_t& bits) noexcept {
  const double size = norm(force_N);
  if (!(size > limit_N)) {
    return;
  }
  force_N *= limit_N / size;
  bits |= bit;
}

}  // namespace

ForceGovernor::ForceGovernor(const GovernorLimits& limits)
    : limits_(limits), thermalLimit_N_(limits.maxForce_N) {
  require(std::isfinite(limits.maxForce_N) && limits.maxForce_N > 0.0,
          Text::tr("the maximum force must be above 0 N"), limits.maxForce_N);
  require(limits.continuousForce_N > 0.0 && limits.continuousForce_N <= limits.maxForce_N,
          Text::tr("the continuous force must lie above 0 N and not above the maximum"),
          limits.continuousForce_N);
  require(limits.tickPeriod_us > 0, Text::tr("the tick period must be above 0 us"),
          static_cast<double>(limits.tickPeriod_us));
  const Vec3 size = limits.workspaceMax_m - limits.workspaceMin_m;
  require(size.x > 0.0 && size.y > 0.0 && size.z > 0.0 && isFinite(size),
          Text::tr("the workspace box must have an inside"), size.x);
}

void ForceGovernor::enable(bool on) noexcept {
  if (on) {
    faults_ = 0;
    if (state_ != GovernorState::kEngaged) {
      state_ = GovernorState::kEngaging;
    }
  } else if (state_ != GovernorState::kOff) {
    state_ = state_ == GovernorState::kInhibited ? GovernorState::kOff : GovernorState::kReleasing;
  }
}

void ForceGovernor::noteFault(std::int64_t now_us) noexcept {
  // A fault lasts as long as its inputs do: only its first tick counts.
  if (state_ != GovernorState::kInhibited) {
    ++faults_;
  }
  if (state_ != GovernorState::kOff) {
    state_ = GovernorState::kInhibited;
  }
  soundFrom_us_ = now_us + kInhibitTime_us;
}

double ForceGovernor::staleGain(const GovernorInput& input, std::int64_t step_us) noexcept {
  if ((input.deviceStatus & kDeviceStale) == 0) {
    lastFresh_us_ = input.now_us;
  }
  const std::int64_t age_us = input.now_us - std::min(lastFresh_us_, input.computed_us);
  const std::int64_t begins_us = limits_.fadesAtOnce ? 0 : kStaleFadeBegins_us;
  const std::int64_t ends_us = limits_.fadesAtOnce ? kFadeEnds_us : kStaleFadeEnds_us;
  const double left = static_cast<double>(ends_us - age_us) / static_cast<double>(ends_us - begins_us);
  const double risen = staleGain_ + static_cast<double>(step_us) / static_cast<double>(kStaleRecovery_us);
  staleGain_ = std::clamp(std::min(left, risen), 0.0, 1.0);
  return staleGain_;
}

double ForceGovernor::workspaceGain(const Vec3& tip_m) const noexcept {
  const Vec3& low = limits_.workspaceMin_m;
  const Vec3& high = limits_.workspaceMax_m;
  const double way = norm(Vec3{outside(tip_m.x, low.x, high.x), outside(tip_m.y, low.y, high.y),
                               outside(tip_m.z, low.z, high.z)});
  return std::max(0.0, 1.0 - way / kWorkspaceFade_m);
}

void ForceGovernor::foldThermally(std::uint32_t deviceStatus) noexcept {
  const bool warm = (deviceStatus & kDeviceWarm) != 0;
  thermalLimit_N_ = warm ? std::max(limits_.continuousForce_N, thermalLimit_N_ * kThermalFoldBack)
                         : std::min(limits_.maxForce_N, thermalLimit_N_ * kThermalRecovery);
}

double ForceGovernor::energyLimit_N() const noexcept {
  const double continuous = limits_.continuousForce_N;
  const double budget = continuous * continuous;
  const double headroom = std::clamp((budget - heat_N2_) / (kHeatMargin * budget), 0.0, 1.0);
  return continuous + (limits_.maxForce_N - continuous) * headroom;
}

double ForceGovernor::advanceRamp(std::int64_t step_us) noexcept {
  const std::int64_t before = ramp_us_;
  if (state_ == GovernorState::kEngaging) {
    ramp_us_ = std::min(kEngageTime_us, ramp_us_ + step_us);
    if (ramp_us_ == kEngageTime_us) {
      state_ = GovernorState::kEngaged;
    }
  } else if (state_ == GovernorState::kReleasing) {
    ramp_us_ = std::max<std::int64_t>(0, ramp_us_ - step_us * (kEngageTime_us / kReleaseTime_us));
    if (ramp_us_ == 0) {
      state_ = GovernorState::kOff;
    }
  }
  return static_cast<double>(std::abs(ramp_us_ - before)) / static_cast<double>(kEngageTime_us);
}

bool ForceGovernor::letsThrough(const GovernorInput& input, std::uint32_t& bits) noexcept {
  if (!isFinite(input.wanted_N) || !std::isfinite(norm(input.wanted_N)) || !isFinite(input.tip_m) ||
      (input.deviceStatus & kDeviceInvalid) != 0) {
    noteFault(input.now_us);
    bits |= kForceNotFinite;
  } else if ((input.deviceStatus & kNotReady) != 0) {
    if (state_ != GovernorState::kInhibited && state_ != GovernorState::kOff) {
      state_ = GovernorState::kInhibited;
      soundFrom_us_ = input.now_us;
    }
  } else if (state_ == GovernorState::kInhibited && input.now_us >= soundFrom_us_ &&
             faults_ <= kFaultsForgiven) {
    state_ = GovernorState::kEngaging;
  }
  if (state_ == GovernorState::kReleasing && ramp_us_ == 0) {
    state_ = GovernorState::kOff;
  }
  if (state_ != GovernorState::kOff && state_ != GovernorState::kInhibited) {
    return true;
  }
  bits |= kForceInhibited;
  return false;
}

Vec3 ForceGovernor::limited(const GovernorInput& input, double staleness, std::uint32_t& bits) noexcept {
  const double inBox = workspaceGain(input.tip_m);
  if (staleness < 1.0) {
    bits |= kForceStale;
  }
  if (inBox < 1.0) {
    bits |= kForceWorkspace;
  }
  Vec3 force_N = input.wanted_N * (staleness * inBox);
  if (thermalLimit_N_ < limits_.maxForce_N) {
    clampNorm(force_N, thermalLimit_N_, kForceThermal, bits);
  }
  const double energy_N = energyLimit_N();
  if (energy_N < limits_.maxForce_N) {
    clampNorm(force_N, energy_N, kForceEnergy, bits);
  }
  clampNorm(force_N, limits_.maxForce_N, kForceSaturated, bits);
  return force_N;
}

ForceCommand ForceGovernor::govern(const GovernorInput& input) noexcept {
  const std::int64_t elapsed_us = started_ ? input.now_us - last_us_ : limits_.tickPeriod_us;
  const bool gap = elapsed_us < 0 || elapsed_us > kLongestTickGap_us;
  // A late tick buys no larger step: the device felt the old force all the while.
  const std::int64_t step_us = std::clamp<std::int64_t>(elapsed_us, 0, limits_.tickPeriod_us);
  const double step_s = static_cast<double>(step_us) * 1e-6;
  if (!started_ || gap) {
    lastFresh_us_ = input.now_us;
  }
  started_ = true;
  last_us_ = input.now_us;

  std::uint32_t bits = kForceFull;
  const double staleness = staleGain(input, step_us);
  foldThermally(input.deviceStatus);
  const bool through = letsThrough(input, bits);
  Vec3 sent_N;
  if (!through || gap) {
    if (gap) {
      bits |= kForceStale;
    }
    if (gap && state_ == GovernorState::kEngaged) {
      state_ = GovernorState::kEngaging;
    }
    if (state_ == GovernorState::kEngaging) {
      bits |= kForceEngaging;
    }
    ramp_us_ = 0;
    slewed_N_ = {};
  } else {
    const Vec3 force_N = limited(input, staleness, bits);
    // The ramp may use part of the slew budget, so that the sent force keeps the limit in every tick.
    const double rampShare_N = advanceRamp(step_us) * limits_.maxForce_N;
    if (limits_.fallsFreely) {
      slewed_N_ = keptForce_N(slewed_N_, force_N);
    }
    Vec3 change_N = force_N - slewed_N_;
    clampNorm(change_N, std::max(0.0, kSlewLimit_N_per_s * step_s - rampShare_N), kForceSlew, bits);
    slewed_N_ += change_N;
    const double gain = static_cast<double>(ramp_us_) / static_cast<double>(kEngageTime_us);
    if (gain < 1.0) {
      bits |= kForceEngaging;
    }
    sent_N = slewed_N_ * gain;
  }
  heat_N2_ += (dot(sent_N, sent_N) - heat_N2_) * (step_s / kHeatTime_s);
  return {sent_N, bits};
}

}  // namespace torsio
