// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/hollow_validity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "sim/core/angle.h"
#include "sim/core/short_number.h"
#include "sim/tissue/hollow/tube_onset.h"

namespace torsio {

namespace {

// Of the tables of docs/validation.md, "Folded tubes compared with CalculiX"; of the unloaded wall.
constexpr double kTautPressure = 2.1;  // p R / (G t)
constexpr double kFoldedPressure = 0.5;
constexpr double kTautThickness = 0.48;  // t / R
constexpr double kFoldedThickness = 0.15;
constexpr double kLongestChecked = 12.0;  // L / R
constexpr double kShortestChecked = 3.0;
constexpr double kRounding = 1.001;
constexpr double kEmpty = 0.05;  // p R / (G t) below which an empty tube is the nearest checked one

// Torque over that of solid elements, less 1.
constexpr std::array kTaut{-0.07, 0.07};
constexpr std::array kFoldedUnderPressure{-0.09, 0.04};
constexpr std::array kFoldedEmpty{-0.16, 0.32};

Text joined(const std::vector<Text>& limits) {
  Text all;
  for (const Text& limit : limits) {
    all = all.empty() ? limit : Text::tr("%1; %2", all, limit);
  }
  return all;
}

// Largest over the places, and the mean length, of the wall without its rest pressure.
struct Unloaded {
  double pressure = 0.0;
  double thickness = 0.0;
  double length = 0.0;
};

Unloaded unloaded(const WrungCase& wrung) {
  Unloaded wall;
  double radius_m = 0.0;
  for (const WallPlace& place : wrung.places) {
    const double perThickness = place.radius_m / (wrung.shearModulus_Pa * place.thickness_m);
    const double stretch = restStretch(wrung.restPressure_Pa * perThickness, wrung.gentLimit);
    const double square = stretch * stretch;
    wall.pressure = std::max(wall.pressure, wrung.pressure_Pa * perThickness / square);
    wall.thickness = std::max(wall.thickness, square * place.thickness_m / place.radius_m);
    radius_m += place.radius_m / stretch / static_cast<double>(wrung.places.size());
  }
  wall.length = wrung.length_m / radius_m;
  return wall;
}

void add(WallValidity& sum, const WallValidity& part) {
  if (part.beyond.str().size() > sum.beyond.str().size()) {
    sum.beyond = part.beyond;
  }
  if (!sum.torqueError || !part.torqueError) {
    sum.torqueError = part.torqueError;
    return;
  }
  auto& [least, most] = *sum.torqueError;
  least = std::min(least, part.torqueError->front());
  most = std::max(most, part.torqueError->back());
}

std::string percent(double share) {
  return (share > 0.0 ? "+" : "") + shortNumber(std::round(100.0 * share));
}

}  // namespace

WallValidity wallValidity(const WrungCase& wrung) {
  const Unloaded wall = unloaded(wrung);
  const double twist_rad = std::abs(wrung.twist_rad);
  const bool folded = twist_rad > wrung.taut_rad;
  const double mostPressure = folded ? kFoldedPressure : kTautPressure;
  const double thickest = folded ? kFoldedThickness : kTautThickness;
  std::vector<Text> limits;
  if (twist_rad > wrung.closing_rad) {
    limits.push_back(Text::tr(
        "beyond a twist of %1 degrees the waist is packed with wall: the torque is that of a rope, its "
        "order of size only",
        shortNumber(degrees(wrung.closing_rad))));
  }
  if (wall.pressure > kRounding * mostPressure) {
    limits.push_back(
        folded ? Text::tr("folded beyond %1 degrees under a pressure times radius over stiffness times "
                          "wall of %2; folds are checked up to %3",
                          shortNumber(degrees(wrung.taut_rad)), shortNumber(wall.pressure),
                          shortNumber(mostPressure))
               : Text::tr("pressure times radius over stiffness times wall is %1; the law of the wall is "
                          "checked up to %2",
                          shortNumber(wall.pressure), shortNumber(mostPressure)));
  }
  if (wall.thickness > kRounding * thickest) {
    limits.push_back(Text::tr("the wall is up to %1 of its radius thick; its law is checked up to %2",
                              shortNumber(wall.thickness), shortNumber(thickest)));
  }
  if (wall.length > kRounding * kLongestChecked || kRounding * wall.length < kShortestChecked) {
    limits.push_back(
        Text::tr("the wrung stretch is %1 times as long as its radius; its law is checked for %2 to "
                 "%3",
                 shortNumber(wall.length), shortNumber(kShortestChecked), shortNumber(kLongestChecked)));
  }
  WallValidity validity{joined(limits), {}};
  if (limits.empty()) {
    const std::array<double, 2>& underFolds = wall.pressure < kEmpty ? kFoldedEmpty : kFoldedUnderPressure;
    validity.torqueError = folded ? underFolds : kTaut;
  }
  return validity;
}

WallValidity wallValidity(const HollowOrgan& organ, const OrganState& state) {
  const HollowWall& wall = organ.detorsion().wall;
  const double angle_rad = state.twist.graspAngle_rad;
  const double pressure_Pa = state.hollow.reading.pressure_Pa;
  std::optional<WallValidity> all;
  for (int span = 0; span < organ.spans() && organ.tube(span) != nullptr; ++span) {
    const WrungSpan& at = organ.detorsion().spans[static_cast<std::size_t>(span)];
    const WallValidity one = wallValidity({.places = organ.wallOf(span),
                                           .length_m = std::abs(at.mobile - at.held) * organ.length_m(),
                                           .shearModulus_Pa = organ.shearModulus_Pa(),
                                           .gentLimit = wall.gentLimit,
                                           .restPressure_Pa = wall.restPressure_Pa,
                                           .pressure_Pa = pressure_Pa,
                                           .twist_rad = organ.wrungBy_rad(span, angle_rad),
                                           .taut_rad = organ.tube(span)->taut_rad(pressure_Pa),
                                           .closing_rad = organ.tube(span)->closing_rad(pressure_Pa)});
    all ? add(*all, one) : void(all = one);
  }
  return all.value_or(WallValidity{});
}

ValidTurn validTurn(const HollowOrgan& organ) {
  const double start_rad = organ.detorsion().start.most_rad;
  const double most_rad = organ.tube(0) == nullptr ? 0.0 : organ.within_rad(start_rad + kPi);
  const auto beyondAt = [&organ](double turn_rad) {
    const Text there = wallValidity(organ, organ.stateAt(turn_rad)).beyond;
    return there.empty() ? wallValidity(organ, organ.stateAt(-turn_rad)).beyond : there;
  };
  ValidTurn valid{organ.tube(0) == nullptr ? std::numeric_limits<double>::infinity() : 0.0, {}};
  while (valid.to_rad < most_rad) {
    const double next_rad = std::min(valid.to_rad + radians(1.0), most_rad);
    valid.beyond = beyondAt(next_rad);
    if (!valid.beyond.empty()) {
      valid.beyond = beyondAt(std::max(next_rad, start_rad));
      break;
    }
    valid.to_rad = next_rad;
  }
  return valid;
}

Text validityText(const HollowOrgan& organ) {
  if (organ.tube(0) == nullptr) {
    return {};
  }
  const ValidTurn valid = validTurn(organ);
  const auto& [least, most] =
      wallValidity(organ, organ.stateAt(valid.to_rad)).torqueError.value_or(std::array{0.0, 0.0});
  const Text checked =
      Text::tr("Checked with solid elements up to a turn of %1 degrees: the torque is off by %2 to %3 %",
               shortNumber(std::round(degrees(valid.to_rad))), percent(least), percent(most));
  return valid.to_rad < organ.detorsion().start.most_rad
             ? Text::tr("%1. As it comes, it may be beyond that: %2.", checked, valid.beyond)
             : Text::tr("%1.", checked);
}

}  // namespace torsio
