// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/corotational_tetrahedra.h"

#include <utility>

#include <Eigen/Dense>

namespace torsio {

namespace {

Vec3 times(const Matrix3& m, const Vec3& v) {
  return {m[0] * v.x + m[3] * v.y + m[6] * v.z, m[1] * v.x + m[4] * v.y + m[7] * v.z,
          m[2] * v.x + m[5] * v.y + m[8] * v.z};
}

}  // namespace

CorotationalTetrahedra::CorotationalTetrahedra(SolidMesh mesh, std::span<const Vec3> rest_m,
                                               const ElasticConstants& constants)
    : mesh_(std::move(mesh)), constants_(constants), volumes_m3_(tetrahedronVolumes(mesh_, rest_m)) {
  checkElasticConstants(constants);
  gradients_.reserve(mesh_.cells());
  for (std::size_t c = 0; c < mesh_.cells(); ++c) {
    const std::span<const int> cell = mesh_.cell(c);
    const auto at = [&](std::size_t k) { return rest_m[static_cast<std::size_t>(cell[k])]; };
    const Vec3 a = at(1) - at(0);
    const Vec3 b = at(2) - at(0);
    const Vec3 d = at(3) - at(0);
    const double six = 6.0 * volumes_m3_[c];
    const Vec3 g1 = cross(b, d) / six;
    const Vec3 g2 = cross(d, a) / six;
    const Vec3 g3 = cross(a, b) / six;
    gradients_.push_back({-(g1 + g2 + g3), g1, g2, g3});
  }
}

Matrix3 CorotationalTetrahedra::gradientOf(std::size_t element, std::span<const Vec3> places_m) const {
  const std::span<const int> cell = mesh_.cell(element);
  const std::array<Vec3, 4>& g = gradients_[element];
  const Vec3& origin = places_m[static_cast<std::size_t>(cell[0])];
  Matrix3 f{};
  for (std::size_t k = 1; k < 4; ++k) {
    const Vec3 x = places_m[static_cast<std::size_t>(cell[k])] - origin;
    f[0] += x.x * g[k].x, f[1] += x.y * g[k].x, f[2] += x.z * g[k].x;
    f[3] += x.x * g[k].y, f[4] += x.y * g[k].y, f[5] += x.z * g[k].y;
    f[6] += x.x * g[k].z, f[7] += x.y * g[k].z, f[8] += x.z * g[k].z;
  }
  return f;
}

bool CorotationalTetrahedra::elementForces(std::size_t element, std::span<const Vec3> places_m,
                                           double& energy_J, std::span<Vec3> forces_N) const {
  const StressState state = corotationalStress(gradientOf(element, places_m), constants_);
  const double volume_m3 = volumes_m3_[element];
  energy_J = volume_m3 * state.energy_Pa;
  for (std::size_t k = 0; k < 4; ++k) {
    forces_N[k] = volume_m3 * times(state.stress_Pa, gradients_[element][k]);
  }
  return true;
}

void CorotationalTetrahedra::elementStiffness(std::size_t element, std::span<const Vec3> places_m,
                                              std::span<double> stiffness) const {
  const Matrix9 tangent = corotationalTangent(gradientOf(element, places_m), constants_);
  const Eigen::Map<const Eigen::Matrix<double, 9, 9>> a(tangent.data());
  Eigen::Map<Eigen::Matrix<double, 12, 12>> k(stiffness.data());
  for (int c = 0; c < 4; ++c) {
    const Vec3& g = gradients_[element][static_cast<std::size_t>(c)];
    const Eigen::Matrix<double, 9, 3> byPlace =
        volumes_m3_[element] * (a.leftCols<3>() * g.x + a.middleCols<3>(3) * g.y + a.rightCols<3>() * g.z);
    for (int r = 0; r < 4; ++r) {
      const Vec3& h = gradients_[element][static_cast<std::size_t>(r)];
      k.block<3, 3>(3 * r, 3 * c) =
          h.x * byPlace.topRows<3>() + h.y * byPlace.middleRows<3>(3) + h.z * byPlace.bottomRows<3>();
    }
  }
}

void CorotationalTetrahedra::warpedStiffness(std::size_t element, std::span<const Vec3> places_m,
                                             std::span<Vec3> forces_N, std::span<Matrix3> blocks) const {
  const Matrix3 f = gradientOf(element, places_m);
  const Matrix3 r = rotationOf(f);
  const std::array<Vec3, 4>& g = gradients_[element];
  const double shear = volumes_m3_[element] * constants_.shearModulus_Pa;
  const double lame = volumes_m3_[element] * constants_.lame_Pa();
  double trace = -3.0;
  Matrix3 stress;
  for (std::size_t i = 0; i < 9; ++i) {
    trace += r[i] * f[i];
  }
  for (std::size_t i = 0; i < 9; ++i) {
    stress[i] = 2.0 * shear * (f[i] - r[i]) + lame * trace * r[i];
  }
  std::array<Vec3, 4> turned;
  for (std::size_t k = 0; k < 4; ++k) {
    turned[k] = times(r, g[k]);
    forces_N[k] = times(stress, g[k]);
  }
  // K_ab = V [lambda h_a h_b^T + G h_b h_a^T + G (g_a . g_b) I] with h = R g
  for (std::size_t a = 0; a < 4; ++a) {
    const std::array<double, 3> ha{turned[a].x, turned[a].y, turned[a].z};
    for (std::size_t b = 0; b < 4; ++b) {
      const std::array<double, 3> hb{turned[b].x, turned[b].y, turned[b].z};
      Matrix3& block = blocks[4 * a + b];
      for (std::size_t column = 0; column < 3; ++column) {
        for (std::size_t row = 0; row < 3; ++row) {
          block[row + 3 * column] = lame * ha[row] * hb[column] + shear * hb[row] * ha[column];
        }
      }
      const double diagonal = shear * dot(g[a], g[b]);
      block[0] += diagonal, block[4] += diagonal, block[8] += diagonal;
    }
  }
}

}  // namespace torsio
