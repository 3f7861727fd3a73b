// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/instrument_parts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/pose.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_holes.h"
#include "sim/geometry/mesh/mesh_pieces.h"
#include "sim/geometry/mesh/mesh_repair.h"

namespace torsio {

namespace {

/// Cuts a piece and closes the cut where the piece was closed.
TriangleMesh partAt(const TriangleMesh& piece, const Vec3& normal, double offset_m, bool closed) {
  TriangleMesh part = cutAt(piece, normal, offset_m);
  if (part.triangles.empty()) {
    return part;
  }
  MeshRepairs ignored;
  weldVertices(part, 1e-9, ignored);
  removeDegenerateFaces(part, ignored);
  removeUnusedVertices(part, ignored);
  if (closed) {
    static_cast<void>(closeHoles(part));
  }
  return part;
}

void append(TriangleMesh& whole, const TriangleMesh& part) {
  const auto first = static_cast<std::uint32_t>(whole.vertices_m.size());
  whole.vertices_m.insert(whole.vertices_m.end(), part.vertices_m.begin(), part.vertices_m.end());
  for (const TriangleMesh::Triangle& t : part.triangles) {
    whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

Vec3 middleOf(const TriangleMesh& piece) {
  Vec3 sum;
  double whole = 0.0;
  for (const TriangleMesh::Triangle& t : piece.triangles) {
    const auto& [a, b, c] = t;
    const std::array<Vec3, 3> p{piece.vertices_m[a], piece.vertices_m[b], piece.vertices_m[c]};
    const double area = norm(cross(p[1] - p[0], p[2] - p[0]));
    sum += area / 3.0 * (p[0] + p[1] + p[2]);
    whole += area;
  }
  return whole > 0.0 ? sum / whole : piece.vertices_m.front();
}

double area(const TriangleMesh& piece) {
  double sum = 0.0;
  for (const TriangleMesh::Triangle& t : piece.triangles) {
    const Vec3& p = piece.vertices_m[t[0]];
    sum += norm(cross(piece.vertices_m[t[1]] - p, piece.vertices_m[t[2]] - p));
  }
  return sum;
}

/// A jaw whose teeth reach over the middle is still one jaw.
void addJaw(ToolSurface& tool, const TriangleMesh& piece, bool closed) {
  constexpr double kOneSided = 0.7;
  if (piece.triangles.empty()) {
    return;
  }
  const double whole = area(piece);
  const double above = area(cutAt(piece, {0, 1, 0}, 0.0));
  if (above > kOneSided * whole) {
    append(tool.upperJaw, piece);
  } else if (above < (1.0 - kOneSided) * whole) {
    append(tool.lowerJaw, piece);
  } else {
    append(tool.upperJaw, partAt(piece, {0, 1, 0}, 0.0, closed));
    append(tool.lowerJaw, partAt(piece, {0, -1, 0}, 0.0, closed));
  }
}

}  // namespace

std::vector<TriangleMesh> piecesOf(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> pieceOf = componentOfTriangles(mesh);
  std::vector<TriangleMesh> pieces(pieceOf.empty() ? 0
                                                   : *std::max_element(pieceOf.begin(), pieceOf.end()) + 1);
  constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::vector<std::uint32_t> moved(mesh.vertices_m.size(), kNone);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    TriangleMesh& piece = pieces[pieceOf[t]];
    TriangleMesh::Triangle corners = mesh.triangles[t];
    for (std::uint32_t& v : corners) {
      if (moved[v] == kNone) {
        moved[v] = static_cast<std::uint32_t>(piece.vertices_m.size());
        piece.vertices_m.push_back(mesh.vertices_m[v]);
      }
      v = moved[v];
    }
    piece.triangles.push_back(corners);
  }
  return pieces;
}

bool isClosedBody(const TriangleMesh& mesh) {
  const MeshReport report = checkMesh(mesh);
  return report.closed() && report.manifold() && report.degenerateFaces == 0;
}

void addPiece(ToolSurface& tool, const TriangleMesh& piece, bool closed) {
  const double pivot_m = tool.pivot_mm / kToolMetre_mm;
  double least_m = piece.vertices_m.front().z;
  double most_m = least_m;
  for (const Vec3& v : piece.vertices_m) {
    least_m = std::min(least_m, v.z);
    most_m = std::max(most_m, v.z);
  }
  // A jaw has its lever behind the hinge, and the fork of the shaft reaches before it.
  const bool through = least_m < 0.5 * pivot_m && most_m > pivot_m + std::max(0.01, 0.5 * pivot_m);
  if (through) {
    append(tool.shaft, partAt(piece, {0, 0, 1}, pivot_m, closed));
    addJaw(tool, partAt(piece, {0, 0, -1}, -pivot_m, closed), closed);
  } else if (middleOf(piece).z < pivot_m) {
    addJaw(tool, piece, closed);
  } else {
    append(tool.shaft, piece);
  }
}

void closeJaws(ToolSurface& tool, double drawnOpen_deg) {
  if (drawnOpen_deg <= 0.0) {
    return;
  }
  const Vec3 pivot_m{0, 0, tool.pivot_mm / kToolMetre_mm};
  double least_m = pivot_m.z;
  for (const auto& [jaw, sign] : {std::pair{&tool.upperJaw, -1.0}, std::pair{&tool.lowerJaw, 1.0}}) {
    for (Vec3& v : jaw->vertices_m) {
      v = pivot_m + rotateAbout(v - pivot_m, {1, 0, 0}, sign * radians(drawnOpen_deg));
      least_m = std::min(least_m, v.z);
    }
  }
  for (TriangleMesh* part : {&tool.shaft, &tool.upperJaw, &tool.lowerJaw}) {
    for (Vec3& v : part->vertices_m) {
      v.z -= least_m;
    }
  }
  tool.tip_mm += kToolMetre_mm * least_m * tool.axes[2];
  tool.pivot_mm -= kToolMetre_mm * least_m;
  tool.length_mm -= kToolMetre_mm * least_m;
}

}  // namespace torsio
