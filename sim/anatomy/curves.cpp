// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/curves.h"

#include <algorithm>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

// Index i of the interval [x_i, x_i+1] that holds `at`.
std::size_t interval(const std::vector<double>& x, double at) {
  const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, at);
  return static_cast<std::size_t>(above - x.begin()) - 1;
}

// Solves a small dense system by Gaussian elimination with row pivots; right sides are vectors.
std::vector<Vec3> solve(std::vector<std::vector<double>> a, std::vector<Vec3> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t r = k + 1; r < n; ++r) {
      if (std::abs(a[r][k]) > std::abs(a[pivot][k])) {
        pivot = r;
      }
    }
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t r = k + 1; r < n; ++r) {
      const double factor = a[r][k] / a[k][k];
      for (std::size_t c = k; c < n; ++c) {
        a[r][c] -= factor * a[k][c];
      }
      b[r] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t c = k + 1; c < n; ++c) {
      b[k] -= a[k][c] * b[c];
    }
    b[k] = b[k] / a[k][k];
  }
  return b;
}

}  // namespace

MonotoneCurve::MonotoneCurve(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)), slope_(x_.size(), 0.0) {
  TORSIO_EXPECTS(x_.size() >= 2 && x_.size() == y_.size());
  const std::size_t last = x_.size() - 1;
  const auto width = [this](std::size_t i) { return x_[i + 1] - x_[i]; };
  const auto rise = [this, width](std::size_t i) { return (y_[i + 1] - y_[i]) / width(i); };
  for (std::size_t i = 1; i < last; ++i) {
    const double a = rise(i - 1);
    const double b = rise(i);
    if (a * b <= 0.0) {
      continue;
    }
    const double w1 = 2.0 * width(i) + width(i - 1);
    const double w2 = width(i) + 2.0 * width(i - 1);
    slope_[i] = (w1 + w2) / (w1 / a + w2 / b);
  }
  // Ends: a parabola through three points, limited so that it keeps the sign of the first rise.
  const auto end = [](double h0, double h1, double d0, double d1) {
    const double slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (slope * d0 <= 0.0) {
      return 0.0;
    }
    return d0 * d1 <= 0.0 && std::abs(slope) > std::abs(3.0 * d0) ? 3.0 * d0 : slope;
  };
  slope_[0] = last == 1 ? rise(0) : end(width(0), width(1), rise(0), rise(1));
  slope_[last] = last == 1 ? rise(0) : end(width(last - 1), width(last - 2), rise(last - 1), rise(last - 2));
}

double MonotoneCurve::operator()(double x) const {
  if (x <= x_.front()) {
    return y_.front();
  }
  if (x >= x_.back()) {
    return y_.back();
  }
  const std::size_t i = interval(x_, x);
  const double h = x_[i + 1] - x_[i];
  const double t = (x - x_[i]) / h;
  const double s = 1.0 - t;
  return s * s * (1.0 + 2.0 * t) * y_[i] + t * s * s * h * slope_[i] + t * t * (1.0 + 2.0 * s) * y_[i + 1] -
         t * t * s * h * slope_[i + 1];
}

SplineCurve::SplineCurve(const std::vector<Vec3>& points) : points_(points) {
  const std::size_t n = points.size();
  TORSIO_EXPECTS(n >= 4);
  knots_.assign(1, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    knots_.push_back(knots_.back() + norm(points[i] - points[i - 1]));
  }
  const auto h = [this](std::size_t i) { return knots_[i + 1] - knots_[i]; };
  std::vector<std::vector<double>> a(n, std::vector<double>(n, 0.0));
  std::vector<Vec3> b(n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    a[i][i - 1] = h(i - 1);
    a[i][i] = 2.0 * (h(i - 1) + h(i));
    a[i][i + 1] = h(i);
    b[i] = 6.0 * ((points[i + 1] - points[i]) / h(i) - (points[i] - points[i - 1]) / h(i - 1));
  }
  // Not-a-knot: the third derivative is continuous at the second and the last but one point.
  a[0][0] = h(1), a[0][1] = -(h(0) + h(1)), a[0][2] = h(0);
  a[n - 1][n - 3] = h(n - 2), a[n - 1][n - 2] = -(h(n - 3) + h(n - 2)), a[n - 1][n - 1] = h(n - 3);
  second_ = solve(a, b);
}

Vec3 SplineCurve::operator()(double t) const {
  const std::size_t i = interval(knots_, t);
  const double h = knots_[i + 1] - knots_[i];
  const double b = (t - knots_[i]) / h;
  const double a = 1.0 - b;
  return a * points_[i] + b * points_[i + 1] +
         (h * h / 6.0) * ((a * a * a - a) * second_[i] + (b * b * b - b) * second_[i + 1]);
}

std::vector<CurveFrame> framesAlong(const SplineCurve& curve, std::size_t count, const Vec3& firstE1) {
  TORSIO_EXPECTS(count >= 2);
  constexpr std::size_t kFine = 20000;  // chords for the arc length: error below 1e-6 mm
  std::vector<double> arc(kFine + 1, 0.0);
  const auto parameter = [&curve](double i) { return curve.chordLength() * i / static_cast<double>(kFine); };
  Vec3 previous = curve(0.0);
  for (std::size_t i = 1; i <= kFine; ++i) {
    const Vec3 point = curve(parameter(static_cast<double>(i)));
    arc[i] = arc[i - 1] + norm(point - previous);
    previous = point;
  }
  std::vector<CurveFrame> frames(count);
  constexpr double kStep = 0.5;  // half a fine chord to each side
  for (std::size_t k = 0; k < count; ++k) {
    CurveFrame& f = frames[k];
    f.arc = arc.back() * static_cast<double>(k) / static_cast<double>(count - 1);
    const std::size_t i = interval(arc, f.arc);
    const double at = static_cast<double>(i) + (f.arc - arc[i]) / (arc[i + 1] - arc[i]);
    f.centre = curve(parameter(at));
    f.tangent = normalized(curve(parameter(at + kStep)) - curve(parameter(at - kStep)));
  }
  frames[0].e1 = normalized(firstE1 - dot(firstE1, frames[0].tangent) * frames[0].tangent);
  for (std::size_t k = 1; k < count; ++k) {
    const CurveFrame& f = frames[k - 1];
    CurveFrame& g = frames[k];
    const Vec3 v1 = g.centre - f.centre;
    const Vec3 e = f.e1 - (2.0 * dot(v1, f.e1) / dot(v1, v1)) * v1;
    const Vec3 t = f.tangent - (2.0 * dot(v1, f.tangent) / dot(v1, v1)) * v1;
    const Vec3 v2 = g.tangent - t;
    const double c2 = dot(v2, v2);
    g.e1 = c2 > 0.0 ? e - (2.0 * dot(v2, e) / c2) * v2 : e;
    g.e1 = normalized(g.e1 - dot(g.e1, g.tangent) * g.tangent);
  }
  for (CurveFrame& f : frames) {
    f.e2 = cross(f.tangent, f.e1);
  }
  return frames;
}

}  // namespace torsio
