// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <type_traits>

#include "sim/core/pose.h"

namespace torsio {

/// Most nodes that a rod may have: all arrays of the tick have this fixed size.
inline constexpr int kMaxRodNodes = 64;

/// Places and orientations of the nodes of a rod, trivially copyable. Node i lies at `nodes[i].position_m`
/// (the centroid of its section, metres, world frame); its unit quaternion turns the section's axes into the
/// world frame: the images of x and y are the section's axes e1 and e2, the image of z is its normal t.
struct RodPose {
  int count = 0;  ///< nodes in use, 0 to kMaxRodNodes
  std::array<Pose, kMaxRodNodes> nodes{};
  friend constexpr bool operator==(const RodPose&, const RodPose&) = default;
};

static_assert(std::is_trivially_copyable_v<RodPose>);

}  // namespace torsio
