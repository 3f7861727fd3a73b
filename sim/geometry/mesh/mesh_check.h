// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "sim/core/plausible.h"
#include "sim/core/text.h"
#include "sim/core/vec3.h"
#include "sim/geometry/mesh/mesh_repair.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Limits within which a mesh is accepted as an organ, besides Stated::kOrganSide. Lengths in metres.
inline constexpr double kLargestCoordinate_m = 100;  ///< importers keep single precision
inline constexpr std::size_t kMaxTriangles = 2'000'000;
inline constexpr std::size_t kMinTriangles = 200;
inline constexpr double kSmallPieceShare =
    0.05;  ///< separate pieces up to this share of the area are dropped
inline constexpr double kThinnestOrgan_m = 0.0005;  ///< mean thickness 2 V / A

/// Findings about a mesh as it is.
struct MeshReport {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t badIndices = 0;         ///< triangles with a corner outside the vertex list; nothing below then
  std::size_t nonFiniteVertices = 0;  ///< NaN or infinite; nothing below then
  std::size_t firstBadVertex = 0;     ///< index of the first non-finite vertex
  std::size_t unusedVertices = 0;
  std::size_t degenerateFaces = 0;      ///< without area (isDegenerate)
  std::size_t duplicateFaces = 0;       ///< same three corners as an earlier face
  std::size_t boundaryEdges = 0;        ///< used by one face
  std::size_t holes = 0;                ///< connected sets of boundary edges
  std::size_t nonManifoldEdges = 0;     ///< used by more than two faces
  std::size_t nonManifoldVertices = 0;  ///< whose faces do not form one fan
  std::size_t inconsistentEdges = 0;    ///< two faces that run the same way
  std::size_t components = 0;           ///< pieces connected through vertices
  std::int64_t euler = 0;               ///< V - E + F over the used vertices
  double area_m2 = 0.0;
  double volume_m3 = 0.0;  ///< signed; only meaningful when closed() and oriented()
  Vec3 boxMin_m;
  Vec3 boxMax_m;
  Vec3 firstHole_m;         ///< a point on the first boundary edge
  Vec3 firstNonManifold_m;  ///< a point on the first non-manifold edge, or the vertex

  [[nodiscard]] bool closed() const noexcept { return triangles > 0 && boundaryEdges == 0; }
  [[nodiscard]] bool manifold() const noexcept { return nonManifoldEdges == 0 && nonManifoldVertices == 0; }
  [[nodiscard]] bool oriented() const noexcept { return inconsistentEdges == 0; }
  /// Returns the number of handles of a closed manifold surface: 0 for a sphere, 1 for a torus; -1 when it
  /// has no genus.
  [[nodiscard]] std::int64_t genus() const noexcept;
  [[nodiscard]] double largestSide_m() const noexcept;
};

/// Examines a mesh without changing it; never throws for a bad one. O(T log T).
[[nodiscard]] MeshReport checkMesh(const TriangleMesh& mesh);

/// Checks that a mesh can be read at all. Throws Error{kBadMesh} when it is empty or has an index out of
/// range, a coordinate that is not finite, or too many triangles. `where` names the file.
void requireSound(const TriangleMesh& mesh, const std::string& where);

/// Checks that a mesh lies near the origin. Throws Error{kBadMesh} for a coordinate beyond
/// kLargestCoordinate_m.
void requireNearOrigin(const TriangleMesh& mesh, const std::string& where);

/// Checks that a surface is as large as what it shows (Stated::kOrganSide, kInstrumentSide). Throws
/// Error{kBadMesh}, M09, with the unit that would fit in place of `unit_m` where one does, else with the
/// sentence `otherwise`. No unit: the file states it.
void requireLargestSide(double side_m, Stated what, const Text& otherwise, const std::string& where,
                        std::optional<double> unit_m);

/// Repairs what can be repaired without guessing (double vertices and faces, orientation, small separate
/// pieces, inner shells) and returns a closed, manifold, outward-oriented surface of genus 0. Throws
/// Error{kBadMesh} for everything else, with the code of the rule (M06..M19), the measured value and what to
/// do. `where` names the file; `unit_m` is the file unit that was assumed, for the guess of the right one
/// (none: the file states it); `repairs`, when given, receives what was done.
[[nodiscard]] TriangleMesh requireOrgan(TriangleMesh mesh, const std::string& where,
                                        std::optional<double> unit_m = 0.001, MeshRepairs* repairs = nullptr);

}  // namespace torsio
