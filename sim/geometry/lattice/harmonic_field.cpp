// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/harmonic_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/SparseCholesky>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/lattice/level_loops.h"

namespace torsio {

namespace {

using Index = std::uint32_t;
using Matrix = Eigen::SparseMatrix<double>;

constexpr Index kNone = std::numeric_limits<Index>::max();
/// Positive weights keep the maximum principle; small ones keep linear fields on flat sides exact to the same
/// order.
constexpr double kSmallestWeight = 1e-6;
constexpr double kLargestCotangent = 1e5;  // slivers must not spoil the conditioning

double cotangent(const Vec3& apex, const Vec3& a, const Vec3& b) {
  const Vec3 u = a - apex;
  const Vec3 v = b - apex;
  const double sine = norm(cross(u, v));
  const double cosine = dot(u, v);
  if (sine * kLargestCotangent <= std::abs(cosine)) {
    return std::copysign(kLargestCotangent, cosine);
  }
  return cosine / sine;
}

[[noreturn]] void refuseField() {
  throw Error(ErrorCode::kBadMesh, Text::tr("the harmonic field of the organ has no solution"), "",
              Text::tr("Check that the mesh is one closed surface without handles."));
}

/// The Laplacian between the caps, factorised once: the level and the angle differ in their right sides only.
class SideLaplacian {
 public:
  SideLaplacian(const TriangleMesh& mesh, const SurfaceTopology& topology, std::span<const LatticePart> parts)
      : mesh_(mesh), topology_(topology), parts_(parts), unknown_(mesh.vertices_m.size(), kNone) {
    numberUnknowns();
    computeWeights();
    factorise();
  }

  /// The function that is harmonic between the caps, has `values` on them and rises by a further
  /// 2 pi turns[half] along each half-edge. Replaces the values between the caps.
  void extend(std::vector<double>& values, const std::vector<std::int8_t>& turns) const {
    if (vertexOf_.empty()) {
      return;
    }
    Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(vertexOf_.size()));
    for (std::size_t i = 0; i < vertexOf_.size(); ++i) {
      double& sum = right[static_cast<Eigen::Index>(i)];
      for (const Index half : topology_.outgoing(vertexOf_[i])) {
        const Index other = topology_.target(half);
        if (!turns.empty()) {
          sum += weights_[half] * kTurn * turns[half];
        }
        if (unknown_[other] == kNone) {
          sum += weights_[half] * values[other];
        }
      }
    }
    const Eigen::VectorXd solution = solver_.solve(right);
    if (!solution.allFinite()) {
      refuseField();
    }
    for (std::size_t i = 0; i < vertexOf_.size(); ++i) {
      values[vertexOf_[i]] = solution[static_cast<Eigen::Index>(i)];
    }
  }

  /// What flows out of the free cap.
  [[nodiscard]] double freeFlux(const std::vector<double>& values,
                                const std::vector<std::int8_t>& turns) const {
    double flux = 0.0;
    for (Index half = 0; half < topology_.halfEdges(); ++half) {
      const Index from = topology_.origin(half);
      const Index to = topology_.target(half);
      if (parts_[from] != LatticePart::kFreeCap || parts_[to] == LatticePart::kFreeCap) {
        continue;
      }
      const double jump = turns.empty() ? 0.0 : kTurn * turns[half];
      flux += weights_[half] * (values[to] - values[from] + jump);
    }
    return flux;
  }

 private:
  /// In the order of the vertices; those of a fine surface by their way from one of them, because an order
  /// without neighbourhood, as files have it, makes the factors half as large again and takes twice as long.
  void numberUnknowns() {
    constexpr std::size_t kFineVertices = 50'000;
    const auto take = [this](Index v) {
      if (parts_[v] == LatticePart::kSide && unknown_[v] == kNone) {
        unknown_[v] = static_cast<Index>(vertexOf_.size());
        vertexOf_.push_back(v);
      }
    };
    const bool fine = parts_.size() > kFineVertices;
    for (Index v = 0; v < parts_.size(); ++v) {
      take(v);
      for (std::size_t i = vertexOf_.size() - 1; fine && i < vertexOf_.size(); ++i) {
        for (const Index half : topology_.outgoing(vertexOf_[i])) {
          take(topology_.target(half));
        }
      }
    }
  }

  void computeWeights() {
    weights_.assign(topology_.halfEdges(), 0.0);
    for (Index half = 0; half < topology_.halfEdges(); ++half) {
      const Index other = topology_.opposite(half);
      if (other < half) {
        continue;
      }
      double weight = 0.0;
      for (const Index h : {half, other}) {
        const Vec3& apex = mesh_.vertices_m[topology_.origin(SurfaceTopology::previous(h))];
        weight += 0.5 * cotangent(apex, mesh_.vertices_m[topology_.origin(h)],
                                  mesh_.vertices_m[topology_.target(h)]);
      }
      weights_[half] = weights_[other] = std::max(weight, kSmallestWeight);
    }
  }

  void factorise() {
    if (vertexOf_.empty()) {
      return;
    }
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(topology_.halfEdges() / 2 + vertexOf_.size());
    for (std::size_t i = 0; i < vertexOf_.size(); ++i) {
      double diagonal = 0.0;
      for (const Index half : topology_.outgoing(vertexOf_[i])) {
        diagonal += weights_[half];
        const Index j = unknown_[topology_.target(half)];
        if (j < i) {
          entries.emplace_back(static_cast<int>(i), static_cast<int>(j), -weights_[half]);
        }
      }
      entries.emplace_back(static_cast<int>(i), static_cast<int>(i), diagonal);
    }
    const auto size = static_cast<Eigen::Index>(vertexOf_.size());
    Matrix matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver_.compute(matrix);
    if (solver_.info() != Eigen::Success) {
      refuseField();
    }
  }

  const TriangleMesh& mesh_;
  const SurfaceTopology& topology_;
  std::span<const LatticePart> parts_;
  std::vector<Index> unknown_;   // of a vertex, kNone on the caps
  std::vector<Index> vertexOf_;  // of an unknown
  std::vector<double> weights_;  // one a half-edge
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower> solver_;
};

/// A chain of triangles from the fixed to the free cap. The edges that it crosses carry one turn of the
/// angle.
class Seam {
 public:
  Seam(const TriangleMesh& mesh, const SurfaceTopology& topology, std::span<const LatticePart> parts)
      : topology_(topology), parts_(parts), entered_(mesh.triangles.size(), kNone) {
    side_.reserve(mesh.triangles.size());
    for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
      side_.push_back(isSideTriangle(triangle, parts) ? 1 : 0);
    }
    std::vector<Index> queue;
    for (Index half = 0; half < topology.halfEdges(); ++half) {
      if (side_[half / 3] == 0 || entered_[half / 3] != kNone || !onRim(half, LatticePart::kFixedCap)) {
        continue;
      }
      entered_[half / 3] = half;
      queue.push_back(half / 3);
    }
    for (std::size_t i = 0; i < queue.size() && last_ == kNone; ++i) {
      for (Index half = 3 * queue[i]; half < 3 * queue[i] + 3; ++half) {
        if (onRim(half, LatticePart::kFreeCap)) {
          last_ = half;
        }
        const Index other = topology.opposite(half);
        if (side_[other / 3] == 0 || entered_[other / 3] != kNone) {
          continue;
        }
        entered_[other / 3] = other;
        queue.push_back(other / 3);
      }
    }
    if (last_ == kNone) {
      throw Error(ErrorCode::kBadMesh,
                  Text::tr("no way leads over the surface from the fixed to the free end"), "",
                  Text::tr("Check that the mesh is one connected surface and that its ends do not touch."));
    }
  }

  /// The triangles with which the chain begins and ends.
  [[nodiscard]] Index firstTriangle() const {
    Index t = last_ / 3;
    while (!onRim(entered_[t], LatticePart::kFixedCap)) {
      t = topology_.opposite(entered_[t]) / 3;
    }
    return t;
  }
  [[nodiscard]] Index lastTriangle() const { return last_ / 3; }

  [[nodiscard]] std::vector<std::int8_t> turns() const {
    std::vector<std::int8_t> turns(topology_.halfEdges(), 0);
    // Leaving a triangle across a half-edge, its target lies on the left and its origin on the right; the
    // angle rises from left to right, seen from outside with the free end up.
    const auto leave = [&](Index half) {
      turns[half] = -1;
      turns[topology_.opposite(half)] = 1;
    };
    leave(last_);
    for (Index t = last_ / 3;; t = topology_.opposite(entered_[t]) / 3) {
      leave(topology_.opposite(entered_[t]));
      if (onRim(entered_[t], LatticePart::kFixedCap)) {
        break;
      }
    }
    return turns;
  }

 private:
  /// The half-edge of a side triangle beyond which the cap begins.
  [[nodiscard]] bool onRim(Index half, LatticePart cap) const {
    return parts_[topology_.origin(half)] == cap && parts_[topology_.target(half)] == cap &&
           side_[topology_.opposite(half) / 3] == 0;
  }

  const SurfaceTopology& topology_;
  std::span<const LatticePart> parts_;
  std::vector<std::uint8_t> side_;  // one a triangle
  std::vector<Index> entered_;      // by which half-edge of a triangle the chain could enter it
  Index last_ = kNone;              // half-edge by which it enters the free cap
};

/// Angles of the vertices on the rim of a cap: in proportion to what flows across the rim, counted from the
/// seam, because the angle is conjugate to the level.
class Rim {
 public:
  /// `start`: the triangle of the seam at this rim.
  Rim(const TriangleMesh& mesh, const SurfaceTopology& topology, std::span<const LatticePart> parts,
      LatticePart cap, Index start)
      : mesh_(mesh), topology_(topology), fixed_(cap == LatticePart::kFixedCap) {
    HarmonicField beyond;  // 0 on one side of the rim, 1 on the other: its level line runs round the cap
    for (const LatticePart part : parts) {
      beyond.level.push_back((part == cap) != fixed_ ? 1.0 : 0.0);
    }
    beyond.angle_rad.assign(parts.size(), 0.0);
    beyond.turns.assign(topology.halfEdges(), 0);
    std::vector<LevelLoop> loops = LevelTracer(mesh, topology, beyond).trace(0.5);
    const auto atSeam = [start](const LoopPoint& point) { return point.half / 3 == start; };
    const auto first = std::find_if(loops.front().points.begin(), loops.front().points.end(), atSeam);
    if (loops.size() != 1 || first == loops.front().points.end()) {
      throw Error(ErrorCode::kBadMesh, Text::tr("a cap of the organ is not a disc"), "",
                  Text::tr("Give other end points, or check the mesh for handles."));
    }
    for (const LoopPoint& point : loops.front().points) {
      crossings_.push_back(point.half);
    }
    std::rotate(crossings_.begin(), crossings_.begin() + (first - loops.front().points.begin()),
                crossings_.end());
  }

  void setAngles(HarmonicField& field) const {
    const std::size_t n = crossings_.size();
    const double atSeam = flow(0, field.level);  // the seam halves the edge of its triangle
    double total = 0.5 * atSeam;
    std::vector<std::pair<double, double>> visits(field.angle_rad.size());  // sum of flows, how often
    for (std::size_t i = 1; i <= n; ++i) {
      auto& [sum, count] = visits[capVertex(i)];
      sum += total;
      count += 1.0;
      if (i < n) {
        total += flow(i, field.level);
      }
    }
    total += 0.5 * atSeam;
    if (!(total > 0.0)) {
      refuseField();
    }
    for (std::size_t i = 0; i < n; ++i) {
      const auto& [sum, count] = visits[capVertex(i)];
      field.angle_rad[capVertex(i)] = kTurn * sum / (count * total);
    }
  }

 private:
  [[nodiscard]] Index capVertex(std::size_t i) const {
    const Index half = crossings_[i % crossings_.size()];  // from the upper to the lower side of the rim
    return fixed_ ? topology_.target(half) : topology_.origin(half);
  }
  [[nodiscard]] Index farVertex(std::size_t i) const {
    const Index half = crossings_[i % crossings_.size()];
    return fixed_ ? topology_.origin(half) : topology_.target(half);
  }

  /// Across the rim edge between crossing i and the next: gradient in their triangle times the edge's length.
  [[nodiscard]] double flow(std::size_t i, const std::vector<double>& level) const {
    const Index a = capVertex(i);
    const Index b = capVertex(i + 1);
    if (a == b) {
      return 0.0;
    }
    const Vec3& far = mesh_.vertices_m[farVertex(i)];
    const Vec3 edge = mesh_.vertices_m[b] - mesh_.vertices_m[a];
    const double area = norm(cross(edge, far - mesh_.vertices_m[a]));
    const double rise = std::abs(level[farVertex(i)] - 0.5 * (level[a] + level[b]));
    const double smallest = dot(edge, edge) / kLargestCotangent;
    const double height = std::max(area, smallest);
    return height > 0.0 ? rise * dot(edge, edge) / height : 0.0;
  }

  const TriangleMesh& mesh_;
  const SurfaceTopology& topology_;
  bool fixed_;
  std::vector<Index> crossings_;  // half-edges from the upper to the lower side, in order, from the seam
};

}  // namespace

double HarmonicField::rise_rad(const SurfaceTopology& topology, std::uint32_t half) const noexcept {
  return angle_rad[topology.target(half)] - angle_rad[topology.origin(half)] + 2.0 * kPi * turns[half];
}

bool isSideTriangle(const TriangleMesh::Triangle& triangle, std::span<const LatticePart> parts) {
  const LatticePart first = parts[triangle[0]];
  return first == LatticePart::kSide || parts[triangle[1]] != first || parts[triangle[2]] != first;
}

HarmonicField solveHarmonicField(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                 std::span<const LatticePart> parts, std::vector<double> level) {
  const SideLaplacian laplacian(mesh, topology, parts);
  const Seam seam(mesh, topology, parts);
  std::vector<double> rise;  // harmonic, 0 and 1 on the caps
  for (const LatticePart part : parts) {
    rise.push_back(part == LatticePart::kFreeCap ? 1.0 : 0.0);
  }
  laplacian.extend(rise, {});
  for (double& value : rise) {
    value = std::clamp(value, 0.0, 1.0);
  }

  HarmonicField field;
  field.level = level.empty() ? rise : std::move(level);
  field.angle_rad.assign(parts.size(), 0.0);
  field.turns = seam.turns();
  Rim(mesh, topology, parts, LatticePart::kFixedCap, seam.firstTriangle()).setAngles(field);
  Rim(mesh, topology, parts, LatticePart::kFreeCap, seam.lastTriangle()).setAngles(field);
  laplacian.extend(field.angle_rad, field.turns);
  // Both rims count from the seam, which winds about the organ: turn one against the other until no twist is
  // left between them.
  const double shift = -laplacian.freeFlux(field.angle_rad, field.turns) / laplacian.freeFlux(rise, {});
  for (std::size_t v = 0; v < parts.size(); ++v) {
    field.angle_rad[v] += shift * rise[v];
  }
  return field;
}

}  // namespace torsio
