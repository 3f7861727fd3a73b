// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "sim/scene/model_choice.h"

namespace CLI {
class App;
}

namespace torsio::cli {

/// What the options say that change the twist model of a pattern.
struct ModelArguments {
  std::string interpolation;  ///< of the paper: "angle", "components" (Eq. 15); empty: not given
  std::string drift;          ///< of kriging: "constant" (Eq. 16), "linear"; empty: not given
  ModelChoice choice;         ///< the other parts
};

/// Adds these options, but for G, to a command; `arguments` outlives it.
void addModelOptions(CLI::App& command, ModelArguments& arguments);

/// Returns what the options ask for.
[[nodiscard]] ModelChoice modelChoice(const ModelArguments& arguments);

}  // namespace torsio::cli
