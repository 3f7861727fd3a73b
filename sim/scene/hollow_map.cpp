// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/hollow_map.h"

#include <algorithm>
#include <cmath>

#include "sim/base/portable_math.h"

namespace torsio {

namespace {

constexpr int kInverseSteps = 12;
constexpr double kInverseTolerance = 1e-14;  // of the organ's length
constexpr double kLargestStep = 0.1;         // of the organ's length

Vec3 turnedAbout(const Vec3& x, const Vec3& centre, const Vec3& axis, double angle_rad,
                 double radius) noexcept {
  const Vec3 u = x - centre;
  const SinCos a = portableSinCos(angle_rad);
  const Vec3 across = u - dot(axis, u) * axis;
  return x + (radius * a.cos - 1.0) * across + (radius * a.sin) * cross(axis, u);
}

}  // namespace

HollowMap::HollowMap(const TwistModel& model, const HollowOrgan& organ, const OrganState& state) noexcept
    : model_(model), organ_(organ), angle_rad_(state.twist.graspAngle_rad) {
  for (int span = 0; span < organ.spans(); ++span) {
    Profile& profile = profiles_[static_cast<std::size_t>(span)];
    for (std::size_t i = 0; i < kPlaces; ++i) {
      profile[i] = organ.sectionIn(span, static_cast<double>(i) / static_cast<double>(kPlaces - 1), state);
    }
    profile.front() = {};
    profile.back() = {angle_rad_, 1.0};
  }
}

HollowOrgan::Section HollowMap::section(double arc_m) const noexcept {
  const HollowOrgan::Place place = organ_.placeOf(arc_m);
  if (place.span < 0) {
    return {angle_rad_, 1.0};
  }
  const Profile& profile = profiles_[static_cast<std::size_t>(place.span)];
  const double at = place.share * static_cast<double>(kPlaces - 1);
  const std::size_t cell = std::min(static_cast<std::size_t>(at), kPlaces - 2);
  const double share = at - static_cast<double>(cell);
  const HollowOrgan::Section& low = profile[cell];
  const HollowOrgan::Section& high = profile[cell + 1];
  return {low.turn_rad + share * (high.turn_rad - low.turn_rad),
          low.radius + share * (high.radius - low.radius)};
}

Vec3 HollowMap::vertex(const TwistVertex& vertex) const noexcept {
  const HollowOrgan::Section here = section(vertex.arc_m);
  return turnedAbout(vertex.rest_m, vertex.line.point_m, vertex.line.direction, here.turn_rad, here.radius);
}

Vec3 HollowMap::forward(const Vec3& rest_m) const noexcept {
  const double arc_m = model_.tables().arcs.arcAt(model_.lattice(), rest_m);
  const AxisFrame frame = model_.graspFrame(arc_m);
  const HollowOrgan::Section here = section(arc_m);
  return turnedAbout(rest_m, frame.centre_m, frame.tangent, here.turn_rad, here.radius);
}

Vec3 HollowMap::unwound(const Vec3& deformed_m, double arc_m) const noexcept {
  const AxisFrame frame = model_.graspFrame(arc_m);
  const HollowOrgan::Section here = section(arc_m);
  return turnedAbout(deformed_m, frame.centre_m, frame.tangent, -here.turn_rad, 1.0 / here.radius);
}

// Zero when the point, turned back as one of this arc length, has this arc length.
double HollowMap::miss(const Vec3& deformed_m, double arc_m) const noexcept {
  return model_.tables().arcs.arcAt(model_.lattice(), unwound(deformed_m, arc_m)) - arc_m;
}

// Secant steps from the nearest point of the axis, as TwistMap::backward; the best arc length met counts.
Vec3 HollowMap::backward(const Vec3& deformed_m) const noexcept {
  const double length_m = organ_.length_m();
  double before_m = model_.lattice().nearestArc_m(deformed_m);
  double missBefore_m = miss(deformed_m, before_m);
  double best_m = before_m;
  double least_m = std::abs(missBefore_m);
  double arc_m = std::clamp(before_m + missBefore_m, 0.0, length_m);
  for (int i = 0; i < kInverseSteps && least_m > kInverseTolerance * length_m; ++i) {
    const double here_m = miss(deformed_m, arc_m);
    if (std::abs(here_m) < least_m) {
      best_m = arc_m;
      least_m = std::abs(here_m);
    }
    const double change_m = here_m - missBefore_m;
    double next_m = change_m != 0.0 ? arc_m - here_m * (arc_m - before_m) / change_m : arc_m + here_m;
    if (!(std::abs(next_m - arc_m) <= kLargestStep * length_m)) {
      next_m = arc_m + 0.5 * here_m;
    }
    before_m = arc_m;
    missBefore_m = here_m;
    arc_m = std::clamp(next_m, 0.0, length_m);
  }
  return unwound(deformed_m, best_m);
}

}  // namespace torsio
