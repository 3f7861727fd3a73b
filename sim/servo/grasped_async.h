// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/servo/async_tissue.h"
#include "sim/servo/grasped_bar.h"

namespace torsio {

/// An organ that moves as a bar, and that a model outside the servo lets the hand feel.
class GraspedAsync : public GraspedBar {
 public:
  GraspedAsync(const Scene& scene, std::int64_t tickPeriod_us)
      : GraspedBar(scene, tickPeriod_us), tickPeriod_us_(tickPeriod_us) {}

  void hear(const BesideAnswer& answer) noexcept { tissue_.hear(answer, tickPeriod_us_); }
  [[nodiscard]] bool forgets() const noexcept { return false; }

  [[nodiscard]] std::optional<AxisFrame> grip(const Vec3& held_m, double arc_m, const ToolState& tool,
                                              OrganState& organ) noexcept {
    const std::optional<AxisFrame> axis = GraspedBar::grip(held_m, arc_m, tool, organ);
    if (axis) {
      tissue_.grip();
    }
    return axis;
  }
  [[nodiscard]] GripFeel feel(const Vec3& tip_m, const JawMotion& motion,
                              const OrganState& organ) const noexcept {
    if (tissue_.doubtful()) {
      return {.late = true};
    }
    const double angle_rad = organ.twist.graspAngle_rad;
    const double cap_N_per_m = model().options().stiffnessCap_N_per_m;
    return {tissue_.torque_Nm(angle_rad), tissue_.force_N(angle_rad, motion.axis(), tip_m, cap_N_per_m)};
  }

 private:
  AsyncTissue tissue_;
  std::int64_t tickPeriod_us_;
};
static_assert(std::is_trivially_copyable_v<GraspedAsync>);

}  // namespace torsio
