// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/side_branch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/nearest_on_triangle.h"
#include "sim/geometry/mesh/surface_topology.h"

namespace torsio {

namespace {

using Index = std::uint32_t;

constexpr double kMaxOfOrgan = 0.1;

[[noreturn]] void refuseBranch(const Text& what) {
  throw Error(
      ErrorCode::kBadParameter, what, Text::tr("side branch"),
      Text::tr("Move its root to where the branch leaves the organ, or turn the direction of the cut."));
}

/// Marks the vertices of the piece beyond the plane that lies nearest to `root_m`.
std::vector<std::uint8_t> branchOf(const TriangleMesh& mesh, const Vec3& root_m, const Vec3& direction) {
  std::vector<std::uint8_t> open(mesh.vertices_m.size(), 0);
  Index nearest = 0;
  double least_m = std::numeric_limits<double>::infinity();
  for (Index v = 0; v < open.size(); ++v) {
    const Vec3 from = mesh.vertices_m[v] - root_m;
    open[v] = dot(from, direction) >= 0.0 ? 1 : 0;
    if (open[v] != 0 && norm(from) < least_m) {
      least_m = norm(from);
      nearest = v;
    }
  }
  const std::vector<Index> piece = takeConnected(SurfaceTopology(mesh), open, nearest);
  if (piece.empty()) {
    refuseBranch(Text::tr("nothing of the organ lies beyond the cut of its side branch"));
  }
  if (static_cast<double>(piece.size()) > kMaxOfOrgan * static_cast<double>(open.size())) {
    refuseBranch(Text::tr("the side branch is more than a tenth of the organ"));
  }
  std::vector<std::uint8_t> branch(open.size(), 0);
  for (const Index v : piece) {
    branch[v] = 1;
  }
  return branch;
}

}  // namespace

TrimmedOrgan::TrimmedOrgan(const TriangleMesh& mesh, const Vec3& root_m, const Vec3& outward) {
  const Vec3 direction = normalized(outward);
  if (!isFinite(root_m) || !isFinite(direction) || direction == Vec3{}) {
    refuseBranch(Text::tr("the place or the direction of the side branch is not finite"));
  }
  const std::vector<std::uint8_t> branch = branchOf(mesh, root_m, direction);
  cut(mesh, branch);
  close(mesh);
  place(mesh, branch, root_m, direction);
}

void TrimmedOrgan::cut(const TriangleMesh& mesh, const std::vector<std::uint8_t>& branch) {
  places_.resize(mesh.vertices_m.size());
  for (Index v = 0; v < branch.size(); ++v) {
    places_[v].onLid = branch[v] != 0;
    if (!places_[v].onLid) {
      places_[v].vertex = static_cast<Index>(mesh_.vertices_m.size());
      mesh_.vertices_m.push_back(mesh.vertices_m[v]);
    }
  }
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const TriangleMesh::Triangle& corners = mesh.triangles[t];
    if (std::none_of(corners.begin(), corners.end(), [&branch](Index v) { return branch[v] != 0; })) {
      triangles_.push_back(t);
      mesh_.triangles.push_back(
          {places_[corners[0]].vertex, places_[corners[1]].vertex, places_[corners[2]].vertex});
    }
  }
}

void TrimmedOrgan::close(const TriangleMesh& mesh) {
  const SurfaceTopology whole(mesh);
  std::vector<std::uint8_t> kept(mesh.triangles.size(), 0);
  for (const Index t : triangles_) {
    kept[t] = 1;
  }
  std::map<Index, Index> rimFrom;  // half-edge of the whole by the vertex where it starts
  for (const Index t : triangles_) {
    for (Index half = 3 * t; half < 3 * t + 3; ++half) {
      if (kept[whole.opposite(half) / 3] == 0 && !rimFrom.emplace(whole.origin(half), half).second) {
        refuseBranch(Text::tr("the cut of the side branch is no simple loop"));
      }
    }
  }
  const Index start = rimFrom.begin()->first;
  Vec3 middle_m;
  std::size_t steps = 0;
  Index at = start;
  do {
    const Index half = rimFrom.at(at);
    middle_m += mesh.vertices_m[at] / static_cast<double>(rimFrom.size());
    rims_.push_back({half / 3, half % 3});
    at = whole.target(half);
    ++steps;
  } while (at != start && rimFrom.count(at) != 0 && steps < rimFrom.size());
  if (at != start || steps != rimFrom.size()) {
    refuseBranch(Text::tr("the cut of the side branch is no simple loop"));
  }
  const auto centre = static_cast<Index>(mesh_.vertices_m.size());
  mesh_.vertices_m.push_back(middle_m);
  for (const Rim& rim : rims_) {
    const TriangleMesh::Triangle& corners = mesh.triangles[rim.triangle];
    mesh_.triangles.push_back(
        {places_[corners[(rim.corner + 1) % 3]].vertex, places_[corners[rim.corner]].vertex, centre});
  }
}

void TrimmedOrgan::place(const TriangleMesh& mesh, const std::vector<std::uint8_t>& branch,
                         const Vec3& root_m, const Vec3& direction) {
  for (Index v = 0; v < branch.size(); ++v) {
    if (branch[v] == 0) {
      continue;
    }
    const Vec3& p = mesh.vertices_m[v];
    const Vec3 foot_m = p - dot(p - root_m, direction) * direction;
    NearestOnTriangle nearest;
    for (auto t = static_cast<Index>(triangles_.size()); t < mesh_.triangles.size(); ++t) {
      const TriangleMesh::Triangle& corners = mesh_.triangles[t];
      const NearestOnTriangle found = nearestOnTriangle(
          foot_m, {mesh_.vertices_m[corners[0]], mesh_.vertices_m[corners[1]], mesh_.vertices_m[corners[2]]});
      if (found.distance2 < nearest.distance2) {
        nearest = found;
        places_[v].lidTriangle = t;
        places_[v].weights = {found.u, found.v, found.w};
      }
    }
  }
}

std::vector<LatticeCoordinate> TrimmedOrgan::toWhole(std::span<const LatticeCoordinate> trimmed) const {
  std::vector<LatticeCoordinate> whole;
  whole.reserve(places_.size());
  for (const Place& place : places_) {
    if (!place.onLid) {
      whole.push_back(trimmed[place.vertex]);
      continue;
    }
    const TriangleMesh::Triangle& corners = mesh_.triangles[place.lidTriangle];
    const double first_rad = trimmed[corners[0]].angle_rad;
    LatticeCoordinate at{0.0, first_rad};
    for (std::size_t k = 0; k < 3; ++k) {
      const LatticeCoordinate& corner = trimmed[corners[k]];
      const double turns = (corner.angle_rad - first_rad) / (2.0 * kPi);
      at.arc_m += place.weights[k] * corner.arc_m;
      at.angle_rad += place.weights[k] * 2.0 * kPi * (turns - std::round(turns));
    }
    const double turns = at.angle_rad / (2.0 * kPi);
    at.angle_rad = std::min(2.0 * kPi * (turns - std::floor(turns)), std::nextafter(2.0 * kPi, 0.0));
    whole.push_back(at);
  }
  return whole;
}

std::vector<LatticePart> TrimmedOrgan::toWhole(std::span<const LatticePart> trimmed) const {
  std::vector<LatticePart> whole;
  whole.reserve(places_.size());
  for (const Place& place : places_) {
    whole.push_back(place.onLid ? LatticePart::kSide : trimmed[place.vertex]);
  }
  return whole;
}

LatticePoint TrimmedOrgan::toWhole(const LatticePoint& point) const {
  LatticePoint found = point;
  if (point.triangle < triangles_.size()) {
    found.triangle = triangles_[point.triangle];
    return found;
  }
  const Rim& rim = rims_[point.triangle - triangles_.size()];
  const TriangleMesh::Triangle& lid = mesh_.triangles[point.triangle];
  const Vec3& from = mesh_.vertices_m[lid[1]];
  const Vec3 edge = mesh_.vertices_m[lid[0]] - from;
  const double share = std::clamp(dot(point.position_m - from, edge) / dot(edge, edge), 0.0, 1.0);
  found.position_m = from + share * edge;
  found.triangle = rim.triangle;
  found.barycentric = {};
  found.barycentric[rim.corner] = 1.0 - share;
  found.barycentric[(rim.corner + 1) % 3] = share;
  return found;
}

}  // namespace torsio
