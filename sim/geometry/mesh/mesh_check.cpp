// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <numeric>
#include <set>
#include <vector>

#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_pieces.h"

namespace torsio {

namespace {

using Triangle = TriangleMesh::Triangle;

std::string number(double value, const char* format = "%.4g") {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string mm(double metres) {
  return number(metres * 1000.0) + " mm";
}

std::string pointMm(const Vec3& p) {
  std::array<char, 120> text{};
  std::snprintf(text.data(), text.size(), "(%.4g, %.4g, %.4g) mm", p.x * 1000.0, p.y * 1000.0, p.z * 1000.0);
  return text.data();
}

[[noreturn]] void refuseMesh(const Text& what, const Text& where, const Text& remedy) {
  throw Error(ErrorCode::kBadMesh, what, where, remedy);
}

std::uint32_t root(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) {
    i = parent[i] = parent[parent[i]];
  }
  return i;
}

void join(std::vector<std::uint32_t>& parent, std::uint32_t a, std::uint32_t b) {
  a = root(parent, a), b = root(parent, b);
  parent[std::max(a, b)] = std::min(a, b);
}

std::vector<std::uint32_t> singletons(std::size_t count) {
  std::vector<std::uint32_t> parent(count);
  std::iota(parent.begin(), parent.end(), std::uint32_t{0});
  return parent;
}

void measureFaces(const TriangleMesh& mesh, MeshReport& report) {
  std::vector<Triangle> sorted = mesh.triangles;
  for (Triangle& t : sorted) {
    std::sort(t.begin(), t.end());
  }
  std::sort(sorted.begin(), sorted.end());
  report.duplicateFaces =
      static_cast<std::size_t>(std::distance(std::unique(sorted.begin(), sorted.end()), sorted.end()));
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices_m[t[0]], &b = mesh.vertices_m[t[1]], &c = mesh.vertices_m[t[2]];
    report.area_m2 += 0.5 * norm(cross(b - a, c - a));
    if (isDegenerate(a, b, c)) {
      ++report.degenerateFaces;
    }
  }
  report.volume_m3 = signedVolume_m3(mesh);
}

void measureBox(const TriangleMesh& mesh, MeshReport& report) {
  if (mesh.vertices_m.empty()) {
    return;
  }
  const BoundingBox box = boxOf(mesh.vertices_m);
  report.boxMin_m = box.low;
  report.boxMax_m = box.high;
}

// Counts the edges by use and returns how many different ones there are.
std::size_t measureEdges(const TriangleMesh& mesh, const std::vector<EdgeUse>& edges, MeshReport& report) {
  std::size_t different = 0;
  std::vector<std::uint32_t> holeOf = singletons(mesh.vertices_m.size());
  std::vector<std::uint32_t> onBoundary;
  for (std::size_t i = 0; i < edges.size(); ++different) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) {
      ++end;
    }
    const Vec3 middle = 0.5 * (mesh.vertices_m[edges[i].low] + mesh.vertices_m[edges[i].high]);
    if (end - i == 1) {
      if (report.boundaryEdges++ == 0) {
        report.firstHole_m = middle;
      }
      onBoundary.push_back(edges[i].low);
      join(holeOf, edges[i].low, edges[i].high);
    } else if (end - i > 2) {
      if (report.nonManifoldEdges++ == 0) {
        report.firstNonManifold_m = middle;
      }
    } else if (edges[i].ascending == edges[i + 1].ascending) {
      ++report.inconsistentEdges;
    }
    i = end;
  }
  std::set<std::uint32_t> holes;
  for (const std::uint32_t v : onBoundary) {
    holes.insert(root(holeOf, v));
  }
  report.holes = holes.size();
  return different;
}

// A vertex is manifold when its corners are all connected through shared edges: one fan.
void measureVertices(const TriangleMesh& mesh, const std::vector<EdgeUse>& edges, MeshReport& report) {
  std::vector<std::uint32_t> fan = singletons(3 * mesh.triangles.size());
  const auto cornerAt = [&mesh](const EdgeUse& e, std::uint32_t vertex) {
    const std::uint32_t start = mesh.triangles[e.triangle][e.side] == vertex ? e.side : (e.side + 1U) % 3;
    return 3 * e.triangle + start;
  };
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const EdgeUse &a = edges[i], &b = edges[i + 1];
    if (a.low != b.low || a.high != b.high) {
      continue;
    }
    join(fan, cornerAt(a, a.low), cornerAt(b, a.low));
    join(fan, cornerAt(a, a.high), cornerAt(b, a.high));
  }
  std::vector<std::uint32_t> fans(mesh.vertices_m.size(), 0);
  for (std::uint32_t corner = 0; corner < fan.size(); ++corner) {
    if (root(fan, corner) == corner) {
      ++fans[mesh.triangles[corner / 3][corner % 3]];
    }
  }
  std::size_t used = 0;
  for (std::size_t v = 0; v < fans.size(); ++v) {
    if (fans[v] > 0) {
      ++used;
    }
    if (fans[v] < 2) {
      continue;
    }
    if (report.nonManifoldVertices++ == 0 && report.nonManifoldEdges == 0) {
      report.firstNonManifold_m = mesh.vertices_m[v];
    }
  }
  report.unusedVertices = mesh.vertices_m.size() - used;
}

void requireSize(const MeshReport& report, const std::string& where, std::optional<double> unit_m) {
  const double side_m = report.largestSide_m();
  requireLargestSide(
      side_m, Stated::kOrganSide,
      Text::tr("M09 largest side %1 is not that of an organ (%2)",
               inPlausibleUnit(Stated::kOrganSide, side_m), plausibleRange(Stated::kOrganSide)),
      where, unit_m);
}

void requireClosedManifold(const MeshReport& r, const std::string& where) {
  if (r.nonManifoldEdges > 0) {
    refuseMesh(Text::tr("M12 %1 {edge|edges} shared by more than two faces, first at %2",
                        std::to_string(r.nonManifoldEdges), pointMm(r.firstNonManifold_m)),
               where, Text::tr("Remove inner or doubled faces in a mesh editor"));
  }
  if (r.boundaryEdges > 0) {
    refuseMesh(Text::tr("M11 the surface is open: %1 boundary {edge|edges} in %2 {hole|holes}, first at %3",
                        std::to_string(r.boundaryEdges), std::to_string(r.holes), pointMm(r.firstHole_m)),
               where, Text::tr("Close the holes in a mesh editor"));
  }
  if (r.nonManifoldVertices > 0) {
    refuseMesh(Text::tr("M12 %1 {vertex|vertices} where two parts only touch, first at %2",
                        std::to_string(r.nonManifoldVertices), pointMm(r.firstNonManifold_m)),
               where, Text::tr("Separate or join the parts in a mesh editor"));
  }
}

void requireShape(const MeshReport& r, const std::string& where) {
  if (r.degenerateFaces > 0) {
    refuseMesh(
        Text::tr("M10 %1 {face|faces} without area could not be repaired", std::to_string(r.degenerateFaces)),
        where, Text::tr("Remesh the surface"));
  }
  if (r.genus() != 0) {
    refuseMesh(Text::tr("M16 the surface has %1 {handle|handles}, like a ring", std::to_string(r.genus())),
               where, Text::tr("Close the tunnels: an organ's outer surface has none"));
  }
  const double thickness_m = r.area_m2 > 0.0 ? 2.0 * r.volume_m3 / r.area_m2 : 0.0;
  if (!(thickness_m > kThinnestOrgan_m)) {
    refuseMesh(Text::tr("M18 the surface is flat: mean thickness %1, volume %2 ml", mm(thickness_m),
                        number(r.volume_m3 * 1e6)),
               where, Text::tr("Give a closed surface that encloses the organ"));
  }
  if (r.triangles < kMinTriangles) {
    refuseMesh(Text::tr("M19 too coarse: %1 triangles, at least %2 are needed", std::to_string(r.triangles),
                        std::to_string(kMinTriangles)),
               where, Text::tr("Subdivide the surface"));
  }
}

}  // namespace

void requireLargestSide(double side_m, Stated what, const Text& otherwise, const std::string& where,
                        std::optional<double> unit_m) {
  if (isPlausible(what, side_m)) {
    return;
  }
  const std::array stated{StatedValue{what, side_m}};
  const std::optional<StatedUnit> likely = unit_m ? unitThatFits(stated, *unit_m) : std::nullopt;
  if (likely) {
    refuseMesh(Text::tr("M09 largest side %1: the file seems to be in %2", inPlausibleUnit(what, side_m),
                        likely->name),
               where,
               Text::tr("Add --organ-unit %1 (in the window: choose the unit of the file)", likely->word));
  }
  refuseMesh(otherwise, where, Text::tr("Scale the mesh to life size"));
}

std::int64_t MeshReport::genus() const noexcept {
  if (!closed() || !manifold()) {
    return -1;
  }
  return (2 * static_cast<std::int64_t>(components) - euler) / 2;
}

double MeshReport::largestSide_m() const noexcept {
  const Vec3 side = boxMax_m - boxMin_m;
  return std::max({side.x, side.y, side.z});
}

MeshReport checkMesh(const TriangleMesh& mesh) {
  MeshReport report;
  report.vertices = mesh.vertices_m.size();
  report.triangles = mesh.triangles.size();
  const auto outside = [&mesh](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&mesh](std::uint32_t i) { return i >= mesh.vertices_m.size(); });
  };
  report.badIndices =
      static_cast<std::size_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(), outside));
  const auto bad = [](const Vec3& v) { return !isFinite(v); };
  const auto firstBad = std::find_if(mesh.vertices_m.begin(), mesh.vertices_m.end(), bad);
  report.firstBadVertex = static_cast<std::size_t>(std::distance(mesh.vertices_m.begin(), firstBad));
  report.nonFiniteVertices = static_cast<std::size_t>(std::count_if(firstBad, mesh.vertices_m.end(), bad));
  if (report.badIndices > 0 || report.nonFiniteVertices > 0) {
    return report;
  }

  measureBox(mesh, report);
  measureFaces(mesh, report);
  const std::vector<EdgeUse> edges = sortedEdges(mesh);
  const std::size_t different = measureEdges(mesh, edges, report);
  measureVertices(mesh, edges, report);
  const std::vector<std::uint32_t> component = componentOfTriangles(mesh);
  if (!component.empty()) {
    report.components = *std::max_element(component.begin(), component.end()) + std::size_t{1};
  }
  report.euler = static_cast<std::int64_t>(report.vertices - report.unusedVertices) -
                 static_cast<std::int64_t>(different) + static_cast<std::int64_t>(report.triangles);
  return report;
}

void requireSound(const TriangleMesh& mesh, const std::string& where) {
  if (mesh.triangles.empty()) {
    refuseMesh(Text::tr("M06 no triangles"), where,
               Text::tr("Give a file with a surface, not points or lines"));
  }
  if (mesh.triangles.size() > kMaxTriangles) {
    refuseMesh(Text::tr("M03 %1 triangles, at most %2 are accepted", std::to_string(mesh.triangles.size()),
                        std::to_string(kMaxTriangles)),
               where, Text::tr("Decimate the surface"));
  }
  for (std::size_t i = 0; i < mesh.vertices_m.size(); ++i) {
    const Vec3& v = mesh.vertices_m[i];
    if (!isFinite(v)) {
      refuseMesh(Text::tr("M07 vertex %1 is not a finite number", std::to_string(i)), where,
                 Text::tr("Remove the vertex or export the mesh again"));
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t i : mesh.triangles[t]) {
      if (i >= mesh.vertices_m.size()) {
        refuseMesh(Text::tr("M08 face %1 uses vertex %2 of %3", std::to_string(t), std::to_string(i),
                            std::to_string(mesh.vertices_m.size())),
                   where, Text::tr("Export the mesh again"));
      }
    }
  }
}

void requireNearOrigin(const TriangleMesh& mesh, const std::string& where) {
  for (std::size_t i = 0; i < mesh.vertices_m.size(); ++i) {
    const Vec3& v = mesh.vertices_m[i];
    if (std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) > kLargestCoordinate_m) {
      refuseMesh(Text::tr("M07 vertex %1 is at %2, further than %3 from the origin", std::to_string(i),
                          pointMm(v), mm(kLargestCoordinate_m)),
                 where, Text::tr("Check the unit, or move the mesh near the origin"));
    }
  }
}

TriangleMesh requireOrgan(TriangleMesh mesh, const std::string& where, std::optional<double> unit_m,
                          MeshRepairs* repairs) {
  MeshRepairs done;
  requireSound(mesh, where);
  removeUnusedVertices(mesh, done);
  MeshReport report;
  measureBox(mesh, report);
  requireSize(report, where, unit_m);
  requireNearOrigin(mesh, where);
  constexpr double kWeldShare = 1e-6;  // of the largest side: 0.2 um on a stomach, above float rounding
  weldVertices(mesh, kWeldShare * report.largestSide_m(), done);
  removeDegenerateFaces(mesh, done);
  if (mesh.triangles.empty()) {
    requireSound(mesh, where);
  }
  if (const double share = keepMainComponent(mesh, kSmallPieceShare, done); share > 0.0) {
    refuseMesh(Text::tr("M14 separate pieces hold %1 % of the surface", number(100.0 * share, "%.0f")), where,
               Text::tr("Keep one organ only"));
  }
  MeshRepairs ofDroppedPieces;
  removeUnusedVertices(mesh, ofDroppedPieces);
  requireClosedManifold(checkMesh(mesh), where);
  if (!orientFaces(mesh, done)) {
    refuseMesh(Text::tr("M13 the surface is one-sided (like a Moebius strip)"), where,
               Text::tr("Repair the faces in a mesh editor"));
  }
  report = checkMesh(mesh);
  requireSize(report, where, unit_m);
  requireShape(report, where);
  if (repairs != nullptr) {
    *repairs = done;
  }
  return mesh;
}

}  // namespace torsio
