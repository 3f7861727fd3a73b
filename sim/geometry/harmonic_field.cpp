// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/harmonic_field.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <utility>

#include <Eigen/SparseCholesky>

#include "sim/base/error.h"
#include "sim/base/portable_math.h"

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
  if (sine * kLargestCotangent <= std::abs(cosine)) return std::copysign(kLargestCotangent, cosine);
  return cosine / sine;
}

/// The Laplacian of the side, its unknowns and the seam across which the angle jumps by a turn.
class SideLaplacian {
 public:
  SideLaplacian(const TriangleMesh& mesh, const SurfaceTopology& topology, std::span<const LatticePart> parts)
      : mesh_(mesh), topology_(topology), parts_(parts), unknown_(mesh.vertices_m.size(), kNone) {
    side_.reserve(mesh.triangles.size());
    for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
      side_.push_back(isSideTriangle(triangle, parts) ? 1 : 0);
    }
    for (std::size_t t = 0; t < side_.size(); ++t) {
      if (side_[t] == 0) continue;
      for (const Index v : mesh.triangles[t]) {
        if (unknown_[v] != kNone) continue;
        unknown_[v] = static_cast<Index>(vertexOf_.size());
        vertexOf_.push_back(v);
      }
    }
    computeWeights();
    assemble();
  }

  /// u: 0 and 1 on the caps.
  std::vector<double> solveLevel() const {
    Matrix matrix = laplacian_;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(matrix.rows());
    for (Eigen::Index column = 0; column < matrix.outerSize(); ++column) {
      for (Matrix::InnerIterator entry(matrix, column); entry; ++entry) {
        const bool rowHeld = held(entry.row());
        const bool columnHeld = held(entry.col());
        if (entry.row() == entry.col()) {
          if (rowHeld) entry.valueRef() = 1.0;
          continue;
        }
        if (columnHeld && !rowHeld) right[entry.row()] -= entry.value() * capLevel(entry.col());
        if (rowHeld && !columnHeld) right[entry.col()] -= entry.value() * capLevel(entry.row());
        if (rowHeld || columnHeld) entry.valueRef() = 0.0;
      }
    }
    for (Eigen::Index i = 0; i < right.size(); ++i) {
      if (held(i)) right[i] = capLevel(i);
    }
    const Eigen::VectorXd solution = solve(matrix, right);
    std::vector<double> level(parts_.size());
    for (Index v = 0; v < level.size(); ++v) {
      if (parts_[v] != LatticePart::kSide) {
        level[v] = parts_[v] == LatticePart::kFreeCap ? 1.0 : 0.0;
      } else {
        level[v] = std::clamp(solution[unknown_[v]], 0.0, 1.0);
      }
    }
    return level;
  }

  /// The angle and its whole turns along the half-edges; the caps are free edges.
  void solveAngle(HarmonicField& field) const {
    field.turns = seam();
    Eigen::VectorXd right = Eigen::VectorXd::Zero(laplacian_.rows());
    for (Index half = 0; half < topology_.halfEdges(); ++half) {
      if (field.turns[half] == 0 || weights_[half] == 0.0) continue;
      right[unknown_[topology_.origin(half)]] += weights_[half] * 2.0 * kPi * field.turns[half];
    }
    Matrix matrix = laplacian_;
    matrix.coeffRef(0, 0) += matrix.coeff(0, 0);  // fixes the free constant
    const Eigen::VectorXd solution = solve(matrix, right);
    field.angle_rad.assign(parts_.size(), 0.0);
    for (std::size_t i = 0; i < vertexOf_.size(); ++i) {
      field.angle_rad[vertexOf_[i]] = solution[static_cast<Eigen::Index>(i)];
    }
  }

 private:
  bool held(Eigen::Index i) const {
    return parts_[vertexOf_[static_cast<std::size_t>(i)]] != LatticePart::kSide;
  }
  double capLevel(Eigen::Index i) const {
    return parts_[vertexOf_[static_cast<std::size_t>(i)]] == LatticePart::kFreeCap ? 1.0 : 0.0;
  }

  void computeWeights() {
    weights_.assign(topology_.halfEdges(), 0.0);
    for (Index half = 0; half < topology_.halfEdges(); ++half) {
      const Index other = topology_.opposite(half);
      if (other < half) continue;
      double weight = 0.0;
      bool used = false;
      for (const Index h : {half, other}) {
        if (side_[h / 3] == 0) continue;
        used = true;
        const Vec3& apex = mesh_.vertices_m[topology_.origin(SurfaceTopology::previous(h))];
        weight += 0.5 * cotangent(apex, mesh_.vertices_m[topology_.origin(h)],
                                  mesh_.vertices_m[topology_.target(h)]);
      }
      if (used) weights_[half] = weights_[other] = std::max(weight, kSmallestWeight);
    }
  }

  void assemble() {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(topology_.halfEdges() + vertexOf_.size());
    for (std::size_t i = 0; i < vertexOf_.size(); ++i) {
      double diagonal = 0.0;
      for (const Index half : topology_.outgoing(vertexOf_[i])) {
        if (weights_[half] == 0.0) continue;
        diagonal += weights_[half];
        const Index j = unknown_[topology_.target(half)];
        if (j < i) entries.emplace_back(static_cast<int>(i), static_cast<int>(j), -weights_[half]);
      }
      entries.emplace_back(static_cast<int>(i), static_cast<int>(i), diagonal);
    }
    const auto size = static_cast<Eigen::Index>(vertexOf_.size());
    laplacian_.resize(size, size);
    laplacian_.setFromTriplets(entries.begin(), entries.end());
  }

  static Eigen::VectorXd solve(const Matrix& matrix, const Eigen::VectorXd& right) {
    const Eigen::SimplicialLDLT<Matrix, Eigen::Lower> solver(matrix);
    Eigen::VectorXd solution;
    if (solver.info() == Eigen::Success) solution = solver.solve(right);
    if (solver.info() != Eigen::Success || !solution.allFinite()) {
      throw Error(ErrorCode::kBadMesh, "the harmonic field of the organ has no solution", "",
                  "Check that the mesh is one closed surface without handles.");
    }
    return solution;
  }

  /// A chain of side triangles from the fixed to the free cap. The edges that it crosses carry one turn.
  std::vector<std::int8_t> seam() const {
    std::vector<Index> entered(mesh_.triangles.size(), kNone);  // by which half-edge of the triangle
    std::vector<Index> queue;
    for (Index half = 0; half < topology_.halfEdges(); ++half) {
      if (side_[half / 3] == 0 || entered[half / 3] != kNone || !onRim(half, LatticePart::kFixedCap))
        continue;
      entered[half / 3] = half;
      queue.push_back(half / 3);
    }
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (Index half = 3 * queue[i]; half < 3 * queue[i] + 3; ++half) {
        if (onRim(half, LatticePart::kFreeCap)) return turnsAlong(entered, half);
        const Index other = topology_.opposite(half);
        if (side_[other / 3] == 0 || entered[other / 3] != kNone) continue;
        entered[other / 3] = other;
        queue.push_back(other / 3);
      }
    }
    throw Error(ErrorCode::kBadMesh, "no way leads over the surface from the fixed to the free end", "",
                "Check that the mesh is one connected surface and that its ends do not touch.");
  }

  /// The half-edge of a side triangle beyond which the cap begins.
  bool onRim(Index half, LatticePart cap) const {
    return parts_[topology_.origin(half)] == cap && parts_[topology_.target(half)] == cap &&
           side_[topology_.opposite(half) / 3] == 0;
  }

  std::vector<std::int8_t> turnsAlong(const std::vector<Index>& entered, Index last) const {
    std::vector<std::int8_t> turns(topology_.halfEdges(), 0);
    // Leaving a triangle across a half-edge, its target lies on the left and its origin on the right; the
    // angle rises from left to right, seen from outside with the free end up.
    const auto leave = [&](Index half) {
      turns[half] = -1;
      turns[topology_.opposite(half)] = 1;
    };
    leave(last);
    for (Index t = last / 3;; t = topology_.opposite(entered[t]) / 3) {
      leave(topology_.opposite(entered[t]));
      if (onRim(entered[t], LatticePart::kFixedCap)) break;
    }
    return turns;
  }

  const TriangleMesh& mesh_;
  const SurfaceTopology& topology_;
  std::span<const LatticePart> parts_;
  std::vector<std::uint8_t> side_;  // one a triangle
  std::vector<Index> unknown_;      // of a vertex
  std::vector<Index> vertexOf_;     // of an unknown
  std::vector<double> weights_;     // one a half-edge, 0 outside the side
  Matrix laplacian_;                // lower half
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
  HarmonicField field;
  if (!level.empty()) {
    field.level = std::move(level);
    laplacian.solveAngle(field);
    return field;
  }
  // The two factorisations do not know of each other: half the waiting on two cores.
  std::future<std::vector<double>> solvingLevel =
      std::async(std::launch::async, [&laplacian] { return laplacian.solveLevel(); });
  laplacian.solveAngle(field);
  field.level = solvingLevel.get();
  return field;
}

}  // namespace torsio
