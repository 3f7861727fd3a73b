// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/hollow/wrung_organ.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr double kThickest = 0.45;  // t / R
constexpr int kPressureHalvings = 30;
constexpr double kPull = 0.02;  // on free ends, over 2 pi R G t: what lies beyond pulls a little; assumed

void check(std::span<const WallPlace> places, double length_m, const HollowContent& content) {
  const auto positive = [](double x) { return x > 0.0 && std::isfinite(x); };
  if (!positive(content.shearModulus_Pa)) {
    refuseParameter(Text::verbatim("the shear modulus is %1 Pa, but must be above 0",
                                   std::to_string(content.shearModulus_Pa)),
                    Text::verbatim("material"),
                    Text::verbatim("Give G in pascal; for nearly incompressible tissue it is E / 3."));
  }
  if (!(content.restPressure_Pa >= 0.0 && content.highestPressure_Pa >= content.restPressure_Pa &&
        std::isfinite(content.highestPressure_Pa))) {
    refuseParameter(Text::verbatim("the pressure over outside must not be negative"),
                    Text::verbatim("pressure"), Text::verbatim("Give 0 for an empty organ."));
  }
  for (const WallPlace& place : places) {
    if (!positive(place.thickness_m) || !positive(place.radius_m) ||
        place.thickness_m > kThickest * place.radius_m) {
      refuseParameter(
          Text::verbatim("a wall of %1 mm leaves no tube where the organ's radius is %2 mm",
                         std::to_string(1000.0 * place.thickness_m), std::to_string(1000.0 * place.radius_m)),
          Text::verbatim("wall"), Text::verbatim("Give a wall above 0 and below 0.45 of the radius."));
    }
  }
  if (!positive(length_m) || !positive(content.gentLimit)) {
    refuseParameter(Text::verbatim("a length or a limit of the wall is not above 0"), Text::verbatim("wall"),
                    Text::verbatim("Check the organ's ends."));
  }
}

}  // namespace

WrungOrgan::Unloaded WrungOrgan::unloaded(std::span<const WallPlace> places, double length_m,
                                          const HollowContent& content) {
  check(places, length_m, content);
  Unloaded tube;
  double compliance = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto [radius, thickness] = places[i];
    const double stretch = restStretch(
        content.restPressure_Pa * radius / (content.shearModulus_Pa * thickness), content.gentLimit);
    tube.wall.radius.push_back(radius / stretch);
    tube.wall.thickness.push_back(thickness * stretch);
    tube.radius_m += radius / stretch / static_cast<double>(places.size());
    const double share = i == 0 || i + 1 == places.size() ? 0.5 : 1.0;
    compliance += share * length_m / static_cast<double>(places.size() - 1) /
                  (kTurn * content.shearModulus_Pa * thickness * radius * radius * radius);
  }
  tube.plainStiffness_Nm_per_rad = 1.0 / compliance;
  for (std::size_t i = 0; i < places.size(); ++i) {
    tube.wall.radius[i] /= tube.radius_m;
    tube.wall.thickness[i] /= tube.radius_m;
  }
  tube.wall.length = length_m / tube.radius_m;
  tube.wall.ends = {places.front().radius_m / tube.radius_m, places.back().radius_m / tube.radius_m};
  tube.wall.gentLimit = content.gentLimit;
  tube.wall.freeLength = content.freeLength;
  tube.wall.foldsNeedRoom = content.foldsNeedRoom;
  if (content.freeLength) {
    double thickness = 0.0;
    for (const double t : tube.wall.thickness) {
      thickness += t / static_cast<double>(places.size());
    }
    tube.wall.pull = kPull * kTurn * thickness;
  }
  return tube;
}

WrungOrgan::WrungOrgan(std::span<const WallPlace> places, double length_m, const HollowContent& content)
    : WrungOrgan(unloaded(places, length_m, content), content) {}

WrungOrgan::WrungOrgan(Unloaded tube, const HollowContent& content)
    : shear_Pa_(content.shearModulus_Pa),
      rest_Pa_(content.restPressure_Pa),
      unit_m_(tube.radius_m),
      plainStiffness_Nm_per_rad_(tube.plainStiffness_Nm_per_rad),
      wall_(std::move(tube.wall)),
      table_(wall_, content.highestPressure_Pa / content.shearModulus_Pa) {
  Profile drawn;
  table_.placesAt(0.0, rest_Pa_ / shear_Pa_, drawn);
  std::transform(drawn.begin(), drawn.end(), drawnRadius_.begin(),
                 [](const WrungPlace& place) { return place.radius; });
  for (std::size_t i = 0; i < wall_.radius.size(); ++i) {
    meanRadius_ += wall_.radius[i] / static_cast<double>(wall_.radius.size());
    meanThickness_ += wall_.thickness[i] / static_cast<double>(wall_.radius.size());
  }
}

WrungState WrungOrgan::at(double angle_rad, double pressure_Pa) const noexcept {
  WrungState state = table_.at(angle_rad, pressure_Pa / shear_Pa_);
  state.torque *= shear_Pa_ * unit_m_ * unit_m_ * unit_m_;
  state.waist *= unit_m_;
  state.length *= unit_m_;
  state.volume *= unit_m_ * unit_m_ * unit_m_;
  return state;
}

double WrungOrgan::torque_Nm(double angle_rad, double pressure_Pa) const noexcept {
  return table_.torqueAt(angle_rad, pressure_Pa / shear_Pa_) * (shear_Pa_ * unit_m_ * unit_m_ * unit_m_);
}

WrungPlace WrungOrgan::placeAt(double share, double angle_rad, double pressure_Pa) const noexcept {
  const WrungPlace drawn = table_.placeAt(share, 0.0, rest_Pa_ / shear_Pa_);
  WrungPlace place = table_.placeAt(share, angle_rad, pressure_Pa / shear_Pa_);
  place.radius /= drawn.radius;
  place.shift = unit_m_ * (place.shift - drawn.shift);
  return place;
}

void WrungOrgan::profileAt(double angle_rad, double pressure_Pa, Profile& profile) const noexcept {
  table_.placesAt(angle_rad, pressure_Pa / shear_Pa_, profile);
  againstDrawn(profile);
}

void WrungOrgan::profileOf(std::size_t solved, Profile& profile) const noexcept {
  table_.solvedPlaces(solved, profile);
  againstDrawn(profile);
}

void WrungOrgan::againstDrawn(Profile& profile) const noexcept {
  for (std::size_t i = 0; i < kPlaces; ++i) {
    profile[i].radius /= drawnRadius_[i];
    profile[i].shift = 0.0;
  }
}

double WrungOrgan::sealedPressure_Pa(double angle_rad, double filled_Pa) const noexcept {
  const double amount = (kAtmosphere_Pa + filled_Pa) * table_.at(0.0, filled_Pa / shear_Pa_).volume;
  // More pressure, more volume: the amount rises with it, so halving finds the one pressure.
  double low = 0.0;
  double high = kAtmosphere_Pa;
  for (int k = 0; k < kPressureHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    const bool more = (kAtmosphere_Pa + middle) * table_.at(angle_rad, middle / shear_Pa_).volume > amount;
    (more ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

TubePlace WrungOrgan::tubeAt(double radius, double thickness, double pressure_Pa) const {
  return {thickness / radius, wall_.length / radius, pressure_Pa / shear_Pa_ * radius / thickness,
          wall_.gentLimit};
}

double WrungOrgan::onset_rad(double pressure_Pa) const {
  // The torque is the same everywhere: the organ folds where it reaches what its wall can carry taut.
  double torque = std::numeric_limits<double>::infinity();
  std::vector<double> onsets;
  std::vector<double> torques;
  for (std::size_t i = 0; i < wall_.radius.size(); ++i) {
    const double radius = wall_.radius[i];
    const double thickness = wall_.thickness[i];
    const TubePlace place = tubeAt(radius, thickness, pressure_Pa);
    onsets.push_back(foldOnset(place) / radius);
    torques.push_back(kTurn * thickness * radius * radius *
                      tautTube(place.pressure, place.gentLimit, onsets.back() * radius).torque);
    torque = std::min(torque, torques.back());
  }
  double angle = 0.0;
  for (std::size_t i = 0; i < onsets.size(); ++i) {
    const double share = i == 0 || i + 1 == onsets.size() ? 0.5 : 1.0;
    angle += share * wall_.length / static_cast<double>(onsets.size() - 1) * onsets[i] * torque / torques[i];
  }
  return std::min(angle, closing_rad(pressure_Pa));
}

double WrungOrgan::taut_rad(double pressure_Pa) const noexcept {
  return table_.taut_rad(pressure_Pa / shear_Pa_);
}

double WrungOrgan::closing_rad(double pressure_Pa) const noexcept {
  return table_.closing_rad(pressure_Pa / shear_Pa_);
}

double WrungOrgan::peakTorque_Nm(double pressure_Pa) const noexcept {
  return table_.peakTorque(pressure_Pa / shear_Pa_) * shear_Pa_ * unit_m_ * unit_m_ * unit_m_;
}

int WrungOrgan::waves(double pressure_Pa) const {
  return foldWaves(tubeAt(meanRadius_, meanThickness_, pressure_Pa));
}

}  // namespace torsio
