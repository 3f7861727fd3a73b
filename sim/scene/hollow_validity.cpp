// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/hollow_validity.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/core/angle.h"
#include "sim/core/short_number.h"

namespace torsio {

namespace {

// Of the tables of docs/validation.md.
constexpr double kCheckedPressure = 0.5;  // p R / (G t)
constexpr double kThickestChecked = 0.1;  // t / R
constexpr double kLongestChecked = 12.0;  // L / R
constexpr double kShortestChecked = 3.0;
constexpr double kRounding = 1.001;

Text joined(const std::vector<Text>& limits) {
  Text all;
  for (const Text& limit : limits) {
    all = all.empty() ? limit : Text::tr("%1; %2", all, limit);
  }
  return all;
}

}  // namespace

Text wallLimitsPassed(const WrungCase& wrung) {
  double pressure = 0.0;
  double thickness = 0.0;
  double radius_m = 0.0;
  for (const WallPlace& place : wrung.places) {
    pressure =
        std::max(pressure, wrung.pressure_Pa * place.radius_m / (wrung.shearModulus_Pa * place.thickness_m));
    thickness = std::max(thickness, place.thickness_m / place.radius_m);
    radius_m += place.radius_m / static_cast<double>(wrung.places.size());
  }
  const double length = wrung.length_m / radius_m;
  std::vector<Text> limits;
  if (std::abs(wrung.twist_rad) > wrung.closing_rad) {
    limits.push_back(Text::tr(
        "beyond a twist of %1 degrees the waist is packed with wall: the torque is that of a rope, its "
        "order of size only",
        shortNumber(degrees(wrung.closing_rad))));
  }
  if (pressure > kRounding * kCheckedPressure) {
    limits.push_back(
        Text::tr("pressure times radius over stiffness times wall is %1; the law of the wall is "
                 "checked up to %2",
                 shortNumber(pressure), shortNumber(kCheckedPressure)));
  }
  if (thickness > kRounding * kThickestChecked) {
    limits.push_back(Text::tr("the wall is up to %1 of its radius thick; its law is checked up to %2",
                              shortNumber(thickness), shortNumber(kThickestChecked)));
  }
  if (length > kRounding * kLongestChecked || kRounding * length < kShortestChecked) {
    limits.push_back(
        Text::tr("the wrung stretch is %1 times as long as its radius; its law is checked for %2 to "
                 "%3",
                 shortNumber(length), shortNumber(kShortestChecked), shortNumber(kLongestChecked)));
  }
  return joined(limits);
}

Text wallLimitsPassed(const HollowOrgan& organ, const OrganState& state) {
  const HollowWall& wall = organ.detorsion().wall;
  const double angle_rad = state.twist.graspAngle_rad;
  const double pressure_Pa = state.hollow.reading.pressure_Pa;
  Text worst;
  std::size_t most = 0;
  for (int span = 0; span < organ.spans() && organ.tube(span) != nullptr; ++span) {
    const WrungSpan& at = organ.detorsion().spans[static_cast<std::size_t>(span)];
    const Text passed = wallLimitsPassed({.places = organ.wallOf(span),
                                          .length_m = std::abs(at.mobile - at.held) * organ.length_m(),
                                          .shearModulus_Pa = organ.shearModulus_Pa(),
                                          .pressure_Pa = std::max(pressure_Pa, wall.restPressure_Pa),
                                          .twist_rad = organ.wrungBy_rad(span, angle_rad),
                                          .closing_rad = organ.tube(span)->closing_rad(pressure_Pa)});
    if (passed.str().size() > most) {
      most = passed.str().size();
      worst = passed;
    }
  }
  return worst;
}

}  // namespace torsio
