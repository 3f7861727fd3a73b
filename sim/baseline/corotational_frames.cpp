// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/corotational_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include <Eigen/Dense>

namespace torsio {

namespace {

Vec3 times(const Matrix3& m, const Vec3& v) {
  return {m[0] * v.x + m[3] * v.y + m[6] * v.z, m[1] * v.x + m[4] * v.y + m[7] * v.z,
          m[2] * v.x + m[5] * v.y + m[8] * v.z};
}

constexpr double kGradientTolerance = 1e-3;
constexpr int kMaxGradientSteps = 200;
enum NodeKind : int { kFreeNode = 0, kStillNode = 1, kEndNode = 2 };

double product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

Matrix3 inverted(const Matrix3& m) {
  const Vec3 a{m[0], m[1], m[2]};
  const Vec3 b{m[3], m[4], m[5]};
  const Vec3 c{m[6], m[7], m[8]};
  const Vec3 bc = cross(b, c);
  const Vec3 ca = cross(c, a);
  const Vec3 ab = cross(a, b);
  const double k = 1.0 / dot(a, bc);
  return {k * bc.x, k * ca.x, k * ab.x, k * bc.y, k * ca.y, k * ab.y, k * bc.z, k * ca.z, k * ab.z};
}

/// out += m in, three numbers each.
void addProduct(const Matrix3& m, const double* in, double* out) {
  out[0] += m[0] * in[0] + m[3] * in[1] + m[6] * in[2];
  out[1] += m[1] * in[0] + m[4] * in[1] + m[7] * in[2];
  out[2] += m[2] * in[0] + m[5] * in[1] + m[8] * in[2];
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

CorotationalFrames::CorotationalFrames(const SweptSolid& solid, TwistEnds ends,
                                       const ElasticConstants& constants, const DynamicsOptions& options)
    : ends_(std::move(ends)),
      options_(options),
      rest_m_(solid.points_m),
      body_(tetrahedra(solid), solid.points_m, constants),
      masses_kg_(nodeMasses(tetrahedra(solid), solid.points_m, options.density_kg_per_m3)),
      turn_(3 * solid.points_m.size()),
      kind_(solid.points_m.size(), kFreeNode),
      inverse_(solid.points_m.size()),
      motion_m_(solid.points_m.size()),
      pose_{solid.points_m},
      velocity_(3 * solid.points_m.size() + 4),
      full_(velocity_.size()) {
  for (const int node : ends_.held) {
    kind_[static_cast<std::size_t>(node)] = kStillNode;
  }
  for (const int node : ends_.turned) {
    kind_[static_cast<std::size_t>(node)] = kEndNode;
  }
  makePattern(tetrahedra(solid));
}

void CorotationalFrames::makePattern(const SolidMesh& mesh) {
  std::vector<std::set<int>> neighbours(rest_m_.size());
  for (std::size_t c = 0; c < mesh.cells(); ++c) {
    for (const int a : mesh.cell(c)) {
      neighbours[static_cast<std::size_t>(a)].insert(mesh.cell(c).begin(), mesh.cell(c).end());
    }
  }
  rowStart_.push_back(0);
  for (const std::set<int>& row : neighbours) {
    column_.insert(column_.end(), row.begin(), row.end());
    rowStart_.push_back(static_cast<int>(column_.size()));
  }
  blocks_.resize(column_.size());
  for (std::size_t c = 0; c < mesh.cells(); ++c) {
    for (const int a : mesh.cell(c)) {
      const auto first = column_.begin() + rowStart_[static_cast<std::size_t>(a)];
      const auto last = column_.begin() + rowStart_[static_cast<std::size_t>(a) + 1];
      for (const int b : mesh.cell(c)) {
        placeOf_.push_back(static_cast<int>(std::lower_bound(first, last, b) - column_.begin()));
      }
    }
  }
}

void CorotationalFrames::assemble() {
  std::fill(blocks_.begin(), blocks_.end(), Matrix3{});
  forces_N_.assign(rest_m_.size(), Vec3{});
  std::array<Vec3, 4> forces;
  std::array<Matrix3, 16> stiffness;
  for (std::size_t e = 0; e < body_.elements(); ++e) {
    body_.warpedStiffness(e, pose_.places_m, forces, stiffness);
    const std::span<const int> nodes = body_.elementNodes(e);
    for (std::size_t a = 0; a < 4; ++a) {
      forces_N_[static_cast<std::size_t>(nodes[a])] += forces[a];
    }
    for (std::size_t k = 0; k < 16; ++k) {
      Matrix3& block = blocks_[static_cast<std::size_t>(placeOf_[16 * e + k])];
      for (std::size_t i = 0; i < 9; ++i) {
        block[i] += stiffness[k][i];
      }
    }
  }
  // (M (1 + drag dt) + dt^2 K) / dt^2
  const double h = options_.frame_s;
  const double inertial = (1.0 + options_.drag_per_s * h) / (h * h);
  for (std::size_t i = 0; i < rest_m_.size(); ++i) {
    const auto first = column_.begin() + rowStart_[i];
    const auto last = column_.begin() + rowStart_[i + 1];
    const auto place =
        static_cast<std::size_t>(std::lower_bound(first, last, static_cast<int>(i)) - column_.begin());
    for (const std::size_t d : {0U, 4U, 8U}) {
      blocks_[place][d] += inertial * masses_kg_[i];
    }
    inverse_[i] = inverted(blocks_[place]);
  }
}

void CorotationalFrames::expand(Field& field) const {
  const double angle = field[turn_];
  const Vec3 way{field[turn_ + 1], field[turn_ + 2], field[turn_ + 3]};
  for (std::size_t i = 0; i < kind_.size(); ++i) {
    if (kind_[i] != kFreeNode) {
      const Vec3 v = kind_[i] == kEndNode ? angle * motion_m_[i] + way : Vec3{};
      field[3 * i] = v.x, field[3 * i + 1] = v.y, field[3 * i + 2] = v.z;
    }
  }
}

void CorotationalFrames::reduce(Field& field) const {
  double angle = 0.0;
  Vec3 way;
  for (std::size_t i = 0; i < kind_.size(); ++i) {
    if (kind_[i] != kFreeNode) {
      const Vec3 v{field[3 * i], field[3 * i + 1], field[3 * i + 2]};
      angle += dot(motion_m_[i], v);
      way += kind_[i] == kEndNode && ends_.placeFree ? v : Vec3{};
      field[3 * i] = field[3 * i + 1] = field[3 * i + 2] = 0.0;
    }
  }
  field[turn_] = angle;
  field[turn_ + 1] = way.x, field[turn_ + 2] = way.y, field[turn_ + 3] = way.z;
}

void CorotationalFrames::apply(const Field& in, Field& out) {
  full_ = in;
  expand(full_);
  std::fill(out.begin(), out.end(), 0.0);
  for (std::size_t i = 0; i < rest_m_.size(); ++i) {
    for (int k = rowStart_[i]; k < rowStart_[i + 1]; ++k) {
      const auto at = static_cast<std::size_t>(k);
      addProduct(blocks_[at], &full_[3 * static_cast<std::size_t>(column_[at])], &out[3 * i]);
    }
  }
  reduce(out);
}

void CorotationalFrames::makePreconditioner() {
  Field answer(velocity_.size());
  for (std::size_t k = 0; k < (ends_.placeFree ? 4U : 1U); ++k) {
    Field unit(velocity_.size());
    unit[turn_ + k] = 1.0;
    apply(unit, answer);
    inverseTurned_[k] = 1.0 / answer[turn_ + k];
  }
}

void CorotationalFrames::precondition(const Field& in, Field& out) const {
  std::fill(out.begin(), out.end(), 0.0);
  for (std::size_t i = 0; i < kind_.size(); ++i) {
    if (kind_[i] == kFreeNode) {
      addProduct(inverse_[i], &in[3 * i], &out[3 * i]);
    }
  }
  for (std::size_t k = 0; k < inverseTurned_.size(); ++k) {
    out[turn_ + k] = inverseTurned_[k] * in[turn_ + k];
  }
}

void CorotationalFrames::step(double torque_Nm) {
  advance(torque_Nm, std::nullopt);
}

void CorotationalFrames::stepTo(double angle_rad) {
  advance(0.0, angle_rad - pose_.angle_rad);
}

void CorotationalFrames::advance(double torque_Nm, std::optional<double> turn_rad) {
  for (const int node : ends_.turned) {
    motion_m_[static_cast<std::size_t>(node)] = turningOf(ends_, pose_, node);
  }
  assemble();
  makePreconditioner();
  if (turn_rad) {
    inverseTurned_[0] = 0.0;  // its number in the way stays as it is given
  }
  // Unknown: the way of this frame. Right side: M v / dt - forces, the torque on the angle.
  const double h = options_.frame_s;
  Field right(velocity_.size());
  for (std::size_t i = 0; i < rest_m_.size(); ++i) {
    const double m = masses_kg_[i] / h;
    right[3 * i] = m * velocity_[3 * i] - forces_N_[i].x;
    right[3 * i + 1] = m * velocity_[3 * i + 1] - forces_N_[i].y;
    right[3 * i + 2] = m * velocity_[3 * i + 2] - forces_N_[i].z;
  }
  reduce(right);
  right[turn_] += torque_Nm;
  Field way(velocity_.size());
  for (std::size_t i = 0; i < way.size(); ++i) {
    way[i] = h * velocity_[i];
  }
  reduce(way);
  for (std::size_t k = turn_; k < way.size(); ++k) {
    way[k] = h * velocity_[k];
  }
  way[turn_] = turn_rad.value_or(way[turn_]);
  Field residual(way.size());
  Field answer(way.size());
  apply(way, residual);
  for (std::size_t i = 0; i < way.size(); ++i) {
    residual[i] = right[i] - residual[i];
  }
  precondition(residual, answer);
  Field direction = answer;
  Field image(way.size());
  double remaining = product(residual, answer);
  Field scaled(way.size());
  precondition(right, scaled);
  // What is led has no torque on its right side: the error that it begins with is the measure.
  const double measure = turn_rad ? std::max(remaining, product(right, scaled)) : product(right, scaled);
  const double wanted = kGradientTolerance * kGradientTolerance * measure;
  for (gradientSteps_ = 0; gradientSteps_ < kMaxGradientSteps && remaining > wanted; ++gradientSteps_) {
    apply(direction, image);
    const double length = remaining / product(direction, image);
    for (std::size_t i = 0; i < way.size(); ++i) {
      way[i] += length * direction[i];
      residual[i] -= length * image[i];
    }
    precondition(residual, answer);
    const double next = product(residual, answer);
    for (std::size_t i = 0; i < way.size(); ++i) {
      direction[i] = answer[i] + (next / remaining) * direction[i];
    }
    remaining = next;
  }
  expand(way);
  for (std::size_t i = 0; i < rest_m_.size(); ++i) {
    pose_.places_m[i] += {way[3 * i], way[3 * i + 1], way[3 * i + 2]};
  }
  pose_.way_m += {way[turn_ + 1], way[turn_ + 2], way[turn_ + 3]};
  turnEnd(ends_, rest_m_, pose_.angle_rad + way[turn_], pose_);
  for (std::size_t i = 0; i < way.size(); ++i) {
    velocity_[i] = way[i] / h;
  }
}

}  // namespace torsio
