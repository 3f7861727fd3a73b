// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/surface_patches.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include <queue>

#include "sim/core/error.h"

namespace torsio {

namespace {

using Triangle = TriangleMesh::Triangle;
using Adjacency = std::vector<std::vector<std::uint32_t>>;

constexpr std::size_t kTrianglesInPatch = 32;
constexpr std::size_t kPatchesInGroup = 16;

/// Pieces of a connected graph: every node belongs to the seed that it is nearest to along the graph.
class RoundPieces {
 public:
  RoundPieces(const Adjacency& next, const std::vector<Vec3>& places_m)
      : next_(next), places_m_(places_m), pieceOf_(next.size(), 0), way_m_(next.size(), kFar) {}

  /// The node farthest from all seeds becomes the next one; then each seed moves to the middle of its piece,
  /// some times.
  std::vector<std::uint32_t> cut(std::size_t pieces) {
    std::vector<std::uint32_t> seeds;
    while (seeds.size() < pieces) {
      const auto farthest = std::max_element(way_m_.begin(), way_m_.end());
      seeds.push_back(static_cast<std::uint32_t>(farthest - way_m_.begin()));
      spread({seeds.back()}, static_cast<std::uint32_t>(seeds.size() - 1));
    }
    for (int round = 0; round < kRounds; ++round) {
      seeds = middles(seeds.size());
      std::fill(way_m_.begin(), way_m_.end(), kFar);
      spread(seeds, 0);
    }
    return pieceOf_;
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  static constexpr int kRounds = 4;

  /// Takes over what is nearer to these seeds, numbered from `first` on (Dijkstra).
  void spread(const std::vector<std::uint32_t>& seeds, std::uint32_t first) {
    using Open = std::pair<double, std::uint32_t>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      way_m_[seeds[i]] = 0.0;
      pieceOf_[seeds[i]] = first + static_cast<std::uint32_t>(i);
      open.emplace(0.0, seeds[i]);
    }
    while (!open.empty()) {
      const auto [way, at] = open.top();
      open.pop();
      if (way > way_m_[at]) {
        continue;
      }
      for (const std::uint32_t other : next_[at]) {
        if (!(way < way_m_[other])) {
          continue;  // nearer already, whatever the step
        }
        const double longer = way + norm(places_m_[other] - places_m_[at]);
        if (!(longer < way_m_[other])) {
          continue;
        }
        way_m_[other] = longer;
        pieceOf_[other] = pieceOf_[at];
        open.emplace(longer, other);
      }
    }
  }

  [[nodiscard]] std::vector<std::uint32_t> middles(std::size_t pieces) const {
    std::vector<Vec3> means_m(pieces);
    std::vector<double> counts(pieces, 0.0);
    for (std::size_t i = 0; i < pieceOf_.size(); ++i) {
      means_m[pieceOf_[i]] += places_m_[i];
      counts[pieceOf_[i]] += 1.0;
    }
    std::vector<std::uint32_t> nodes(pieces, 0);
    std::vector<double> nearest_m(pieces, kFar);
    for (std::uint32_t i = 0; i < pieceOf_.size(); ++i) {
      const std::uint32_t piece = pieceOf_[i];
      const double away_m = norm(places_m_[i] - means_m[piece] / counts[piece]);
      if (away_m >= nearest_m[piece]) {
        continue;
      }
      nearest_m[piece] = away_m;
      nodes[piece] = i;
    }
    return nodes;
  }

  const Adjacency& next_;
  const std::vector<Vec3>& places_m_;
  std::vector<std::uint32_t> pieceOf_;
  std::vector<double> way_m_;
};

/// The vertex nearest to the mean of them all.
std::uint32_t middle(const TriangleMesh& mesh, std::span<const std::uint32_t> vertices) {
  Vec3 mean;
  for (const std::uint32_t v : vertices) {
    mean += mesh.vertices_m[v] / static_cast<double>(vertices.size());
  }
  return *std::min_element(vertices.begin(), vertices.end(), [&](std::uint32_t a, std::uint32_t b) {
    return norm(mesh.vertices_m[a] - mean) < norm(mesh.vertices_m[b] - mean);
  });
}

double radiusAbout(const TriangleMesh& mesh, std::uint32_t seed, std::span<const std::uint32_t> vertices) {
  double radius_m = 0.0;
  for (const std::uint32_t v : vertices) {
    radius_m = std::max(radius_m, norm(mesh.vertices_m[v] - mesh.vertices_m[seed]));
  }
  return radius_m;
}

}  // namespace

SurfacePatches::SurfacePatches(const TriangleMesh& mesh) : triangles_(mesh.triangles) {
  findRings(mesh.vertices_m.size());
  cut(mesh);
}

void SurfacePatches::findRings(std::size_t vertices) {
  ringBegins_.assign(vertices + 1, 0);
  for (const Triangle& t : triangles_) {
    for (const std::uint32_t v : t) {
      ++ringBegins_[v + 1];
    }
  }
  std::partial_sum(ringBegins_.begin(), ringBegins_.end(), ringBegins_.begin());
  ring_.resize(3 * triangles_.size());
  std::vector<std::uint32_t> next(ringBegins_.begin(), ringBegins_.end() - 1);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    for (const std::uint32_t v : triangles_[i]) {
      ring_[next[v]++] = i;
    }
  }
}

void SurfacePatches::cut(const TriangleMesh& mesh) {
  Adjacency next(triangles_.size());
  std::vector<Vec3> places_m(triangles_.size());
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    for (const std::uint32_t v : triangles_[i]) {
      places_m[i] += mesh.vertices_m[v] / 3.0;
      for (const std::uint32_t other : ring(v)) {
        if (other != i) {
          next[i].push_back(other);
        }
      }
    }
  }
  const std::size_t patches = std::clamp<std::size_t>(triangles_.size() / kTrianglesInPatch, 1, kMaxPatches);
  const std::vector<std::uint32_t> patchOf = RoundPieces(next, places_m).cut(patches);

  std::vector<std::set<std::uint32_t>> touching(patches);
  std::vector<Vec3> sums_m(patches);
  std::vector<double> counts(patches, 0.0);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    sums_m[patchOf[i]] += places_m[i];
    counts[patchOf[i]] += 1.0;
    for (const std::uint32_t other : next[i]) {
      if (patchOf[other] != patchOf[i]) {
        touching[patchOf[i]].insert(patchOf[other]);
      }
    }
  }
  Adjacency nextPatch(patches);
  for (std::size_t p = 0; p < patches; ++p) {
    nextPatch[p].assign(touching[p].begin(), touching[p].end());
    if (counts[p] > 0.0) {
      sums_m[p] = sums_m[p] / counts[p];
    }
  }
  const std::size_t groups = std::clamp<std::size_t>(patches / kPatchesInGroup, 1, kMaxGroups);
  const std::vector<std::uint32_t> groupOf = RoundPieces(nextPatch, sums_m).cut(groups);

  // Patches are numbered in the order of their groups.
  std::vector<std::uint32_t> order(patches);
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return groupOf[a] < groupOf[b]; });
  std::vector<std::uint32_t> number(patches);
  std::vector<std::uint32_t> orderedGroups(patches);
  for (std::uint32_t at = 0; at < patches; ++at) {
    number[order[at]] = at;
    orderedGroups[at] = groupOf[order[at]];
  }
  std::vector<std::vector<std::uint32_t>> members(patches);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    members[number[patchOf[i]]].push_back(i);
  }
  fill(mesh, members);
  join(mesh, orderedGroups, groups);
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::size_t p = 0; p < patches; ++p) {
    for (const std::uint32_t other : nextPatch[p]) {
      if (groupOf[p] < groupOf[other]) {
        pairs.emplace(groupOf[p], groupOf[other]);
      }
    }
  }
  for (const auto& [one, other] : pairs) {
    const double apart_m = norm(mesh.vertices_m[groups_[one].seed] - mesh.vertices_m[groups_[other].seed]);
    if (apart_m > 0.0) {
      neighbours_.push_back({one, other, apart_m});
    }
  }
}

void SurfacePatches::fill(const TriangleMesh& mesh, const std::vector<std::vector<std::uint32_t>>& members) {
  for (const std::vector<std::uint32_t>& triangles : members) {
    Patch patch;
    patch.firstVertex = static_cast<std::uint32_t>(vertices_.size());
    patch.firstFacet = static_cast<std::uint32_t>(facets_.size());
    patch.facetCount = static_cast<std::uint32_t>(triangles.size());
    std::unordered_map<std::uint32_t, std::uint16_t> local;
    for (const std::uint32_t triangle : triangles) {
      Facet facet;
      facet.triangle = triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = triangles_[triangle][k];
        const auto [found, added] = local.try_emplace(vertex, static_cast<std::uint16_t>(local.size()));
        if (added) {
          vertices_.push_back(vertex);
        }
        facet.corner[k] = found->second;
      }
      facets_.push_back(facet);
      if (local.size() > kMaxVertices) {
        throw Error(ErrorCode::kBadMesh,
                    Text::tr("the surface has %1 triangles, more than a tick can look at",
                             std::to_string(triangles_.size())),
                    Text::tr("collision mesh"),
                    Text::tr("Reduce the surface to half a million triangles or fewer"));
      }
    }
    patch.vertexCount = static_cast<std::uint32_t>(local.size());
    patch.seed = middle(mesh, vertices(patch));
    patch.radius_m = radiusAbout(mesh, patch.seed, vertices(patch));
    patches_.push_back(patch);
  }
}

void SurfacePatches::join(const TriangleMesh& mesh, const std::vector<std::uint32_t>& groupOf,
                          std::size_t groups) {
  groups_.resize(groups);
  for (std::uint32_t p = 0; p < patches_.size(); ++p) {
    Group& group = groups_[groupOf[p]];
    if (group.patchCount++ == 0) {
      group.firstPatch = p;
    }
  }
  for (Group& group : groups_) {
    const auto own = std::span(patches_).subspan(group.firstPatch, group.patchCount);
    std::vector<std::uint32_t> seeds;
    for (const Patch& patch : own) {
      seeds.push_back(patch.seed);
    }
    group.seed = middle(mesh, seeds);
    for (Patch& patch : own) {
      patch.apart_m = norm(mesh.vertices_m[patch.seed] - mesh.vertices_m[group.seed]);
      group.radius_m = std::max(group.radius_m, radiusAbout(mesh, group.seed, vertices(patch)));
    }
  }
}

}  // namespace torsio
