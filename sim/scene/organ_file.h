// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/scene/organ_finding.h"
#include "sim/scene/organ_wall.h"

namespace torsio {

/// Ends of an organ, as LatticeOptions has them. Metres.
struct OrganEnds {
  std::optional<Vec3> fixedEnd_m;  ///< both or none; none: found from the shape
  std::optional<Vec3> freeEnd_m;
  Vec3 fixedCut;  ///< outward direction of a cut through that end; zero: none
  Vec3 freeCut;
  double capRadius_m = 0.0;  ///< > 0: discs on the surface about the ends instead of the rounded tips
  bool straight = false;     ///< sections are parallel planes between the ends (LatticeMode::kStraightAxis)
  Vec3 branchRoot_m{};       ///< of what hangs on the side, as LatticeOptions has it
  Vec3 branchCut{};          ///< zero: nothing does
};

/// An organ that was checked and judged, as Torsio keeps it: what `torsio organ import` makes of a mesh.
struct OrganFile {
  TriangleMesh mesh;  ///< of requireOrgan, metres, LPS
  OrganEnds ends;
  std::string anatomy;                  ///< id of the scene whose patterns suit it; empty: not known
  std::optional<double> wall_m;         ///< thickness of its wall
  std::optional<OrganWallMap> wallMap;  ///< where it is so thick, on the lattice of `ends`
  std::vector<std::string> patterns;    ///< that leave it whole; none: it was not judged by its patterns
  std::string source;                   ///< name of the mesh file, without its folder
  std::vector<OrganWarning> warnings;   ///< with which it was accepted
};

/// Tells whether a file is named as an organ file: "liver.organ".
[[nodiscard]] bool isOrganFile(const std::filesystem::path& file);

/// Writes an organ: the same bytes for the same organ. Throws Error{kFileUnwritable}.
void writeOrganFile(const std::filesystem::path& file, const OrganFile& organ);

/// Reads an organ, exactly as it was written. Throws Error{kFileMissing, kFileUnreadable}: no organ file, one
/// of a later version, one that was damaged or changed by hand (a digest over all of it tells);
/// Error{kBadMesh} for a surface that requireOrgan refuses.
[[nodiscard]] OrganFile readOrganFile(const std::filesystem::path& file);

}  // namespace torsio
