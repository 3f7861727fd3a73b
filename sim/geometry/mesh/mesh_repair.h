// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// What was changed in a mesh before it was accepted; every repair is counted so that it can be shown.
struct MeshRepairs {
  std::size_t weldedVertices = 0;
  std::size_t degenerateFaces = 0;    ///< faces without area, removed
  std::size_t duplicateFaces = 0;     ///< same three corners, removed
  std::size_t turnedFaces = 0;        ///< against their neighbours, turned
  bool insideOut = false;             ///< the whole surface was turned
  std::size_t droppedComponents = 0;  ///< small separate pieces, removed
  std::size_t droppedShells = 0;      ///< closed pieces inside the organ (inner wall), removed
  std::size_t unusedVertices = 0;

  [[nodiscard]] bool any() const noexcept;
  /// Counts what an earlier pass repaired in. A surface that both turned inside out is as it was.
  void add(const MeshRepairs& earlier) noexcept;
  /// Describes the repairs, one of a kind a line: "2 faces turned".
  [[nodiscard]] std::vector<std::string> lines() const;
  /// Describes the repairs in one line, empty when nothing was repaired.
  [[nodiscard]] std::string text() const;
};

/// One side of a triangle: `side` k runs from corner k to corner (k + 1) % 3.
struct EdgeUse {
  std::uint32_t low = 0;   ///< the smaller vertex index
  std::uint32_t high = 0;  ///< the larger one
  std::uint32_t triangle = 0;
  std::uint8_t side = 0;
  bool ascending = false;  ///< the triangle runs from low to high
};

/// Lists all sides of all triangles, equal edges next to each other, in a fixed order. All indices must be
/// in range.
[[nodiscard]] std::vector<EdgeUse> sortedEdges(const TriangleMesh& mesh);

/// Joins vertices not further apart than `tolerance_m` >= 0 to the first of them, keeping the order.
/// Importers split vertices at seams of normals and textures; nothing works on the result otherwise.
void weldVertices(TriangleMesh& mesh, double tolerance_m, MeshRepairs& repairs);

/// Removes faces with a repeated corner and repeated faces, and turns the long edge of flat slivers so that
/// no face without area is left where that can be done without opening the surface.
void removeDegenerateFaces(TriangleMesh& mesh, MeshRepairs& repairs);

/// Turns faces so that neighbours agree, then the whole surface so that it encloses a positive volume.
/// Edges must not be used more than twice. False when the surface is one-sided; then nothing is changed.
[[nodiscard]] bool orientFaces(TriangleMesh& mesh, MeshRepairs& repairs);

/// Removes vertices that no triangle uses, keeping the order.
void removeUnusedVertices(TriangleMesh& mesh, MeshRepairs& repairs);

/// Tells whether the height of the triangle is below a millionth of its longest side.
[[nodiscard]] bool isDegenerate(const Vec3& a, const Vec3& b, const Vec3& c) noexcept;

}  // namespace torsio
