// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "sim/scene/model_choice.h"

namespace CLI {
class App;
}

namespace torsio::cli {

/// Options that modify the twist model of a pattern.
struct ModelArguments {
  std::string interpolation;  ///< of the paper: "angle", "components" (Eq. 15); empty: not given
  std::string drift;          ///< of kriging: "constant" (Eq. 16), "linear"; empty: not given
  ModelChoice choice;         ///< other options
};

/// Adds these options, except for G; `arguments` must outlive the command.
void addModelOptions(CLI::App& command, ModelArguments& arguments);

/// Returns the resulting choice.
[[nodiscard]] ModelChoice modelChoice(const ModelArguments& arguments);

}  // namespace torsio::cli
