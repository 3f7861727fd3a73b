// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "sim/tissue/rod/rod_energy.h"

namespace torsio {

/// Six numbers of a node: x, y, z of the world, turns about its own e1, e2, t.
using Freedoms = std::array<double, 6>;
using NodeVector = std::array<Freedoms, kMaxRodNodes>;
/// A 6 x 6 block, row after row.
using Block6 = std::array<double, 36>;

/// Most contacts whose stiffness enters a step; forces and energy count all of them.
inline constexpr int kMaxStiffContacts = 256;

/// The linear system of a Newton step: a block tridiagonal part P, whose row block i is coupling[i - 1]^T,
/// diagonal[i], coupling[i], less k d d^T for each contact. A contact of depth rate c = c1 - c2 (point less
/// capsule) joins distant nodes by k c c^T = 2 k (c1 c1^T + c2 c2^T) - k d d^T, d = c1 + c2; the first part
/// is a bound of it within the band and lies in P. Fixed size, for the tick.
struct RodSystem {
  int count = 0;
  NodeVector gradient{};  ///< N, N m
  std::array<Block6, kMaxRodNodes> diagonal{};
  std::array<Block6, kMaxRodNodes> coupling{};
  std::array<std::array<double, 2>, kMaxRodNodes> floors{};  ///< least pivot of a node: places, turns
  std::array<std::array<bool, 6>, kMaxRodNodes> held{};
  NodeVector reaction{};  ///< of held freedoms: what holds them there
  double contactStiffness_N_per_m = 0.0;
  int contactCount = 0;
  std::array<RodContact, kMaxStiffContacts> contacts{};
};

/// Fills gradient and stiffness (docs/model.md R.4) of `task` at `pose`. Rows of held freedoms become those
/// of the identity, with no gradient. Pivots below `pivotFloor` of the stiffness of the element beside are
/// not trusted. The stiffness of contact is its Gauss-Newton part. Real time.
void assemble(const RodTask& task, const RodPose& pose, double pivotFloor, RodSystem& system) noexcept;

/// Factorises diagonal and coupling in place (L L^T); a pivot below its floor is replaced by its size or the
/// floor, so that what is solved is positive definite. Returns the number of pivots that were negative, which
/// is the number of negative eigenvalues when no pivot was lifted before. Real time.
int factorise(RodSystem& system) noexcept;

/// Solves L L^T z = right after factorise(). Real time.
void solveFactorised(const RodSystem& system, const NodeVector& right, NodeVector& z) noexcept;

/// Vectors of solveNewton().
struct RodSearch {
  NodeVector residual{}, preconditioned{}, direction{}, bandTimesDirection{};
};

/// Finds the Newton step, stiffness . step = -gradient, after factorise(): at once without contact, otherwise
/// by at most `iterations` steps of conjugate gradients preconditioned by the band. Each of them, hence the
/// result, leads down. Real time.
void solveNewton(const RodSystem& system, int iterations, RodSearch& search, NodeVector& step) noexcept;

}  // namespace torsio
