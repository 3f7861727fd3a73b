// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/organ_places.h"

#include <cmath>
#include <cstddef>

#include "sim/anatomy/curves.h"
#include "sim/core/angle.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/query/collision_mesh.h"

namespace torsio {

namespace {

/// The skin in millimetres, met from the curve inside it.
class Skin {
 public:
  Skin(const TriangleMesh& surface_m, const std::vector<CurveFrame>& frames, double zero_deg)
      : skin_(surface_m), frames_(frames), zero_deg_(zero_deg) {}

  [[nodiscard]] Vec3 at_m(double share, double angle_deg) const {
    const CurveFrame& frame = frames_[nearest(share)];
    const SinCos a = portableSinCos(radians(angle_deg + zero_deg_));
    const Vec3 outwards = a.cos * frame.e1 + a.sin * frame.e2;
    const Vec3 centre_m = kMillimetre_m * frame.centre;
    double outside_m = kMillimetre_m;  // the first surface met: a loop comes near itself
    while (skin_.closest(centre_m + outside_m * outwards).distance_m < 0.0) {
      outside_m += kMillimetre_m;
    }
    double inside_m = outside_m - kMillimetre_m;
    for (int i = 0; i < 40; ++i) {
      const double r_m = 0.5 * (inside_m + outside_m);
      (skin_.closest(centre_m + r_m * outwards).distance_m < 0.0 ? inside_m : outside_m) = r_m;
    }
    return centre_m + inside_m * outwards;
  }

  [[nodiscard]] double length_mm() const { return frames_.back().arc; }
  [[nodiscard]] double arc_mm(double share) const { return frames_[nearest(share)].arc; }

 private:
  [[nodiscard]] std::size_t nearest(double share) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < frames_.size(); ++i) {
      if (std::abs(frames_[i].arc - share * length_mm()) <
          std::abs(frames_[best].arc - share * length_mm())) {
        best = i;
      }
    }
    return best;
  }

  CollisionMesh skin_;
  const std::vector<CurveFrame>& frames_;
  double zero_deg_;
};

}  // namespace

OrganPlaces placesOn(const TriangleMesh& surface, const std::vector<CurveFrame>& frames, double zero_deg,
                     const std::vector<WantedPlace>& wanted) {
  constexpr double kStep_mm = 10.0;
  constexpr double kFirst = 0.03;  // the line stays away from the rounded ends
  const Skin skin(surface, frames, zero_deg);
  OrganPlaces places;
  for (const WantedPlace& place : wanted) {
    places.markers.push_back(
        {place.name, skin.arc_mm(place.share), place.angle_deg, skin.at_m(place.share, place.angle_deg)});
  }
  const double span_mm = (1.0 - 2.0 * kFirst) * skin.length_mm();
  const int steps = static_cast<int>(std::lround(span_mm / kStep_mm));
  for (int k = 0; k <= steps; ++k) {
    places.zeroLine_m.push_back(skin.at_m(kFirst + (1.0 - 2.0 * kFirst) * k / steps, 0.0));
  }
  return places;
}

}  // namespace torsio
