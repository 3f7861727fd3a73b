// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/section/quadratic_elements.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <Eigen/SparseCholesky>

#include "sim/core/contracts.h"
#include "sim/core/index.h"

namespace torsio {

namespace {

using Vector2 = Eigen::Vector2d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// The two corners that the middle node facing corner k lies between.
constexpr int next(int k) {
  return (k + 1) % 3;
}
constexpr int previous(int k) {
  return (k + 2) % 3;
}

/// Geometry of one straight-sided triangle.
struct Element {
  std::array<Vector2, 3> corner;
  std::array<Vector2, 3> gradient;  // of the barycentric coordinates
  double area = 0.0;
};

Element elementAt(const QuadraticFields& f, std::size_t t) {
  Element e;
  for (int k = 0; k < 3; ++k) {
    const Point2& p = f.nodes[at(f.elements[t][at(k)])];
    e.corner[at(k)] = {p[0], p[1]};
  }
  const Vector2 u = e.corner[1] - e.corner[0], v = e.corner[2] - e.corner[0];
  e.area = 0.5 * (u.x() * v.y() - u.y() * v.x());
  for (int k = 0; k < 3; ++k) {
    const Vector2 d = e.corner[at(previous(k))] - e.corner[at(next(k))];
    e.gradient[at(k)] = Vector2(-d.y(), d.x()) / (2.0 * e.area);
  }
  return e;
}

/// Integral of grad phi_i . grad phi_j, from the products s_ij of the linear gradients: exact.
Matrix6 stiffness(const Element& e) {
  std::array<std::array<double, 3>, 3> s{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      s[at(i)][at(j)] = e.area * e.gradient[at(i)].dot(e.gradient[at(j)]);
    }
  }
  const double trace = 0.5 * (s[0][0] + s[1][1] + s[2][2]);
  Matrix6 k = Matrix6::Zero();
  for (int i = 0; i < 3; ++i) {
    k(i, i) = s[at(i)][at(i)];
    // |g_j|^2 + |g_k|^2 + g_j.g_k = (|g_0|^2 + |g_1|^2 + |g_2|^2) / 2 because the gradients sum to zero.
    k(3 + i, 3 + i) = 8.0 / 3.0 * trace;
    for (int j = 0; j < 3; ++j) {
      if (i == j) {
        continue;
      }
      const double sij = s[at(i)][at(j)];
      k(i, j) = -sij / 3.0;
      k(3 + i, 3 + j) = 8.0 / 3.0 * sij;
      const int middle = 3 + (3 - i - j);  // between i and j
      k(i, middle) = k(middle, i) = 4.0 / 3.0 * sij;
    }
  }
  return k;
}

/// Displacement direction of a unit rotation at a corner.
Vector2 spin(const Vector2& p) {
  return {-p.y(), p.x()};
}

/// Integral of (-y, x) . grad phi_i: exact.
Vector6 warpingLoad(const Element& e) {
  Vector6 c;
  const Vector2 sum = spin(e.corner[0]) + spin(e.corner[1]) + spin(e.corner[2]);
  for (int k = 0; k < 3; ++k) {
    const int i = next(k), j = previous(k);
    c(k) = e.area / 3.0 * e.gradient[at(k)].dot(spin(e.corner[at(k)]));
    c(3 + k) = e.area / 3.0 *
               (e.gradient[at(j)].dot(sum + spin(e.corner[at(i)])) +
                e.gradient[at(i)].dot(sum + spin(e.corner[at(j)])));
  }
  return c;
}

Vector6 nodal(const QuadraticFields& f, std::size_t t, const std::vector<double>& values) {
  Vector6 v;
  for (int k = 0; k < 6; ++k) {
    v(k) = values[at(f.elements[t][at(k)])];
  }
  return v;
}

/// Gradient of a quadratic field at corner k.
Vector2 gradientAtCorner(const Element& e, const Vector6& v, int k) {
  Vector2 g = Vector2::Zero();
  for (int i = 0; i < 3; ++i) {
    g += v(i) * (i == k ? 3.0 : -1.0) * e.gradient[at(i)];
  }
  for (int j : {next(k), previous(k)}) {
    const int middle = 3 + (3 - k - j);  // between k and j
    g += 4.0 * v(middle) * e.gradient[at(j)];
  }
  return g;
}

/// Number of the unknown of each node; -1: held at zero.
using Unknowns = std::vector<int>;

/// One symmetric positive definite system whose pattern is kept.
class System {
 public:
  void prepare(const std::vector<std::array<int, 6>>& elements, Unknowns unknowns, int count) {
    unknowns_ = std::move(unknowns);
    std::vector<Eigen::Triplet<double>> triplets;
    triplets.reserve(21 * elements.size());
    forEachEntry(elements, [&](int row, int column) { triplets.emplace_back(row, column, 0.0); });
    matrix_.resize(count, count);
    matrix_.setFromTriplets(triplets.begin(), triplets.end());
    places_.clear();
    places_.reserve(triplets.size());
    forEachEntry(elements, [&](int row, int column) {
      const int* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
      const int* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
      places_.push_back(static_cast<int>(std::lower_bound(begin, end, row) - matrix_.innerIndexPtr()));
    });
    solver_.analyzePattern(matrix_);
  }

  void factorize(const std::vector<std::array<int, 6>>& elements, const std::vector<Matrix6>& stiffnesses) {
    std::fill(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros(), 0.0);
    std::size_t place = 0;
    for (std::size_t t = 0; t < elements.size(); ++t) {
      for (int i = 0; i < 6; ++i) {
        for (int j = 0; j <= i; ++j) {
          if (unknown(elements[t][at(i)]) < 0 || unknown(elements[t][at(j)]) < 0) {
            continue;
          }
          // Two nodes of one hole share an unknown: their coupling counts twice on its diagonal.
          const bool folded = i != j && unknown(elements[t][at(i)]) == unknown(elements[t][at(j)]);
          matrix_.valuePtr()[places_[place++]] += (folded ? 2.0 : 1.0) * stiffnesses[t](i, j);
        }
      }
    }
    solver_.factorize(matrix_);
    TORSIO_EXPECTS(solver_.info() == Eigen::Success);
  }

  /// `load` and the result: one a node.
  [[nodiscard]] std::vector<double> solve(const std::vector<double>& load) const {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(matrix_.rows());
    for (std::size_t i = 0; i < load.size(); ++i) {
      if (unknowns_[i] >= 0) {
        right(unknowns_[i]) += load[i];
      }
    }
    const Eigen::VectorXd solution = solver_.solve(right);
    std::vector<double> values(load.size(), 0.0);
    for (std::size_t i = 0; i < load.size(); ++i) {
      if (unknowns_[i] >= 0) {
        values[i] = solution(unknowns_[i]);
      }
    }
    return values;
  }

 private:
  [[nodiscard]] int unknown(int node) const { return unknowns_[at(node)]; }

  template <typename Visit>
  void forEachEntry(const std::vector<std::array<int, 6>>& elements, const Visit& visit) const {
    for (const auto& element : elements) {
      for (int i = 0; i < 6; ++i) {
        for (int j = 0; j <= i; ++j) {
          const int a = unknown(element[at(i)]), b = unknown(element[at(j)]);
          if (a >= 0 && b >= 0) {
            visit(std::max(a, b), std::min(a, b));
          }
        }
      }
    }
  }

  Unknowns unknowns_;
  Eigen::SparseMatrix<double> matrix_;  // lower triangle
  std::vector<int> places_;             // of each element entry among the values
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> solver_;
};

/// Numbers the edge middles after the corners and marks those on the boundary.
QuadraticFields withMiddles(const PlaneMesh& mesh) {
  QuadraticFields f;
  f.nodes = mesh.points;
  f.loop = mesh.loop;
  f.arc = mesh.arc;
  f.elements.resize(mesh.triangles.size());
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    auto& element = f.elements[at(t)];
    for (int k = 0; k < 3; ++k) {
      element[at(k)] = mesh.triangles[at(t)][at(k)];
      const int other = mesh.neighbours[at(t)][at(k)];
      if (other >= 0 && other < t) {
        int corner = 0;
        while (mesh.neighbours[at(other)][at(corner)] != t) {
          ++corner;
        }
        element[at(3 + k)] = f.elements[at(other)][at(3 + corner)];
        continue;
      }
      const int a = mesh.triangles[at(t)][at(next(k))], b = mesh.triangles[at(t)][at(previous(k))];
      element[at(3 + k)] = static_cast<int>(f.nodes.size());
      const Point2 p = mesh.points[at(a)], q = mesh.points[at(b)];
      f.nodes.push_back({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])});
      f.loop.push_back(other < 0 ? mesh.loop[at(a)] : -1);
      f.arc.push_back(other < 0 ? middleArc(mesh, a, b) : 0.0);
    }
  }
  return f;
}

}  // namespace

class QuadraticElements::Impl {
 public:
  QuadraticFields solve(const PlaneMesh& mesh, std::span<const double> holeAreas) {
    QuadraticFields f = withMiddles(mesh);
    if (f.elements != elements_ || f.loop != loop_) {
      prepare(f);
    }
    assemble(f, holeAreas);
    membrane_.factorize(f.elements, stiffness_);
    warping_.factorize(f.elements, stiffness_);
    f.membrane = membrane_.solve(membraneLoad_);
    f.warping = warping_.solve(warpingLoad_);
    evaluate(f, holeAreas);
    return f;
  }

 private:
  void prepare(const QuadraticFields& f) {
    elements_ = f.elements;
    loop_ = f.loop;
    // Membrane: zero on the outline, one unknown for each hole, after those inside.
    Unknowns unknowns(f.nodes.size(), -1);
    int count = 0;
    int holes = 0;
    for (std::size_t i = 0; i < f.nodes.size(); ++i) {
      if (f.loop[i] < 0) {
        unknowns[i] = count++;
      }
      holes = std::max(holes, f.loop[i]);
    }
    for (std::size_t i = 0; i < f.nodes.size(); ++i) {
      if (f.loop[i] > 0) {
        unknowns[i] = count + f.loop[i] - 1;
      }
    }
    membrane_.prepare(f.elements, std::move(unknowns), count + holes);
    // Warping: known up to a constant, so the last corner of the last element is held.
    Unknowns free(f.nodes.size(), 0);
    const std::size_t held = at(f.elements.back()[2]);
    for (std::size_t i = 0; i < free.size(); ++i) {
      free[i] = i == held ? -1 : static_cast<int>(i) - (i > held ? 1 : 0);
    }
    warping_.prepare(f.elements, std::move(free), static_cast<int>(f.nodes.size()) - 1);
  }

  void assemble(const QuadraticFields& f, std::span<const double> holeAreas) {
    stiffness_.resize(f.elements.size());
    membraneLoad_.assign(f.nodes.size(), 0.0);
    warpingLoad_.assign(f.nodes.size(), 0.0);
    for (std::size_t t = 0; t < f.elements.size(); ++t) {
      const Element e = elementAt(f, t);
      stiffness_[t] = stiffness(e);
      const Vector6 load = warpingLoad(e);
      for (int k = 0; k < 6; ++k) {
        const std::size_t node = at(f.elements[t][at(k)]);
        if (k >= 3) {
          membraneLoad_[node] += e.area / 3.0;
        }
        warpingLoad_[node] -= load(k);
      }
    }
    plateauLoad(f, holeAreas);
  }

  /// The pressure on the plate over a hole pushes on the hole's own unknown; any one node of it will do.
  void plateauLoad(const QuadraticFields& f, std::span<const double> holeAreas) {
    plateNode_.assign(holeAreas.size(), -1);
    for (std::size_t i = 0; i < f.nodes.size(); ++i) {
      if (f.loop[i] > 0 && plateNode_[at(f.loop[i] - 1)] < 0) {
        plateNode_[at(f.loop[i] - 1)] = static_cast<int>(i);
      }
    }
    for (std::size_t h = 0; h < holeAreas.size(); ++h) {
      membraneLoad_[at(plateNode_[h])] += holeAreas[h];
    }
  }

  /// Bounds from the two energies (they hold for any field of the space, so an error of the linear solver
  /// cannot break them), edge forces and the share of each element in the gap.
  void evaluate(QuadraticFields& f, std::span<const double> holeAreas) const {
    double membraneEnergy = 0.0, warpingEnergy = 0.0, polarMoment = 0.0, area = 0.0, warpingSum = 0.0;
    double load = 0.0, warpingWork = 0.0;
    f.edgeForce.assign(f.nodes.size(), 0.0);
    f.gap.resize(f.elements.size());
    for (std::size_t i = 0; i < f.nodes.size(); ++i) {
      load += membraneLoad_[i] * f.membrane[i];
      warpingWork += warpingLoad_[i] * f.warping[i];
      f.edgeForce[i] = membraneLoad_[i];
    }
    for (std::size_t h = 0; h < holeAreas.size(); ++h) {
      f.edgeForce[at(plateNode_[h])] -= holeAreas[h];
    }
    for (std::size_t t = 0; t < f.elements.size(); ++t) {
      const Element e = elementAt(f, t);
      const Vector6 z = nodal(f, t, f.membrane), psi = nodal(f, t, f.warping);
      const Vector6 force = stiffness_[t] * z;
      membraneEnergy += z.dot(force);
      warpingEnergy += psi.dot(stiffness_[t] * psi);
      for (int k = 0; k < 6; ++k) {
        f.edgeForce[at(f.elements[t][at(k)])] -= force(k);
      }
      const Vector2 sum = e.corner[0] + e.corner[1] + e.corner[2];
      polarMoment += e.area / 12.0 *
                     (sum.squaredNorm() + e.corner[0].squaredNorm() + e.corner[1].squaredNorm() +
                      e.corner[2].squaredNorm());
      area += e.area;
      warpingSum += e.area / 3.0 * (psi(3) + psi(4) + psi(5));
      f.gap[t] = gapOf(e, z, psi);
    }
    f.lower = 4.0 * (2.0 * load - membraneEnergy);
    f.upper = polarMoment - 2.0 * warpingWork + warpingEnergy;
    for (double& psi : f.warping) {
      psi -= warpingSum / area;
    }
  }

  /// Integral over the element of |tau from psi - tau from z|^2; the sum over all elements is upper - lower
  /// (Prager and Synge), so the elements with the largest shares are the ones to split.
  static double gapOf(const Element& e, const Vector6& z, const Vector6& psi) {
    Vector2 sum = Vector2::Zero();
    double squares = 0.0;
    for (int k = 0; k < 3; ++k) {
      const Vector2 slope = gradientAtCorner(e, z, k);
      const Vector2 d =
          gradientAtCorner(e, psi, k) + spin(e.corner[at(k)]) - 2.0 * Vector2(slope.y(), -slope.x());
      sum += d;
      squares += d.squaredNorm();
    }
    return e.area / 12.0 * (sum.squaredNorm() + squares);
  }

  std::vector<std::array<int, 6>> elements_;  // topology that the systems were prepared for
  std::vector<int> loop_;
  System membrane_;
  System warping_;
  std::vector<Matrix6> stiffness_;
  std::vector<double> membraneLoad_;
  std::vector<double> warpingLoad_;
  std::vector<int> plateNode_;
};

QuadraticElements::QuadraticElements() : impl_(std::make_unique<Impl>()) {}
QuadraticElements::~QuadraticElements() = default;
QuadraticElements::QuadraticElements(QuadraticElements&&) noexcept = default;
QuadraticElements& QuadraticElements::operator=(QuadraticElements&&) noexcept = default;

QuadraticFields QuadraticElements::solve(const PlaneMesh& mesh, std::span<const double> holeAreas) {
  return impl_->solve(mesh, holeAreas);
}

}  // namespace torsio
