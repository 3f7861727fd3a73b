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

/// Most markers of an organ: the paper's Fig. 11 has ten.
inline constexpr std::size_t kMaxMarkers = 10;

/// A named point on the skin of an organ (Fig. 11).
struct OrganMarker {
  int number = 0;  ///< from 1
  std::string name;
  std::uint32_t face = 0;                            ///< triangle of the organ's mesh
  std::array<double, 3> barycentric{1.0, 0.0, 0.0};  ///< of its corners, sum 1
  Vec3 position_m;                                   ///< at rest: what face and coordinates say
};

/// Moves a marker to a point of a triangle of the scene's organ, which must exist (contract).
void placeMarker(const Scene& scene, std::uint32_t face, const std::array<double, 3>& barycentric,
                 OrganMarker& marker);

/// Reads markers of the scene's organ from JSON: "markers" with 1 to 10 entries of "number" (from 1 on),
/// "name" (another one each) and either "face" and "barycentric" or "position_mm" within 5 mm of the surface,
/// which the nearest surface point stands for; "organ_hash", if given, is that of the organ. Throws Error:
/// kFileMissing, kFileUnreadable; kBadData naming file, marker and field.
[[nodiscard]] std::vector<OrganMarker> readMarkers(const std::filesystem::path& file, const Scene& scene);

/// Writes markers so that readMarkers() reads the same ones, with the hash of the organ that they lie on.
/// Throws Error{kFileUnwritable}.
void writeMarkers(const std::filesystem::path& file, const std::vector<OrganMarker>& markers,
                  const Scene& scene);

/// Reads the markers of a shipped organ (organMarkersFile()); none when it has no such file.
/// Throws as readMarkers().
[[nodiscard]] std::vector<OrganMarker> readOrganMarkers(const std::filesystem::path& assets,
                                                        const Scene& scene);

/// Makes ten markers for an organ that has none: five sections along it, one point each on ridge 0 and on the
/// ridge half-way round; "section 2, ridge 1" by name.
[[nodiscard]] std::vector<OrganMarker> spreadMarkers(const Scene& scene);

/// Checks what is written and compared: 1 to 10 markers that count from 1, with names that are not empty and
/// differ. Throws Error{kBadData}; `where`: whose markers, or "".
void checkMarkers(const std::vector<OrganMarker>& markers, const std::string& where);

}  // namespace torsio
