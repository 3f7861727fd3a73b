// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "sim/core/live_types.h"
#include "sim/core/time_units.h"

namespace torsio {

/// Stiffness up to which a force is honest, N/m: twice what a device is asked to render, because two contacts
/// or a contact and a grip may act side by side.
inline constexpr double kHonestStiffness_N_per_m = 1000.0;
/// Energy that a contact may give before it has received any: what the first ticks of a touch lack because
/// the force is held between ticks.
inline constexpr double kEnergyAllowance_J = 1e-4;
/// Force against the hand's motion that is never withheld; without it a contact without energy would stay
/// without force.
inline constexpr double kLeastResistance_N = 0.05;

struct StoredEnergyOptions {
  std::int64_t tickPeriod_us = kTickPeriod_us;  ///< > 0
  /// Ticks between the tick that computes a force and the way of the hand that it acts on; 0: at once. At
  /// most StoredEnergyLimit::kLongestLatency_ticks.
  int latency_ticks = 0;
};

/// Last stage of a force, at the hand's port: a force may be no larger than a spring could give that stores
/// what the hand has put in.
///
///   E(k) = E(k-1) - F(k-1) . (x(k) - x(k-1))          (Ryu, Kwon and Hannaford 2004: exact for a held force)
///   |F(k)| <= f,  f = sqrt(2 K (E + e) + (K v T)^2) - K v T
///
/// F: force sent, N; x: tip, m; E: energy of the hand in the force, J; K: kHonestStiffness_N_per_m; e:
/// kEnergyAllowance_J; v T: way of the last tick along F, m, 0 against it. f is the force of a
/// spring K with the energy that will be left at the end of the tick. A spring of K or softer is never
/// limited; what a limiter before it, a jaw that opens, a delay or a sampled wall would give beyond what was
/// put in is withheld, without damping. E is never below -e, and 0 again whenever no force is wanted and
/// sent: what a contact can give too much is e and the error of a tick.
///
/// A plain value: copying it copies its memory. IEEE basic operations in a fixed order, so that a replay
/// repeats it bit for bit. Servo thread; noexcept, no allocation.
class StoredEnergyLimit {
 public:
  static constexpr int kLongestLatency_ticks = 16;

  /// Makes a limit without stored energy. Throws Error{kBadParameter} for options out of range.
  explicit StoredEnergyLimit(const StoredEnergyOptions& options);

  /// Returns the force to send, once a tick, after every other limit; kForcePassivity is set in `limits`
  /// where it was made smaller. `sound`: false while the device delivers no position (a contact begins anew).
  [[nodiscard]] Vec3 limited(const Vec3& tip_m, const Vec3& command_N, bool sound,
                             std::uint32_t& limits) noexcept;
  /// Forgets what the hand has put in, once the tissue has let it go: a jaw that closes or opens begins anew.
  void forget() noexcept { energy_J_ = energy_J_ < 0.0 ? energy_J_ : 0.0; }
  /// Adds energy that the tissue brings along, J >= 0: of an organ that was twisted before the jaw closed.
  void lend(double energy_J) noexcept { energy_J_ += energy_J; }

  /// Returns the energy of the hand in the force, J; below 0 the hand got more back.
  [[nodiscard]] double energy_J() const noexcept { return energy_J_; }

 private:
  void begin(const Vec3& tip_m) noexcept;
  [[nodiscard]] bool quiet(const Vec3& command_N) const noexcept;

  StoredEnergyOptions options_;
  bool begun_ = false;
  double energy_J_ = 0.0;
  Vec3 last_m_;
  std::array<Vec3, kLongestLatency_ticks + 1> sent_N_{};  // newest first
};
static_assert(std::is_trivially_copyable_v<StoredEnergyLimit>);

}  // namespace torsio
