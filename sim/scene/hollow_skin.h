// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "sim/scene/hollow_organ.h"
#include "sim/tissue/twist/twist_model_tables.h"
#include "sim/tissue/view/twist_kernels.h"

namespace torsio {

/// A hollow organ as it is drawn (docs/model.md H.8): as HollowMap has it, with the folds of the wrung wall.
/// What is common to all vertices is computed on construction. For views; lives on the stack.
class HollowSkin {
 public:
  HollowSkin(const HollowOrgan& organ, const OrganState& state) noexcept;

  /// Returns where a vertex goes; `round_rad`: its ridge angle.
  [[nodiscard]] Vec3 vertex(const TwistVertex& vertex, double round_rad) const noexcept;

  static constexpr std::size_t kPlaces = 65;  ///< of a span, at equal shares, as HollowMap
  using Cells = std::array<HollowCells, kPlaces - 2>;
  /// Writes the places of a span as the kernels read them: each two neighbouring cells.
  void write(int span, Cells& cells) const noexcept;
  /// Returns how many folds go round a span.
  [[nodiscard]] int waves(int span) const noexcept { return limbs_[static_cast<std::size_t>(span)].waves; }
  /// Tells whether no vertex moves.
  [[nodiscard]] bool rests() const noexcept;

 private:
  struct Place {
    double turn_rad = 0.0;
    double radius = 1.0;
    double amplitude = 0.0;
    double crest_rad = 0.0;
  };
  struct Limb {
    int waves = 3;
    std::array<Place, kPlaces> places{};
  };
  void fill(int span, const OrganState& state, Limb& limb) const noexcept;
  [[nodiscard]] Place placeAt(const Limb& limb, double share) const noexcept;

  const HollowOrgan& organ_;
  double angle_rad_ = 0.0;
  std::array<Limb, 2> limbs_;  // of the spans
};

}  // namespace torsio
