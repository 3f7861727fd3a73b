// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/scene/model_choice.h"
#include "sim/scene/scene.h"

namespace CLI {
class App;
}

namespace torsio::cli {

/// Options that choose an organ and its model; identical in all commands.
struct OrganArguments {
  std::string organ = "forearm";  ///< a scene's name, or a mesh file
  std::string unit = "mm";        ///< unit of the mesh file
  std::vector<double> fixedEnd;   ///< fixed end of the mesh file, in its unit; empty: found from the shape
  std::vector<double> freeEnd;    ///< free end of the mesh file, in its unit; empty: found from the shape
  std::string material;           ///< material by name; empty: the scene's
  std::string pattern;            ///< twist pattern by name; empty: the scene's first
  std::string formulation;        ///< formulation of the twist model; empty: the scene's
  std::optional<int> ridges;      ///< ridges of the lattice (N); empty: the scene's
  std::optional<int> sections;    ///< sections of the lattice (M); empty: the scene's
};

/// Adds these options; `arguments` must outlive the command.
void addOrganOptions(CLI::App& command, OrganArguments& arguments);

/// Converts the options to a scene request. Throws Error{kUsage} for a name that is neither a scene nor a
/// file.
[[nodiscard]] SceneRequest sceneRequest(const OrganArguments& arguments);

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
