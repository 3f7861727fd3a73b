// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/tool_touch.h"

#include <algorithm>
#include <cmath>

#include "sim/core/portable_math.h"
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
// How far from a part the surface is looked for, beyond what is needed, to know for how long none is near.
constexpr double kProbe_m = 0.020;
// How much farther than the nearest triangle those are that are remembered of the tip.
constexpr double kNeighbours_m = 0.003;
// Rounding of coordinates, and of the way between two of them.
constexpr double kFreeMargin_m = 1e-9;
constexpr double kFreeShare = 1.0 + 1e-9;
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

/// Tells whether a bound is known for the way of the surface to and from this state.
bool bounded(const Scene& scene, const OrganState& organ) noexcept {
  return organ.pose.count == 0 && !organ.hollow.present && (organ.atRest() || scene.model.knowsWays());
}

/// Remembers that the surface is `free_m` from a part.
void remember(PartMemory& part, const Segment& axis, const Scene& scene, const OrganState& organ,
              double free_m) noexcept {
  part.axis = axis;
  part.twist = organ.twist;
  part.free_m = bounded(scene, organ) ? free_m : -1.0;
}

/// Tells whether the surface cannot have come within kLookAhead_m of a part.
bool stillFree(const PartMemory& part, const Segment& axis, const Scene& scene,
               const OrganState& organ) noexcept {
  if (!(part.free_m > kLookAhead_m) || !bounded(scene, organ)) {
    return false;
  }
  const double tool_m = std::max(norm(axis.from_m - part.axis.from_m), norm(axis.to_m - part.axis.to_m));
  const double left_m = part.free_m - kLookAhead_m - kFreeMargin_m - kFreeShare * tool_m;
  return left_m > 0.0 && left_m > kFreeShare * scene.model.farthestWay_m(part.twist, organ.twist);
}

template <typename Surface>
PartTouch touchCapsule(Surface& surface, const Scene& scene, const OrganState& organ, const Segment& axis,
                       double radius_m, PartMemory& part) noexcept {
  const double reach_m = radius_m + kLookAhead_m;
  const double probe_m = bounded(scene, organ) ? reach_m + kProbe_m : reach_m;
  const SegmentHit hit = surface.nearest(axis, probe_m, part.triangle);
  remember(part, axis, scene, organ, (hit.found ? hit.surface.distance_m : probe_m) - radius_m);
  if (!hit.found) {
    return {};
  }
  part.triangle = hit.surface.triangle;
  if (!(std::abs(hit.surface.distance_m) < reach_m)) {
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

/// The parts that may touch.
struct NearParts {
  bool tip = false;
  std::array<bool, 2> blades{};
  bool shaft = false;
  [[nodiscard]] bool any() const noexcept { return tip || blades[0] || blades[1] || shaft; }
};

NearParts nearParts(const ToolShape& shape, const Scene& scene, const OrganState& organ, bool holding,
                    const TouchMemory& memory) noexcept {
  NearParts near;
  near.tip = !stillFree(memory.tip, {shape.tip_m, shape.tip_m}, scene, organ);
  for (std::size_t i = 0; i < near.blades.size(); ++i) {
    near.blades[i] = !holding && !stillFree(memory.blades[i], shape.blades[i], scene, organ);
  }
  near.shaft = !stillFree(memory.shaft, shape.shaft, scene, organ);
  return near;
}

/// `touchTip`: asks for the tip alone.
template <typename Surface, typename TouchTip>
ToolTouch touchAll(Surface& surface, const ToolShape& shape, const Scene& scene, const OrganState& organ,
                   const NearParts& near, TouchMemory& memory, const TouchTip& touchTip) noexcept {
  ToolTouch touch;
  if (near.tip) {
    touch.tip = touchTip(memory.tip);
    // A deformed organ reports no distance beyond kTipReach_m.
    remember(memory.tip, {shape.tip_m, shape.tip_m}, scene, organ,
             std::min(touch.tip.gap_m, kTipReach_m - shape.tipRadius_m));
  }
  touch.jaw = touch.tip;
  for (std::size_t i = 0; i < near.blades.size(); ++i) {
    if (near.blades[i]) {
      touch.jaw = deeper(touch.jaw, touchCapsule(surface, scene, organ, shape.blades[i], shape.bladeRadius_m,
                                                 memory.blades[i]));
    }
  }
  if (near.shaft) {
    touch.shaft = touchCapsule(surface, scene, organ, shape.shaft, shape.tipRadius_m, memory.shaft);
  }
  return touch;
}

/// The nearest of the remembered triangles, when every other one must be farther: tip and surface have not
/// gone as far since as that one was beyond reach.
SegmentHit amongNeighbours(const DeformedSurface& surface, const Segment& axis, const Scene& scene,
                           const OrganState& organ, const TipPlace& place) noexcept {
  if (!(place.reach_m > 0.0) || !bounded(scene, organ)) {
    return {};
  }
  const double way_m = norm(axis.from_m - place.tip_m) + scene.model.farthestWay_m(place.twist, organ.twist);
  const double left_m = place.reach_m - kFreeMargin_m - kFreeShare * way_m;
  if (!(left_m > 0.0)) {
    return {};
  }
  const SegmentHit hit = surface.nearestAmong(axis, place.near);
  return std::abs(hit.surface.distance_m) < left_m ? hit : SegmentHit{};
}

/// The tip of a deformed organ. Far from the surface the map back to rest tells inside from outside; only
/// deep inside the exact distance is worth its time.
template <typename ToRest>
PartTouch touchTipOf(DeformedSurface& surface, const ToolShape& shape, const Scene& scene,
                     const OrganState& organ, const ToRest& toRest_m, PartMemory& tip,
                     TipPlace& place) noexcept {
  const Segment axis{shape.tip_m, shape.tip_m};
  if (const SegmentHit known = amongNeighbours(surface, axis, scene, organ, place); known.found) {
    tip.triangle = known.surface.triangle;
    return fromSurface(shape.tip_m, known.surface, shape.tipRadius_m);
  }
  const SegmentHit hit = surface.nearest(axis, kTipReach_m, tip.triangle);
  if (hit.found) {
    tip.triangle = hit.surface.triangle;
    if (bounded(scene, organ)) {
      const double reach_m = std::abs(hit.surface.distance_m) + kNeighbours_m;
      place.reach_m = surface.gather(axis, reach_m, place.near) ? reach_m : -1.0;
      place.tip_m = shape.tip_m;
      place.twist = organ.twist;
    }
    return fromSurface(shape.tip_m, hit.surface, shape.tipRadius_m);
  }
  const Vec3 rest_m = toRest_m(shape.tip_m);
  if (scene.collision.closest(rest_m).distance_m > (scene.hollow ? kWrungDoubt_m : 0.0)) {
    return {};
  }
  return fromSurface(shape.tip_m, surface.closest(shape.tip_m, tip.triangle), shape.tipRadius_m);
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

/// Answers `ask(surface, toRest_m)` with the surface of the organ as it lies and the map back to rest.
template <typename Ask>
auto askDeformed(const Scene& scene, const OrganState& organ, const Ask& ask) noexcept {
  if (scene.rod) {
    const RodSkin& skin = scene.rod->skin();
    const RodVertices moved{skin, skin.curveOf(organ.pose)};
    DeformedSurface surface(scene.collision.patches(), {&moved, &RodVertices::at});
    return ask(surface, [&](const Vec3& at_m) { return skin.toRest_m(at_m, moved.curve); });
  }
  if (scene.hollow && scene.hollow->swing() != nullptr) {
    const RodSkin& skin = scene.hollow->swing()->rod().skin();
    const RodVertices moved{skin, scene.hollow->curveOf(organ)};
    DeformedSurface surface(scene.collision.patches(), {&moved, &RodVertices::at});
    return ask(surface, [&](const Vec3& at_m) { return skin.toRest_m(at_m, moved.curve); });
  }
  const TwistModel::Tables& tables = scene.model.tables();
  if (scene.hollow) {
    const WrungSurface moved{HollowMap(scene.lattice(), *scene.hollow, organ), *scene.hollow};
    DeformedSurface surface(scene.collision.patches(), moved.places(), moved.bounds());
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

ToolTouch touchTool(const ToolShape& shape, const Scene& scene, const OrganState& organ, bool holding,
                    TouchMemory& memory) noexcept {
  const NearParts near = nearParts(shape, scene, organ, holding, memory);
  if (!near.any()) {
    return {};
  }
  if (organ.atRest()) {
    return touchAll(scene.collision, shape, scene, organ, near, memory, [&](PartMemory& tip) {
      const SurfacePoint surface = scene.collision.closest(shape.tip_m, tip.triangle);
      tip.triangle = surface.triangle;
      return fromSurface(shape.tip_m, surface, shape.tipRadius_m);
    });
  }
  return askDeformed(scene, organ, [&](DeformedSurface& surface, const auto& toRest_m) {
    return touchAll(surface, shape, scene, organ, near, memory, [&](PartMemory& tip) {
      return touchTipOf(surface, shape, scene, organ, toRest_m, tip, memory.place);
    });
  });
}

SurfacePoint nearestSurface(const Vec3& point_m, const Scene& scene, const OrganState& organ) noexcept {
  if (organ.atRest()) {
    return scene.collision.closest(point_m);
  }
  return askDeformed(scene, organ,
                     [&](DeformedSurface& surface, const auto&) { return surface.closest(point_m); });
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
