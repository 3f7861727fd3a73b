// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/hollow_reach.h"

#include <algorithm>
#include <cmath>

#include "sim/core/angle.h"
#include "sim/core/portable_math.h"
#include "sim/scene/hollow_map.h"
#include "sim/scene/hollow_organ.h"

namespace torsio {

namespace {

// Rounding, of coordinates and of angles of some turns.
constexpr double kRoundingShare = 1.0 + 1e-9;
constexpr double kRounding_m = 1e-12;

Vec3 acrossOf(const Vec3& u, const Vec3& direction) {
  return u - dot(u, direction) * direction;
}

/// 2 sin(x / 2) from above, 2 from half a turn on: how far a unit lever arm goes.
double chordOf(double turn_rad) noexcept {
  if (turn_rad >= kPi) {
    return 2.0;
  }
  const double y2 = 0.25 * turn_rad * turn_rad;
  return turn_rad * (1.0 - y2 * (1.0 / 6.0 - y2 / 120.0));
}

}  // namespace

HollowReach::Lever HollowReach::leverOf(const HollowOrgan& organ, std::size_t vertex) {
  const TwistVertex& v = organ.vertices()[vertex];
  const HollowOrgan::Place place = organ.turningPlace(v.arc_m, v.rest_m);
  const TwistLine line = organ.lineOf(v.line, place);
  Lever lever;
  lever.line = line.direction;
  lever.span = place.span;
  lever.share = place.share;
  if (organ.wound() || place.span < 0) {
    lever.across_m = acrossOf(v.rest_m - line.point_m, line.direction);
    lever.foot_m = v.rest_m - lever.across_m;
    return lever;
  }
  lever.foot_m = v.line.point_m;
  const Vec3 u = v.rest_m - lever.foot_m;
  lever.across_m = acrossOf(u, v.line.direction);
  lever.along_m = u - lever.across_m;
  return lever;
}

// With one turn and radius for all, a vertex is from the seed by k + a cos(turn) + b sin(turn). Between two
// angles that is a sum of the values there with weights w, w', less (w + w' - 1) k; each weight is at most
// step / sin(step) times that of a straight line.
HollowReach::Piece HollowReach::measured(const Lever& seed, const std::vector<Lever>& levers,
                                         std::span<const std::uint32_t> vertices) {
  constexpr double kStep_rad = kTurn / static_cast<double>(kAngles);
  const double weight = kStep_rad / portableSinCos(kStep_rad).sin;
  const double excess = 1.0 / portableSinCos(0.5 * kStep_rad).cos - 1.0;
  std::array<SinCos, kAngles> turns;
  for (std::size_t i = 0; i < kAngles; ++i) {
    turns[i] = portableSinCos(kStep_rad * static_cast<double>(i));
  }
  Piece piece;
  piece.span = seed.span;
  piece.share = seed.share;
  std::array<double, kRadii> steady2{};
  for (const std::uint32_t vertex : vertices) {
    const Lever& v = levers[vertex];
    if (v.span < 0) {
      piece.mobile = true;
    } else {
      Range& range = piece.spans[static_cast<std::size_t>(v.span)];
      range = range.to < range.from ? Range{v.share, v.share}
                                    : Range{std::min(range.from, v.share), std::max(range.to, v.share)};
    }
    piece.across_m = std::max(piece.across_m, norm(v.across_m));
    piece.along_m = std::max(piece.along_m, norm(acrossOf(v.along_m, v.line)));
    for (std::size_t r = 0; r < kRadii; ++r) {
      const auto radius = static_cast<double>(r);
      const Vec3 own = v.along_m + radius * v.across_m;
      const Vec3 other = seed.along_m + radius * seed.across_m;
      const Vec3 a = acrossOf(own, v.line) - acrossOf(other, seed.line);
      const Vec3 b = cross(v.line, own) - cross(seed.line, other);
      const Vec3 k = (v.foot_m + own) - (seed.foot_m + other) - a;
      steady2[r] = std::max(steady2[r], dot(k, k));
      for (std::size_t i = 0; i < kAngles; ++i) {
        const Vec3 away = k + turns[i].cos * a + turns[i].sin * b;
        piece.reach_m[r][i] = std::max(piece.reach_m[r][i], dot(away, away));
      }
    }
  }
  for (std::size_t r = 0; r < kRadii; ++r) {
    for (double& reach_m : piece.reach_m[r]) {
      reach_m = weight * std::sqrt(reach_m) + excess * std::sqrt(steady2[r]);
    }
  }
  return piece;
}

HollowReach::HollowReach(const HollowOrgan& organ, const SurfacePatches& patches) {
  std::vector<Lever> levers;
  for (std::size_t i = 0; i < organ.vertices().size(); ++i) {
    levers.push_back(leverOf(organ, i));
  }
  for (const SurfacePatches::Patch& patch : patches.patches()) {
    patches_.push_back(measured(levers[patch.seed], levers, patches.vertices(patch)));
  }
  for (const SurfacePatches::Group& group : patches.groups()) {
    std::vector<std::uint32_t> vertices;
    for (std::size_t p = group.firstPatch; p < group.firstPatch + group.patchCount; ++p) {
      const auto own = patches.vertices(patches.patches()[p]);
      vertices.insert(vertices.end(), own.begin(), own.end());
    }
    groups_.push_back(measured(levers[group.seed], levers, vertices));
  }
}

double HollowReach::reachOf_m(const Piece& piece, const HollowMap& map) noexcept {
  const HollowOrgan::Section seed = map.section({piece.span, piece.share});
  double turn_rad = 0.0;  // by which any section is turned otherwise than the seed's
  double radius = 0.0;    // by which it is narrower or wider
  double widest = 0.0;
  const auto look = [&](const HollowMap::Spread& spread) {
    turn_rad =
        std::max({turn_rad, spread.most.turn_rad - seed.turn_rad, seed.turn_rad - spread.least.turn_rad});
    radius = std::max({radius, spread.most.radius - seed.radius, seed.radius - spread.least.radius});
    widest = std::max(widest, spread.most.radius);
  };
  for (std::size_t span = 0; span < piece.spans.size(); ++span) {
    const Range& range = piece.spans[span];
    if (!(range.to < range.from)) {
      look(map.spread(static_cast<int>(span), range.from, range.to));
    }
  }
  if (piece.mobile) {
    look(map.spread(-1, 1.0, 1.0));
  }
  const double turns = seed.turn_rad / kTurn;
  const double at = (turns - std::floor(turns)) * static_cast<double>(kAngles);
  const std::size_t low = std::min(static_cast<std::size_t>(at), kAngles - 1);
  const std::size_t high = low + 1 < kAngles ? low + 1 : 0;
  const double share = at - static_cast<double>(low);
  std::array<double, kRadii> reach_m;
  for (std::size_t r = 0; r < kRadii; ++r) {
    reach_m[r] = piece.reach_m[r][low] + share * (piece.reach_m[r][high] - piece.reach_m[r][low]);
  }
  double even_m = reach_m[0] + seed.radius * (reach_m[1] - reach_m[0]);
  if (seed.radius > 1.0) {
    even_m = reach_m[1] +
             (seed.radius - 1.0) * (seed.radius > 2.0 ? reach_m[1] + reach_m[2] : reach_m[2] - reach_m[1]);
  }
  const double otherwise_m =
      radius * piece.across_m + chordOf(turn_rad) * (widest * piece.across_m + piece.along_m);
  return kRoundingShare * (even_m + otherwise_m) + kRounding_m;
}

double HollowReach::group_m(std::size_t group, const HollowMap& map) const noexcept {
  return reachOf_m(groups_[group], map);
}

double HollowReach::patch_m(std::size_t patch, const HollowMap& map) const noexcept {
  return reachOf_m(patches_[patch], map);
}

}  // namespace torsio
