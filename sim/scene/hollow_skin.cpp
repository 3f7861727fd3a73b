// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/hollow_skin.h"

#include <algorithm>

#include "sim/core/angle.h"

namespace torsio {

HollowSkin::HollowSkin(const HollowOrgan& organ, const OrganState& state) noexcept
    : organ_(organ), angle_rad_(state.twist.graspAngle_rad) {
  for (int span = 0; span < (organ.wound() ? 1 : organ.spans()); ++span) {
    fill(span, state, limbs_[static_cast<std::size_t>(span)]);
  }
}

void HollowSkin::fill(int span, const OrganState& state, Limb& limb) const noexcept {
  WrungOrgan::Profile walls;
  organ_.sectionsOf(span, state, limb.sections, walls);
  const WrungOrgan* tube = organ_.tube(span);
  if (tube == nullptr) {
    return;
  }
  limb.waves = drawnWaves(tube->waves(state.hollow.reading.pressure_Pa));
  for (std::size_t i = 1; i < kPlaces; ++i) {
    limb.folds[i] = foldPhase({limb.waves, foldAmplitude(limb.waves, walls[i].slack), walls[i].foldTurn});
  }
}

HollowSkin::Place HollowSkin::placeAt(const Limb& limb, double share) const noexcept {
  const double at = share * static_cast<double>(kPlaces - 1);
  const std::size_t cell = std::min(static_cast<std::size_t>(at), kPlaces - 2);
  const double rest = at - static_cast<double>(cell);
  const auto mix = [rest](double from, double to) { return from + rest * (to - from); };
  const HollowOrgan::Section& low = limb.sections[cell];
  const HollowOrgan::Section& high = limb.sections[cell + 1];
  const FoldPhase& before = limb.folds[cell];
  const FoldPhase& after = limb.folds[cell + 1];
  return {{mix(low.turn_rad, high.turn_rad), mix(low.radius, high.radius)},
          {mix(before.even, after.even), mix(before.odd, after.odd)}};
}

bool HollowSkin::rests() const noexcept {
  const auto still = [](const Limb& limb) {
    return std::all_of(limb.sections.begin(), limb.sections.end(),
                       [](const HollowOrgan::Section& s) { return s.turn_rad == 0.0 && s.radius == 1.0; }) &&
           std::all_of(limb.folds.begin(), limb.folds.end(),
                       [](const FoldPhase& fold) { return fold.even == 0.0 && fold.odd == 0.0; });
  };
  return angle_rad_ == 0.0 && std::all_of(limbs_.begin(), limbs_.end(), still);
}

// Folds belong where the wall is narrower: at the place whose turn and radius the vertex has.
Vec3 HollowSkin::vertex(const TwistVertex& vertex, double round_rad) const noexcept {
  const HollowOrgan::Place where = organ_.turningPlace(vertex.arc_m, vertex.rest_m);
  if (where.span < 0) {
    return organ_.moved(vertex.rest_m, vertex.line, where, {angle_rad_, 1.0}, {});
  }
  const Limb& limb = limbs_[static_cast<std::size_t>(where.span)];
  const Place place = placeAt(limb, where.share);
  const FoldedPoint fold = foldedPoint(limb.waves, place.fold, roundWave(limb.waves, round_rad));
  return organ_.moved(vertex.rest_m, vertex.line, where, place.section, {fold.turn_rad, fold.radius});
}

}  // namespace torsio
