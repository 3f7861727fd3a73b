// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "sim/core/vec3.h"

namespace torsio {

/// What a mesh file, or its format, says of its coordinates.
struct MeshSpace {
  std::optional<double> unit_m;  ///< metres in one; none: the file does not say
  bool ras = false;              ///< they point right, forward and up; else left, back and up (LPS)

  /// Returns a point or direction of the file in LPS.
  [[nodiscard]] Vec3 toLps(const Vec3& v) const { return ras ? Vec3{-v.x, -v.y, v.z} : v; }
};

/// Returns what the beginning of a file with this ending (small letters) says: the unit of COLLADA; metres
/// for glTF; of 3D Slicer's STL, PLY and OBJ the comment "3D Slicer output. SPACE=RAS", in millimetres.
[[nodiscard]] MeshSpace meshSpaceIn(std::string_view head, std::string_view extension);

/// Returns the same of a file; nothing for a file that is no mesh or cannot be read.
[[nodiscard]] MeshSpace meshSpaceOf(const std::filesystem::path& file);

/// Returns the metres in one unit of a mesh file: what it says, else what was given, else a millimetre.
/// Throws Error{kBadParameter} where a given unit contradicts the file.
[[nodiscard]] double meshUnit_m(const std::filesystem::path& file, std::optional<double> given_m);

}  // namespace torsio
