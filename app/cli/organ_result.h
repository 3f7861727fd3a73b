// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/scene/organ_import.h"

namespace CLI {
class App;
}

namespace torsio::cli {

/// What is asked of an organ that is made of something else.
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

/// Adds the options; `options` outlives the command. `unit` says in what the ends are given.
void addOrganResultOptions(CLI::App& command, OrganResultOptions& options, const std::string& unit);

/// Puts the options into a request; `unit_m` is that of the ends. Throws Error{kUsage} for a name that is
/// none of an organ file, and for one end without the other.
void applyOrganResultOptions(const OrganResultOptions& options, double unit_m, OrganImportRequest& request);

/// What became of a surface, as --json prints it.
[[nodiscard]] nlohmann::ordered_json organJson(const OrganImport& import, const std::string& out);

/// Writes the organ file when it was asked for and the organ is accepted, prints `json` or what there is to
/// say for people; `file` names what was read. Throws Error{kBadMesh} for an organ that is refused.
void finishOrgan(const OrganImport& import, const OrganResultOptions& options, const std::string& file,
                 const nlohmann::ordered_json& json);

}  // namespace torsio::cli
