// SPDX-License-Identifier: GPL-3.0-or-later
// The linear algebra of a Newton step.
#include <array>
#include <cmath>
#include <cstddef>

#include "sim/tissue/rod/rod_system.h"

namespace torsio {
namespace {

Freedoms rowOf(const Block6& a, std::size_t row) noexcept {
  Freedoms values{};
  for (std::size_t c = 0; c < 6; ++c) {
    values[c] = a[6 * row + c];
  }
  return values;
}

/// A row is a whole number of the processor's registers: the triangle alone would be slower.
void subtract(double factor, const Freedoms& of, Freedoms& from) noexcept {
  for (std::size_t c = 0; c < 6; ++c) {
    from[c] -= factor * of[c];
  }
}

/// Makes `y` L^-1 y, L the factor `l` with inverse diagonal, and takes y^T y from `a` (lower triangle; what
/// lies above the diagonal is not read afterwards).
void eliminate(const Block6& l, Block6& y, Block6& a) noexcept {
  for (std::size_t r = 0; r < 6; ++r) {
    Freedoms row = rowOf(y, r);
    for (std::size_t k = 0; k < r; ++k) {
      subtract(l[6 * r + k], rowOf(y, k), row);
    }
    for (std::size_t c = 0; c < 6; ++c) {
      y[6 * r + c] = row[c] * l[7 * r];
    }
  }
  for (std::size_t r = 0; r < 6; ++r) {
    Freedoms row = rowOf(a, r);
    for (std::size_t k = 0; k < 6; ++k) {
      subtract(y[6 * k + r], rowOf(y, k), row);
    }
    for (std::size_t c = 0; c < 6; ++c) {
      a[6 * r + c] = row[c];
    }
  }
}

/// Factorises the lower triangle of `a` in place, its diagonal inverted; returns how many pivots were
/// negative.
int factoriseBlock(double* a, const std::array<double, 2>& floors) noexcept {
  int negative = 0;
  for (int r = 0; r < 6; ++r) {
    for (int c = 0; c < r; ++c) {
      double v = a[6 * r + c];
      for (int k = 0; k < c; ++k) {
        v -= a[6 * r + k] * a[6 * c + k];
      }
      a[6 * r + c] = v * a[7 * c];
    }
    double pivot = a[7 * r];
    for (int k = 0; k < r; ++k) {
      pivot -= a[6 * r + k] * a[6 * r + k];
    }
    negative += pivot < 0.0 ? 1 : 0;
    const double floor = floors[r < 3 ? 0 : 1];
    if (!(pivot > floor)) {
      pivot = pivot < -floor ? -pivot : floor;
    }
    a[7 * r] = 1.0 / std::sqrt(pivot);
  }
  return negative;
}

double product(const NodeVector& a, const NodeVector& b, std::size_t count) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      sum += a[i][k] * b[i][k];
    }
  }
  return sum;
}

void copyNodes(const NodeVector& from, std::size_t count, NodeVector& to) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    to[i] = from[i];
  }
}

/// Subtracts k d (d . p) of every contact from `v`, but for held freedoms.
void subtractContacts(const RodSystem& system, const NodeVector& p, NodeVector& v) noexcept {
  for (int c = 0; c < system.contactCount; ++c) {
    const RodContact& contact = system.contacts[static_cast<std::size_t>(c)];
    double along = 0.0;
    for (std::size_t n = 0; n < 4; ++n) {
      const Freedoms& at = p[static_cast<std::size_t>(contact.nodes[n])];
      const double size = n < 2 ? contact.shares[n] : -contact.shares[n];
      along += size * (contact.normal.x * at[0] + contact.normal.y * at[1] + contact.normal.z * at[2]);
    }
    const Vec3 push = (system.contactStiffness_N_per_m * along) * contact.normal;
    for (std::size_t n = 0; n < 4; ++n) {
      const auto node = static_cast<std::size_t>(contact.nodes[n]);
      const double size = n < 2 ? contact.shares[n] : -contact.shares[n];
      v[node][0] -= system.held[node][0] ? 0.0 : size * push.x;
      v[node][1] -= system.held[node][1] ? 0.0 : size * push.y;
      v[node][2] -= system.held[node][2] ? 0.0 : size * push.z;
    }
  }
}

}  // namespace

int factorise(RodSystem& system) noexcept {
  int negative = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(system.count); ++i) {
    if (i > 0) {
      eliminate(system.diagonal[i - 1], system.coupling[i - 1], system.diagonal[i]);
    }
    negative += factoriseBlock(system.diagonal[i].data(), system.floors[i]);
  }
  return negative;
}

void solveFactorised(const RodSystem& system, const NodeVector& right, NodeVector& z) noexcept {
  const auto count = static_cast<std::size_t>(system.count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* l = system.diagonal[i].data();
    double v[6];
    for (std::size_t r = 0; r < 6; ++r) {
      v[r] = right[i][r];
    }
    if (i > 0) {
      const double* y = system.coupling[i - 1].data();
      for (std::size_t k = 0; k < 6; ++k) {
        for (std::size_t r = 0; r < 6; ++r) {
          v[r] -= y[6 * k + r] * z[i - 1][k];
        }
      }
    }
    for (std::size_t r = 0; r < 6; ++r) {
      for (std::size_t k = 0; k < r; ++k) {
        v[r] -= l[6 * r + k] * z[i][k];
      }
      z[i][r] = v[r] * l[7 * r];
    }
  }
  for (std::size_t i = count; i-- > 0;) {
    const double* l = system.diagonal[i].data();
    if (i + 1 < count) {
      const double* y = system.coupling[i].data();
      for (std::size_t k = 0; k < 6; ++k) {
        double v = 0.0;
        for (std::size_t c = 0; c < 6; ++c) {
          v += y[6 * k + c] * z[i + 1][c];
        }
        z[i][k] -= v;
      }
    }
    for (std::size_t r = 6; r-- > 0;) {
      double v = z[i][r];
      for (std::size_t k = r + 1; k < 6; ++k) {
        v -= l[6 * k + r] * z[i][k];
      }
      z[i][r] = v * l[7 * r];
    }
  }
}

void solveNewton(const RodSystem& system, int iterations, RodSearch& search, NodeVector& step) noexcept {
  const auto count = static_cast<std::size_t>(system.count);
  NodeVector& r = search.residual;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      r[i][k] = -system.gradient[i][k];
    }
  }
  solveFactorised(system, r, step);
  if (system.contactCount == 0) {
    return;
  }
  NodeVector& z = search.preconditioned;
  NodeVector& p = search.direction;
  NodeVector& ap = search.bandTimesDirection;
  copyNodes(step, count, p);
  copyNodes(r, count, ap);
  double rz = product(r, p, count);
  const double enough = 1e-8 * rz;
  for (int n = 0; n < iterations; ++n) {
    NodeVector& curvature = z;  // z is free until the next preconditioning
    copyNodes(ap, count, curvature);
    subtractContacts(system, p, curvature);
    const double bend = product(p, curvature, count);
    if (!(bend > 0.0)) {
      return;  // what was found so far leads down; the first is the step of the band alone
    }
    const double alpha = rz / bend;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < 6; ++k) {
        step[i][k] = (n == 0 ? 0.0 : step[i][k]) + alpha * p[i][k];
        r[i][k] -= alpha * curvature[i][k];
      }
    }
    solveFactorised(system, r, z);
    const double next = product(r, z, count);
    if (!(next > enough)) {
      return;
    }
    const double beta = next / rz;
    rz = next;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < 6; ++k) {
        p[i][k] = z[i][k] + beta * p[i][k];
        ap[i][k] = r[i][k] + beta * ap[i][k];
      }
    }
  }
}

}  // namespace torsio
