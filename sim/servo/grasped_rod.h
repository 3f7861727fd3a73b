// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <type_traits>

#include "sim/scene/rod_organ.h"
#include "sim/scene/scene.h"
#include "sim/servo/grasp.h"
#include "sim/tissue/rod/rod_step.h"

namespace torsio {

/// Way of every point of a released organ from its place at rest below which it lies at rest.
inline constexpr double kRestWay_m = 1e-3;
/// Turn of a released organ below which it lies at rest.
inline constexpr double kRestTurn_rad = 0.02;

/// An organ that is a rod, tick by tick: the hand's coupling to the organ, what the organ answers, and its
/// return when it is let go (docs/model.md R.6). The same bits on every machine.
class GraspedRod : public CommonTissue {
 public:
  GraspedRod(const Scene& scene, std::int64_t tickPeriod_us)
      : rod_(scene.rod.get()), tick_s_(static_cast<double>(tickPeriod_us) * 1e-6) {}

  [[nodiscard]] std::optional<AxisFrame> grip(const Vec3& held_m, double arc_m, const ToolState& tool,
                                              OrganState& organ) noexcept;
  [[nodiscard]] std::uint32_t follow(const ToolState& tool, JawMotion& motion, OrganState& organ) noexcept;
  [[nodiscard]] TissueReturn relax(OrganState& organ) noexcept;
  /// The pull of the coupling, and its torque as a force round the axis. Nearer than sqrt(K / stiffness cap)
  /// that falls with the arm, as TwistModel::graspForce_N.
  [[nodiscard]] GripFeel feel(const Vec3& tip_m, const JawMotion& motion,
                              const OrganState& organ) const noexcept;
  /// The rod itself carries the tool.
  [[nodiscard]] ToolState carried(const ToolState& tool, const JawMotion& /*motion*/,
                                  const OrganState& /*organ*/) const noexcept {
    return tool;
  }
  [[nodiscard]] bool keepsJaw() const noexcept { return rod_->task().axis != GripAxis::kOwn; }

 private:
  /// Measures the organ in its pose.
  void look(OrganState& organ) noexcept;

  const RodOrgan* rod_;
  double tick_s_;
  OrganGrip grip_;
  Pose closed_;  // the tool as the jaw closed
  GripLoad load_;
  double torque_Nm_ = 0.0;
  bool folds_ = false;  // the tissue would fold in the pose of the last tick, or has slipped back by a turn
  RodWorkspace work_;
};
static_assert(std::is_trivially_copyable_v<GraspedRod>);

}  // namespace torsio
