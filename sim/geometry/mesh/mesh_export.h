// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

enum class PlyFormat { kBinary, kAscii };

struct MeshExportOptions {
  PlyFormat format = PlyFormat::kBinary;  ///< PLY only
  std::vector<std::string> comments;      ///< lines for the head of the file
  /// Colours, red, green and blue, one a vertex, or empty. PLY only.
  std::span<const std::array<std::uint8_t, 3>> colours;
  bool normals = false;  ///< of the vertices, outwards. PLY only
  /// Texture coordinates s and t, one pair a vertex, or empty. PLY only.
  std::span<const std::array<float, 2>> texture{};
};

/// Writes a mesh as the bytes of a PLY file: single precision, millimetres, little endian when binary; the
/// same bytes on every platform.
[[nodiscard]] std::string plyBytes(const TriangleMesh& mesh, const MeshExportOptions& options = {});

/// Writes a mesh as the text of a Wavefront OBJ file, millimetres.
[[nodiscard]] std::string objText(const TriangleMesh& mesh, const MeshExportOptions& options = {});

/// Writes a mesh to a PLY file, through a temporary file. Throws Error{kFileUnwritable}.
void writePly(const std::filesystem::path& file, const TriangleMesh& mesh,
              const MeshExportOptions& options = {});
void writeObj(const std::filesystem::path& file, const TriangleMesh& mesh,
              const MeshExportOptions& options = {});

}  // namespace torsio
