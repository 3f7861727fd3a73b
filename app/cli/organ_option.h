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

/// The options that choose an organ and its model; the same words in every command.
struct OrganArguments {
  std::string organ = "arm";     ///< a scene's name, or a mesh file
  std::string unit = "mm";       ///< of the file
  std::vector<double> fixedEnd;  ///< of the mesh file, in its unit; empty: found
  std::vector<double> freeEnd;
  std::string material;  ///< empty: the scene's
  std::string pattern;
  std::string formulation;  ///< empty: the scene's
  std::optional<int> ridges;
  std::optional<int> sections;
};

void addOrganOptions(CLI::App& command, OrganArguments& arguments);

/// Throws Error for a name that is neither a scene nor a file.
[[nodiscard]] SceneRequest sceneRequest(const OrganArguments& arguments);

}  // namespace torsio::cli
