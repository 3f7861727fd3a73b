// SPDX-License-Identifier: GPL-3.0-or-later
// How the sections of a hollow organ that came twisted go round: rigidly about one line in its mobile part.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "sim/core/portable_math.h"
#include "sim/scene/hollow_organ.h"

namespace torsio {

namespace {

constexpr double kRoomLeft = 1.02;        // of the turn
constexpr double kNarrowestWound = 0.36;  // of the radius at rest: that of a packed wall, about
constexpr int kDrawings = 20;             // steps of the way to it

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
  ends_[0] = end.tangent;
  if (detorsion_.spans.size() < 2) {
    // What runs beside a stalk is wound round it.
    wound_ = limbs_.empty() && lattice.options().branchCut != Vec3{};
    if (wound_) {
      const Vec3 root_m = frameAt(detorsion_.spans.front().held).centre_m;
      line_ = {root_m, normalized(end.centre_m - root_m)};
      measureHeights(lattice);
    }
    return;
  }
  const AxisFrame other = frameAt(detorsion_.spans.back().mobile);
  ends_[1] = other.tangent;
  wound_ = dot(end.tangent, other.tangent) < 0.0;
  if (wound_) {
    const Vec3 foot_m = 0.5 * (frameAt(detorsion_.spans.front().held).centre_m +
                               frameAt(detorsion_.spans.back().held).centre_m);
    line_ = {foot_m, normalized(0.5 * (end.centre_m + other.centre_m) - foot_m)};
    measureHeights(lattice);
    measureRoom(lattice);
  } else {
    const Vec3 chord = normalized(other.centre_m - end.centre_m);
    line_.direction = dot(chord, end.tangent) < 0.0 ? -1.0 * chord : chord;
  }
}

void HollowOrgan::measureHeights(const SectionLattice& lattice) {
  for (std::size_t i = 0; i < kWallPlaces; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kWallPlaces - 1);
    double sum_m = 0.0;
    for (const WrungSpan& span : detorsion_.spans) {
      const double fraction = span.held + share * (span.mobile - span.held);
      sum_m += dot(lattice.frameAt(fraction * length_m_).centre_m - line_.point_m, line_.direction);
    }
    const double mean_m = sum_m / static_cast<double>(detorsion_.spans.size());
    heights_m_[i] = std::max(mean_m, i > 0 ? heights_m_[i - 1] : mean_m);
  }
}

// Two strands that are wound round each other at a distance A from their line come no nearer than 2 A as long
// as they rise by at least A for each radian: d^2 = 2 A^2 (1 + cos x) + (rise x)^2, x their difference in
// turn.
void HollowOrgan::measureRoom(const SectionLattice& lattice) {
  const auto heightAt = [this](double share) {
    const double at = share * static_cast<double>(kWallPlaces - 1);
    const std::size_t cell = std::min(static_cast<std::size_t>(at), kWallPlaces - 2);
    return heights_m_[cell] + (at - static_cast<double>(cell)) * (heights_m_[cell + 1] - heights_m_[cell]);
  };
  constexpr auto kCells = static_cast<double>(kPlaces - 1);
  for (std::size_t i = 0; i + 1 < kPlaces; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / kCells;
    double arm_m = 0.0;
    for (const WrungSpan& span : detorsion_.spans) {
      const double fraction = span.held + share * (span.mobile - span.held);
      const Vec3 way_m = lattice.frameAt(fraction * length_m_).centre_m - line_.point_m;
      arm_m += 0.5 * norm(way_m - dot(way_m, line_.direction) * line_.direction);
    }
    const double rise_m =
        heightAt((static_cast<double>(i) + 1.0) / kCells) - heightAt(static_cast<double>(i) / kCells);
    room_rad_[i] = arm_m > 0.0 ? rise_m / arm_m : 0.0;
  }
}

void HollowOrgan::wind(Sections& sections) const noexcept {
  if (detorsion_.spans.size() < 2) {
    return;  // a limb beside a stalk goes round with it
  }
  const double angle_rad = sections.back().turn_rad;
  const double way = angle_rad < 0.0 ? -1.0 : 1.0;
  const auto roomOf = [&](std::size_t i) {
    return 2.0 * room_rad_[i] / (sections[i].radius + sections[i + 1].radius);
  };
  const auto wholeRoom = [&] {
    double room_rad = 0.0;
    for (std::size_t i = 0; i + 1 < kPlaces; ++i) {
      room_rad += roomOf(i);
    }
    return room_rad;
  };
  // Limbs that have no room for the turn are drawn together where they are free to.
  const Sections alone = sections;
  const auto draw = [&](int step) {
    const double drawn = static_cast<double>(step) / kDrawings;
    for (std::size_t i = 0; i < kPlaces; ++i) {
      const double narrowest = std::min(alone[i].radius, kNarrowestWound);
      sections[i].radius = alone[i].radius + drawn * free_[i] * (narrowest - alone[i].radius);
    }
  };
  const auto tooNarrow = [&] { return wholeRoom() < kRoomLeft * std::abs(angle_rad); };
  // The nearer, the more room: the first step that leaves enough is found by halving.
  if (tooNarrow()) {
    int low = 0;
    int high = kDrawings;
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      draw(middle);
      (tooNarrow() ? low : high) = middle;
    }
    draw(high);
  }
  std::array<double, kPlaces - 1> turn_rad{};
  double over_rad = 0.0;
  double left_rad = 0.0;
  for (std::size_t i = 0; i + 1 < kPlaces; ++i) {
    const double wanted_rad = way * (sections[i + 1].turn_rad - sections[i].turn_rad);
    turn_rad[i] = std::min(wanted_rad, roomOf(i));
    over_rad += wanted_rad - turn_rad[i];
    left_rad += roomOf(i) - turn_rad[i];
  }
  const double share = left_rad > 0.0 ? over_rad / left_rad : 0.0;
  for (std::size_t i = 0; i + 2 < kPlaces; ++i) {
    const double more_rad = share * (roomOf(i) - turn_rad[i]);
    sections[i + 1].turn_rad = sections[i].turn_rad + way * (turn_rad[i] + more_rad);
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
  const double x = place.share;
  if (detorsion_.spans.size() < 2) {
    // Late, so that the narrow places, where most of the turn is, keep their own axis. The line is that of
    // the mobile end: a bend before it turns with the mobile part.
    return {own.point_m, normalized(own.direction + (x * x * x * x) * (line_.direction - own.direction))};
  }
  // As far beside its own axis as the mobile end's, in an even way: a section that tips fast runs into its
  // neighbour on the inner side of a bend.
  const Vec3 beside = line_.direction - ends_[static_cast<std::size_t>(place.span)];
  return {own.point_m, normalized(own.direction + (x * x * (3.0 - 2.0 * x)) * beside)};
}

Vec3 HollowOrgan::moved(const Vec3& rest_m, const TwistLine& own, const Place& place, const Section& section,
                        const Fold& fold) const noexcept {
  if (wound_) {
    const Vec3 folded_m = turnedAbout(rest_m, own, fold.turn_rad, fold.radius);
    return turnedAbout(folded_m, line_, section.turn_rad, section.radius);
  }
  const Vec3 shaped_m = turnedAbout(rest_m, own, 0.0, section.radius * fold.radius);
  return turnedAbout(shaped_m, lineOf(own, place), section.turn_rad + fold.turn_rad, 1.0);
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
