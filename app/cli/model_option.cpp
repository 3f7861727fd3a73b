// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/model_option.h"

#include <CLI/CLI.hpp>

namespace torsio::cli {

void addModelOptions(CLI::App& command, ModelArguments& arguments) {
  command
      .add_option("--interpolation", arguments.interpolation,
                  "With --formulation paper: angle, or components (dX, dY, dZ along each ridge, Eq. 15)")
      ->check(CLI::IsMember({"angle", "components"}));
  command.add_option("--drift", arguments.drift, "Drift of kriging: constant (Eq. 16 as printed) or linear")
      ->check(CLI::IsMember({"constant", "linear"}));
  command.add_option("--beta", arguments.choice.beta,
                     "With --formulation paper: beta of Eq. 18, in sections; default: infinite");
  command.add_flag("--clamp-lift", arguments.choice.clampLift,
                   "With --formulation paper: dZ of Eq. 23 at the clamp too, as printed");
  command.add_flag("--poynting", arguments.choice.poynting, "A twisted bar with a free end grows longer");
  command.add_flag("--restrained-ends", arguments.choice.restrainedEnds,
                   "Clamped ends keep their sections flat");
  command.add_flag("--taper", arguments.choice.taper, "Correct the compliance of a tapering organ");
  command.add_flag("--shear-centre", arguments.choice.shearCentre, "Sections turn about their shear centres");
  command.add_option("--foundation", arguments.choice.foundationLengths,
                     "Elastic foundation: sqrt(G J / k) in organ lengths, such as 0.5");
  command.add_option("--stiffening", arguments.choice.stiffeningStrain,
                     "Shear strain at which the torque has doubled against the linear law");
}

ModelChoice modelChoice(const ModelArguments& arguments) {
  ModelChoice choice = arguments.choice;
  if (!arguments.interpolation.empty()) {
    choice.interpolation = arguments.interpolation == "components" ? PaperInterpolation::kComponents
                                                                   : PaperInterpolation::kAngle;
  }
  if (!arguments.drift.empty()) {
    choice.drift = arguments.drift == "constant" ? Drift::kConstant : Drift::kLinear;
  }
  return choice;
}

}  // namespace torsio::cli
