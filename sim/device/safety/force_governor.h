// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "sim/core/live_types.h"
#include "sim/core/time_units.h"
#include "sim/core/vec3.h"

namespace torsio {

/// Time over which the driver lets the force back in after an interruption.
inline constexpr std::int64_t kGateOpens_us = 500'000;

/// The driver's own last safeguard, behind the ForceGovernor: closed at once, opened by a ramp. Servo thread;
/// a plain value.
class ForceGate {
 public:
  void close() noexcept { open_us_ = 0; }
  /// Returns the share of the force to send now, and moves the ramp on by `step_us` >= 0 for the next call.
  double advance(std::int64_t step_us) noexcept {
    const double gain = static_cast<double>(open_us_) / static_cast<double>(kGateOpens_us);
    open_us_ = std::min(kGateOpens_us, open_us_ + step_us);
    return gain;
  }

 private:
  std::int64_t open_us_ = 0;
};

/// Largest rise of the sent force: 3.3 N take 33 ms. No published limit exists for the Touch; at the
/// stiffest contact (500 N/m) a hand at 0.2 m/s stays just below it.
inline constexpr double kSlewLimit_N_per_s = 100.0;

/// Returns the part of the last force that the next one keeps: the last one shortened as far as the next asks
/// for. Only the way from there to the next is a rise; a fall is free, because one that is held back gives
/// the hand energy.
[[nodiscard]] inline Vec3 keptForce_N(const Vec3& last_N, const Vec3& next_N) noexcept {
  const double square = dot(last_N, last_N);
  return square > 0.0 ? last_N * std::clamp(dot(last_N, next_N) / square, 0.0, 1.0) : last_N;
}

/// State of the governor's engage ramp.
enum class GovernorState : std::uint8_t {
  kOff,        ///< switched off by the user: no force
  kEngaging,   ///< the gain rises from 0 to 1
  kEngaged,    ///< full gain
  kReleasing,  ///< switched off, the gain falls to 0
  kInhibited,  ///< a fault or a device that is not ready: no force until it has passed
};

/// Limits of the device that the governor protects.
struct GovernorLimits {
  double maxForce_N = 3.3;                   ///< norm, short bursts; > 0
  double continuousForce_N = 0.88;           ///< may be held for ever; 0 < continuous <= maximum
  Vec3 workspaceMin_m{-10.0, -10.0, -10.0};  ///< usable box, world frame
  Vec3 workspaceMax_m{10.0, 10.0, 10.0};
  std::int64_t tickPeriod_us = kTickPeriod_us;  ///< > 0
  /// Whether a force may fall at once and only its rise is limited; a fall that is held back gives the hand
  /// energy. False: by rules 1.
  bool fallsFreely = true;
  /// Whether a force fades as soon as nothing new is known (kFadeEnds_us). False, by rules up to 3: from
  /// kStaleFadeBegins_us to kStaleFadeEnds_us.
  bool fadesAtOnce = true;
};

/// Longest gap between ticks after which force is still let through; after a longer one the coupling starts
/// anew.
inline constexpr std::int64_t kLongestTickGap_us = 5'000;
/// Age at which a force has faded to nothing: what it gives a hand meanwhile nobody knows.
inline constexpr std::int64_t kFadeEnds_us = 4'000;
/// Age from which a force faded by rules up to 3.
inline constexpr std::int64_t kStaleFadeBegins_us = 5'000;
/// Age at which a force had faded to nothing by rules up to 3.
inline constexpr std::int64_t kStaleFadeEnds_us = 25'000;
/// Time that the faded force takes to come back after a stall.
inline constexpr std::int64_t kStaleRecovery_us = 100'000;
/// Distance outside the usable box over which the force falls to zero.
inline constexpr double kWorkspaceFade_m = 0.010;
/// Factor a tick by which the allowed force shrinks in thermal fold-back (rule of the vendor's own sample).
inline constexpr double kThermalFoldBack = 0.999;
/// Factor a tick by which the allowed force recovers after thermal fold-back.
inline constexpr double kThermalRecovery = 1.001;
/// Time constant of the leaky mean of the squared force (motor heat). Assumed: no figure is published.
inline constexpr double kHeatTime_s = 60.0;
/// Share of the heat budget over which the allowed force falls from the maximum to the continuous one.
inline constexpr double kHeatMargin = 0.25;
/// Time of the ramp by which the force comes in when it is switched on.
inline constexpr std::int64_t kEngageTime_us = 500'000;
/// Time of the ramp by which the force goes when it is switched off.
inline constexpr std::int64_t kReleaseTime_us = 100'000;
/// Time for which the inputs must be sound after a fault before the governor engages again.
inline constexpr std::int64_t kInhibitTime_us = 1'000'000;
/// Number of faults after which the governor waits until the force is switched off and on.
inline constexpr int kFaultsForgiven = 3;

/// What the governor reads in one tick.
struct GovernorInput {
  std::int64_t now_us = 0;       ///< time of this tick
  std::int64_t computed_us = 0;  ///< time for which the wanted force was computed
  Vec3 wanted_N;                 ///< from the tissue
  Vec3 tip_m;                    ///< world frame
  std::uint32_t deviceStatus = kDeviceOk;
};

/// Makes every force safe for hand and device, in this order: finite check, staleness fade, workspace fade,
/// thermal fold-back, continuous-energy budget, norm clamp (direction kept), slew limit, engage ramp.
///
/// A plain value: copying it copies its memory. The governor knows the time only from its input and
/// computes with IEEE basic operations and square roots, so that a replay repeats it bit for bit. Servo
/// thread; noexcept, no allocation. The sent force rises by at most kSlewLimit_N_per_s; it falls as it is
/// asked to, and a fault, a lost device or a gap between ticks cuts it to zero at once.
class ForceGovernor {
 public:
  /// Makes a governor for a device. Throws Error{kBadParameter} for limits that are not finite or not in
  /// order.
  explicit ForceGovernor(const GovernorLimits& limits);

  /// Switches the force on (engage ramp; also forgives all faults) or off (release ramp). A new governor is
  /// on.
  void enable(bool on) noexcept;
  /// Returns the force to send, with the ForceLimit bits of every stage that acted.
  [[nodiscard]] ForceCommand govern(const GovernorInput& input) noexcept;

  [[nodiscard]] GovernorState state() const noexcept { return state_; }
  [[nodiscard]] const GovernorLimits& limits() const noexcept { return limits_; }
  /// Returns the leaky mean of the squared sent force, N^2; never above the square of the continuous force
  /// for long.
  [[nodiscard]] double heat_N2() const noexcept { return heat_N2_; }

 private:
  /// Tells whether force may pass: false when the state, a fault or the device's status forbids it.
  [[nodiscard]] bool letsThrough(const GovernorInput& input, std::uint32_t& bits) noexcept;
  /// Applies the stages from the staleness fade to the norm clamp.
  [[nodiscard]] Vec3 limited(const GovernorInput& input, double staleness, std::uint32_t& bits) noexcept;
  [[nodiscard]] double staleGain(const GovernorInput& input, std::int64_t step_us) noexcept;
  [[nodiscard]] double workspaceGain(const Vec3& tip_m) const noexcept;
  void foldThermally(std::uint32_t deviceStatus) noexcept;
  [[nodiscard]] double energyLimit_N() const noexcept;
  void noteFault(std::int64_t now_us) noexcept;
  /// Moves the engage ramp by one step and returns how much the gain changed, >= 0.
  double advanceRamp(std::int64_t step_us) noexcept;

  GovernorLimits limits_;
  GovernorState state_ = GovernorState::kEngaging;
  bool started_ = false;
  int faults_ = 0;
  std::int64_t last_us_ = 0;
  std::int64_t lastFresh_us_ = 0;
  std::int64_t soundFrom_us_ = 0;  // kInhibited: engage again at this time
  std::int64_t ramp_us_ = 0;       // 0 .. kEngageTime_us: the gain in integers
  double staleGain_ = 1.0;
  double thermalLimit_N_;
  double heat_N2_ = 0.0;
  Vec3 slewed_N_;  // before the ramp
};
static_assert(std::is_trivially_copyable_v<ForceGovernor>);

}  // namespace torsio
