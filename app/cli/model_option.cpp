// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/model_option.h"

#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "sim/base/error.h"

namespace torsio::cli {

namespace {

/// Refuses the first option that was given and that this formulation does not know.
void refuseGiven(std::initializer_list<std::pair<const char*, bool>> options, const Text& why,
                 const Text& remedy) {
  for (const auto& [name, given] : options) {
    if (given) {
      throw Error(ErrorCode::kUsage, why, std::string(name), remedy);
    }
  }
}

void checkFormulation(const ModelArguments& asked, Formulation formulation) {
  if (formulation == Formulation::kPaper) {
    refuseGiven({{"--poynting", asked.poynting},
                 {"--restrained-ends", asked.restrainedEnds},
                 {"--taper", asked.taper},
                 {"--shear-centre", asked.shearCentre},
                 {"--foundation", asked.foundationLengths.has_value()},
                 {"--stiffening", asked.stiffeningStrain.has_value()}},
                Text::verbatim("the paper's formulation does not know this"),
                Text::verbatim("Leave it out, or give --formulation saint-venant"));
    return;
  }
  refuseGiven({{"--interpolation", !asked.interpolation.empty()},
               {"--beta", asked.beta.has_value()},
               {"--clamp-lift", asked.clampLift}},
              Text::verbatim("only the paper's formulation knows this"),
              Text::verbatim("Leave it out, or give --formulation paper"));
}

}  // namespace

void addModelOptions(CLI::App& command, ModelArguments& arguments) {
  command
      .add_option("--interpolation", arguments.interpolation,
                  "With --formulation paper: angle, or components (dX, dY, dZ along each ridge, Eq. 15)")
      ->check(CLI::IsMember({"angle", "components"}));
  command.add_option("--drift", arguments.drift, "Of kriging: constant (Eq. 16 as printed) or linear")
      ->check(CLI::IsMember({"constant", "linear"}));
  command.add_option("--beta", arguments.beta,
                     "With --formulation paper: beta of Eq. 18, in sections; default: infinite");
  command.add_flag("--clamp-lift", arguments.clampLift,
                   "With --formulation paper: dZ of Eq. 23 at the clamp too, as printed");
  command.add_flag("--poynting", arguments.poynting, "A twisted bar with a free end grows longer");
  command.add_flag("--restrained-ends", arguments.restrainedEnds, "Clamped ends keep their sections flat");
  command.add_flag("--taper", arguments.taper, "Correct the compliance of a tapering organ");
  command.add_flag("--shear-centre", arguments.shearCentre, "Sections turn about their shear centres");
  command.add_option("--foundation", arguments.foundationLengths,
                     "Elastic foundation: sqrt(G J / k) in organ lengths, such as 0.5");
  command.add_option("--stiffening", arguments.stiffeningStrain,
                     "Shear strain at which the torque has doubled against the linear law");
}

bool changesModel(const ModelArguments& a) noexcept {
  return !a.interpolation.empty() || !a.drift.empty() || a.beta || a.clampLift || a.poynting ||
         a.restrainedEnds || a.taper || a.shearCentre || a.foundationLengths || a.stiffeningStrain ||
         a.shearModulus_Pa;
}

TwistModel modelAsAsked(const Scene& scene, const ModelArguments& asked) {
  TwistModelOptions options = scene.model.options();
  checkFormulation(asked, options.formulation);
  if (asked.interpolation == "components") {
    options.paperInterpolation = PaperInterpolation::kComponents;
  }
  if (!asked.drift.empty()) {
    options.kriging.drift = asked.drift == "constant" ? Drift::kConstant : Drift::kLinear;
  }
  if (asked.beta) {
    if (!std::isfinite(*asked.beta) || *asked.beta == 0.0) {
      throw Error(ErrorCode::kBadParameter, Text::verbatim("beta of Eq. 18 must be a number, and not 0"),
                  Text::verbatim("--beta"), Text::verbatim("Give a number of sections, or leave it out"));
    }
    options.paper.rateExponent = (scene.lattice().sections() - 1) / *asked.beta;
  }
  options.paper.clampLift |= asked.clampLift;
  options.poynting |= asked.poynting;
  options.corrections.taper |= asked.taper;
  options.corrections.restrainedEnds |= asked.restrainedEnds;
  if (asked.shearCentre) {
    options.centre = TwistCentre::kShearCentre;
  }
  options.foundationLengths = asked.foundationLengths.value_or(options.foundationLengths);
  options.stiffeningStrain = asked.stiffeningStrain.value_or(options.stiffeningStrain);
  Material material = scene.model.material();
  material.shearModulus_Pa = asked.shearModulus_Pa.value_or(material.shearModulus_Pa);
  return {scene.mesh, scene.lattice(), material, options};
}

}  // namespace torsio::cli
