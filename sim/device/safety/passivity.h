// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "sim/core/live_types.h"
#include "sim/core/time_units.h"

namespace torsio {

/// Largest damping that the controller injects, N s/m: what a Touch renders cleanly, as another toolkit caps
/// it for this device.
inline constexpr double kLargestDamping_Ns_per_m = 4.0;

struct PassivityOptions {
  std::int64_t tickPeriod_us = kTickPeriod_us;  ///< > 0
  /// Ticks between the tick that computes a force and the way of the hand that it acts on; 0: at once. At
  /// most kLongestLatency_ticks.
  int latency_ticks = 0;
  double largestDamping_Ns_per_m = kLargestDamping_Ns_per_m;  ///< > 0
};

/// Time-domain passivity observer and controller at the hand's port (Hannaford and Ryu 2002, with the exact
/// energy of a held force, Ryu, Kwon and Hannaford 2004). The observer adds up the energy that the hand has
/// put into the rendered force,
///
///   E(k) = E(k-1) - F(k-1) . (x(k) - x(k-1)),   F: force sent, N;  x: tip, m;  E: J,
///
/// which holds exactly for a force that is held between ticks. A passive tissue never gives back more than it
/// got: when E < 0, the controller adds -a v, a = min(-E / (T v^2), largest damping), which takes the excess
/// back within one tick. v is the mean velocity of the last four ticks, because one step of an encoder
/// (0.055 mm) would count as 55 mm/s. Whenever no force is wanted or sent, what the hand has put in is
/// forgotten, what it got too much is not; the controller adds nothing where no force is wanted.
///
/// A plain value: copying it copies its memory. IEEE basic operations in a fixed order, so that a replay
/// repeats it bit for bit. Servo thread; noexcept, no allocation.
class PassivityController {
 public:
  static constexpr int kLongestLatency_ticks = 16;

  /// Makes a controller without stored energy. Throws Error{kBadParameter} for options out of range.
  explicit PassivityController(const PassivityOptions& options);

  /// Returns the wanted force, damped where energy was generated; kForcePassivity is then set in `limits`.
  /// Once a tick, before the governor. `sound`: false while the device delivers no position (the observer
  /// begins anew).
  [[nodiscard]] Vec3 control(std::int64_t now_us, const Vec3& tip_m, const Vec3& wanted_N, bool sound,
                             std::uint32_t& limits) noexcept;
  /// Takes the force that the governor really sent, once a tick after control().
  void sent(const Vec3& force_N) noexcept;

  /// Returns the energy that the hand has put in since the force was last zero, J; below 0 the hand got
  /// more back.
  [[nodiscard]] double energy_J() const noexcept { return energy_J_; }

 private:
  struct Place {
    Vec3 tip_m;
    std::int64_t time_us = 0;
  };
  static constexpr std::size_t kWindow = 4;

  void begin(std::int64_t now_us, const Vec3& tip_m) noexcept;
  [[nodiscard]] bool quiet(const Vec3& wanted_N) const noexcept;

  PassivityOptions options_;
  bool begun_ = false;
  double energy_J_ = 0.0;
  std::array<Place, kWindow> places_{};  // a ring: the oldest is the next to be overwritten
  std::size_t nextPlace_ = 0;
  Vec3 last_m_;
  std::array<Vec3, kLongestLatency_ticks + 1> sent_N_{};  // newest first
};
static_assert(std::is_trivially_copyable_v<PassivityController>);

}  // namespace torsio
