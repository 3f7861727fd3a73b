// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/geometry/mesh/mesh_space.h"
#include "sim/scene/organ_import.h"

namespace CLI {
class App;
}

namespace torsio::cli {

/// Options for an organ made from other data.
struct OrganResultOptions {
  std::string out;
  std::vector<double> fixedEnd;
  std::vector<double> freeEnd;
  std::vector<double> fixedCut;
  std::vector<double> freeCut;
  std::optional<double> wall_mm;
  std::string anatomy;
  bool json = false;
};

/// Adds the options; `options` must outlive the command. `unit`: unit of the ends.
void addOrganResultOptions(CLI::App& command, OrganResultOptions& options, const std::string& unit);

/// Applies the options to a request; `unit_m`: unit of the ends, `space`: their axes. Throws Error{kUsage}
/// for a name that is not an organ file's, or for one end without the other.
void applyOrganResultOptions(const OrganResultOptions& options, double unit_m, OrganImportRequest& request,
                             const MeshSpace& space = {});

/// Returns the outcome of an import, as --json prints it.
[[nodiscard]] nlohmann::ordered_json organJson(const OrganImport& import, const std::string& out);

/// Writes the organ file if requested and accepted, then prints `json` or a summary; `file`: the input.
/// Throws Error{kBadMesh} for a rejected organ.
void finishOrgan(const OrganImport& import, const OrganResultOptions& options, const std::string& file,
                 const nlohmann::ordered_json& json);

}  // namespace torsio::cli
