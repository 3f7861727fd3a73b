// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/equilibrium.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Sparse>

#include "sim/base/refusal.h"

namespace torsio {

namespace {

constexpr int kHeldNode = -1;
constexpr int kTurnedNode = -2;
constexpr double kResidualWanted = 1e-7;  ///< over the forces that hold the ends
/// Where rounding ends the way: a residual below this that no step makes smaller is taken.
constexpr double kResidualOfRounding = 1e-5;
constexpr double kEnergyOfRounding_J = 1e-20;  ///< of a body at rest
constexpr int kMostNewtonSteps = 60;
constexpr int kMostStepHalvings = 16;
/// A finite rotation in one step is not what a tangent describes.
constexpr double kMostTurnAStep_rad = 0.5;

double component(const Vec3& v, int i) {
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

}  // namespace

struct Equilibrium::Linear {
  Eigen::SparseMatrix<double> matrix;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> solver;
  bool analysed = false;

  /// Factorises; adds to the diagonal until all pivots are positive.
  [[nodiscard]] bool factorise() {
    if (!analysed) {
      solver.analyzePattern(matrix);
      analysed = true;
    }
    const double mean = matrix.diagonal().cwiseAbs().mean();
    double shift = 0.0;
    for (int attempt = 0; attempt < 12; ++attempt) {
      solver.setShift(shift);
      solver.factorize(matrix);
      if (solver.info() == Eigen::Success && solver.vectorD().minCoeff() > 0.0) {
        return true;
      }
      shift = shift == 0.0 ? 1e-4 * mean : 4.0 * shift;
    }
    return false;
  }
};

Equilibrium::Equilibrium(const ElasticBody& body, TwistEnds ends, std::span<const Vec3> rest_m)
    : body_(body),
      ends_(std::move(ends)),
      rest_m_(rest_m.begin(), rest_m.end()),
      unknownOf_(rest_m.size(), kHeldNode),
      linear_(std::make_unique<Linear>()) {
  // A node of no element (the middle of a quadratic triangle) stays where it is.
  for (std::size_t e = 0; e < body.elements(); ++e) {
    for (const int node : body.elementNodes(e)) {
      unknownOf_[static_cast<std::size_t>(node)] = 0;
    }
  }
  for (const int node : ends_.held) {
    unknownOf_[static_cast<std::size_t>(node)] = kHeldNode;
  }
  for (const int node : ends_.turned) {
    unknownOf_[static_cast<std::size_t>(node)] = kTurnedNode;
  }
  for (int& unknown : unknownOf_) {
    if (unknown == 0) {
      unknown = unknowns_;
      unknowns_ += 3;
    }
  }
  ++unknowns_;
  residual_.resize(static_cast<std::size_t>(unknowns_));
}

Equilibrium::~Equilibrium() = default;

bool Equilibrium::evaluate(double torque_Nm, const TwistPose& pose) {
  forces_N_.assign(pose.places_m.size(), Vec3{});
  energy_J_ = 0.0;
  std::array<Vec3, kMostElementNodes> part;
  for (std::size_t e = 0; e < body_.elements(); ++e) {
    const std::span<const int> nodes = body_.elementNodes(e);
    double energy_J = 0.0;
    if (!body_.elementForces(e, pose.places_m, energy_J, std::span(part).first(nodes.size()))) {
      return false;
    }
    energy_J_ += energy_J;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      forces_N_[static_cast<std::size_t>(nodes[k])] += part[k];
    }
  }
  potential_J_ = energy_J_ - torque_Nm * pose.angle_rad;
  double moment_Nm = 0.0;
  for (std::size_t i = 0; i < unknownOf_.size(); ++i) {
    const Vec3& f = forces_N_[i];
    if (unknownOf_[i] == kTurnedNode) {
      moment_Nm += dot(cross(ends_.axis, pose.places_m[i] - ends_.axisPoint_m), f);
    } else if (unknownOf_[i] != kHeldNode) {
      const auto at = static_cast<std::size_t>(unknownOf_[i]);
      residual_[at] = f.x, residual_[at + 1] = f.y, residual_[at + 2] = f.z;
    }
  }
  residual_.back() = moment_Nm - torque_Nm;
  return std::isfinite(potential_J_);
}

void Equilibrium::assemble(const TwistPose& pose) {
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> stiffness(9 * kMostElementNodes * kMostElementNodes);
  const int angle = unknowns_ - 1;
  const auto motion = [&](int node) {  // d place / d angle
    return cross(ends_.axis, pose.places_m[static_cast<std::size_t>(node)] - ends_.axisPoint_m);
  };
  double byAngleTwice = 0.0;
  for (const int node : ends_.turned) {
    byAngleTwice += dot(cross(ends_.axis, motion(node)), forces_N_[static_cast<std::size_t>(node)]);
  }
  for (std::size_t e = 0; e < body_.elements(); ++e) {
    const std::span<const int> nodes = body_.elementNodes(e);
    const std::size_t size = 3 * nodes.size();
    body_.elementStiffness(e, pose.places_m, std::span(stiffness).first(size * size));
    for (std::size_t column = 0; column < size; ++column) {
      const int columnNode = nodes[column / 3];
      const int columnUnknown = unknownOf_[static_cast<std::size_t>(columnNode)];
      if (columnUnknown == kHeldNode) {
        continue;
      }
      const int c = static_cast<int>(column % 3);
      for (std::size_t row = 0; row < size; ++row) {
        const int rowNode = nodes[row / 3];
        const int rowUnknown = unknownOf_[static_cast<std::size_t>(rowNode)];
        const double value = stiffness[row + size * column];
        const int r = static_cast<int>(row % 3);
        if (rowUnknown == kTurnedNode && columnUnknown == kTurnedNode) {
          byAngleTwice += component(motion(rowNode), r) * value * component(motion(columnNode), c);
        } else if (rowUnknown == kTurnedNode) {
          entries.emplace_back(angle, columnUnknown + c, component(motion(rowNode), r) * value);
        } else if (rowUnknown >= 0 && columnUnknown >= 0 && rowUnknown + r >= columnUnknown + c) {
          entries.emplace_back(rowUnknown + r, columnUnknown + c, value);
        }
      }
    }
  }
  entries.emplace_back(angle, angle, byAngleTwice);
  linear_->matrix.resize(unknowns_, unknowns_);
  linear_->matrix.setFromTriplets(entries.begin(), entries.end());
}

double Equilibrium::forceScale() const {
  double held = 0.0;
  for (const int node : ends_.held) {
    const Vec3& f = forces_N_[static_cast<std::size_t>(node)];
    held += dot(f, f);
  }
  return std::sqrt(held);
}

bool Equilibrium::advance(double torque_Nm, std::span<const double> move, TwistPose& pose) {
  const double before_J = potential_J_;
  double slope_J = 0.0;
  double norm2 = 0.0;
  for (std::size_t i = 0; i < move.size(); ++i) {
    slope_J += residual_[i] * move[i];
    norm2 += residual_[i] * residual_[i];
  }
  const TwistPose start = pose;
  double share = std::min(1.0, kMostTurnAStep_rad / std::max(1e-300, std::abs(move.back())));
  for (int i = 0; i <= kMostStepHalvings; ++i, share *= 0.5) {
    turnEnd(ends_, rest_m_, start.angle_rad + share * move.back(), pose);
    for (std::size_t n = 0; n < unknownOf_.size(); ++n) {
      if (unknownOf_[n] >= 0) {
        const double* d = move.data() + unknownOf_[n];
        pose.places_m[n] = start.places_m[n] + share * Vec3{d[0], d[1], d[2]};
      }
    }
    if (!evaluate(torque_Nm, pose)) {
      continue;
    }
    double now2 = 0.0;
    for (const double r : residual_) {
      now2 += r * r;
    }
    // Near the end the energy changes by less than its rounding; then the residual decides.
    if (potential_J_ <= before_J + 1e-4 * share * slope_J || now2 < 0.25 * norm2) {
      return true;
    }
  }
  return false;
}

EquilibriumReport Equilibrium::solve(double torque_Nm, TwistPose& pose) {
  const auto fail = [&] {
    refuseParameter("No equilibrium was found for this torque", std::to_string(torque_Nm) + " N m",
                    "Give a smaller torque, or more steps");
  };
  if (!std::isfinite(torque_Nm)) {
    refuseParameter("The torque must be finite", "torque", "Give it in newton metres");
  }
  if (!evaluate(torque_Nm, pose)) {
    fail();
  }
  EquilibriumReport report;
  double before = 1.0;
  for (; report.iterations <= kMostNewtonSteps; ++report.iterations) {
    double free = 0.0;
    for (std::size_t i = 0; i + 1 < residual_.size(); ++i) {
      free += residual_[i] * residual_[i];
    }
    const double scale = std::max(forceScale(), 1e-300);
    report.residual = std::sqrt(free) / scale;
    const double end = std::abs(residual_.back()) / std::max(std::abs(torque_Nm), 1e-300);
    const double worse = std::max(report.residual, end);
    if (worse <= kResidualWanted || (worse <= kResidualOfRounding && worse > 0.5 * before) ||
        (torque_Nm == 0.0 && energy_J_ <= kEnergyOfRounding_J)) {
      report.energy_J = energy_J_;
      return report;
    }
    before = worse;
    assemble(pose);
    if (!linear_->factorise()) {
      fail();
    }
    const Eigen::VectorXd move =
        linear_->solver.solve(-Eigen::Map<const Eigen::VectorXd>(residual_.data(), unknowns_));
    if (!move.allFinite() || !advance(torque_Nm, {move.data(), static_cast<std::size_t>(unknowns_)}, pose)) {
      fail();
    }
  }
  fail();
  return report;
}

}  // namespace torsio
