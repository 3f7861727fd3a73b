// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "sim/core/async_model.h"
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

/// Silence of an asynchronous model after which nothing of it is felt any more.
inline constexpr std::int64_t kAsyncLate_us = 500'000;
/// Turn beyond the angle of the last answer up to which its slope is followed; from there on the torque
/// stays.
inline constexpr double kAsyncReach_rad = 0.35;

/// An organ that moves as a bar, and that an asynchronous model lets the hand feel: between two answers the
/// torque of the last one, continued along its slope over the hand's angle. Nothing when the model has
/// failed, or was silent for longer than kAsyncLate_us. IEEE basic operations only.
class GraspedAsync : public GraspedBar {
 public:
  GraspedAsync(const Scene& scene, std::int64_t tickPeriod_us)
      : GraspedBar(scene, tickPeriod_us), tickPeriod_us_(tickPeriod_us) {}

  void takeAnswer(const AsyncAnswer& answer) noexcept;
  [[nodiscard]] bool forgets() const noexcept { return false; }
  /// Forgets the answers to the grip before.
  [[nodiscard]] std::optional<AxisFrame> grip(const Vec3& held_m, double arc_m, const ToolState& tool,
                                              OrganState& organ) noexcept;
  /// A torque of 0 before the first answer. Nearer to the axis than sqrt(slope / cap) the force falls with
  /// the arm, as that of the twist model does.
  [[nodiscard]] GripFeel feel(const Vec3& tip_m, const JawMotion& motion,
                              const OrganState& organ) const noexcept;

 private:
  AsyncAnswer last_;
  std::int64_t silent_us_ = 0;
  std::int64_t tickPeriod_us_;
};
static_assert(std::is_trivially_copyable_v<GraspedAsync>);

}  // namespace torsio
