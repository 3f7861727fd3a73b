// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace torsio {

/// Which model answers the hand in a run. The first is computed in each tick of the servo; the others take
/// longer than a tick, and run beside it at their own rate (sim/core/async_model.h).
enum class TissueModel : std::uint8_t {
  kTwist = 0,           ///< the product's own: twist model or rod
  kFiniteElements = 1,  ///< corotational linear tetrahedra
  kMassSpring = 2,      ///< lattice of springs, extended position-based dynamics
};

/// All models, in the order of the enumeration.
inline constexpr std::array kTissueModels{TissueModel::kTwist, TissueModel::kFiniteElements,
                                          TissueModel::kMassSpring};

/// Returns the id of a model in files, options and tables: "twist", "fem" or "msm".
[[nodiscard]] std::string_view tissueModelId(TissueModel model) noexcept;
/// Returns the model of an id. Throws Error{kBadParameter} that lists the known ones.
[[nodiscard]] TissueModel tissueModelOf(const std::string& id);
/// Tells whether the model runs asynchronously.
[[nodiscard]] constexpr bool runsAsync(TissueModel model) noexcept {
  return model != TissueModel::kTwist;
}

}  // namespace torsio
