// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

#include "sim/base/live_types.h"

namespace torsio {

/// How far the engage ramp has come.
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
  std::int64_t tickPeriod_us = 1000;  ///< > 0
};

/// No force is let through after a gap between ticks longer than this: the coupling must start anew.
inline constexpr std::int64_t kLongestTickGap_us = 5'000;
/// A force older than the first age fades and is gone at the second.
inline constexpr std::int64_t kStaleFadeBegins_us = 5'000;
inline constexpr std::int64_t kStaleFadeEnds_us = 25'000;
/// After a stall the faded force takes this long to come back.
inline constexpr std::int64_t kStaleRecovery_us = 100'000;
/// Outside the usable box the force falls to zero over this way.
inline constexpr double kWorkspaceFade_m = 0.010;
/// Thermal fold-back: the allowed force shrinks and recovers by these factors a tick (the rule of the
/// vendor's own sample).
inline constexpr double kThermalFoldBack = 0.999;
inline constexpr double kThermalRecovery = 1.001;
/// Time constant of the leaky mean of the squared force (motor heat). Assumed: no figure is published.
inline constexpr double kHeatTime_s = 60.0;
/// Share of the heat budget over which the allowed force falls from the maximum to the continuous one.
inline constexpr double kHeatMargin = 0.25;
/// Largest change of the sent force: 3.3 N take 33 ms. No published limit exists for the Touch; at the
/// stiffest contact (500 N/m) a hand at 0.2 m/s stays just below it.
inline constexpr double kSlewLimit_N_per_s = 100.0;
inline constexpr std::int64_t kEngageTime_us = 500'000;
inline constexpr std::int64_t kReleaseTime_us = 100'000;
/// After a fault the inputs must be sound for this long before the governor engages again ...
inline constexpr std::int64_t kInhibitTime_us = 1'000'000;
/// ... and after more faults than this it waits until the force is switched off and on.
inline constexpr int kFaultsForgiven = 3;

/// What the governor looks at in one tick.
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
/// A plain value: copying it copies its memory. It knows the time only from its input and computes with IEEE
/// basic operations and square roots, so that a replay repeats it bit for bit. Servo thread; noexcept, no
/// allocation. The sent force changes by at most kSlewLimit_N_per_s, except that a fault, a lost device or a
/// gap between ticks cuts it to zero at once.
class ForceGovernor {
 public:
  /// Throws Error{kBadParameter} for limits that are not finite or not in order.
  explicit ForceGovernor(const GovernorLimits& limits);

  /// Switches the force on (engage ramp; also forgives all faults) or off (release ramp). On at the start.
  void enable(bool on) noexcept;
  /// The force to send, with the ForceLimit bits of every stage that acted.
  [[nodiscard]] ForceCommand govern(const GovernorInput& input) noexcept;

  [[nodiscard]] GovernorState state() const noexcept { return state_; }
  [[nodiscard]] const GovernorLimits& limits() const noexcept { return limits_; }
  /// Leaky mean of the squared sent force, N^2; never above the square of the continuous force for long.
  [[nodiscard]] double heat_N2() const noexcept { return heat_N2_; }

 private:
  /// False when the state, a fault or the device's status forbids any force.
  [[nodiscard]] bool letsThrough(const GovernorInput& input, std::uint32_t& bits) noexcept;
  /// The stages from the staleness fade to the norm clamp.
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
