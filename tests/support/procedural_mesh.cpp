// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/procedural_mesh.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "sim/core/pose.h"

namespace torsio::testing {

namespace {

using Point = std::array<double, 2>;

double side(const Point& a, const Point& b, const Point& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/// Ear clipping: triangles over the indices of a simple anticlockwise polygon.
std::vector<std::array<std::uint32_t, 3>> triangulate(const Outline2& outline) {
  std::vector<std::uint32_t> rest(outline.size());
  for (std::uint32_t i = 0; i < rest.size(); ++i) {
    rest[i] = i;
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t at = 0;
  for (std::size_t tries = 0; rest.size() > 3 && tries < 2 * rest.size();) {
    const std::uint32_t a = rest[at % rest.size()];
    const std::uint32_t b = rest[(at + 1) % rest.size()];
    const std::uint32_t c = rest[(at + 2) % rest.size()];
    bool ear = side(outline[a], outline[b], outline[c]) > 0.0;
    for (const std::uint32_t p : rest) {
      if (!ear) {
        break;
      }
      if (p == a || p == b || p == c) {
        continue;
      }
      ear = !(side(outline[a], outline[b], outline[p]) >= 0.0 &&
              side(outline[b], outline[c], outline[p]) >= 0.0 &&
              side(outline[c], outline[a], outline[p]) >= 0.0);
    }
    if (ear) {
      triangles.push_back({a, b, c});
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>((at + 1) % rest.size()));
      tries = 0;
    } else {
      ++tries;
    }
    at = (at + 1) % rest.size();
  }
  triangles.push_back({rest[0], rest[1], rest[2]});
  return triangles;
}

SweepFrame inPlane(const Vec3& centre_m, double heading_rad) {
  return {centre_m, {std::cos(heading_rad), 0, -std::sin(heading_rad)}, {0, 1, 0}, 1.0};
}

}  // namespace

Outline2 ellipseOutline(double a_m, double b_m, int points) {
  Outline2 outline;
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * kPi * i / points;
    outline.push_back({a_m * std::cos(angle), b_m * std::sin(angle)});
  }
  return outline;
}

Outline2 rectangleOutline(double width_m, double height_m, int perSide) {
  const double x = 0.5 * width_m;
  const double y = 0.5 * height_m;
  const Outline2 corners{{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  Outline2 outline;
  for (std::size_t k = 0; k < 4; ++k) {
    const Point& a = corners[k];
    const Point& b = corners[(k + 1) % 4];
    for (int i = 0; i < perSide; ++i) {
      const double t = static_cast<double>(i) / perSide;
      outline.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
    }
  }
  return outline;
}

Outline2 starOutline(int tips, double outer_m, double inner_m) {
  Outline2 outline;
  for (int i = 0; i < 2 * tips; ++i) {
    const double angle = kPi * i / tips;
    const double radius = i % 2 == 0 ? outer_m : inner_m;
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

Outline2 letterC(double radius_m, double width_m, int points) {
  Outline2 outline;
  const auto arc = [&](double radius, bool forward) {
    for (int i = 0; i <= points; ++i) {
      const double t = static_cast<double>(forward ? i : points - i) / points;
      const double angle = 0.25 * kPi + 1.5 * kPi * t;
      outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
  };
  arc(radius_m + 0.5 * width_m, true);
  arc(radius_m - 0.5 * width_m, false);
  return outline;
}

double areaOf(const Outline2& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& a = outline[i];
    const Point& b = outline[(i + 1) % outline.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * twice;
}

std::array<double, 2> centroidOf(const Outline2& outline) {
  Point sum{0.0, 0.0};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& a = outline[i];
    const Point& b = outline[(i + 1) % outline.size()];
    const double part = a[0] * b[1] - a[1] * b[0];
    sum[0] += part * (a[0] + b[0]);
    sum[1] += part * (a[1] + b[1]);
  }
  const double area = areaOf(outline);
  return {sum[0] / (6.0 * area), sum[1] / (6.0 * area)};
}

TriangleMesh sweep(const Outline2& outline, int rings, const std::function<SweepFrame(double)>& frameAt,
                   bool alternate) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  const auto last = static_cast<std::uint32_t>(rings);
  for (std::uint32_t k = 0; k <= last; ++k) {
    const SweepFrame frame = frameAt(static_cast<double>(k) / rings);
    for (const Point& p : outline) {
      mesh.vertices_m.push_back(frame.centre_m + frame.scale * (p[0] * frame.e1 + p[1] * frame.e2));
    }
  }
  for (std::uint32_t k = 0; k < last; ++k) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = k * n + i;
      const std::uint32_t b = k * n + (i + 1) % n;
      if (alternate && (k + i) % 2 == 1) {
        mesh.triangles.push_back({a, b, a + n});
        mesh.triangles.push_back({b, b + n, a + n});
      } else {
        mesh.triangles.push_back({a, b, b + n});
        mesh.triangles.push_back({a, b + n, a + n});
      }
    }
  }
  for (const auto& [a, b, c] : triangulate(outline)) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({last * n + a, last * n + b, last * n + c});
  }
  return mesh;
}

TriangleMesh prism(const Outline2& outline, double height_m, int rings, double topScale) {
  return sweep(outline, rings, [=](double t) {
    return SweepFrame{{0, 0, t * height_m}, {1, 0, 0}, {0, 1, 0}, 1.0 + t * (topScale - 1.0)};
  });
}

TriangleMesh bentTube(double radius_m, double bend_m, double angle_rad, int points, int rings) {
  return sweep(circleOutline(radius_m, points), rings, [=](double t) {
    const double turn = t * angle_rad;
    return inPlane({bend_m * (1.0 - std::cos(turn)), 0, bend_m * std::sin(turn)}, turn);
  });
}

TriangleMesh jTube(double radius_m, double straight_m, double bend_m, int points, int rings) {
  const double bow = kPi * bend_m;
  const double back = straight_m / 3.0;
  const double total = straight_m + bow + back;
  return sweep(circleOutline(radius_m, points), rings, [=](double t) {
    const double s = t * total;
    if (s <= straight_m) {
      return inPlane({0, 0, s}, 0.0);
    }
    if (s >= straight_m + bow) {
      return inPlane({2.0 * bend_m, 0, straight_m - (s - straight_m - bow)}, kPi);
    }
    const double turn = (s - straight_m) / bend_m;
    return inPlane({bend_m * (1.0 - std::cos(turn)), 0, straight_m + bend_m * std::sin(turn)}, turn);
  });
}

TriangleMesh kinkedTube(double radius_m, double leg_m, double turn_rad, int points, int rings) {
  return sweep(circleOutline(radius_m, points), 2 * rings, [=](double t) {
    const double s = (2.0 * t - 1.0) * leg_m;
    const double heading = s < 0.0 ? 0.0 : turn_rad;
    const Vec3 direction{std::sin(heading), 0, std::cos(heading)};
    // The ring at the joint is in the mitre plane between the legs.
    if (std::abs(s) < 1e-9 * leg_m) {
      SweepFrame mitre = inPlane({}, 0.5 * turn_rad);
      mitre.e1 = mitre.e1 / std::cos(0.5 * turn_rad);
      return mitre;
    }
    return inPlane(s * direction, heading);
  });
}

TriangleMesh capsule(double radius_m, double length_m, int points, int rings) {
  const double bow = 0.5 * kPi * radius_m;
  const double total = 2.0 * bow + length_m;
  return sweep(circleOutline(radius_m, points), rings, [=](double t) {
    constexpr double kTip = 0.02;  // radius of the tiny flat tips, relative to the radius
    const double s = t * total;
    double z = s - bow;
    double scale = 1.0;
    if (s < bow || s > bow + length_m) {
      const double angle = (s < bow ? s : total - s) / radius_m;
      scale = std::max(std::sin(angle), kTip);
      z = s < bow ? -radius_m * std::cos(angle) : length_m + radius_m * std::cos(angle);
    }
    return SweepFrame{{0, 0, z}, {1, 0, 0}, {0, 1, 0}, scale};
  });
}

TriangleMesh turned(TriangleMesh mesh, const Vec3& axis, double angle_rad) {
  for (Vec3& p : mesh.vertices_m) {
    p = rotateAbout(p, normalized(axis), angle_rad);
  }
  return mesh;
}

TriangleMesh shifted(TriangleMesh mesh, const Vec3& by_m) {
  for (Vec3& p : mesh.vertices_m) {
    p += by_m;
  }
  return mesh;
}

TriangleMesh mirroredX(TriangleMesh mesh) {
  for (Vec3& p : mesh.vertices_m) {
    p.x = -p.x;
  }
  for (auto& triangle : mesh.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

TriangleMesh together(TriangleMesh first, const TriangleMesh& second, const Vec3& offset_m) {
  const auto start = static_cast<std::uint32_t>(first.vertices_m.size());
  for (const Vec3& v : second.vertices_m) {
    first.vertices_m.push_back(v + offset_m);
  }
  for (const TriangleMesh::Triangle& t : second.triangles) {
    first.triangles.push_back({t[0] + start, t[1] + start, t[2] + start});
  }
  return first;
}

}  // namespace torsio::testing
