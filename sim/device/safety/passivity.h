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

/// Ticks at most between the tick that computes a force and the way of the hand that it acts on.
inline constexpr int kLongestLatency_ticks = 16;

/// The hand's port of a held force: the forces that were sent and the energy that the hand has put into them,
///
///   E(k) = E(k-1) - F(k-1) . (x(k) - x(k-1)),   F: force sent, N;  x: tip, m;  E: energy, J,
///
/// which is exact for a force that is held between ticks (Ryu, Kwon and Hannaford 2004).
class HandPort {
 public:
  /// Returns the energy of the hand in the force, J; below 0 the hand got more back.
  [[nodiscard]] double energy_J() const noexcept { return energy_J_; }

 protected:
  explicit HandPort(int latency_ticks) noexcept : latency_ticks_(latency_ticks) {}

  [[nodiscard]] bool begun() const noexcept { return begun_; }
  void begin(const Vec3& tip_m) noexcept;
  /// Adds the energy of the way to `tip_m` and returns that way.
  Vec3 move(const Vec3& tip_m) noexcept;
  /// Returns the way to `tip_m` without adding its energy.
  Vec3 skip(const Vec3& tip_m) noexcept;
  /// Returns the force that acts now, N.
  [[nodiscard]] const Vec3& acting_N() const noexcept {
    return sent_N_[static_cast<std::size_t>(latency_ticks_)];
  }
  /// Tells whether neither this force nor any that still acts differs from zero.
  [[nodiscard]] bool quiet(const Vec3& force_N) const noexcept;
  void keep(const Vec3& force_N) noexcept;

  double energy_J_ = 0.0;

 private:
  int latency_ticks_;
  bool begun_ = false;
  Vec3 last_m_;
  std::array<Vec3, kLongestLatency_ticks + 1> sent_N_{};  // newest first
};

struct PassivityOptions {
  std::int64_t tickPeriod_us = kTickPeriod_us;  ///< > 0
  /// Ticks between the tick that computes a force and the way of the hand that it acts on; 0: at once. At
  /// most kLongestLatency_ticks.
  int latency_ticks = 0;
  double largestDamping_Ns_per_m = kLargestDamping_Ns_per_m;  ///< > 0
};

/// Time-domain passivity observer and controller at the hand's port (Hannaford and Ryu 2002). A passive
/// tissue never gives back more energy than it got: when E < 0, the controller adds -a v, a = min(-E / (T
/// v^2), largest damping), which takes the excess back within one tick. v is the mean velocity of the last
/// four ticks, because one step of an encoder (0.055 mm) would count as 55 mm/s. Whenever no force is wanted
/// or sent, what the hand has put in is forgotten, what it got too much is not; the controller adds nothing
/// where no force is wanted.
///
/// A plain value: copying it copies its memory. IEEE basic operations in a fixed order, so that a replay
/// repeats it bit for bit. Servo thread; noexcept, no allocation.
class PassivityController : public HandPort {
 public:
  /// Makes a controller without stored energy. Throws Error{kBadParameter} for options out of range.
  explicit PassivityController(const PassivityOptions& options);

  /// Returns the wanted force, damped where energy was generated; kForcePassivity is then set in `limits`.
  /// Once a tick, before the governor. `sound`: false while the device delivers no position (the observer
  /// begins anew).
  [[nodiscard]] Vec3 control(std::int64_t now_us, const Vec3& tip_m, const Vec3& wanted_N, bool sound,
                             std::uint32_t& limits) noexcept;
  /// Takes the force that the governor really sent, once a tick after control().
  void sent(const Vec3& force_N) noexcept { keep(force_N); }

 private:
  struct Place {
    Vec3 tip_m;
    std::int64_t time_us = 0;
  };
  static constexpr std::size_t kWindow = 4;

  PassivityOptions options_;
  std::array<Place, kWindow> places_{};  // a ring: the oldest is the next to be overwritten
  std::size_t nextPlace_ = 0;
};
static_assert(std::is_trivially_copyable_v<PassivityController>);

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
  /// As PassivityOptions::latency_ticks.
  int latency_ticks = 0;
  /// Whether the ways that a reading hid are judged (below). False, by rules up to 3: all of such a way
  /// counts with the last force, and a loss beyond kEnergyAllowance_J is forgiven.
  bool countsHiddenWays = true;
};

/// What a device tells of the hand in one tick.
enum class HandReading : std::uint8_t {
  kFresh,
  kStandsStill,  ///< the last position, repeated
  kNone,         ///< no position: a contact begins anew
};

/// Last stage of a force, at the hand's port: a force may be no larger than a spring could give that stores
/// what the hand has put in.
///
///   |F(k)| <= f,  f = sqrt(2 K (E + e) + (K v T)^2) - K v T
///
/// E: energy of the hand in the force (HandPort), J; K: kHonestStiffness_N_per_m; e:
/// kEnergyAllowance_J; v T: way of the last tick along F, m, 0 against it. f is the force of a
/// spring K with the energy that will be left at the end of the tick. A spring of K or softer is never
/// limited; what a limiter before it, a jaw that opens, a delay or a sampled wall would give beyond what was
/// put in is withheld, without damping. E is never below -e, and 0 again whenever no force is wanted and
/// sent: what a contact can give too much is e and the error of a tick.
///
/// While a reading stands still, nobody knows the way of the hand. It is taken to go on as it went, and once
/// it is known where it arrived, to have gone there evenly; of the two, what gives the hand more counts. Such
/// a loss is not forgiven before the contact ends.
///
/// A plain value: copying it copies its memory. IEEE basic operations in a fixed order, so that a replay
/// repeats it bit for bit. Servo thread; noexcept, no allocation.
class StoredEnergyLimit : public HandPort {
 public:
  /// Makes a limit without stored energy. Throws Error{kBadParameter} for options out of range.
  explicit StoredEnergyLimit(const StoredEnergyOptions& options);

  /// Returns the force to send, once a tick, after every other limit; kForcePassivity is set in `limits`
  /// where it was made smaller.
  [[nodiscard]] Vec3 limited(const Vec3& tip_m, const Vec3& command_N, HandReading hand,
                             std::uint32_t& limits) noexcept;
  /// Forgets what the hand has put in, once the tissue has let it go: a jaw that closes or opens begins anew.
  void forget() noexcept { energy_J_ = energy_J_ < 0.0 ? energy_J_ : 0.0; }
  /// Adds energy that the tissue brings along, J >= 0: of an organ that was twisted before the jaw closed.
  void lend(double energy_J) noexcept { energy_J_ += energy_J; }

 private:
  /// What is known of a way that a reading hides.
  struct HiddenWay {
    int ticks = 0;
    Vec3 forces_N;         ///< that acted, added up
    double given_J = 0.0;  ///< to the hand, if it goes on as it went
  };

  /// Adds the energy of this tick, or notes it as hidden. Returns the way of the tick.
  Vec3 account(const Vec3& tip_m, HandReading hand) noexcept;

  StoredEnergyOptions options_;
  HiddenWay hidden_;
  Vec3 lastWay_m_;       // of a tick
  double owed_J_ = 0.0;  // what hidden ways of this contact may have given the hand
};
static_assert(std::is_trivially_copyable_v<StoredEnergyLimit>);

}  // namespace torsio
