// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/tool_touch.h"

#include <algorithm>
#include <cmath>

#include "sim/base/portable_math.h"
#include "sim/geometry/query/deformed_surface.h"
#include "sim/scene/hollow_map.h"
#include "sim/scene/rod_organ.h"
#include "sim/tissue/twist/twist_model_map.h"

namespace torsio {

namespace {

// Nearer than this the direction to the surface is rounding; the surface's own normal counts.
constexpr double kOnSurface_m = 1e-6;
// Where an axis that has entered the organ is looked at besides the place of entry, metres along it.
constexpr std::array kWithin_m{0.016, 0.008, 0.004};
// Farther than this from the surface of a deformed organ the tip is just outside or deep inside.
constexpr double kTipReach_m = 0.010;
// A bent part that turns frame by frame lies over itself at the inner side of its bends: there the map back
// to rest is in doubt by so much.
constexpr double kWrungDoubt_m = 0.020;
// Share of the jaw's length that the mouth reaches back.
constexpr double kMouthShare = 0.5;

PartTouch fromSurface(const Vec3& axisPoint_m, const SurfacePoint& surface, double radius_m) noexcept {
  PartTouch touch;
  touch.gap_m = surface.distance_m - radius_m;
  touch.point_m = surface.position_m;
  touch.radius_m = radius_m;
  const bool near = std::abs(surface.distance_m) < kOnSurface_m || !std::isfinite(surface.distance_m);
  touch.normal = near ? surface.normal : (axisPoint_m - surface.position_m) / surface.distance_m;
  return touch;
}

const PartTouch& deeper(const PartTouch& a, const PartTouch& b) noexcept {
  return b.gap_m < a.gap_m ? b : a;
}

/// The depth of an axis that has entered at `hit`, looked for on one side of it (`side` 1 or -1).
template <typename Surface>
void lookWithin(Surface& surface, const Segment& axis, const SegmentHit& hit, double length_m, double side,
                PartTouch& touch) noexcept {
  double before = hit.along;
  for (const double way_m : kWithin_m) {
    const double along = std::clamp(hit.along + side * way_m / length_m, 0.0, 1.0);
    // The place of entry is so far away; it is the surface too, so that this point is not deeper.
    const double deepest_m = std::abs(along - hit.along) * length_m - hit.surface.distance_m;
    if (along == before || touch.gap_m + touch.radius_m <= -deepest_m) {
      continue;
    }
    before = along;
    const Vec3 point_m = axis.at(along);
    touch = deeper(touch, fromSurface(point_m, surface.closest(point_m), touch.radius_m));
  }
}

template <typename Surface>
PartTouch touchCapsule(Surface& surface, const Segment& axis, double radius_m) noexcept {
  const SegmentHit hit = surface.nearest(axis, radius_m + kLookAhead_m);
  if (!hit.found) {
    return {};
  }
  PartTouch touch = fromSurface(axis.at(hit.along), hit.surface, radius_m);
  if (hit.surface.distance_m > 0.0) {
    return touch;
  }
  const Vec3 way_m = axis.to_m - axis.from_m;
  const double length_m = norm(way_m);
  if (!(length_m > 0.0)) {
    return touch;
  }
  // One that pierces the surface is inside on one side only.
  const bool pierces = hit.surface.distance_m == 0.0;
  const bool inwards = dot(way_m, hit.surface.normal) < 0.0;
  if (inwards || !pierces) {
    lookWithin(surface, axis, hit, length_m, 1.0, touch);
  }
  if (!inwards || !pierces) {
    lookWithin(surface, axis, hit, length_m, -1.0, touch);
  }
  return touch;
}

template <typename Surface>
ToolTouch touchAll(Surface& surface, const PartTouch& tip, const ToolShape& shape, bool holding) noexcept {
  ToolTouch touch;
  touch.tip = tip;
  touch.jaw = tip;
  if (!holding) {
    for (const Segment& blade : shape.blades) {
      touch.jaw = deeper(touch.jaw, touchCapsule(surface, blade, shape.bladeRadius_m));
    }
  }
  touch.shaft = touchCapsule(surface, shape.shaft, shape.tipRadius_m);
  return touch;
}

/// The tip of a deformed organ. Far from the surface the map back to rest tells inside from outside; only
/// deep inside the exact distance is worth its time.
template <typename ToRest>
PartTouch touchTip(DeformedSurface& surface, const ToolShape& shape, const Scene& scene,
                   const ToRest& toRest_m) noexcept {
  const SegmentHit hit = surface.nearest({shape.tip_m, shape.tip_m}, kTipReach_m);
  if (hit.found) {
    return fromSurface(shape.tip_m, hit.surface, shape.tipRadius_m);
  }
  const Vec3 rest_m = toRest_m(shape.tip_m);
  if (scene.collision.closest(rest_m).distance_m > (scene.hollow ? kWrungDoubt_m : 0.0)) {
    return {};
  }
  return fromSurface(shape.tip_m, surface.closest(shape.tip_m), shape.tipRadius_m);
}

/// The vertices as the model moves them.
struct MovedVertices {
  TwistMap map;
  const std::vector<TwistVertex>& vertices;

  static Vec3 at(const void* self, std::uint32_t vertex) noexcept {
    const auto& moved = *static_cast<const MovedVertices*>(self);
    return moved.map.vertex(moved.vertices[vertex]);
  }
};

/// The vertices as the skin of a rod moves them.
struct RodVertices {
  const RodSkin& skin;
  RodCurve curve;

  static Vec3 at(const void* self, std::uint32_t vertex) noexcept {
    const auto& moved = *static_cast<const RodVertices*>(self);
    return moved.skin.vertex_m(vertex, moved.curve);
  }
};

/// The vertices as a hollow organ that came twisted lies, without its folds.
struct WrungVertices {
  HollowMap map;
  const std::vector<TwistVertex>& vertices;

  static Vec3 at(const void* self, std::uint32_t vertex) noexcept {
    const auto& moved = *static_cast<const WrungVertices*>(self);
    return moved.map.vertex(moved.vertices[vertex]);
  }
};

/// Answers `ask(surface, toRest_m)` with the surface of the organ as it lies and the map back to rest.
template <typename Ask>
auto askDeformed(const Scene& scene, const OrganState& organ, const Ask& ask) noexcept {
  if (scene.rod) {
    const RodSkin& skin = scene.rod->skin();
    const RodVertices moved{skin, skin.curveOf(organ.pose)};
    DeformedSurface surface(scene.collision.patches(), {&moved, &RodVertices::at});
    return ask(surface, [&](const Vec3& at_m) { return skin.toRest_m(at_m, moved.curve); });
  }
  const TwistModel::Tables& tables = scene.model.tables();
  if (scene.hollow) {
    const WrungVertices moved{HollowMap(scene.model, *scene.hollow, organ), tables.vertices};
    DeformedSurface surface(scene.collision.patches(), {&moved, &WrungVertices::at});
    return ask(surface, [&](const Vec3& at_m) { return moved.map.backward(at_m); });
  }
  const MovedVertices moved{TwistMap(tables, scene.model.lattice(), organ.twist), tables.vertices};
  DeformedSurface surface(scene.collision.patches(), {&moved, &MovedVertices::at});
  return ask(surface, [&](const Vec3& at_m) { return scene.model.toRest_m(at_m, organ.twist); });
}

/// The surface point that the mouth reaches and that lies between the blades.
template <typename Surface>
std::optional<SurfacePoint> nearestInMouth(Surface& surface, const ToolShape& shape, const ToolState& tool,
                                           double reach_m) noexcept {
  const SurfacePoint atTip = surface.closest(shape.tip_m);
  const SegmentHit hit = surface.nearest(shape.mouth, reach_m);
  if (!hit.found && !(atTip.distance_m <= reach_m)) {
    return std::nullopt;
  }
  const SurfacePoint found = hit.found ? hit.surface : atTip;  // else the mouth is deep inside
  if (found.distance_m <= 0.0) {
    return found;
  }
  const Vec3 inTool_m = rotate(conjugate(tool.pose.orientation), found.position_m - shape.shaft.from_m);
  const double forward_m = -inTool_m.z;
  const SinCos open = portableSinCos(kJawOpening_rad);
  const bool between = forward_m > 0.0 && std::abs(inTool_m.y) * open.cos <= forward_m * open.sin;
  return between ? std::optional(found) : std::nullopt;
}

}  // namespace

ToolShape toolShape(const ToolState& tool, const Instrument& instrument) noexcept {
  const auto placed = [&tool](const Vec3& inTool_m) {
    return tool.pose.position_m + rotate(tool.pose.orientation, inTool_m);
  };
  const double closed = std::clamp(tool.grip, 0.0, 1.0);
  const SinCos open = portableSinCos(kJawOpening_rad * (1.0 - closed));
  const Vec3 hinge_m = placed({0.0, 0.0, kJawLength_m});
  const double forward_m = kJawLength_m * (1.0 - open.cos);
  const double sideways_m = kJawLength_m * open.sin;
  ToolShape shape;
  shape.tip_m = tool.pose.position_m;
  shape.blades = {Segment{hinge_m, placed({0.0, sideways_m, forward_m})},
                  Segment{hinge_m, placed({0.0, -sideways_m, forward_m})}};
  shape.shaft = {hinge_m, placed({0.0, 0.0, std::max(kJawLength_m, instrument.shaftLength_m)})};
  shape.mouth = {shape.tip_m, placed({0.0, 0.0, kMouthShare * kJawLength_m})};
  shape.tipRadius_m = instrument.tipRadius_m;
  shape.bladeRadius_m = kBladeShare * instrument.tipRadius_m;
  return shape;
}

ToolTouch touchTool(const ToolShape& shape, const Scene& scene, const OrganState& organ,
                    bool holding) noexcept {
  if (organ.atRest()) {
    const PartTouch tip = fromSurface(shape.tip_m, scene.collision.closest(shape.tip_m), shape.tipRadius_m);
    return touchAll(scene.collision, tip, shape, holding);
  }
  return askDeformed(scene, organ, [&](DeformedSurface& surface, const auto& toRest_m) {
    return touchAll(surface, touchTip(surface, shape, scene, toRest_m), shape, holding);
  });
}

std::optional<SurfacePoint> tissueInMouth(const ToolShape& shape, const ToolState& tool, const Scene& scene,
                                          const OrganState& organ) noexcept {
  const double reach_m = scene.instrument.gripReach_m + shape.tipRadius_m;
  if (organ.atRest()) {
    return nearestInMouth(scene.collision, shape, tool, reach_m);
  }
  return askDeformed(scene, organ, [&](DeformedSurface& surface, const auto& toRest_m) {
    std::optional<SurfacePoint> found = nearestInMouth(surface, shape, tool, reach_m);
    if (found) {
      found->position_m = toRest_m(found->position_m);
    }
    return found;
  });
}

}  // namespace torsio
