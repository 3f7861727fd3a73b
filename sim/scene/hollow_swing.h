// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "sim/scene/rod_organ.h"

namespace torsio {

/// How a hollow organ lies, and what it takes, when it is turned about a line as a rod whose wrung stretches
/// have the torque of their wall (docs/model.md U.2). Immutable; the queries are noexcept and allocate
/// nothing, for the tick.
class HollowSwing {
 public:
  /// Follows the task of `rod` to `most_rad` and a little further, both ways. Throws Error{kBadParameter}
  /// where it does not go so far.
  HollowSwing(std::shared_ptr<const RodOrgan> rod, double graspArc, double most_rad);

  [[nodiscard]] const RodOrgan& rod() const noexcept { return *rod_; }
  /// Returns an angle as far as the organ goes.
  [[nodiscard]] double within_rad(double angle_rad) const noexcept;
  [[nodiscard]] RodPose poseAt(double angle_rad) const noexcept;
  /// What the organ takes at an angle.
  struct Load {
    double torque_Nm = 0.0;  ///< at the pressure of the laws
    std::array<double, 2> twist_rad{};
    std::array<double, 2> twistRate{};  ///< d twist / d angle
  };
  [[nodiscard]] Load at(double angle_rad) const noexcept;

 private:
  struct Cell {
    std::size_t low = 0;
    double share = 0.0;
  };
  [[nodiscard]] Cell cellAt(double angle_rad) const noexcept;

  std::shared_ptr<const RodOrgan> rod_;
  std::vector<double> angles_rad_;  // ascending, 0 among them
  std::vector<RodPose> poses_;
  std::vector<Load> loads_;
};

}  // namespace torsio
