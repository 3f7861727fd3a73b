// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/finite_element_bar.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include "sim/base/error.h"
#include "sim/base/portable_math.h"

namespace torsio {
namespace {

constexpr int kMostCorners = 6;

using Vector = Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;
using Gradients = Eigen::Matrix<double, 3, kMostCorners>;
using CellMatrix = Eigen::Matrix<double, 3 * kMostCorners, 3 * kMostCorners>;

/// Derivatives of the shape functions by the place at rest, one column a corner, and the volume it stands
/// for.
struct GaussPoint {
  Gradients gradients = Gradients::Zero();
  double volume = 0.0;
};

/// Wedge shape functions L_k (1 -+ t) / 2 by (xi, eta, t), L = (1 - xi - eta, xi, eta).
Gradients wedgeDerivatives(double xi, double eta, double t) {
  const std::array<double, 3> l{1.0 - xi - eta, xi, eta};
  constexpr std::array<double, 3> kByXi{-1.0, 1.0, 0.0};
  constexpr std::array<double, 3> kByEta{-1.0, 0.0, 1.0};
  Gradients d = Gradients::Zero();
  for (int k = 0; k < kMostCorners; ++k) {
    const auto corner = static_cast<std::size_t>(k % 3);
    const double side = k < 3 ? -1.0 : 1.0;
    const double along = 0.5 * (1.0 + side * t);
    d.col(k) << kByXi[corner] * along, kByEta[corner] * along, 0.5 * side * l[corner];
  }
  return d;
}

/// Derivatives of the tetrahedron's shape functions by (xi, eta, zeta).
Gradients tetrahedronDerivatives() {
  Gradients d = Gradients::Zero();
  d.col(0).setConstant(-1.0);
  d.block<3, 3>(0, 1).setIdentity();
  return d;
}

/// Derivatives by local coordinates and weights. Wedge: 3 points across (exact to degree 2) by 2 Gauss points
/// along, which integrates the stiffness of a straight wedge exactly. Tetrahedron: 1 point, exact.
std::vector<GaussPoint> referencePoints(int corners) {
  if (corners == 4) return {{tetrahedronDerivatives(), 1.0 / 6.0}};
  constexpr double kThird = 1.0 / 6.0;
  constexpr std::array<Point2, 3> kAcross{{{kThird, kThird}, {4.0 * kThird, kThird}, {kThird, 4.0 * kThird}}};
  const double along = std::sqrt(1.0 / 3.0);
  std::vector<GaussPoint> points;
  for (const Point2& p : kAcross) {
    for (const double t : {-along, along}) points.push_back({wedgeDerivatives(p[0], p[1], t), 1.0 / 6.0});
  }
  return points;
}

/// The discrete bar: integration points at rest, and forces and stiffness of a given configuration. Both
/// end layers are held; the free numbers are those of the layers between.
class BarSystem {
 public:
  BarSystem(const BarMesh& mesh, const BarMaterial& material)
      : mesh_(mesh),
        mu_(material.shearModulus_Pa),
        lambda_(2.0 * mu_ * material.poissonRatio / (1.0 - 2.0 * material.poissonRatio)),
        rest_(3 * static_cast<Eigen::Index>(mesh.points.size())),
        firstFree_(3 * mesh.pointsPerLayer),
        freeCount_(static_cast<int>(rest_.size()) - 2 * firstFree_) {
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      const Vec3& p = mesh.points[i];
      rest_.segment<3>(3 * static_cast<Eigen::Index>(i)) = Eigen::Vector3d(p.x, p.y, p.z);
    }
    const std::vector<GaussPoint> reference = referencePoints(mesh.cornersPerCell);
    pointsPerCell_ = reference.size();
    points_.reserve(mesh.cells.size() * pointsPerCell_);
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
      const Gradients x = corners(cell, rest_);
      for (const GaussPoint& p : reference) {
        const Eigen::Matrix3d jacobian = x * p.gradients.transpose();
        const double volume = p.volume * std::abs(jacobian.determinant());
        points_.push_back({jacobian.inverse().transpose() * p.gradients, volume});
      }
    }
  }

  [[nodiscard]] const Vector& rest() const noexcept { return rest_; }

  [[nodiscard]] Vector::ConstSegmentReturnType freePart(const Vector& v) const {
    return v.segment(firstFree_, freeCount_);
  }
  [[nodiscard]] Vector::SegmentReturnType freePart(Vector& v) const {
    return v.segment(firstFree_, freeCount_);
  }

  /// Internal nodal forces of the neo-Hookean material; false when a cell is turned inside out.
  /// P = G (F - F^-T) + lambda ln J F^-T, f_a = sum V P grad N_a.
  [[nodiscard]] bool forces(const Vector& place, Vector& force) const {
    force.setZero(place.size());
    for (std::size_t cell = 0; cell < mesh_.cells.size(); ++cell) {
      const Gradients x = corners(cell, place);
      Gradients f = Gradients::Zero();
      for (std::size_t q = 0; q < pointsPerCell_; ++q) {
        const GaussPoint& p = points_[cell * pointsPerCell_ + q];
        const Eigen::Matrix3d strain = x * p.gradients.transpose();
        const double j = strain.determinant();
        if (!(j > 0.0)) return false;
        const Eigen::Matrix3d inverse = strain.inverse();
        const double pressure = lambda_ * portableLog(j) - mu_;
        f += p.volume * (mu_ * strain + pressure * inverse.transpose()) * p.gradients;
      }
      scatter(cell, f, force);
    }
    return true;
  }

  /// Forces K u of linear elasticity.
  [[nodiscard]] Vector linearForces(const Vector& u) const {
    Vector force = Vector::Zero(u.size());
    const int corners3 = 3 * mesh_.cornersPerCell;
    for (std::size_t cell = 0; cell < mesh_.cells.size(); ++cell) {
      const Gradients v = corners(cell, u);
      const CellMatrix k = cellStiffness(cell, rest_);
      Gradients f = Gradients::Zero();
      f.reshaped().head(corners3) = k.topLeftCorner(corners3, corners3) * v.reshaped().head(corners3);
      scatter(cell, f, force);
    }
    return force;
  }

  /// Lower triangle of the tangent stiffness of the free numbers; at rest it is that of linear elasticity.
  [[nodiscard]] Sparse stiffness(const Vector& place) const {
    std::vector<Eigen::Triplet<double>> entries;
    const int corners = mesh_.cornersPerCell;
    entries.reserve(mesh_.cells.size() * static_cast<std::size_t>(5 * corners * corners));
    for (std::size_t cell = 0; cell < mesh_.cells.size(); ++cell) {
      const CellMatrix k = cellStiffness(cell, place);
      for (int column = 0; column < 3 * corners; ++column) {
        const int freeColumn = freeNumber(cell, column);
        if (freeColumn < 0) continue;
        for (int row = 0; row < 3 * corners; ++row) {
          const int freeRow = freeNumber(cell, row);
          if (freeRow >= freeColumn) entries.emplace_back(freeRow, freeColumn, k(row, column));
        }
      }
    }
    Sparse matrix(freeCount_, freeCount_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

 private:
  [[nodiscard]] Gradients corners(std::size_t cell, const Vector& field) const {
    Gradients x = Gradients::Zero();
    for (int k = 0; k < mesh_.cornersPerCell; ++k) x.col(k) = field.segment<3>(3 * corner(cell, k));
    return x;
  }

  void scatter(std::size_t cell, const Gradients& part, Vector& field) const {
    for (int k = 0; k < mesh_.cornersPerCell; ++k) field.segment<3>(3 * corner(cell, k)) += part.col(k);
  }

  [[nodiscard]] int corner(std::size_t cell, int k) const {
    return mesh_.cells[cell][static_cast<std::size_t>(k)];
  }

  [[nodiscard]] int freeNumber(std::size_t cell, int local) const {
    const int number = 3 * corner(cell, local / 3) + local % 3 - firstFree_;
    return number < freeCount_ ? number : -1;
  }

  /// With h_a = F^-T grad N_a:
  /// K_ab = sum V [G (grad N_a . grad N_b) I + (G - lambda ln J) h_b h_a^T + lambda h_a h_b^T].
  [[nodiscard]] CellMatrix cellStiffness(std::size_t cell, const Vector& place) const {
    const Gradients x = corners(cell, place);
    CellMatrix k = CellMatrix::Zero();
    for (std::size_t q = 0; q < pointsPerCell_; ++q) {
      const GaussPoint& p = points_[cell * pointsPerCell_ + q];
      const Eigen::Matrix3d strain = x * p.gradients.transpose();
      const Gradients h = strain.inverse().transpose() * p.gradients;
      const double turned = p.volume * (mu_ - lambda_ * portableLog(strain.determinant()));
      for (int a = 0; a < mesh_.cornersPerCell; ++a) {
        for (int b = 0; b < mesh_.cornersPerCell; ++b) {
          auto block = k.block<3, 3>(3 * a, 3 * b);
          block.diagonal().array() += p.volume * mu_ * p.gradients.col(a).dot(p.gradients.col(b));
          block += turned * h.col(b) * h.col(a).transpose();
          block += p.volume * lambda_ * h.col(a) * h.col(b).transpose();
        }
      }
    }
    return k;
  }

  const BarMesh& mesh_;
  double mu_;
  double lambda_;
  Vector rest_;
  int firstFree_;
  int freeCount_;
  std::size_t pointsPerCell_ = 0;
  std::vector<GaussPoint> points_;
};

[[noreturn]] void refuse(const std::string& what, const std::string& where, const std::string& remedy) {
  throw Error(ErrorCode::kBadParameter, what, where, remedy);
}

void checkMaterial(const BarMaterial& material) {
  if (!std::isfinite(material.shearModulus_Pa) || material.shearModulus_Pa <= 0.0) {
    refuse("The shear modulus must be positive and finite", "shear modulus", "Give it in pascal");
  }
  if (!(material.poissonRatio >= 0.0 && material.poissonRatio < 0.5)) {
    refuse("Poisson's ratio must be at least 0 and below 0.5", "Poisson's ratio",
           "Give 0.45 to 0.49 for soft tissue");
  }
}

void checkAngle(double angle_rad) {
  if (!std::isfinite(angle_rad)) refuse("The angle must be finite", "angle", "Give the angle in radians");
}

}  // namespace

FiniteElementBar::FiniteElementBar(std::span<const Point2> outline, double length_m, BarElement element,
                                   const BarDivision& division, const BarMaterial& material)
    : mesh_(makeBarMesh(outline, length_m, element, division)), material_(material) {
  checkMaterial(material);
}

double FiniteElementBar::linearTorque_Nm(double angle_rad) const {
  checkAngle(angle_rad);
  const BarSystem system(mesh_, material_);
  Vector u = Vector::Zero(system.rest().size());  // for an angle of 1
  const Eigen::Index last = u.size() / 3;
  for (Eigen::Index i = last - mesh_.pointsPerLayer; i < last; ++i) {
    u.segment<2>(3 * i) << -system.rest()[3 * i + 1], system.rest()[3 * i];
  }
  const Vector load = system.linearForces(u);
  const Eigen::SimplicialLDLT<Sparse, Eigen::Lower> solver(system.stiffness(system.rest()));
  if (solver.info() != Eigen::Success) {
    refuse("The stiffness of the bar cannot be factorised", "division", "Check for slivers in the outline");
  }
  system.freePart(u) = solver.solve(-system.freePart(load));
  return angle_rad * u.dot(system.linearForces(u));  // 2 E / angle
}

std::vector<Point2> regularOutline(int points, double radius_m) {
  if (points < 3) refuse("A polygon needs at least 3 points", "points", "Give 3 or more");
  if (!std::isfinite(radius_m) || radius_m <= 0.0) {
    refuse("The radius must be positive and finite", "radius", "Give the radius in metres");
  }
  std::vector<Point2> outline;
  for (int i = 0; i < points; ++i) {
    const SinCos turn = portableSinCos(2.0 * kPi * i / points);
    outline.push_back({radius_m * turn.cos, radius_m * turn.sin});
  }
  return outline;
}

}  // namespace torsio
