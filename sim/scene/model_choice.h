// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "sim/tissue/twist/twist_model.h"

namespace torsio {

/// What a scene, or an engineer in its place, asks of the twist model beyond the formulation; each part is
/// named after what it does in the paper's equations or in docs/model.md. Recordings are made of what a scene
/// asks for, never of what an engineer does.
struct ModelChoice {
  std::optional<PaperInterpolation> interpolation{};  ///< of the paper (Eq. 15)
  std::optional<Drift> drift{};                       ///< of kriging (Eq. 16)
  std::optional<double> beta{};                       ///< of Eq. 18, in sections
  bool clampLift = false;                             ///< dZ of Eq. 23 at the clamp too
  bool poynting = false;                              ///< axial stretch of a twisted bar
  bool restrainedEnds = false;                        ///< clamped ends keep their sections flat
  bool taper = false;                                 ///< sections of a cone turn less
  bool shearCentre = false;                           ///< sections turn about their shear centres
  std::optional<double> foundationLengths{};          ///< of an elastic foundation, in organ lengths
  std::optional<double> stiffeningStrain{};           ///< at which the torque has doubled
  std::optional<double> shearModulus_Pa{};            ///< G

  friend bool operator==(const ModelChoice&, const ModelChoice&) = default;
  /// Tells whether anything is asked for.
  [[nodiscard]] bool any() const { return !(*this == ModelChoice{}); }
  /// Tells whether anything is asked for that only a bar has, twisted about its own axis: all but G. A curved
  /// organ is then left to the twist model.
  [[nodiscard]] bool ofBar() const {
    ModelChoice rest = *this;
    rest.shearModulus_Pa.reset();
    return rest.any();
  }
};

/// Returns the choice without the parts that a formulation does not know.
[[nodiscard]] ModelChoice choiceFor(const ModelChoice& choice, Formulation formulation);

/// Changes options and material of a model with this number of sections as chosen. Throws Error{kUsage}
/// naming the first part that the formulation of the options does not know, {kBadParameter} for a beta of 0
/// or not finite; the model itself checks the other numbers.
void applyChoice(const ModelChoice& choice, int sections, TwistModelOptions& options, Material& material);

}  // namespace torsio
