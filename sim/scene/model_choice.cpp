// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/model_choice.h"

#include <array>
#include <cmath>
#include <utility>

#include "sim/core/error.h"

namespace torsio {

namespace {

/// Refuses the first part that was chosen.
template <std::size_t Size>
void refuseChosen(const std::array<std::pair<Phrase, bool>, Size>& parts, const Text& why,
                  const Text& remedy) {
  for (const auto& [name, chosen] : parts) {
    if (chosen) {
      throw Error(ErrorCode::kUsage, why, name, remedy);
    }
  }
}

void checkFormulation(const ModelChoice& choice, Formulation formulation) {
  if (formulation == Formulation::kPaper) {
    refuseChosen<6>({{{Text::tr("Poynting's stretch"), choice.poynting},
                      {Text::tr("restrained ends"), choice.restrainedEnds},
                      {Text::tr("taper"), choice.taper},
                      {Text::tr("shear centre"), choice.shearCentre},
                      {Text::tr("foundation"), choice.foundationLengths.has_value()},
                      {Text::tr("stiffening"), choice.stiffeningStrain.has_value()}}},
                    Text::tr("the paper's formulation does not know this"),
                    Text::tr("Leave it out, or choose the formulation saint-venant"));
    return;
  }
  refuseChosen<3>({{{Text::tr("interpolation (Eq. 15)"), choice.interpolation.has_value()},
                    {Text::tr("beta (Eq. 18)"), choice.beta.has_value()},
                    {Text::tr("clamp lift (Eq. 23)"), choice.clampLift}}},
                  Text::tr("only the paper's formulation knows this"),
                  Text::tr("Leave it out, or choose the formulation paper"));
}

}  // namespace

ModelChoice choiceFor(const ModelChoice& choice, Formulation formulation) {
  ModelChoice known;
  known.drift = choice.drift;
  known.shearModulus_Pa = choice.shearModulus_Pa;
  if (formulation == Formulation::kPaper) {
    known.interpolation = choice.interpolation;
    known.beta = choice.beta;
    known.clampLift = choice.clampLift;
  } else {
    known.poynting = choice.poynting;
    known.restrainedEnds = choice.restrainedEnds;
    known.taper = choice.taper;
    known.shearCentre = choice.shearCentre;
    known.foundationLengths = choice.foundationLengths;
    known.stiffeningStrain = choice.stiffeningStrain;
  }
  return known;
}

void applyChoice(const ModelChoice& choice, int sections, TwistModelOptions& options, Material& material) {
  checkFormulation(choice, options.formulation);
  options.paperInterpolation = choice.interpolation.value_or(options.paperInterpolation);
  options.kriging.drift = choice.drift.value_or(options.kriging.drift);
  if (choice.beta) {
    if (!std::isfinite(*choice.beta) || *choice.beta == 0.0) {
      throw Error(ErrorCode::kBadParameter, Text::tr("beta of Eq. 18 must be a number, and not 0"),
                  Text::tr("beta (Eq. 18)"), Text::tr("Give a number of sections, or leave it out"));
    }
    options.paper.rateExponent = (sections - 1) / *choice.beta;
  }
  options.paper.clampLift |= choice.clampLift;
  options.poynting |= choice.poynting;
  options.corrections.taper |= choice.taper;
  options.corrections.restrainedEnds |= choice.restrainedEnds;
  if (choice.shearCentre) {
    options.centre = TwistCentre::kShearCentre;
  }
  options.foundationLengths = choice.foundationLengths.value_or(options.foundationLengths);
  options.stiffeningStrain = choice.stiffeningStrain.value_or(options.stiffeningStrain);
  material.shearModulus_Pa = choice.shearModulus_Pa.value_or(material.shearModulus_Pa);
}

}  // namespace torsio
