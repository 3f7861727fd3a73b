// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/neo_hookean_elements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "sim/baseline/stress_laws.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Point of the reference element with its weight: xi, eta in the unit triangle, t in [-1, 1]; in a
/// tetrahedron the three in the unit tetrahedron.
struct ElementPoint {
  double xi = 0.0;
  double eta = 0.0;
  double t = 0.0;
  double weight = 0.0;
};

/// Six points across, exact to degree 4 (Dunavant 1985), by three Gauss points along, exact to degree 5.
std::vector<ElementPoint> wedgePoints() {
  constexpr double kA = 0.445948490915965;
  constexpr double kB = 0.091576213509771;
  constexpr double kWeightA = 0.223381589678011 / 2.0;
  constexpr double kWeightB = 0.109951743655322 / 2.0;
  const double end = std::sqrt(0.6);
  std::vector<ElementPoint> points;
  for (const auto& [t, along] : {std::pair{-end, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {end, 5.0 / 9.0}}) {
    for (const auto& [at, weight] : {std::pair{kA, kWeightA}, {kB, kWeightB}}) {
      const double far = 1.0 - 2.0 * at;
      points.push_back({at, at, t, weight * along});
      points.push_back({far, at, t, weight * along});
      points.push_back({at, far, t, weight * along});
    }
  }
  return points;
}

/// A shape function of one direction with its slope.
struct Shape {
  double value = 0.0;
  double slope = 0.0;
};

std::vector<Shape> shapesAlong(double t, bool quadratic) {
  if (quadratic) {
    return {{0.5 * t * (t - 1.0), t - 0.5}, {1.0 - t * t, -2.0 * t}, {0.5 * t * (t + 1.0), t + 0.5}};
  }
  return {{0.5 * (1.0 - t), -0.5}, {0.5 * (1.0 + t), 0.5}};
}

struct ShapeAcross {
  double value = 0.0;
  double byXi = 0.0;
  double byEta = 0.0;
};

std::vector<ShapeAcross> shapesAcross(double xi, double eta, bool quadratic) {
  const std::array<double, 3> l{1.0 - xi - eta, xi, eta};
  constexpr std::array<double, 3> kByXi{-1.0, 1.0, 0.0};
  constexpr std::array<double, 3> kByEta{-1.0, 0.0, 1.0};
  std::vector<ShapeAcross> shapes;
  for (std::size_t k = 0; k < 3; ++k) {
    const double slope = quadratic ? 4.0 * l[k] - 1.0 : 1.0;
    shapes.push_back({quadratic ? l[k] * (2.0 * l[k] - 1.0) : l[k], slope * kByXi[k], slope * kByEta[k]});
  }
  for (std::size_t k = 0; quadratic && k < 3; ++k) {
    const std::size_t m = (k + 1) % 3;
    shapes.push_back({4.0 * l[k] * l[m], 4.0 * (l[k] * kByXi[m] + l[m] * kByXi[k]),
                      4.0 * (l[k] * kByEta[m] + l[m] * kByEta[k])});
  }
  return shapes;
}

using LocalGradients = Eigen::Matrix<double, 3, static_cast<int>(kMaxElementNodes)>;

/// Derivatives of all shape functions by (xi, eta, t), in the order of quadraticWedges and linearWedges.
LocalGradients wedgeGradients(const ElementPoint& p, bool quadratic) {
  LocalGradients d = LocalGradients::Zero();
  int node = 0;
  for (const Shape& along : shapesAlong(p.t, quadratic)) {
    for (const ShapeAcross& across : shapesAcross(p.xi, p.eta, quadratic)) {
      d.col(node++) << across.byXi * along.value, across.byEta * along.value, across.value * along.slope;
    }
  }
  return d;
}

/// Four points, exact to degree 2: to the last digit in a quadratic tetrahedron with straight sides.
std::vector<ElementPoint> tetrahedronPoints() {
  const double far = 0.25 + 0.15 * std::sqrt(5.0);
  const double near = (1.0 - far) / 3.0;
  constexpr double kWeight = 1.0 / 24.0;
  return {{near, near, near, kWeight},
          {far, near, near, kWeight},
          {near, far, near, kWeight},
          {near, near, far, kWeight}};
}

/// The same of a quadratic tetrahedron, by (xi, eta, t), in the order of quadraticTetrahedra.
LocalGradients tetrahedronGradients(const ElementPoint& p) {
  const std::array<double, 4> l{1.0 - p.xi - p.eta - p.t, p.xi, p.eta, p.t};
  const std::array<Eigen::Vector3d, 4> slopes{Eigen::Vector3d(-1.0, -1.0, -1.0), Eigen::Vector3d::UnitX(),
                                              Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
  LocalGradients d = LocalGradients::Zero();
  int node = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    d.col(node++) = (4.0 * l[k] - 1.0) * slopes[k];
  }
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t m = k + 1; m < 4; ++m) {
      d.col(node++) = 4.0 * (l[k] * slopes[m] + l[m] * slopes[k]);
    }
  }
  return d;
}

Eigen::Vector3d vector(const Vec3& v) {
  return {v.x, v.y, v.z};
}

/// F = sum x_a (grad N_a)^T.
Eigen::Matrix3d deformation(std::span<const int> nodes, std::span<const Vec3> places,
                            const std::array<Vec3, kMaxElementNodes>& gradients) {
  Eigen::Matrix3d f = Eigen::Matrix3d::Zero();
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const Vec3& x = places[static_cast<std::size_t>(nodes[a])];
    f.col(0) += gradients[a].x * vector(x);
    f.col(1) += gradients[a].y * vector(x);
    f.col(2) += gradients[a].z * vector(x);
  }
  return f;
}

Matrix3 plainNumbers(const Eigen::Matrix3d& m) {
  Matrix3 values;
  Eigen::Map<Eigen::Matrix3d>(values.data()) = m;
  return values;
}

}  // namespace

NeoHookeanElements::NeoHookeanElements(SolidMesh mesh, std::span<const Vec3> rest_m,
                                       const ElasticConstants& constants)
    : mesh_(std::move(mesh)), constants_(constants) {
  checkElasticConstants(constants);
  const bool tetrahedra = mesh_.nodesPerCell == kQuadraticTetrahedronNodes;
  const bool quadratic = mesh_.nodesPerCell == static_cast<int>(kMaxElementNodes);
  const std::vector<ElementPoint> rule = tetrahedra ? tetrahedronPoints() : wedgePoints();
  pointsPerElement_ = rule.size();
  points_.reserve(mesh_.cells() * pointsPerElement_);
  for (std::size_t c = 0; c < mesh_.cells(); ++c) {
    const std::span<const int> nodes = mesh_.cell(c);
    for (const ElementPoint& p : rule) {
      const LocalGradients local = tetrahedra ? tetrahedronGradients(p) : wedgeGradients(p, quadratic);
      Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();  // d place / d (xi, eta, t)
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        jacobian +=
            vector(rest_m[static_cast<std::size_t>(nodes[a])]) * local.col(static_cast<int>(a)).transpose();
      }
      const double det = jacobian.determinant();
      if (!(det > 0.0)) {
        throw Error(ErrorCode::kBadMesh, Text::tr("An element of the organ is folded at rest"),
                    Text::tr("element %1", c + 1), Text::tr("Give other ends, or fewer sections"));
      }
      const LocalGradients gradients = jacobian.inverse().transpose() * local;
      IntegrationPoint point;
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        const auto g = gradients.col(static_cast<int>(a));
        point.gradients[a] = {g.x(), g.y(), g.z()};
      }
      point.volume_m3 = p.weight * det;
      points_.push_back(point);
    }
  }
}

bool NeoHookeanElements::elementForces(std::size_t element, std::span<const Vec3> places_m, double& energy_J,
                                       std::span<Vec3> forces_N) const {
  const std::span<const int> nodes = mesh_.cell(element);
  energy_J = 0.0;
  std::fill(forces_N.begin(), forces_N.end(), Vec3{});
  for (std::size_t q = 0; q < pointsPerElement_; ++q) {
    const IntegrationPoint& point = points_[element * pointsPerElement_ + q];
    const Eigen::Matrix3d f = deformation(nodes, places_m, point.gradients);
    if (!(f.determinant() > 0.0)) {
      return false;
    }
    const StressState state = neoHookeanStress(plainNumbers(f), constants_);
    energy_J += point.volume_m3 * state.energy_Pa;
    const Eigen::Map<const Eigen::Matrix3d> stress(state.stress_Pa.data());
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const Eigen::Vector3d force = point.volume_m3 * (stress * vector(point.gradients[a]));
      forces_N[a] += {force.x(), force.y(), force.z()};
    }
  }
  return true;
}

void NeoHookeanElements::elementStiffness(std::size_t element, std::span<const Vec3> places_m,
                                          std::span<double> stiffness) const {
  const std::span<const int> nodes = mesh_.cell(element);
  const auto count = static_cast<Eigen::Index>(nodes.size());
  Eigen::Map<Eigen::MatrixXd> k(stiffness.data(), 3 * count, 3 * count);
  k.setZero();
  for (std::size_t q = 0; q < pointsPerElement_; ++q) {
    const IntegrationPoint& point = points_[element * pointsPerElement_ + q];
    const Matrix9 tangent =
        neoHookeanTangent(plainNumbers(deformation(nodes, places_m, point.gradients)), constants_);
    const Eigen::Map<const Eigen::Matrix<double, 9, 9>> a(tangent.data());
    for (Eigen::Index c = 0; c < count; ++c) {
      const Vec3& g = point.gradients[static_cast<std::size_t>(c)];
      // d P by the place of node c
      const Eigen::Matrix<double, 9, 3> byPlace =
          point.volume_m3 * (a.leftCols<3>() * g.x + a.middleCols<3>(3) * g.y + a.rightCols<3>() * g.z);
      for (Eigen::Index r = 0; r < count; ++r) {
        const Vec3& h = point.gradients[static_cast<std::size_t>(r)];
        k.block<3, 3>(3 * r, 3 * c) +=
            h.x * byPlace.topRows<3>() + h.y * byPlace.middleRows<3>(3) + h.z * byPlace.bottomRows<3>();
      }
    }
  }
}

}  // namespace torsio
