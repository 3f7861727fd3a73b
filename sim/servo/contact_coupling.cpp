// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/contact_coupling.h"

#include <algorithm>
#include <cstddef>

#include "sim/core/portable_math.h"

namespace torsio {

namespace {

bool presses(const ContactPatch& patch) noexcept {
  return patch.depth_m > 0.0 && patch.toolRadius_m > 0.0 && patch.radius_m > patch.toolRadius_m;
}

Vec3 total(const LiveState& state, const Vec3& point_m) noexcept {
  Vec3 sum;
  for (const ContactPatch& patch : state.patches) {
    sum += indentationAt(patch, point_m);
  }
  return sum;
}

bool anyPresses(const LiveState& state) noexcept {
  return std::any_of(state.patches.begin(), state.patches.end(), presses);
}

}  // namespace

Vec3 indentationAt(const ContactPatch& patch, const Vec3& point_m) noexcept {
  if (!presses(patch)) {
    return {};
  }
  const Vec3 way = point_m - patch.point_m;
  const double r2 = dot(way, way);
  if (!(r2 < patch.radius_m * patch.radius_m)) {
    return {};
  }
  const double r_m = std::max(patch.toolRadius_m, std::sqrt(r2));
  const double share = portableLog(patch.radius_m / r_m) / portableLog(patch.radius_m / patch.toolRadius_m);
  return patch.normal * (-patch.depth_m * share);
}

bool indentSurface(const LiveState& state, std::span<Vec3> vertices_m) noexcept {
  if (!anyPresses(state)) {
    return false;
  }
  for (Vec3& v : vertices_m) {
    v += total(state, v);
  }
  return true;
}

}  // namespace torsio
