// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "sim/core/live_types.h"
#include "sim/core/organ_pose.h"
#include "sim/tissue/twist/twist_model.h"

namespace torsio {

/// How an organ lies: all that changes while it is twisted. Trivially copyable: can be saved, compared.
struct OrganState {
  TwistState twist;     ///< the gripped section and the angle of the task
  RodPose pose{};       ///< of an organ that is a rod; no nodes: at rest
  HollowPose hollow{};  ///< of a hollow organ that came twisted

  /// Tells whether nothing is moved; never of a hollow organ, which its content may widen.
  [[nodiscard]] bool atRest() const noexcept {
    return pose.count == 0 && twist.graspAngle_rad == 0.0 && !hollow.present;
  }
  friend constexpr bool operator==(const OrganState&, const OrganState&) = default;
};
static_assert(std::is_trivially_copyable_v<OrganState>);

/// Returns how the organ lies in a snapshot.
[[nodiscard]] inline OrganState organStateOf(const LiveState& state) noexcept {
  return {{state.response.graspArc_m, state.response.angle_rad}, state.pose, state.hollow};
}

}  // namespace torsio
