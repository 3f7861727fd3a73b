// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "sim/geometry/mesh/mesh_repair.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// What a mesh file holds that no organ has: it is left out.
struct MeshExtras {
  std::size_t textures = 0;
  std::size_t bones = 0;
  std::size_t animations = 0;
};

/// A surface as a file has it, unchecked but for indices: all parts, node transforms flattened.
struct RawMesh {
  TriangleMesh mesh;
  MeshExtras ignored;
};

/// Checks what is known of a mesh file without reading it. Throws Error{kFileMissing, kFileUnreadable}: M01
/// (not there, empty), M02 (a format that is not read), M03 (more than 500 MB).
void requireMeshFile(const std::filesystem::path& file);

/// Reads an OBJ, STL, PLY, OFF, GLB, glTF or COLLADA file in this process (assimp, private), the file's own
/// numbers times `scale_m` (meshUnit_m), turned to LPS where the file says that they are not. Files named
/// inside the file are opened only below its own folder. Throws Error{kFileMissing, kFileUnreadable,
/// kBadMesh} with the code of the rule (M01..M08). A damaged file may take assimp, and the process, down:
/// files of users are read by readMeshApart.
[[nodiscard]] RawMesh readMesh(const std::filesystem::path& file, double scale_m);

struct MeshImportOptions {
  double scale_m = 0.001;   ///< one file unit in metres
  bool unitStated = false;  ///< by the file (mesh_space.h): no other unit is looked for
  bool organ = true;        ///< requireOrgan; false: any finite surface (instruments, scenery)
};

/// Reads a surface from an OBJ, STL, PLY, OFF, GLB, glTF or COLLADA file (assimp, private): all parts and
/// node transforms flattened, equal vertices welded, checked, and in metres. Axes are taken as LPS unless the
/// file says otherwise. `repairs`, when given, receives what had to be repaired. Files named inside the file
/// are opened only below its own folder. Throws Error{kFileMissing, kFileUnreadable} for a file that is not a
/// mesh, {kBadParameter} for the scale, {kBadMesh} for a mesh that breaks a rule (M01..M19).
[[nodiscard]] TriangleMesh importMesh(const std::filesystem::path& file,
                                      const MeshImportOptions& options = {}, MeshRepairs* repairs = nullptr);

/// Welds, checks and repairs a surface in metres that was read from a file; `where` names it. Throws
/// Error{kBadMesh} as importMesh.
[[nodiscard]] TriangleMesh checkedMesh(TriangleMesh mesh, const std::string& where,
                                       const MeshImportOptions& options = {}, MeshRepairs* repairs = nullptr);

/// Checks that a file unit is one. Throws Error{kBadParameter}.
void requireUnit(double scale_m, const std::string& where);

/// Returns the metres in one "m", "cm", "mm" or "um" (the values of --organ-unit). Throws
/// Error{kBadParameter}.
[[nodiscard]] double lengthUnit_m(std::string_view name);

}  // namespace torsio
