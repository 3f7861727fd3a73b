// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "sim/scene/scene.h"

namespace torsio::gui {

/// Shear stress on the drawn skin: the model's patches (Eq. 13) spread smoothly over the vertices between
/// their centres. Caps beyond the ends carry none. GUI thread; holds the scene.
class ShearMap {
 public:
  ShearMap() = default;
  explicit ShearMap(std::shared_ptr<const Scene> scene);

  /// Where the scale ends: the largest shear of the exercise at its target angle, Pa. Fixed, so that a colour
  /// means the same all the time. Of an organ that came twisted the largest on the way to its largest twist.
  [[nodiscard]] double top_Pa() const noexcept { return top_Pa_; }
  /// Share of the scale at each vertex of the mesh, 0..1 (above the scale: 1).
  void evaluate(const OrganState& state, std::span<float> share);
  [[nodiscard]] bool empty() const noexcept { return scene_ == nullptr; }

 private:
  struct Weight {
    std::array<int, 4> patches{};
    std::array<float, 4> weights{};  ///< all zero on a cap
  };
  std::shared_ptr<const Scene> scene_;
  std::vector<Weight> weights_;  // one a vertex
  std::vector<double> patch_Pa_;
  double top_Pa_ = 0.0;
};

/// Colour of a share of the scale, sRGB 0..1: from dark blue over grey to yellow, rising evenly in lightness
/// and telling apart for every kind of colour vision (the map "cividis", seven stops).
[[nodiscard]] std::array<float, 3> shearColour(float share) noexcept;

}  // namespace torsio::gui
