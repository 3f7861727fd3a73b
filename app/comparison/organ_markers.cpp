// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/organ_markers.h"

#include <array>
#include <system_error>

#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/base/file_io.h"
#include "sim/base/refusal.h"

namespace torsio {

std::vector<OrganMarker> readOrganMarkers(const std::filesystem::path& assets, const std::string& sceneId) {
  const std::filesystem::path file = assets / "organs" / (sceneId + "_markers.json");
  std::error_code failed;
  if (!std::filesystem::exists(file, failed)) {
    return {};
  }
  constexpr double kMetresPerMillimetre = 1e-3;
  std::vector<OrganMarker> markers;
  try {
    const nlohmann::json root = nlohmann::json::parse(readFile(file));
    for (const nlohmann::json& entry : root.at("markers")) {
      OrganMarker marker;
      marker.number = entry.at("number").get<int>();
      marker.name = entry.at("name").get<std::string>();
      const auto place = entry.at("position_mm").get<std::array<double, 3>>();
      marker.position_m = kMetresPerMillimetre * Vec3{place[0], place[1], place[2]};
      markers.push_back(marker);
      if (marker.number != static_cast<int>(markers.size()) || !isFinite(marker.position_m)) {
        refuse(Text::verbatim("Markers count from 1, and each has a finite position"), file.string(),
               Text::verbatim("Correct the file"));
      }
    }
  } catch (const nlohmann::json::exception& reason) {
    refuse(Text::verbatim("The markers cannot be read: %1", std::string(reason.what())), file.string(),
           Text::verbatim("Correct the file"));
  }
  return markers;
}

}  // namespace torsio
