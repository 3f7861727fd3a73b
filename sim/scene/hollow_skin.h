// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "sim/scene/hollow_organ.h"
#include "sim/tissue/hollow/fold_field.h"
#include "sim/tissue/twist/twist_model_tables.h"

namespace torsio {

/// A hollow organ as it is drawn (docs/model.md H.8): as HollowMap has it, with the folds of the wrung wall.
/// What is common to all vertices is computed on construction. For views; lives on the stack.
class HollowSkin {
 public:
  HollowSkin(const HollowOrgan& organ, const OrganState& state) noexcept;

  /// Returns where a vertex goes; `round_rad`: its ridge angle.
  [[nodiscard]] Vec3 vertex(const TwistVertex& vertex, double round_rad) const noexcept;

  static constexpr std::size_t kPlaces = HollowOrgan::kPlaces;  ///< of a span, at equal shares
  /// Tells whether no vertex moves.
  [[nodiscard]] bool rests() const noexcept;

 private:
  struct Limb {
    int waves = kMinDrawnWaves;
    HollowOrgan::Sections sections{};
    std::array<FoldPhase, kPlaces> folds{};
  };
  struct Place {
    HollowOrgan::Section section;
    FoldPhase fold;
  };
  void fill(int span, const OrganState& state, Limb& limb) const noexcept;
  [[nodiscard]] Place placeAt(const Limb& limb, double share) const noexcept;

  const HollowOrgan& organ_;
  double angle_rad_ = 0.0;
  std::array<Limb, 2> limbs_;  // of the spans
};

}  // namespace torsio
