// SPDX-License-Identifier: GPL-3.0-or-later
// The gas in a hollow organ that is sealed: p V = const over the wrung spans and the mobile part.
#include <algorithm>
#include <cmath>

#include "sim/core/angle.h"
#include "sim/scene/hollow_organ.h"
#include "sim/tissue/hollow/tube_onset.h"
#include "sim/tissue/section/polygon.h"
#include "sim/tissue/section/wall_section.h"

namespace torsio {

namespace {

constexpr int kGasHalvings = 20;

constexpr int kMobilePlaces = 40;
constexpr double kThickestTube = 0.45;  // t / R: beyond it nothing is left inside

/// The wall at the middles of equal steps between two arc lengths, where it leaves a tube.
std::vector<WallPlace> tubesBetween(const SectionLattice& lattice, const WallMap& wall, double from_m,
                                    double to_m) {
  const auto [low_m, high_m] = std::minmax(from_m, to_m);
  std::vector<double> arcs_m;
  for (int i = 0; i < kMobilePlaces; ++i) {
    arcs_m.push_back(low_m + (high_m - low_m) * (i + 0.5) / kMobilePlaces);
  }
  std::vector<WallPlace> places;
  const std::vector<LatticeOutline> outlines = lattice.outlinesAt(arcs_m);
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const double thickness_m = wall.thickness_m(arcs_m[i] / lattice.length_m());
    const double radius_m = perimeter(outlines[i].points_m) / kTurn - 0.5 * thickness_m;
    if (thickness_m <= kThickestTube * radius_m) {
      places.push_back({radius_m, thickness_m});
    }
  }
  return places;
}

/// Volume of the round tubes of the wall's perimeters, m^3, which a pressure widens by the balance of their
/// hoops; `step_m`: length of each.
double widenedVolume_m3(const std::vector<WallPlace>& places, double step_m, const HollowWall& wall,
                        double shear_Pa, double pressure_Pa) {
  double volume_m3 = 0.0;
  for (const auto& [radius_m, thickness_m] : places) {
    const double rest =
        restStretch(wall.restPressure_Pa * radius_m / (shear_Pa * thickness_m), wall.gentLimit);
    const double unloaded_m = radius_m / rest;
    const double scaled = pressure_Pa * unloaded_m / (shear_Pa * thickness_m * rest);
    const double widened_m = unloaded_m * tautTube(scaled, wall.gentLimit, 0.0).stretch;
    volume_m3 += step_m * kPi * widened_m * widened_m;
  }
  return volume_m3;
}

}  // namespace

void HollowOrgan::fillMobilePart(const Parts& parts) {
  const std::vector<WrungSpan>& spans = detorsion_.spans;
  const bool forward = spans.front().held < spans.front().mobile;
  const double openEnd = forward ? 1.0 : 0.0;  // of one span the mobile part goes on to the organ's end
  const double from_m = spans.front().mobile * length_m_;
  const double to_m = (spans.size() > 1 ? spans.back().mobile : openEnd) * length_m_;
  const WallMap map(detorsion_.wall.thickness_m);
  const std::vector<WallPlace> places = tubesBetween(*parts.lattice, map, from_m, to_m);
  highestPressure_Pa_ = std::max(detorsion_.wall.restPressure_Pa, detorsion_.wall.pressure_Pa);
  for (std::size_t i = 0; i < kGasPressures; ++i) {
    const double pressure_Pa =
        highestPressure_Pa_ * static_cast<double>(i) / static_cast<double>(kGasPressures - 1);
    mobileVolume_m3_[i] = widenedVolume_m3(places, std::abs(to_m - from_m) / kMobilePlaces, detorsion_.wall,
                                           parts.shearModulus_Pa, pressure_Pa);
  }
}

double HollowOrgan::volume_m3(double angle_rad, double pressure_Pa) const noexcept {
  double place = 0.0;
  if (highestPressure_Pa_ > 0.0) {
    place = std::clamp(pressure_Pa / highestPressure_Pa_, 0.0, 1.0) * static_cast<double>(kGasPressures - 1);
  }
  const std::size_t low = std::min(static_cast<std::size_t>(place), kGasPressures - 2);
  const double share = place - static_cast<double>(low);
  double volume_m3 = mobileVolume_m3_[low] + share * (mobileVolume_m3_[low + 1] - mobileVolume_m3_[low]);
  for (const Limb& limb : limbs_) {
    volume_m3 += limb.tube->at(angle_rad, pressure_Pa).volume;
  }
  return volume_m3;
}

double HollowOrgan::gas_J(double angle_rad, double pressure_Pa) const noexcept {
  return detorsion_.wall.sealed ? (kAtmosphere_Pa + pressure_Pa) * volume_m3(angle_rad, pressure_Pa) : 0.0;
}

double HollowOrgan::sealedPressure_Pa(double angle_rad, double gas_J) const noexcept {
  // More pressure, more volume: the product rises with it, so halving finds the one pressure.
  double low_Pa = 0.0;
  double high_Pa = highestPressure_Pa_;
  for (int k = 0; k < kGasHalvings; ++k) {
    const double middle_Pa = 0.5 * (low_Pa + high_Pa);
    const bool more = (kAtmosphere_Pa + middle_Pa) * volume_m3(angle_rad, middle_Pa) > gas_J;
    (more ? high_Pa : low_Pa) = middle_Pa;
  }
  return 0.5 * (low_Pa + high_Pa);
}

}  // namespace torsio
