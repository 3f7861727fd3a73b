// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "sim/core/device_sample.h"
#include "sim/core/live_types.h"
#include "sim/scene/organ_state.h"
#include "sim/scene/rod_organ.h"
#include "sim/tissue/rod/rod_step.h"

namespace torsio {

/// Way of every point of a released organ from its place at rest below which it lies at rest.
inline constexpr double kRestWay_m = 1e-3;
/// Turn of a released organ below which it lies at rest.
inline constexpr double kRestTurn_rad = 0.02;

/// What became of an organ that is let alone for a tick.
enum class RodReturn : std::uint8_t {
  kMoving,  ///< on its way back
  kRest,    ///< where it was at first
  kStays,   ///< in balance elsewhere: another shape at rest
};

/// Jaw on an organ that is a rod, tick by tick: the hand's coupling to the organ, what the organ answers, and
/// its return when it is let go (docs/model.md R.6). Trivially copyable. Servo thread; noexcept, allocation
/// free, the same bits on every machine.
class RodGrasp {
 public:
  /// Closes at arc length `arc_m` of the organ as it lies, the tool at `tool`; at rest it begins to move.
  void close(const RodOrgan& organ, double arc_m, const Pose& tool, OrganState& state) noexcept;
  /// Moves the organ on by a tick of `duration_s`, the hand having turned by `turn_rad` about axis() since
  /// it closed.
  void follow(const RodOrgan& organ, const Pose& tool, double turn_rad, TwistDrive drive, double duration_s,
              OrganState& state) noexcept;
  /// Moves the organ on by a tick without a hand.
  [[nodiscard]] RodReturn relax(const RodOrgan& organ, double duration_s, OrganState& state) noexcept;

  /// Returns the axis that the hand turns about.
  [[nodiscard]] const AxisFrame& axis() const noexcept { return grip_.axis; }
  /// Returns the torque of the hand about axis(), N m.
  [[nodiscard]] double torque_Nm() const noexcept { return torque_Nm_; }
  /// Returns what a tool with its tip at `tip_m` feels: the pull of the coupling, and its torque as a force
  /// round the axis. Nearer than sqrt(K / stiffness cap) that falls with the arm, as
  /// TwistModel::graspForce_N.
  [[nodiscard]] Vec3 force_N(const RodOrgan& organ, const Vec3& tip_m) const noexcept;
  /// Tells whether the tissue would fold in the pose of the last tick, or has slipped back by a whole turn.
  [[nodiscard]] bool folds() const noexcept { return folds_; }
  /// Tells whether the coupling is drawn out further than `way_m`.
  [[nodiscard]] bool drawnBeyond(double way_m) const noexcept;

 private:
  OrganGrip grip_;
  Pose closed_;  // the tool as the jaw closed
  GripLoad load_;
  double torque_Nm_ = 0.0;
  bool folds_ = false;
  /// Measures the organ in its pose.
  void look(const RodOrgan& organ, OrganState& state) noexcept;

  RodWorkspace work_;
};
static_assert(std::is_trivially_copyable_v<RodGrasp>);

}  // namespace torsio
