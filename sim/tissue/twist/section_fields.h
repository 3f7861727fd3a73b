// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "sim/geometry/lattice/section_lattice.h"

namespace torsio {

/// A point inside an outline and the area that it stands for (of either sign, so that they add up to it).
struct SectionPoint {
  Point2 place_m{};
  double weight_m2 = 0.0;
};
/// Returns the points of a quadrature over an outline that is exact for polynomials up to degree 5.
[[nodiscard]] std::vector<SectionPoint> pointsOf(std::span<const Point2> outline_m);

/// Number of powers z^n, n = 1 .. kWaves, of a harmonic field over a section: sum of their real and imaginary
/// parts, and a constant.
inline constexpr std::size_t kWaves = 6;
inline constexpr std::size_t kTerms = 2 * kWaves + 1;
using Terms = std::array<double, kTerms>;

/// Returns 1, Re z, Im z, Re z^2 ... of a point.
[[nodiscard]] inline Terms termsAt(const Point2& point) {
  Terms terms{1.0};
  double re = 1.0;
  double im = 0.0;
  for (std::size_t n = 0; n < kWaves; ++n) {
    const double next = re * point[0] - im * point[1];
    im = re * point[1] + im * point[0];
    re = next;
    terms[2 * n + 1] = re;
    terms[2 * n + 2] = im;
  }
  return terms;
}

/// Solves a x = b for a symmetric positive definite matrix by Cholesky; consumes `a`.
template <std::size_t N>
[[nodiscard]] std::array<double, N> solveSymmetric(std::array<std::array<double, N>, N>& a,
                                                   std::array<double, N> b) {
  for (std::size_t k = 0; k < N; ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      a[k][k] -= a[k][j] * a[k][j];
    }
    a[k][k] = std::sqrt(a[k][k]);
    for (std::size_t i = k + 1; i < N; ++i) {
      for (std::size_t j = 0; j < k; ++j) {
        a[i][k] -= a[i][j] * a[k][j];
      }
      a[i][k] /= a[k][k];
    }
  }
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      b[i] -= a[i][j] * b[j];
    }
    b[i] /= a[i][i];
  }
  for (std::size_t i = N; i-- > 0;) {
    for (std::size_t j = i + 1; j < N; ++j) {
      b[i] -= a[j][i] * b[j];
    }
    b[i] /= a[i][i];
  }
  return b;
}

}  // namespace torsio
