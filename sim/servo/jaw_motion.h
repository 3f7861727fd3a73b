// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "sim/core/device_sample.h"
#include "sim/core/live_types.h"
#include "sim/tissue/twist/twist_model.h"

namespace torsio {

/// Distance from the axis within which the tangential drive holds its angle.
inline constexpr double kNearAxis_m = 0.002;

/// Returns the distance of a point from an axis, m.
[[nodiscard]] double radiusAbout_m(const AxisFrame& axis, const Vec3& point_m) noexcept;

/// How the jaw has turned and moved about the axis of the grasped section since it closed. A plain value;
/// servo thread.
class JawMotion {
 public:
  explicit JawMotion(TwistDrive drive) noexcept : drive_(drive) {}

  /// Closes the jaw; the organ is turned by `organ_rad`.
  void close(const AxisFrame& axis, const ToolState& tool, double organ_rad) noexcept;
  /// Follows the tool of this tick.
  void follow(const ToolState& tool) noexcept { angle_rad_ = driveAngle(tool); }

  [[nodiscard]] const AxisFrame& axis() const noexcept { return axis_; }
  [[nodiscard]] TwistDrive drive() const noexcept { return drive_; }
  /// Returns the turn since the jaw closed or restart().
  [[nodiscard]] double turn_rad() const noexcept { return angle_rad_ - firstAngle_rad_; }
  /// Counts the turn from here on.
  void restart() noexcept { firstAngle_rad_ = angle_rad_; }
  /// Takes a part of the turn off: the jaw did not follow the hand.
  void takeOff(double turn_rad) noexcept { firstAngle_rad_ += turn_rad; }
  /// Returns how far the tip has moved along and across the axis.
  [[nodiscard]] Vec3 drift_m(const ToolState& tool) const noexcept;
  /// Returns the tool carried round the axis with the tissue, which is turned by `organ_rad`: a hand that
  /// twists by rolling may stay in place.
  [[nodiscard]] ToolState carried(const ToolState& tool, double organ_rad) const noexcept;

 private:
  [[nodiscard]] double tipAngle(const ToolState& tool) const noexcept;
  [[nodiscard]] double driveAngle(const ToolState& tool) const noexcept;

  TwistDrive drive_;
  AxisFrame axis_;
  double firstAngle_rad_ = 0.0;
  double angle_rad_ = 0.0;      // of the tool about the axis, unwrapped
  double organFrom_rad_ = 0.0;  // the rest: when the jaw closed
  double tipFrom_rad_ = 0.0;
  Quat orientationFrom_;
  double radiusFrom_m_ = 0.0;
  double heightFrom_m_ = 0.0;
};
static_assert(std::is_trivially_copyable_v<JawMotion>);

}  // namespace torsio
