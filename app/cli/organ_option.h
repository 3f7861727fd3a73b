// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

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

}  // namespace torsio::cli
