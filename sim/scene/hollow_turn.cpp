// SPDX-License-Identifier: GPL-3.0-or-later
// How the sections of a hollow organ that came twisted go round: rigidly about one line in its mobile part.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "sim/base/portable_math.h"
#include "sim/scene/hollow_organ.h"

namespace torsio {

namespace {

/// Turns a point about a line and draws it nearer; one that is not moved keeps its bits.
Vec3 turnedAbout(const Vec3& x, const TwistLine& line, double angle_rad, double radius) noexcept {
  if (angle_rad == 0.0 && radius == 1.0) {
    return x;
  }
  const Vec3 u = x - line.point_m;
  const SinCos a = portableSinCos(angle_rad);
  const Vec3 across = u - dot(line.direction, u) * line.direction;
  return x + (radius * a.cos - 1.0) * across + (radius * a.sin) * cross(line.direction, u);
}

}  // namespace

void HollowOrgan::drawLine(const SectionLattice& lattice) {
  const auto frameAt = [&](double fraction) { return lattice.frameAt(fraction * length_m_); };
  const AxisFrame end = frameAt(detorsion_.spans.front().mobile);
  line_ = {end.centre_m, end.tangent};
  if (detorsion_.spans.size() < 2) {
    return;
  }
  const AxisFrame other = frameAt(detorsion_.spans.back().mobile);
  wound_ = dot(end.tangent, other.tangent) < 0.0;
  if (wound_) {
    const Vec3 foot_m = 0.5 * (frameAt(detorsion_.spans.front().held).centre_m +
                               frameAt(detorsion_.spans.back().held).centre_m);
    line_ = {foot_m, normalized(0.5 * (end.centre_m + other.centre_m) - foot_m)};
    for (std::size_t i = 0; i < kWallPlaces; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(kWallPlaces - 1);
      double sum_m = 0.0;
      for (const WrungSpan& span : detorsion_.spans) {
        const AxisFrame frame = frameAt(span.held + share * (span.mobile - span.held));
        sum_m += dot(frame.centre_m - foot_m, line_.direction);
      }
      heights_m_[i] = std::max(0.5 * sum_m, i > 0 ? heights_m_[i - 1] : 0.5 * sum_m);
    }
  } else {
    const Vec3 chord = normalized(other.centre_m - end.centre_m);
    line_.direction = dot(chord, end.tangent) < 0.0 ? -1.0 * chord : chord;
  }
}

HollowOrgan::Place HollowOrgan::turningPlace(double arc_m, const Vec3& point_m) const noexcept {
  if (!wound_) {
    return placeOf(arc_m);
  }
  const double height_m = dot(point_m - line_.point_m, line_.direction);
  if (height_m >= heights_m_.back()) {
    return {};
  }
  if (height_m <= heights_m_.front()) {
    return {0, 0.0};
  }
  const auto above = std::upper_bound(heights_m_.begin(), heights_m_.end(), height_m);
  const double low_m = *std::prev(above);
  const double cell = static_cast<double>(std::distance(heights_m_.begin(), above) - 1);
  return {0, (cell + (height_m - low_m) / (*above - low_m)) / static_cast<double>(kWallPlaces - 1)};
}

TwistLine HollowOrgan::lineOf(const TwistLine& own, const Place& place) const noexcept {
  if (wound_ || place.span < 0) {
    return line_;
  }
  // Late, so that the narrow places, where most of the turn is, keep their own axis.
  const double square = place.share * place.share;
  const double towards = square * square;
  return {own.point_m, normalized(own.direction + towards * (line_.direction - own.direction))};
}

Vec3 HollowOrgan::moved(const Vec3& rest_m, const TwistLine& own, const Place& place, const Section& section,
                        const Fold& fold) const noexcept {
  const double ownRadius = wound_ ? fold.radius : section.radius * fold.radius;
  const Vec3 shaped_m = turnedAbout(rest_m, own, fold.turn_rad, ownRadius);
  return turnedAbout(shaped_m, lineOf(own, place), section.turn_rad, wound_ ? section.radius : 1.0);
}

Vec3 HollowOrgan::movedBack(const Vec3& deformed_m, const TwistLine& own, const Place& place,
                            const Section& section) const noexcept {
  const double back = 1.0 / section.radius;
  const Vec3 shaped_m = turnedAbout(deformed_m, lineOf(own, place), -section.turn_rad, wound_ ? back : 1.0);
  return turnedAbout(shaped_m, own, 0.0, wound_ ? 1.0 : back);
}

AxisFrame HollowOrgan::graspFrame(const Vec3& held_m) const noexcept {
  const Vec3 way = held_m - line_.point_m;
  const double height_m = dot(way, line_.direction);
  const Vec3 across = way - height_m * line_.direction;
  const double arm_m = norm(across);
  AxisFrame frame;
  frame.centre_m = line_.point_m + height_m * line_.direction;
  frame.tangent = line_.direction;
  const Vec3 d = line_.direction;
  const Vec3 aside = std::abs(d.x) < 0.5 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  frame.e1 = arm_m > 0.0 ? across / arm_m : normalized(cross(d, aside));
  frame.e2 = cross(frame.tangent, frame.e1);
  return frame;
}

}  // namespace torsio
