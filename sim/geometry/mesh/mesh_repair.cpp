// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace torsio {

namespace {

using Triangle = TriangleMesh::Triangle;

constexpr double kFlatRatio = 1e-6;  // twice the area over the longest side squared
constexpr int kSliverPasses = 8;
constexpr std::uint32_t kNone = 0xffffffffU;

// A hash grid whose cells are wider than the tolerance, so that mostly one cell is searched.
class WeldGrid {
 public:
  WeldGrid(const std::vector<Vec3>& points, double tolerance_m)
      : points_(points), tolerance_m_(tolerance_m), cell_m_(std::max(8.0 * tolerance_m, 1e-12)) {}

  // The kept point near `p`, or kNone.
  std::uint32_t find(const Vec3& p) const {
    const Cell low = cellOf(p - Vec3{tolerance_m_, tolerance_m_, tolerance_m_});
    const Cell high = cellOf(p + Vec3{tolerance_m_, tolerance_m_, tolerance_m_});
    std::uint32_t best = kNone;
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          best = std::min(best, findIn({x, y, z}, p));
        }
      }
    }
    return best;
  }
  void add(std::uint32_t index) { cells_[key(cellOf(points_[index]))].push_back(index); }

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cellOf(const Vec3& p) const {
    return {static_cast<std::int64_t>(std::floor(p.x / cell_m_)),
            static_cast<std::int64_t>(std::floor(p.y / cell_m_)),
            static_cast<std::int64_t>(std::floor(p.z / cell_m_))};
  }
  // Two cells may share a key: findIn compares positions anyway.
  static std::uint64_t key(const Cell& c) {
    std::uint64_t hash = 0;
    for (const std::int64_t i : c) {
      hash = (hash ^ static_cast<std::uint64_t>(i)) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 29U;
    }
    return hash;
  }
  std::uint32_t findIn(const Cell& cell, const Vec3& p) const {
    const auto found = cells_.find(key(cell));
    if (found == cells_.end()) {
      return kNone;
    }
    for (const std::uint32_t i : found->second) {
      if (norm(points_[i] - p) <= tolerance_m_) {
        return i;
      }
    }
    return kNone;
  }

  const std::vector<Vec3>& points_;
  double tolerance_m_;
  double cell_m_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

bool sameEdge(const EdgeUse& a, const EdgeUse& b) {
  return a.low == b.low && a.high == b.high;
}

void removeRepeatedCorners(TriangleMesh& mesh, MeshRepairs& repairs) {
  const auto bad = [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
  repairs.degenerateFaces += std::erase_if(mesh.triangles, bad);
}

void removeRepeatedFaces(TriangleMesh& mesh, MeshRepairs& repairs) {
  std::vector<std::pair<Triangle, std::uint32_t>> sorted(mesh.triangles.size());
  for (std::uint32_t t = 0; t < sorted.size(); ++t) {
    sorted[t] = {mesh.triangles[t], t};
    std::sort(sorted[t].first.begin(), sorted[t].first.end());
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> repeated(sorted.size(), false);
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first == sorted[i - 1].first) {
      repeated[sorted[i].second] = true;
    }
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < repeated.size(); ++t) {
    if (!repeated[t]) {
      mesh.triangles[kept++] = mesh.triangles[t];
    }
  }
  repairs.duplicateFaces += mesh.triangles.size() - kept;
  mesh.triangles.resize(kept);
}

// Turns the longest edge of a sliver: (a, b, c) with c on the edge a-b, and its neighbour (b, a, d), become
// (a, d, c) and (d, b, c). The surface stays closed; only its flat part is cut the other way.
std::size_t turnSlivers(TriangleMesh& mesh) {
  const std::vector<EdgeUse> edges = sortedEdges(mesh);
  std::vector<bool> touched(mesh.triangles.size(), false);
  const auto connected = [&edges](std::uint32_t p, std::uint32_t q) {
    const std::pair wanted{std::min(p, q), std::max(p, q)};
    const auto at = std::lower_bound(edges.begin(), edges.end(), wanted, [](const EdgeUse& e, auto& pair) {
      return std::pair{e.low, e.high} < pair;
    });
    return at != edges.end() && at->low == wanted.first && at->high == wanted.second;
  };
  std::size_t turned = 0;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const bool manifold = sameEdge(edges[i], edges[i + 1]) && edges[i].ascending != edges[i + 1].ascending &&
                          (i == 0 || !sameEdge(edges[i - 1], edges[i])) &&
                          (i + 2 == edges.size() || !sameEdge(edges[i + 1], edges[i + 2]));
    if (!manifold) {
      continue;
    }
    for (const auto& [flat, other] : {std::pair{edges[i], edges[i + 1]}, std::pair{edges[i + 1], edges[i]}}) {
      Triangle& t = mesh.triangles[flat.triangle];
      Triangle& u = mesh.triangles[other.triangle];
      const std::uint32_t a = t[flat.side], b = t[(flat.side + 1U) % 3], c = t[(flat.side + 2U) % 3];
      const std::uint32_t d = u[(other.side + 2U) % 3];
      const auto& v = mesh.vertices_m;
      const double length = norm(v[a] - v[b]);
      if (touched[flat.triangle] || touched[other.triangle] || !isDegenerate(v[a], v[b], v[c]) ||
          length < norm(v[b] - v[c]) || length < norm(v[c] - v[a]) || c == d || connected(c, d)) {
        continue;
      }
      t = {a, d, c};
      u = {d, b, c};
      touched[flat.triangle] = touched[other.triangle] = true;
      ++turned;
      break;
    }
  }
  return turned;
}

void plural(std::vector<std::string>& lines, std::size_t count, const char* one, const char* many) {
  if (count > 0) {
    lines.push_back(std::to_string(count) + " " + (count == 1 ? one : many));
  }
}

}  // namespace

bool MeshRepairs::any() const noexcept {
  return weldedVertices + degenerateFaces + duplicateFaces + turnedFaces + droppedComponents + droppedShells +
                 unusedVertices >
             0 ||
         insideOut;
}

void MeshRepairs::add(const MeshRepairs& earlier) noexcept {
  weldedVertices += earlier.weldedVertices;
  degenerateFaces += earlier.degenerateFaces;
  duplicateFaces += earlier.duplicateFaces;
  turnedFaces += earlier.turnedFaces;
  insideOut = insideOut != earlier.insideOut;
  droppedComponents += earlier.droppedComponents;
  droppedShells += earlier.droppedShells;
  unusedVertices += earlier.unusedVertices;
}

std::vector<std::string> MeshRepairs::lines() const {
  std::vector<std::string> all;
  plural(all, weldedVertices, "vertex welded", "vertices welded");
  plural(all, degenerateFaces, "face without area removed", "faces without area removed");
  plural(all, duplicateFaces, "repeated face removed", "repeated faces removed");
  plural(all, turnedFaces, "face turned", "faces turned");
  if (insideOut) {
    all.emplace_back("turned inside out");
  }
  plural(all, droppedComponents, "small piece dropped", "small pieces dropped");
  plural(all, droppedShells, "inner shell dropped", "inner shells dropped");
  plural(all, unusedVertices, "unused vertex dropped", "unused vertices dropped");
  return all;
}

std::string MeshRepairs::text() const {
  std::string text;
  for (const std::string& line : lines()) {
    text += (text.empty() ? "" : ", ") + line;
  }
  return text;
}

bool isDegenerate(const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  const double longest2 = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
  return !(norm(cross(b - a, c - a)) > kFlatRatio * longest2);
}

std::vector<EdgeUse> sortedEdges(const TriangleMesh& mesh) {
  // By counting on the lower index, then a short sort of each vertex's few edges.
  std::vector<std::size_t> first(mesh.vertices_m.size() + 1, 0);
  const auto lower = [](const Triangle& t, std::size_t k) { return std::min(t[k], t[(k + 1) % 3]); };
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++first[lower(t, k) + 1];
    }
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<EdgeUse> edges(3 * mesh.triangles.size());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint8_t k = 0; k < 3; ++k) {
      const std::uint32_t from = mesh.triangles[t][k];
      const std::uint32_t to = mesh.triangles[t][(k + 1U) % 3];
      edges[next[std::min(from, to)]++] = {std::min(from, to), std::max(from, to), t, k, from < to};
    }
  }
  const auto at = [&edges](std::size_t i) { return edges.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t v = 0; v + 1 < first.size(); ++v) {
    std::sort(at(first[v]), at(first[v + 1]), [](const EdgeUse& a, const EdgeUse& b) {
      return std::tie(a.high, a.triangle, a.side) < std::tie(b.high, b.triangle, b.side);
    });
  }
  return edges;
}

void weldVertices(TriangleMesh& mesh, double tolerance_m, MeshRepairs& repairs) {
  WeldGrid grid(mesh.vertices_m, tolerance_m);
  std::size_t welded = 0;
  std::vector<std::uint32_t> target(mesh.vertices_m.size());
  for (std::uint32_t i = 0; i < target.size(); ++i) {
    const std::uint32_t found = grid.find(mesh.vertices_m[i]);
    target[i] = found == kNone ? i : found;
    if (found == kNone) {
      grid.add(i);
    } else {
      ++welded;
    }
  }
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) {
      corner = target[corner];
    }
  }
  MeshRepairs counted;
  removeUnusedVertices(mesh, counted);
  repairs.weldedVertices += welded;
  repairs.unusedVertices += counted.unusedVertices - welded;
}

void removeDegenerateFaces(TriangleMesh& mesh, MeshRepairs& repairs) {
  removeRepeatedCorners(mesh, repairs);
  removeRepeatedFaces(mesh, repairs);
  for (int pass = 0; pass < kSliverPasses; ++pass) {
    const bool flat = std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&mesh](const Triangle& t) {
      return isDegenerate(mesh.vertices_m[t[0]], mesh.vertices_m[t[1]], mesh.vertices_m[t[2]]);
    });
    if (!flat) {
      return;
    }
    const std::size_t turned = turnSlivers(mesh);
    repairs.degenerateFaces += turned;
    if (turned == 0) {
      return;
    }
  }
}

bool orientFaces(TriangleMesh& mesh, MeshRepairs& repairs) {
  const std::vector<EdgeUse> edges = sortedEdges(mesh);
  struct Neighbour {
    std::uint32_t triangle = kNone;
    bool agrees = false;
  };
  std::vector<std::array<Neighbour, 3>> neighbours(mesh.triangles.size());
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const EdgeUse& a = edges[i];
    const EdgeUse& b = edges[i + 1];
    if (!sameEdge(a, b)) {
      continue;
    }
    neighbours[a.triangle][a.side] = {b.triangle, a.ascending != b.ascending};
    neighbours[b.triangle][b.side] = {a.triangle, a.ascending != b.ascending};
  }
  std::vector<std::int8_t> turn(mesh.triangles.size(), -1);
  std::vector<std::uint32_t> queue;
  for (std::uint32_t seed = 0; seed < turn.size(); ++seed) {
    if (turn[seed] >= 0) {
      continue;
    }
    turn[seed] = 0;
    queue.assign(1, seed);
    for (std::size_t head = 0; head < queue.size(); ++head) {
      for (const Neighbour& n : neighbours[queue[head]]) {
        if (n.triangle == kNone) {
          continue;
        }
        const auto wanted = static_cast<std::int8_t>(n.agrees ? turn[queue[head]] : 1 - turn[queue[head]]);
        if (turn[n.triangle] < 0) {
          turn[n.triangle] = wanted;
          queue.push_back(n.triangle);
        } else if (turn[n.triangle] != wanted) {
          return false;
        }
      }
    }
  }
  const auto turned = static_cast<std::size_t>(std::count(turn.begin(), turn.end(), std::int8_t{1}));
  for (std::size_t t = 0; t < turn.size(); ++t) {
    if (turn[t] == 1) {
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
  }
  const bool negative = signedVolume_m3(mesh) < 0.0;
  if (negative) {
    for (Triangle& t : mesh.triangles) {
      std::swap(t[1], t[2]);
    }
  }
  const std::size_t changed = negative ? turn.size() - turned : turned;
  const bool mostChanged = 2 * changed > turn.size();
  repairs.insideOut = repairs.insideOut || mostChanged;
  repairs.turnedFaces += mostChanged ? turn.size() - changed : changed;
  return true;
}

void removeUnusedVertices(TriangleMesh& mesh, MeshRepairs& repairs) {
  std::vector<std::uint32_t> target(mesh.vertices_m.size(), kNone);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) {
      target[corner] = 0;
    }
  }
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (target[i] == kNone) {
      continue;
    }
    mesh.vertices_m[next] = mesh.vertices_m[i];
    target[i] = next++;
  }
  repairs.unusedVertices += mesh.vertices_m.size() - next;
  mesh.vertices_m.resize(next);
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) {
      corner = target[corner];
    }
  }
}

}  // namespace torsio
