// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "sim/core/portable_math.h"
#include "sim/core/random.h"
#include "sim/tissue/section/polygon.h"

namespace torsio::shapes {

using Outline = std::vector<Point2>;

/// Points of an ellipse at equal steps of the parameter; a = b: the regular polygon.
inline Outline ellipse(int points, double a, double b, Point2 centre = {}) {
  Outline outline;
  for (int i = 0; i < points; ++i) {
    const double t = 2.0 * kPi * i / points;
    outline.push_back({centre[0] + a * std::cos(t), centre[1] + b * std::sin(t)});
  }
  return outline;
}

inline Outline circle(int points, double radius = 1.0, Point2 centre = {}) {
  return ellipse(points, radius, radius, centre);
}

/// Width x height about the origin.
inline Outline rectangle(double width, double height) {
  const double x = width / 2, y = height / 2;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

inline Outline equilateralTriangle(double side) {
  const double h = side * std::sqrt(3.0);
  return {{-side / 2, -h / 6}, {side / 2, -h / 6}, {0.0, h / 3}};
}

/// A smooth outline like that of an organ: star-shaped, no symmetry.
inline Outline organ(int points) {
  Outline outline;
  for (int i = 0; i < points; ++i) {
    const double t = 2.0 * kPi * i / points;
    const double r = 1.0 + 0.15 * std::cos(2 * t + 0.3) + 0.1 * std::cos(3 * t) + 0.05 * std::sin(5 * t);
    outline.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return outline;
}

/// An ellipse bent round the unit circle by 1.9 rad to either side: not star-shaped about any point.
inline Outline kidney(int points) {
  Outline outline;
  for (int i = 0; i < points; ++i) {
    const double t = 2.0 * kPi * i / points;
    const double along = 1.9 * std::cos(t);
    const double r = 1.0 + 0.42 * std::sin(t) * (1.0 + 0.2 * std::cos(t));
    outline.push_back({r * std::cos(along), r * std::sin(along)});
  }
  return outline;
}

/// Random radii between 0.3 and 1.3: re-entrant corners of every sharpness.
inline Outline randomStar(Random& random, int points) {
  Outline outline;
  for (int i = 0; i < points; ++i) {
    const double t = 2.0 * kPi * (i + 0.7 * random.uniform()) / points;
    const double r = 0.3 + random.uniform();
    outline.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return outline;
}

/// Random points in a box, joined by undoing crossings (each reversal shortens the way round): simple, and as
/// good as never star-shaped.
inline Outline randomSimple(Random& random, int points, double height) {
  Outline p;
  for (int i = 0; i < points; ++i) {
    const double x = random.uniform();
    p.push_back({x, height * random.uniform()});
  }
  const auto n = p.size();
  const auto way = [&](std::size_t i, std::size_t j) {
    return std::hypot(p[i % n][0] - p[j % n][0], p[i % n][1] - p[j % n][1]);
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < n && !changed; ++i) {
      for (std::size_t j = i + 2; j < n && !changed; ++j) {
        if ((j + 1) % n != i && way(i, j) + way(i + 1, j + 1) < way(i, i + 1) + way(j, j + 1) - 1e-12) {
          std::reverse(p.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                       p.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          changed = true;
        }
      }
    }
  }
  return p;
}

inline Outline moved(Outline outline, double scale, Point2 by) {
  for (Point2& p : outline) {
    p = {scale * p[0] + by[0], scale * p[1] + by[1]};
  }
  return outline;
}

inline Outline mirrored(Outline outline) {
  for (Point2& p : outline) {
    p[0] = -p[0];
  }
  return outline;
}

}  // namespace torsio::shapes
