// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

#include "sim/core/beside_answer.h"
#include "sim/core/vec3.h"
#include "sim/tissue/twist/twist_model.h"

namespace torsio {

/// Silence of a model beside the servo after which nothing of it is felt any more.
inline constexpr std::int64_t kBesideLate_us = 500'000;
/// Turn beyond the angle of the last answer up to which its slope is followed; from there on the torque
/// stays.
inline constexpr double kBesideReach_rad = 0.35;

/// What a model that runs beside the servo lets the hand feel between two of its answers: the torque of the
/// last one, continued along its slope over the hand's angle. Nothing when the model has failed, or was
/// silent for longer than kBesideLate_us.
///
/// A plain value; servo thread. IEEE basic operations only.
class AsyncTissue {
 public:
  /// Begins a grip: what was said before belongs to another one.
  void grip() noexcept;
  /// Begins a tick of this period with what has arrived before it, if anything.
  void hear(const BesideAnswer& answer, std::int64_t tickPeriod_us) noexcept;

  /// Tells whether the model is not to be trusted now.
  [[nodiscard]] bool doubtful() const noexcept;
  /// Returns the torque that holds the grip at this angle, N m; 0 in doubt and before the first answer.
  [[nodiscard]] double torque_Nm(double angle_rad) const noexcept;
  /// Returns what a tool with its tip at `tip_m` feels of torque_Nm() about `axis`, a force round it. Nearer
  /// than sqrt(slope / cap) the force falls with the arm, as that of the twist model does.
  [[nodiscard]] Vec3 force_N(double angle_rad, const AxisFrame& axis, const Vec3& tip_m,
                             double stiffnessCap_N_per_m) const noexcept;

 private:
  BesideAnswer last_;
  std::int64_t silent_us_ = 0;
};
static_assert(std::is_trivially_copyable_v<AsyncTissue>);

}  // namespace torsio
