// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/hollow_skin.h"

#include <algorithm>

#include "sim/base/angle.h"
#include "sim/tissue/hollow/fold_field.h"

namespace torsio {

HollowSkin::HollowSkin(const HollowOrgan& organ, const OrganState& state) noexcept
    : organ_(organ), angle_rad_(state.twist.graspAngle_rad) {
  for (int span = 0; span < (organ.wound() ? 1 : organ.spans()); ++span) {
    fill(span, state, limbs_[static_cast<std::size_t>(span)]);
  }
}

void HollowSkin::fill(int span, const OrganState& state, Limb& limb) const noexcept {
  const WrungOrgan* tube = organ_.tube(span);
  const double pressure_Pa = state.hollow.reading.pressure_Pa;
  limb.waves = tube != nullptr ? drawnWaves(tube->waves(pressure_Pa)) : kFewestDrawnWaves;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kPlaces - 1);
    const HollowOrgan::Section section = organ_.sectionIn(span, share, state);
    Place& place = limb.places[i];
    place.turn_rad = section.turn_rad;
    place.radius = section.radius;
    if (tube != nullptr) {
      const WrungPlace wrung = tube->placeAt(share, angle_rad_, pressure_Pa);
      place.amplitude = foldAmplitude(limb.waves, wrung.slack);
      place.crest_rad = wrung.foldTurn;
    }
  }
  limb.places.front() = {};
  limb.places.back().turn_rad = angle_rad_;
}

HollowSkin::Place HollowSkin::placeAt(const Limb& limb, double share) const noexcept {
  const double at = share * static_cast<double>(kPlaces - 1);
  const std::size_t cell = std::min(static_cast<std::size_t>(at), kPlaces - 2);
  const double rest = at - static_cast<double>(cell);
  const Place& low = limb.places[cell];
  const Place& high = limb.places[cell + 1];
  const auto mix = [rest](double from, double to) { return from + rest * (to - from); };
  return {mix(low.turn_rad, high.turn_rad), mix(low.radius, high.radius), mix(low.amplitude, high.amplitude),
          mix(low.crest_rad, high.crest_rad)};
}

void HollowSkin::write(int span, Cells& cells) const noexcept {
  const Limb& limb = limbs_[static_cast<std::size_t>(span)];
  const double wavesPerHalfTurn = limb.waves / kPi;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Place& low = limb.places[i];
    const Place& middle = limb.places[i + 1];
    const Place& high = limb.places[i + 2];
    const auto line = [&](double Place::*what, double unit) -> KinkedLine {
      const double before = middle.*what - low.*what;
      const double after = high.*what - middle.*what;
      return {static_cast<float>(unit * (middle.*what)), static_cast<float>(0.5 * unit * (before + after)),
              static_cast<float>(0.5 * unit * (after - before))};
    };
    cells[i] = {line(&Place::turn_rad, 1.0 / kPi), line(&Place::radius, 1.0), line(&Place::amplitude, 1.0),
                line(&Place::crest_rad, wavesPerHalfTurn)};
  }
}

bool HollowSkin::rests() const noexcept {
  const auto still = [](const Place& place) {
    return place.turn_rad == 0.0 && place.radius == 1.0 && place.amplitude == 0.0;
  };
  return angle_rad_ == 0.0 && std::all_of(limbs_.begin(), limbs_.end(), [&](const Limb& limb) {
           return std::all_of(limb.places.begin(), limb.places.end(), still);
         });
}

// Folds belong where the wall is narrower: at the place whose turn and radius the vertex has.
Vec3 HollowSkin::vertex(const TwistVertex& vertex, double round_rad) const noexcept {
  const HollowOrgan::Place where = organ_.turningPlace(vertex.arc_m, vertex.rest_m);
  Place place{angle_rad_, 1.0, 0.0, 0.0};
  FoldedPoint fold;
  if (where.span >= 0) {
    const Limb& limb = limbs_[static_cast<std::size_t>(where.span)];
    place = placeAt(limb, where.share);
    fold = foldedPoint({limb.waves, place.amplitude, place.crest_rad}, round_rad);
  }
  return organ_.moved(vertex.rest_m, vertex.line, where, {place.turn_rad, place.radius},
                      {fold.turn_rad, fold.radius});
}

}  // namespace torsio
