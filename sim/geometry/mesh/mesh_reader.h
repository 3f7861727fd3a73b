// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

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

/// Reads an OBJ, STL, PLY, OFF, GLB, glTF or COLLADA file in this process (assimp, private), coordinates
/// times `scale_m`. Files named inside the file are opened only below its own folder. Throws
/// Error{kFileMissing, kFileUnreadable, kBadMesh} with the code of the rule (M01..M08). A damaged file may
/// take assimp, and the process, down: files of users are read by readMeshApart.
[[nodiscard]] RawMesh readMesh(const std::filesystem::path& file, double scale_m);

/// Returns a text from a file as one line of at most 200 characters.
[[nodiscard]] std::string printable(std::string text);

}  // namespace torsio
