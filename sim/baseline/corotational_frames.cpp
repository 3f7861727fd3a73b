// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/corotational_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace torsio {

namespace {

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
