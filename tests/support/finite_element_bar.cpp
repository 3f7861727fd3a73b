// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/finite_element_bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include "sim/base/angle.h"
#include "sim/base/error.h"
#include "sim/base/portable_math.h"
#include "sim/base/refusal.h"

namespace torsio {
namespace {

constexpr int kMostCorners = 6;
/// Residual over the reaction of the held ends: the torque is then good to about the same fraction.
constexpr double kConverged = 1e-9;
/// Floor of the residual over G times the area of the section, for a bar that is not turned at all.
constexpr double kRoundOff = 1e-12;
/// Points tell angles apart only to full turns: more than half a turn in a layer would pass for less.
constexpr double kMostPerLayer_rad = radians(90.0);
constexpr int kMostIterations = 40;
constexpr int kMostHalvings = 12;

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
  if (corners == 4) {
    return {{tetrahedronDerivatives(), 1.0 / 6.0}};
  }
  constexpr double kThird = 1.0 / 6.0;
  constexpr std::array<Point2, 3> kAcross{{{kThird, kThird}, {4.0 * kThird, kThird}, {kThird, 4.0 * kThird}}};
  const double along = std::sqrt(1.0 / 3.0);
  std::vector<GaussPoint> points;
  for (const Point2& p : kAcross) {
    for (const double t : {-along, along}) {
      points.push_back({wedgeDerivatives(p[0], p[1], t), 1.0 / 6.0});
    }
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

  /// A force to judge round-off by: G times volume over length.
  [[nodiscard]] double forceScale() const {
    double volume = 0.0;
    for (const GaussPoint& p : points_) {
      volume += p.volume;
    }
    return mu_ * volume / rest_[rest_.size() - 1];
  }

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
        if (!(j > 0.0)) {
          return false;
        }
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
        if (freeColumn < 0) {
          continue;
        }
        for (int row = 0; row < 3 * corners; ++row) {
          const int freeRow = freeNumber(cell, row);
          if (freeRow >= freeColumn) {
            entries.emplace_back(freeRow, freeColumn, k(row, column));
          }
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
    for (int k = 0; k < mesh_.cornersPerCell; ++k) {
      x.col(k) = field.segment<3>(3 * corner(cell, k));
    }
    return x;
  }

  void scatter(std::size_t cell, const Gradients& part, Vector& field) const {
    for (int k = 0; k < mesh_.cornersPerCell; ++k) {
      field.segment<3>(3 * corner(cell, k)) += part.col(k);
    }
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

/// Newton's method for the equilibrium of the free points, the held ones staying where they are.
class NewtonSolve {
 public:
  explicit NewtonSolve(const BarSystem& system) : system_(system) {}

  /// Moves the free part of `place` into equilibrium; false when it does not get there.
  [[nodiscard]] bool solve(Vector& place) {
    if (!system_.forces(place, force_)) {
      return false;
    }
    for (int i = 0; i < kMostIterations; ++i) {
      if (residual() <= kConverged * reaction() + kRoundOff * system_.forceScale()) {
        return true;
      }
      ++iterations_;
      const Sparse matrix = system_.stiffness(place);
      if (!analysed_) {
        solver_.analyzePattern(matrix);
      }
      analysed_ = true;
      solver_.factorize(matrix);
      if (solver_.info() != Eigen::Success) {
        return false;
      }
      const Vector move = solver_.solve(-system_.freePart(force_));
      if (!move.allFinite() || !advance(move, place)) {
        return false;
      }
    }
    return false;
  }

  [[nodiscard]] int iterations() const noexcept { return iterations_; }
  /// Nodal forces of the configuration last solved.
  [[nodiscard]] const Vector& force() const noexcept { return force_; }

 private:
  [[nodiscard]] double residual() const { return system_.freePart(force_).norm(); }
  [[nodiscard]] double reaction() const {
    return std::sqrt(std::max(0.0, force_.squaredNorm() - system_.freePart(force_).squaredNorm()));
  }

  /// Goes along `move` as far as the residual falls and no cell turns inside out.
  [[nodiscard]] bool advance(const Vector& move, Vector& place) {
    const double before = residual();
    const Vector start = place;
    double share = 1.0;
    for (int i = 0; i <= kMostHalvings; ++i, share *= 0.5) {
      system_.freePart(place) = system_.freePart(start) + share * move;
      if (system_.forces(place, force_) && residual() < before) {
        return true;
      }
    }
    return false;
  }

  const BarSystem& system_;
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower> solver_;
  bool analysed_ = false;
  Vector force_;
  int iterations_ = 0;
};

void checkMaterial(const BarMaterial& material) {
  if (!std::isfinite(material.shearModulus_Pa) || material.shearModulus_Pa <= 0.0) {
    refuseParameter(Text::verbatim("The shear modulus must be positive and finite"),
                    Text::verbatim("shear modulus"), Text::verbatim("Give it in pascal"));
  }
  if (!(material.poissonRatio >= 0.0 && material.poissonRatio < 0.5)) {
    refuseParameter(Text::verbatim("Poisson's ratio must be at least 0 and below 0.5"),
                    Text::verbatim("Poisson's ratio"), Text::verbatim("Give 0.45 to 0.49 for soft tissue"));
  }
}

void checkAngle(double angle_rad) {
  if (!std::isfinite(angle_rad)) {
    refuseParameter(Text::verbatim("The angle must be finite"), Text::verbatim("angle"),
                    Text::verbatim("Give the angle in radians"));
  }
}

/// Turns every point about the axis by its share z / length of the angle, from where it is.
void turnOn(double angle_rad, Vector& place) {
  const double length = place[place.size() - 1];
  for (Eigen::Index i = 0; i < place.size(); i += 3) {
    const SinCos turn = portableSinCos(angle_rad * place[i + 2] / length);
    place.segment<2>(i) = Eigen::Vector2d(turn.cos * place[i] - turn.sin * place[i + 1],
                                          turn.sin * place[i] + turn.cos * place[i + 1]);
  }
}

/// Puts the upper end where it is held: its rest turned by the angle.
void holdUpperEnd(double angle_rad, const BarMesh& mesh, Vector& place) {
  const SinCos turn = portableSinCos(angle_rad);
  const std::size_t last = mesh.points.size();
  for (std::size_t i = last - static_cast<std::size_t>(mesh.pointsPerLayer); i < last; ++i) {
    const Vec3& p = mesh.points[i];
    place.segment<2>(3 * static_cast<Eigen::Index>(i)) << turn.cos * p.x - turn.sin * p.y,
        turn.sin * p.x + turn.cos * p.y;
  }
}

/// Radius and angle of the points of the outline against a plain rotation by angle z / length.
BarTwist compareWithRotation(const BarMesh& mesh, int outlinePoints, double angle_rad, const Vector& place) {
  BarTwist twist;
  const double length = mesh.points.back().z;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (static_cast<int>(i) % mesh.pointsPerLayer < mesh.pointsPerLayer - outlinePoints) {
      continue;
    }
    const Vec3& p = mesh.points[i];
    const SinCos turn = portableSinCos(angle_rad * p.z / length);
    const Eigen::Vector2d turned(turn.cos * p.x - turn.sin * p.y, turn.sin * p.x + turn.cos * p.y);
    const Eigen::Vector2d found = place.segment<2>(3 * static_cast<Eigen::Index>(i));
    const double across = turned[0] * found[1] - turned[1] * found[0];
    const double deviation = std::abs(portableAtan2(across, turned.dot(found)));
    twist.angleError_rad = std::max(twist.angleError_rad, deviation);
    twist.radiusChange = std::max(twist.radiusChange, std::abs(found.norm() / turned.norm() - 1.0));
  }
  return twist;
}

}  // namespace

FiniteElementBar::FiniteElementBar(std::span<const Point2> outline, double length_m, BarElement element,
                                   const BarDivision& division, const BarMaterial& material)
    : mesh_(makeBarMesh(outline, length_m, element, division)),
      material_(material),
      outlinePoints_(static_cast<int>(outline.size())),
      layers_(division.layers) {
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
    refuseParameter(Text::verbatim("The stiffness of the bar cannot be factorised"),
                    Text::verbatim("division"), Text::verbatim("Check for slivers in the outline"));
  }
  system.freePart(u) = solver.solve(-system.freePart(load));
  return angle_rad * u.dot(system.linearForces(u));  // 2 E / angle
}

BarTwist FiniteElementBar::neoHookeanTorque(double angle_rad, int steps) const {
  checkAngle(angle_rad);
  if (steps < 1) {
    refuseParameter(Text::verbatim("At least 1 sub-step is needed"), Text::verbatim("steps"),
                    Text::verbatim("Give one for each 15 degrees"));
  }
  if (std::abs(angle_rad) >= kMostPerLayer_rad * layers_) {
    refuseParameter(Text::verbatim("The twist of one layer must stay below 90 degrees"),
                    Text::verbatim("angle"), Text::verbatim("Give more layers"));
  }
  const BarSystem system(mesh_, material_);
  NewtonSolve newton(system);
  Vector place = system.rest();
  for (int step = 1; step <= steps; ++step) {
    turnOn(angle_rad / steps, place);
    holdUpperEnd(angle_rad * step / steps, mesh_, place);
    if (!newton.solve(place)) {
      refuseParameter(Text::verbatim("Newton's method does not converge for a twist of %1 rad",
                                     std::to_string(angle_rad)),
                      Text::verbatim("sub-step %1 of %2", std::to_string(step), std::to_string(steps)),
                      Text::verbatim("Give more sub-steps or more layers"));
    }
  }
  BarTwist twist = compareWithRotation(mesh_, outlinePoints_, angle_rad, place);
  twist.iterations = newton.iterations();
  const Eigen::Index last = place.size() / 3;
  for (Eigen::Index i = last - mesh_.pointsPerLayer; i < last; ++i) {
    twist.torque_Nm += place[3 * i] * newton.force()[3 * i + 1] - place[3 * i + 1] * newton.force()[3 * i];
  }
  return twist;
}

std::vector<Point2> regularOutline(int points, double radius_m) {
  if (points < 3) {
    refuseParameter(Text::verbatim("A polygon needs at least 3 points"), Text::verbatim("points"),
                    Text::verbatim("Give 3 or more"));
  }
  if (!std::isfinite(radius_m) || radius_m <= 0.0) {
    refuseParameter(Text::verbatim("The radius must be positive and finite"), Text::verbatim("radius"),
                    Text::verbatim("Give the radius in metres"));
  }
  std::vector<Point2> outline;
  for (int i = 0; i < points; ++i) {
    const SinCos turn = portableSinCos(2.0 * kPi * i / points);
    outline.push_back({radius_m * turn.cos, radius_m * turn.sin});
  }
  return outline;
}

}  // namespace torsio
