// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/hollow_map.h"

#include <algorithm>
#include <cmath>

namespace torsio {

namespace {

constexpr double kGoodInverse = 1e-9;  // of the organ's length
constexpr int kPlacesTried = 32;
constexpr int kHalvings = 40;  // of a place's distance from the next

}  // namespace

HollowMap::HollowMap(const SectionLattice& lattice, const HollowOrgan& organ,
                     const OrganState& state) noexcept
    : lattice_(lattice), organ_(organ), angle_rad_(state.twist.graspAngle_rad) {
  for (int span = 0; span < organ.spans(); ++span) {
    organ.sectionsOf(span, state, profiles_[static_cast<std::size_t>(span)]);
  }
}

HollowOrgan::Section HollowMap::section(const HollowOrgan::Place& place) const noexcept {
  if (place.span < 0) {
    return {angle_rad_, 1.0};
  }
  const HollowOrgan::Sections& profile = profiles_[static_cast<std::size_t>(place.span)];
  constexpr std::size_t kCells = HollowOrgan::kPlaces - 1;
  const double at = place.share * static_cast<double>(kCells);
  const std::size_t cell = std::min(static_cast<std::size_t>(at), kCells - 1);
  const double share = at - static_cast<double>(cell);
  const HollowOrgan::Section& low = profile[cell];
  const HollowOrgan::Section& high = profile[cell + 1];
  return {low.turn_rad + share * (high.turn_rad - low.turn_rad),
          low.radius + share * (high.radius - low.radius)};
}

// Between two nodes of a profile turn and radius go straight.
HollowMap::Spread HollowMap::spread(int span, double from, double to) const noexcept {
  const HollowOrgan::Section first = section({span, from});
  Spread spread{first, first};
  const auto widen = [&spread](const HollowOrgan::Section& section) {
    spread.least.turn_rad = std::min(spread.least.turn_rad, section.turn_rad);
    spread.least.radius = std::min(spread.least.radius, section.radius);
    spread.most.turn_rad = std::max(spread.most.turn_rad, section.turn_rad);
    spread.most.radius = std::max(spread.most.radius, section.radius);
  };
  widen(section({span, to}));
  if (span < 0) {
    return spread;
  }
  constexpr auto kCells = static_cast<double>(HollowOrgan::kPlaces - 1);
  const HollowOrgan::Sections& profile = profiles_[static_cast<std::size_t>(span)];
  const auto end = std::min(static_cast<std::size_t>(to * kCells), HollowOrgan::kPlaces - 1);
  for (auto node = static_cast<std::size_t>(from * kCells) + 1; node <= end; ++node) {
    widen(profile[node]);
  }
  return spread;
}

Vec3 HollowMap::vertex(const TwistVertex& vertex) const noexcept {
  const HollowOrgan::Place place = organ_.turningPlace(vertex.arc_m, vertex.rest_m);
  return organ_.moved(vertex.rest_m, vertex.line, place, section(place), {});
}

TwistLine HollowMap::ownAxis(double arc_m) const noexcept {
  const AxisFrame frame = lattice_.frameAt(arc_m);
  return {frame.centre_m, frame.tangent};
}

Vec3 HollowMap::forward(const Vec3& rest_m) const noexcept {
  const double arc_m = lattice_.nearestArc_m(rest_m);
  const HollowOrgan::Place place = organ_.turningPlace(arc_m, rest_m);
  return organ_.moved(rest_m, ownAxis(arc_m), place, section(place), {});
}

Vec3 HollowMap::unwound(const Vec3& deformed_m, double arc_m) const noexcept {
  const HollowOrgan::Place place = organ_.turningPlace(arc_m, deformed_m);
  return organ_.movedBack(deformed_m, ownAxis(arc_m), place, section(place));
}

// Zero when the point, turned back as one of this arc length, has this arc length.
double HollowMap::miss(const Vec3& deformed_m, double arc_m) const noexcept {
  return lattice_.nearestArc_m(unwound(deformed_m, arc_m)) - arc_m;
}

ArcFound HollowMap::solve(const Vec3& deformed_m, double from_m) const noexcept {
  return secantSteps([&](double arc_m) { return miss(deformed_m, arc_m); }, from_m, organ_.length_m());
}

// Halves a stretch over whose ends the miss changes its sign. Where it jumps there, it stays large.
ArcFound HollowMap::between(const Vec3& deformed_m, double low_m, double high_m) const noexcept {
  const bool lowIsNegative = miss(deformed_m, low_m) < 0.0;
  ArcFound middle{};
  for (int i = 0; i < kHalvings; ++i) {
    middle.arc_m = 0.5 * (low_m + high_m);
    const double here_m = miss(deformed_m, middle.arc_m);
    middle.miss_m = std::abs(here_m);
    ((here_m < 0.0) == lowIsNegative ? low_m : high_m) = middle.arc_m;
  }
  return middle;
}

// From where the point lies and from where it would lie if it belonged to the mobile part; of two answers the
// one nearer to the organ's axis. Of wound limbs the height says it all. Where neither converges, from the
// best of places along the organ, and between any two that it lies between.
Vec3 HollowMap::backward(const Vec3& deformed_m) const noexcept {
  if (organ_.wound()) {
    return unwound(deformed_m, 0.0);
  }
  const double length_m = organ_.length_m();
  const double good_m = kGoodInverse * length_m;
  const Vec3 asMobile_m = organ_.movedBack(deformed_m, {}, {}, {angle_rad_, 1.0});
  ArcFound best = solve(deformed_m, lattice_.nearestArc_m(asMobile_m));
  const ArcFound other = solve(deformed_m, lattice_.nearestArc_m(deformed_m));
  const auto away_m = [&](const ArcFound& found) {
    return norm(unwound(deformed_m, found.arc_m) - ownAxis(found.arc_m).point_m);
  };
  const bool bothGood = best.miss_m <= good_m && other.miss_m <= good_m;
  if (bothGood ? away_m(other) < away_m(best) : other.miss_m < best.miss_m) {
    best = other;
  }
  if (best.miss_m > good_m) {
    double before_m = miss(deformed_m, 0.0);
    ArcFound start{0.0, std::abs(before_m)};
    for (int i = 1; i <= kPlacesTried; ++i) {
      const double arc_m = length_m * i / kPlacesTried;
      const double here_m = miss(deformed_m, arc_m);
      start = std::abs(here_m) < start.miss_m ? ArcFound{arc_m, std::abs(here_m)} : start;
      if ((here_m < 0.0) != (before_m < 0.0)) {
        const ArcFound halved = between(deformed_m, arc_m - length_m / kPlacesTried, arc_m);
        best = halved.miss_m < best.miss_m ? halved : best;
      }
      before_m = here_m;
    }
    const ArcFound last = solve(deformed_m, start.arc_m);
    best = last.miss_m < best.miss_m ? last : best;
  }
  return unwound(deformed_m, best.arc_m);
}

}  // namespace torsio
