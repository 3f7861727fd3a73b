// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "sim/scene/scene.h"

namespace CLI {
class App;
}

namespace torsio::cli {

/// What the options say that change the twist model of a pattern; each is named after what it does in the
/// paper's equations or in docs/model.md. Nothing given: the model of the scene.
struct ModelArguments {
  std::string interpolation;                ///< of the paper: "angle", "components" (Eq. 15)
  std::string drift;                        ///< of kriging: "constant" (Eq. 16), "linear"
  std::optional<double> beta;               ///< of Eq. 18
  bool clampLift = false;                   ///< dZ of Eq. 23 at the clamp too
  bool poynting = false;                    ///< axial stretch of a twisted bar
  bool restrainedEnds = false;              ///< clamped ends keep their sections flat
  bool taper = false;                       ///< sections of a cone turn less
  bool shearCentre = false;                 ///< sections turn about their shear centres
  std::optional<double> foundationLengths;  ///< of an elastic foundation, in organ lengths
  std::optional<double> stiffeningStrain;   ///< at which the torque has doubled
  std::optional<double> shearModulus_Pa;    ///< G
};

/// Adds these options, but for G, to a command; `arguments` outlives it.
void addModelOptions(CLI::App& command, ModelArguments& arguments);

/// Tells whether anything was asked for.
[[nodiscard]] bool changesModel(const ModelArguments& arguments) noexcept;

/// Builds the scene's twist model anew as the options say. Throws Error{kUsage} for an option that the
/// scene's formulation does not know, {kBadParameter} for a number out of range.
[[nodiscard]] TwistModel modelAsAsked(const Scene& scene, const ModelArguments& arguments);

}  // namespace torsio::cli
