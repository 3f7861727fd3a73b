// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/core/vec3.h"

namespace torsio {

/// Piecewise cubic through (x, y) that never overshoots (Fritsch and Butland 1984); constant outside.
class MonotoneCurve {
 public:
  /// `x` strictly ascending, at least two points.
  MonotoneCurve(std::vector<double> x, std::vector<double> y);
  [[nodiscard]] double operator()(double x) const;

 private:
  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<double> slope_;
};

/// Cubic spline through points with continuous curvature, not-a-knot ends, parameter = chord length.
class SplineCurve {
 public:
  /// At least four points.
  explicit SplineCurve(const std::vector<Vec3>& points);
  [[nodiscard]] double chordLength() const { return knots_.back(); }
  [[nodiscard]] Vec3 operator()(double t) const;

 private:
  std::vector<double> knots_;
  std::vector<Vec3> points_;
  std::vector<Vec3> second_;  // second derivatives at the knots
};

/// A point of a curve with its rotation-minimising frame: e1 x e2 = tangent.
struct CurveFrame {
  double arc = 0.0;
  Vec3 centre;
  Vec3 tangent;
  Vec3 e1;
  Vec3 e2;
};

/// `count` frames at equal steps of arc length from one end to the other, by double reflection (Wang et al.
/// 2008); the first e1 is `firstE1` made perpendicular to the curve.
[[nodiscard]] std::vector<CurveFrame> framesAlong(const SplineCurve& curve, std::size_t count,
                                                  const Vec3& firstE1);

inline constexpr double kMillimetre_m = 0.001;  ///< shapes are described in millimetres and made in metres

}  // namespace torsio
