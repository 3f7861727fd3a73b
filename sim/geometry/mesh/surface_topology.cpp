// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/surface_topology.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include <queue>

#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr SurfaceTopology::Index kNoIndex = std::numeric_limits<SurfaceTopology::Index>::max();

std::string placeOf(const Vec3& point_m) {
  const auto mm = [](double value_m) { return std::to_string(value_m * 1000.0); };
  return "near (" + mm(point_m.x) + ", " + mm(point_m.y) + ", " + mm(point_m.z) + ") mm";
}

void requireUsable(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) {
    throw Error(ErrorCode::kBadMesh, Text::tr("the mesh has no triangles"), "",
                Text::tr("Give a closed triangle surface."));
  }
  for (std::size_t v = 0; v < mesh.vertices_m.size(); ++v) {
    if (!isFinite(mesh.vertices_m[v])) {
      throw Error(ErrorCode::kBadMesh, Text::tr("a vertex is not a finite point"),
                  Text::tr("vertex %1", std::to_string(v)), Text::tr("Export the mesh again."));
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t corner : mesh.triangles[t]) {
      if (corner >= mesh.vertices_m.size()) {
        throw Error(ErrorCode::kBadMesh, Text::tr("a triangle refers to a vertex that does not exist"),
                    Text::tr("triangle %1", std::to_string(t)), Text::tr("Export the mesh again."));
      }
    }
  }
}

}  // namespace

SurfaceTopology::SurfaceTopology(const TriangleMesh& mesh) {
  requireUsable(mesh);
  origin_.reserve(3 * mesh.triangles.size());
  for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
    origin_.insert(origin_.end(), triangle.begin(), triangle.end());
  }
  findOutgoing(mesh.vertices_m.size());
  pairEdges(mesh);
}

void SurfaceTopology::findOutgoing(std::size_t vertices) {
  firstOutgoing_.assign(vertices + 1, 0);
  for (const Index v : origin_) {
    ++firstOutgoing_[v + 1];
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    firstOutgoing_[v + 1] += firstOutgoing_[v];
  }
  outgoing_.resize(origin_.size());
  std::vector<Index> fill(firstOutgoing_.begin(), firstOutgoing_.end() - 1);
  for (Index half = 0; half < halfEdges(); ++half) {
    outgoing_[fill[origin_[half]]++] = half;
  }
}

void SurfaceTopology::pairEdges(const TriangleMesh& mesh) {
  // Outgoing half-edges of each vertex sorted by target: the opposite of a -> b is found among those of b.
  const auto byTarget = [this](Index a, Index b) { return target(a) < target(b); };
  for (Index v = 0; v < vertices(); ++v) {
    std::sort(outgoing_.begin() + firstOutgoing_[v], outgoing_.begin() + firstOutgoing_[v + 1], byTarget);
  }
  opposite_.assign(origin_.size(), kNoIndex);
  for (Index half = 0; half < halfEdges(); ++half) {
    const Index from = origin(half);
    const std::span<const Index> candidates = outgoing(target(half));
    const auto first = std::lower_bound(candidates.begin(), candidates.end(), from,
                                        [this](Index edge, Index vertex) { return target(edge) < vertex; });
    const auto last = std::upper_bound(first, candidates.end(), from,
                                       [this](Index vertex, Index edge) { return vertex < target(edge); });
    if (last - first != 1 || from == target(half)) {
      throw Error(
          ErrorCode::kBadMesh,
          Text::tr(
              "an edge of the surface is open, used more than twice or runs the same way in both triangles"),
          placeOf(mesh.vertices_m[from]), Text::tr("Close and repair the mesh."));
    }
    opposite_[half] = *first;
  }
}

std::vector<double> edgeDistances_m(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                    std::span<const std::uint32_t> sources) {
  using Entry = std::pair<double, std::uint32_t>;
  std::vector<double> distance(mesh.vertices_m.size(), std::numeric_limits<double>::infinity());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for (const std::uint32_t source : sources) {
    distance[source] = 0.0;
    front.emplace(0.0, source);
  }
  while (!front.empty()) {
    const auto [way, vertex] = front.top();
    front.pop();
    if (way > distance[vertex]) {
      continue;
    }
    for (const std::uint32_t half : topology.outgoing(vertex)) {
      const std::uint32_t other = topology.target(half);
      const double longer = way + norm(mesh.vertices_m[other] - mesh.vertices_m[vertex]);
      if (longer < distance[other]) {
        distance[other] = longer;
        front.emplace(longer, other);
      }
    }
  }
  return distance;
}

std::vector<std::uint32_t> takeConnected(const SurfaceTopology& topology, std::vector<std::uint8_t>& open,
                                         std::uint32_t seed) {
  std::vector<std::uint32_t> reached;
  if (open[seed] == 0) {
    return reached;
  }
  open[seed] = 0;
  reached.push_back(seed);
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const std::uint32_t half : topology.outgoing(reached[i])) {
      const std::uint32_t v = topology.target(half);
      if (open[v] == 0) {
        continue;
      }
      open[v] = 0;
      reached.push_back(v);
    }
  }
  return reached;
}

}  // namespace torsio
