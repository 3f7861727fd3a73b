// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/vec3.h"

namespace torsio {

/// A named point on the skin of an organ (Fig. 11).
struct OrganMarker {
  int number = 0;  ///< from 1
  std::string name;
  Vec3 position_m;  ///< at rest
};

/// Reads the markers of a shipped organ, organs/<scene id>_markers.json; none when it has no such file.
/// Throws Error{kBadData} for a file that breaks its rules: numbers that count from 1, a name, three finite
/// coordinates each.
[[nodiscard]] std::vector<OrganMarker> readOrganMarkers(const std::filesystem::path& assets,
                                                        const std::string& sceneId);

}  // namespace torsio
