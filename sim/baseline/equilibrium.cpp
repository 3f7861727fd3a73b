// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/equilibrium.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Dense>

#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr int kHeldNode = -1;
constexpr int kTurnedNode = -2;
constexpr double kResidualWanted = 1e-7;  ///< over the forces that hold the ends
/// Where rounding ends the way: a residual below this that no step makes smaller is taken.
constexpr double kResidualOfRounding = 1e-5;
constexpr double kEnergyOfRounding_J = 1e-20;  ///< of a body at rest
constexpr int kMaxNewtonSteps = 30;
constexpr int kMaxStepHalvings = 16;
/// A finite rotation in one step is not what a tangent describes.
constexpr double kMaxTurnAStep_rad = 0.5;

double component(const Vec3& v, int i) {
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

}  // namespace

/// The tangent as a chain of dense blocks: unknowns are numbered by how many elements lie between them and
/// the held end, so that each block touches the next one only. Cholesky's factorisation block by block; dense
/// blocks make it several times as fast as a general sparse one.
struct Equilibrium::Linear {
  std::vector<Eigen::Index> starts;      ///< of the blocks, and the end
  std::vector<Eigen::MatrixXd> blocks;   ///< on the diagonal; lower triangle L once factorised
  std::vector<Eigen::MatrixXd> towards;  ///< block k to k + 1; L^-1 of it once factorised
  std::vector<int> blockOf;              ///< of each unknown
  double shift = 0.0;                    ///< that made the last tangent positive definite

  void clear() {
    const std::size_t count = starts.size() - 1;
    blocks.resize(count);
    towards.resize(count - 1);
    for (std::size_t k = 0; k < count; ++k) {
      blocks[k].setZero(starts[k + 1] - starts[k], starts[k + 1] - starts[k]);
      if (k + 1 < count) {
        towards[k].setZero(starts[k + 1] - starts[k], starts[k + 2] - starts[k + 1]);
      }
    }
  }

  /// Adds to the symmetric matrix; of every pair the one of the lower row or the diagonal is used.
  void add(int row, int column, double value) {
    const auto r = static_cast<std::size_t>(blockOf[static_cast<std::size_t>(row)]);
    const auto c = static_cast<std::size_t>(blockOf[static_cast<std::size_t>(column)]);
    if (r == c) {
      blocks[r](row - starts[r], column - starts[r]) += value;
    } else if (c == r + 1) {
      towards[r](row - starts[r], column - starts[c]) += value;
    }
  }

  /// Takes an unknown out: its row and column become those of the unit matrix.
  void fix(int unknown) {
    const auto b = static_cast<std::size_t>(blockOf[static_cast<std::size_t>(unknown)]);
    const Eigen::Index at = unknown - starts[b];
    blocks[b].row(at).setZero();
    blocks[b].col(at).setZero();
    blocks[b](at, at) = 1.0;
    if (b > 0) {
      towards[b - 1].col(at).setZero();
    }
    if (b < towards.size()) {
      towards[b].row(at).setZero();
    }
  }

  [[nodiscard]] double meanDiagonal() const {
    double sum = 0.0;
    for (const Eigen::MatrixXd& block : blocks) {
      sum += block.diagonal().cwiseAbs().sum();
    }
    return sum / static_cast<double>(starts.back());
  }

  /// Factorises the matrix with `more` on its diagonal; false when it is not positive definite.
  [[nodiscard]] bool factorise(double more, const std::function<void()>& check) {
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      if (check) {
        check();
      }
      blocks[k].diagonal().array() += more;
      if (k > 0) {
        blocks[k].selfadjointView<Eigen::Lower>().rankUpdate(towards[k - 1].transpose(), -1.0);
      }
      const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(blocks[k]);
      if (factor.info() != Eigen::Success) {
        return false;
      }
      if (k + 1 < blocks.size()) {
        blocks[k].triangularView<Eigen::Lower>().solveInPlace(towards[k]);
      }
    }
    return true;
  }

  [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd x) const {
    const auto part = [&](std::size_t k) { return x.segment(starts[k], starts[k + 1] - starts[k]); };
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      if (k > 0) {
        part(k) -= towards[k - 1].transpose() * part(k - 1);
      }
      Eigen::VectorXd y = part(k);
      blocks[k].triangularView<Eigen::Lower>().solveInPlace(y);
      part(k) = y;
    }
    for (std::size_t k = blocks.size(); k-- > 0;) {
      if (k + 1 < blocks.size()) {
        part(k) -= towards[k] * part(k + 1);
      }
      Eigen::VectorXd y = part(k);
      blocks[k].triangularView<Eigen::Lower>().transpose().solveInPlace(y);
      part(k) = y;
    }
    return x;
  }
};

Equilibrium::Equilibrium(const ElasticBody& body, TwistEnds ends, std::span<const Vec3> rest_m,
                         std::function<void()> check)
    : body_(body),
      ends_(std::move(ends)),
      rest_m_(rest_m.begin(), rest_m.end()),
      check_(std::move(check)),
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
  numberUnknowns();
  residual_.resize(static_cast<std::size_t>(unknowns_));
}

void Equilibrium::numberLevel(std::span<const int> nodes, bool turned) {
  const int block = static_cast<int>(linear_->starts.size()) - 1;
  for (const int node : nodes) {
    if (unknownOf_[static_cast<std::size_t>(node)] != kTurnedNode) {
      unknownOf_[static_cast<std::size_t>(node)] = unknowns_;
      unknowns_ += 3;
    }
  }
  if (turned) {
    turn_ = unknowns_;
    unknowns_ += turnUnknowns();
  }
  linear_->blockOf.resize(static_cast<std::size_t>(unknowns_), block);
  if (unknowns_ > linear_->starts.back()) {
    linear_->starts.push_back(unknowns_);
  }
}

void Equilibrium::numberUnknowns() {
  std::vector<std::vector<int>> elementsOf(unknownOf_.size());
  for (std::size_t e = 0; e < body_.elements(); ++e) {
    for (const int node : body_.elementNodes(e)) {
      elementsOf[static_cast<std::size_t>(node)].push_back(static_cast<int>(e));
    }
  }
  // Level by level away from the held end: the nodes of an element lie in one level or in two that follow.
  // The turned nodes share their unknowns: they are one node, reached as soon as the first of them is.
  std::vector<char> reached(unknownOf_.size(), 0);
  std::vector<int> level = ends_.held;
  for (const int node : level) {
    reached[static_cast<std::size_t>(node)] = 1;
  }
  linear_->starts.push_back(0);
  while (!level.empty()) {
    std::vector<int> next;
    bool turned = false;
    const auto reach = [&](int node) {
      if (reached[static_cast<std::size_t>(node)] == 0) {
        reached[static_cast<std::size_t>(node)] = 1;
        next.push_back(node);
        turned = turned || unknownOf_[static_cast<std::size_t>(node)] == kTurnedNode;
      }
    };
    for (const int node : level) {
      for (const int element : elementsOf[static_cast<std::size_t>(node)]) {
        for (const int other : body_.elementNodes(static_cast<std::size_t>(element))) {
          reach(other);
        }
      }
    }
    if (turned) {
      for (const int node : ends_.turned) {
        reach(node);
      }
    }
    numberLevel(next, turned);
    level = std::move(next);
  }
}

Equilibrium::~Equilibrium() = default;

bool Equilibrium::evaluate(const Load& load, const TwistPose& pose) {
  if (check_) {
    check_();
  }
  forces_N_.assign(pose.places_m.size(), Vec3{});
  energy_J_ = 0.0;
  std::array<Vec3, kMaxElementNodes> part;
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
  potential_J_ = energy_J_ - load.torque_Nm * pose.angle_rad;
  moment_Nm_ = 0.0;
  Vec3 onTurned_N;
  for (std::size_t i = 0; i < unknownOf_.size(); ++i) {
    const Vec3& f = forces_N_[i];
    if (unknownOf_[i] == kTurnedNode) {
      moment_Nm_ += dot(turningOf(ends_, pose, static_cast<int>(i)), f);
      onTurned_N += f;
    } else if (unknownOf_[i] != kHeldNode) {
      const auto at = static_cast<std::size_t>(unknownOf_[i]);
      residual_[at] = f.x, residual_[at + 1] = f.y, residual_[at + 2] = f.z;
    }
  }
  const auto turn = static_cast<std::size_t>(turn_);
  residual_[turn] = load.keepsAngle ? 0.0 : moment_Nm_ - load.torque_Nm;
  if (ends_.placeFree) {
    residual_[turn + 1] = onTurned_N.x, residual_[turn + 2] = onTurned_N.y,
                     residual_[turn + 3] = onTurned_N.z;
  }
  return std::isfinite(potential_J_);
}

void Equilibrium::shareFreedoms(const TwistPose& pose, int node, std::vector<Share>& shares,
                                std::vector<std::size_t>& starts) const {
  const int unknown = unknownOf_[static_cast<std::size_t>(node)];
  const Vec3 turning = unknown == kTurnedNode ? turningOf(ends_, pose, node) : Vec3{};
  for (int c = 0; c < 3; ++c) {
    if (unknown >= 0) {
      shares.push_back({unknown + c, 1.0});
    } else if (unknown == kTurnedNode) {
      shares.push_back({turn_, component(turning, c)});
      if (ends_.placeFree) {
        shares.push_back({turn_ + 1 + c, 1.0});
      }
    }
    starts.push_back(shares.size());
  }
}

void Equilibrium::assemble(const Load& load, const TwistPose& pose) {
  linear_->clear();
  std::vector<double> stiffness(9 * kMaxElementNodes * kMaxElementNodes);
  std::vector<Share> shares;
  std::vector<std::size_t> starts;  // of each freedom's shares, and the end
  for (std::size_t e = 0; e < body_.elements(); ++e) {
    const std::span<const int> nodes = body_.elementNodes(e);
    const std::size_t size = 3 * nodes.size();
    body_.elementStiffness(e, pose.places_m, std::span(stiffness).first(size * size));
    shares.clear();
    starts.assign(1, 0);
    for (const int node : nodes) {
      shareFreedoms(pose, node, shares, starts);
    }
    for (std::size_t column = 0; column < size; ++column) {
      for (std::size_t c = starts[column]; c < starts[column + 1]; ++c) {
        for (std::size_t row = 0; row < size; ++row) {
          const double value = shares[c].factor * stiffness[row + size * column];
          for (std::size_t r = starts[row]; r < starts[row + 1]; ++r) {
            linear_->add(shares[r].unknown, shares[c].unknown, shares[r].factor * value);
          }
        }
      }
    }
  }
  double byAngleTwice = 0.0;  // a turned node follows a circle
  for (const int node : ends_.turned) {
    byAngleTwice +=
        dot(cross(ends_.axis, turningOf(ends_, pose, node)), forces_N_[static_cast<std::size_t>(node)]);
  }
  linear_->add(turn_, turn_, byAngleTwice);
  if (load.keepsAngle) {
    linear_->fix(turn_);
  }
}

bool Equilibrium::factorise(const Load& load, const TwistPose& pose) {
  constexpr int kMaxShifts = 12;
  constexpr double kFirstShift = 1e-3;  // of the mean of the diagonal
  double shift = linear_->shift / 16.0;
  for (int attempt = 0; attempt < kMaxShifts; ++attempt) {
    assemble(load, pose);
    const double mean = linear_->meanDiagonal();
    shift = shift < 1e-6 * mean ? 0.0 : shift;
    if (linear_->factorise(shift, check_)) {
      linear_->shift = shift;
      return true;
    }
    shift = std::max(4.0 * shift, kFirstShift * mean);
  }
  return false;
}

double Equilibrium::forceScale() const {
  double held = 0.0;
  for (const int node : ends_.held) {
    const Vec3& f = forces_N_[static_cast<std::size_t>(node)];
    held += dot(f, f);
  }
  return std::sqrt(held);
}

bool Equilibrium::advance(const Load& load, std::span<const double> move, TwistPose& pose) {
  const double before_J = potential_J_;
  double slope_J = 0.0;
  double norm2 = 0.0;
  for (std::size_t i = 0; i < move.size(); ++i) {
    slope_J += residual_[i] * move[i];
    norm2 += residual_[i] * residual_[i];
  }
  const TwistPose start = pose;
  const double* turned = move.data() + turn_;
  double share = std::min(1.0, kMaxTurnAStep_rad / std::max(1e-300, std::abs(turned[0])));
  for (int i = 0; i <= kMaxStepHalvings; ++i, share *= 0.5) {
    if (ends_.placeFree) {
      pose.way_m = start.way_m + share * Vec3{turned[1], turned[2], turned[3]};
    }
    turnEnd(ends_, rest_m_, start.angle_rad + share * turned[0], pose);
    for (std::size_t n = 0; n < unknownOf_.size(); ++n) {
      if (unknownOf_[n] >= 0) {
        const double* d = move.data() + unknownOf_[n];
        pose.places_m[n] = start.places_m[n] + share * Vec3{d[0], d[1], d[2]};
      }
    }
    if (!evaluate(load, pose)) {
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
  if (!std::isfinite(torque_Nm)) {
    refuseParameter(Text::tr("The torque must be finite"), Text::tr("torque"),
                    Text::tr("Give it in newton metres"));
  }
  return find({.torque_Nm = torque_Nm}, pose);
}

EquilibriumReport Equilibrium::keepAngle(TwistPose& pose) {
  return find({.keepsAngle = true}, pose);
}

EquilibriumReport Equilibrium::find(const Load& load, TwistPose& pose) {
  const auto fail = [&] {
    refuseParameter(
        Text::tr("No equilibrium was found"),
        load.keepsAngle ? std::to_string(pose.angle_rad) + " rad" : std::to_string(load.torque_Nm) + " N m",
        Text::tr("Turn less far, or in more steps"));
  };
  if (!evaluate(load, pose)) {
    fail();
  }
  EquilibriumReport report;
  double before = 1.0;
  for (; report.iterations <= kMaxNewtonSteps; ++report.iterations) {
    const double onAngle = residual_[static_cast<std::size_t>(turn_)];
    double free = 0.0;
    for (std::size_t i = 0; i < residual_.size(); ++i) {
      free += i == static_cast<std::size_t>(turn_) ? 0.0 : residual_[i] * residual_[i];
    }
    const double scale = std::max(forceScale(), 1e-300);
    report.residual = std::sqrt(free) / scale;
    const double end = std::abs(onAngle) / std::max(std::abs(load.torque_Nm), 1e-300);
    const double worse = std::max(report.residual, end);
    if (worse <= kResidualWanted || (worse <= kResidualOfRounding && worse > 0.5 * before) ||
        (load.torque_Nm == 0.0 && energy_J_ <= kEnergyOfRounding_J)) {
      report.energy_J = energy_J_;
      report.torque_Nm = moment_Nm_;
      return report;
    }
    before = worse;
    if (!factorise(load, pose)) {
      fail();
    }
    const Eigen::VectorXd move =
        linear_->solve(-Eigen::Map<const Eigen::VectorXd>(residual_.data(), unknowns_));
    if (!move.allFinite() || !advance(load, {move.data(), static_cast<std::size_t>(unknowns_)}, pose)) {
      fail();
    }
  }
  fail();
  return report;
}

}  // namespace torsio
