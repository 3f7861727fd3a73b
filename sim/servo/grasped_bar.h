// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <type_traits>

#include "sim/scene/scene.h"
#include "sim/servo/grasp.h"

namespace torsio {

/// Time constant of the elastic return after a release.
inline constexpr double kReturnTime_s = 0.12;
/// Angle below which the organ is at rest.
inline constexpr double kAtRest_rad = 1e-3;

/// An organ that the twist model turns about its own axis (docs/model.md): the hand prescribes the angle.
class GraspedBar : public CommonTissue {
 public:
  GraspedBar(const Scene& scene, std::int64_t tickPeriod_us);

  [[nodiscard]] std::optional<AxisFrame> grip(const Vec3& held_m, double arc_m, const ToolState& tool,
                                              OrganState& organ) noexcept;
  [[nodiscard]] std::uint32_t follow(const ToolState& tool, JawMotion& motion, OrganState& organ) noexcept;
  [[nodiscard]] TissueReturn relax(OrganState& organ) noexcept;
  [[nodiscard]] GripFeel feel(const Vec3& tip_m, const JawMotion& motion,
                              const OrganState& organ) const noexcept;

 protected:
  [[nodiscard]] const TwistModel& model() const noexcept { return *model_; }

 private:
  const TwistModel* model_;
  double returnFactor_;  // of the angle, a tick
};
static_assert(std::is_trivially_copyable_v<GraspedBar>);

}  // namespace torsio
