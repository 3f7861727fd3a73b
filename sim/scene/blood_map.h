// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "sim/scene/scene.h"

namespace torsio {

/// How a hollow organ that came twisted looks: colour by its blood (sim/tissue/hollow), beyond the held
/// sections as sound tissue; bruises, tears, and the clip. Any one thread; holds the scene.
class BloodMap {
 public:
  BloodMap() = default;
  explicit BloodMap(std::shared_ptr<const Scene> scene);

  /// Tells that the organ shows nothing of its blood.
  [[nodiscard]] bool empty() const noexcept { return scene_ == nullptr; }
  /// Returns how far the blood of each vertex comes through what is twisted, 0 .. 1.
  [[nodiscard]] std::vector<float> fed() const;
  /// Returns the factor on the colour of what is fed through the twist alone, sRGB.
  [[nodiscard]] static std::array<float, 3> twistedFactor(const HollowPose& pose);
  /// What lies over the tissue's own colour: a bruise, a tear, the clip.
  struct Paint {
    std::array<float, 3> factor{};  ///< on the colour where it covers all, sRGB
    std::vector<float> share;       ///< how far it covers each vertex, 0 .. 1
  };
  /// Returns what evaluate() lays over the blood's colour, the lowest first.
  [[nodiscard]] Paint markPaint(const TissueMark& mark) const;
  [[nodiscard]] Paint clipPaint(double arc_m) const;
  /// Computes what marks and the clip lay over the blood's colour, one a vertex: sRGB times how far it
  /// covers, and how far the blood's colour shows through.
  void cover(const OrganState& state, std::span<std::array<float, 4>> covers) const;
  /// Computes the factor on the tissue's own colour, sRGB, one a vertex of the mesh: blood, marks in their
  /// order, the clip.
  void evaluate(const OrganState& state, std::span<std::array<float, 3>> factors) const;

 private:
  struct Place {
    double arc_m = 0.0;
    double round_rad = 0.0;
    double radius_m = 0.0;
    float fed = 0.0F;  ///< share of the twisted vessels in the blood here
  };
  [[nodiscard]] static float markShare(const Place& place, const TissueMark& mark);
  [[nodiscard]] static float clipShare(const Place& place, double arc_m);

  std::shared_ptr<const Scene> scene_;  // null: not hollow
  std::vector<Place> places_;           // one a vertex
};

}  // namespace torsio
