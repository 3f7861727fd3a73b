// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/scene/scene.h"

namespace torsio {

/// Maximum number of markers of an organ: the paper's Fig. 11 has ten.
inline constexpr std::size_t kMaxMarkers = 10;

/// A named point on the skin of an organ (Fig. 11).
struct OrganMarker {
  int number = 0;  ///< from 1
  std::string name;
  std::uint32_t face = 0;                            ///< triangle of the organ's mesh
  std::array<double, 3> barycentric{1.0, 0.0, 0.0};  ///< weights of its corners, sum 1
  Vec3 position_m;                                   ///< at rest, from face and coordinates
};

/// Moves a marker to a point of a triangle of the scene's organ, which must exist (contract).
void placeMarker(const Scene& scene, std::uint32_t face, const std::array<double, 3>& barycentric,
                 OrganMarker& marker);

/// Reads markers of the scene's organ from JSON: "markers" with 1 to 10 entries of "number" (from 1), a
/// unique "name" and either "face" and "barycentric" or a "position_mm" within 5 mm of the surface, moved to
/// the nearest surface point; "organ_hash", if given, must be the organ's. Throws Error: kFileMissing,
/// kFileUnreadable; kBadData with file, marker and field.
[[nodiscard]] std::vector<OrganMarker> readMarkers(const std::filesystem::path& file, const Scene& scene);

/// Writes markers for readMarkers(), with the hash of their organ. Throws Error{kFileUnwritable}.
void writeMarkers(const std::filesystem::path& file, const std::vector<OrganMarker>& markers,
                  const Scene& scene);

/// Reads the markers of a shipped organ (organMarkersFile()); empty if there is no such file. Throws like
/// readMarkers().
[[nodiscard]] std::vector<OrganMarker> readOrganMarkers(const std::filesystem::path& assets,
                                                        const Scene& scene);

/// Creates ten markers for an organ that has none: at five sections along it, one each on ridge 0 and on the
/// opposite ridge, named "section 2, ridge 1".
[[nodiscard]] std::vector<OrganMarker> spreadMarkers(const Scene& scene);

/// Checks markers: 1 to 10, numbered from 1, with unique names that are not empty. Throws Error{kBadData};
/// `where`: source of the markers, or "".
void checkMarkers(const std::vector<OrganMarker>& markers, const std::string& where);

}  // namespace torsio
