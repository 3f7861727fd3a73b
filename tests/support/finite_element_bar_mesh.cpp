// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/finite_element_bar_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "sim/base/error.h"
#include "sim/base/refusal.h"

namespace torsio {
namespace {

/// Above this a factorisation takes minutes and gigabytes: a slip of the pen, not a wish.
constexpr double kMostPoints = 100'000.0;

void checkDivision(std::size_t outlinePoints, const BarDivision& division) {
  if (division.rings < 1) {
    refuseParameter(Text::verbatim("A bar needs at least 1 ring, not %1", std::to_string(division.rings)),
                    Text::verbatim("rings"), Text::verbatim("Give 1 or more"));
  }
  if (division.layers < 2) {
    refuseParameter(Text::verbatim("A bar needs at least 2 layers, not %1", std::to_string(division.layers)),
                    Text::verbatim("layers"), Text::verbatim("Give 2 or more"));
  }
  const double perLayer = 1.0 + static_cast<double>(outlinePoints) * division.rings;
  if (perLayer * (division.layers + 1.0) > kMostPoints) {
    refuseParameter(Text::verbatim("The bar would have more than 100000 points"), Text::verbatim("division"),
                    Text::verbatim("Give fewer points, rings or layers"));
  }
}

void checkOutline(std::span<const Point2> outline, double length_m) {
  if (!std::isfinite(length_m) || length_m <= 0.0) {
    refuseParameter(Text::verbatim("The length of a bar must be positive and finite"),
                    Text::verbatim("length"), Text::verbatim("Give the length in metres"));
  }
  if (outline.size() < 3) {
    refuseParameter(
        Text::verbatim("An outline needs at least 3 points, this one has %1", std::to_string(outline.size())),
        Text::verbatim("outline"), Text::verbatim("Give at least 3 points"));
  }
  const auto where = [](std::size_t i) { return "outline, point " + std::to_string(i + 1); };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (!std::isfinite(outline[i][0]) || !std::isfinite(outline[i][1])) {
      refuseParameter(Text::verbatim("A coordinate is not a finite number"), where(i),
                      Text::verbatim("Give finite coordinates in metres"));
    }
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (!(orientation({0.0, 0.0}, outline[i], outline[(i + 1) % outline.size()]) > 0.0)) {
      refuseParameter(Text::verbatim("The outline does not run anticlockwise around the axis here"), where(i),
                      Text::verbatim("Give an anticlockwise outline that is star-shaped about (0, 0)"));
    }
  }
  if (const auto crossing = firstSelfCrossing(outline)) {
    refuseParameter(Text::verbatim("The outline runs around the axis more than once"),
                    where(static_cast<std::size_t>(crossing->first)),
                    Text::verbatim("Give an outline without crossings"));
  }
}

/// Triangles of one layer, by number within the layer.
std::vector<std::array<int, 3>> layerTriangles(int count, int rings) {
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    triangles.push_back({0, 1 + i, 1 + next});
    for (int ring = 1; ring < rings; ++ring) {
      const int inner = 1 + (ring - 1) * count;
      const int outer = inner + count;
      const std::array<int, 4> quad{inner + i, outer + i, outer + next, inner + next};
      if ((i + ring) % 2 == 1) {
        triangles.push_back({quad[0], quad[1], quad[2]});
        triangles.push_back({quad[0], quad[2], quad[3]});
      } else {
        triangles.push_back({quad[0], quad[1], quad[3]});
        triangles.push_back({quad[1], quad[2], quad[3]});
      }
    }
  }
  return triangles;
}

/// The three tetrahedra of the prism over `triangle`: `step` leads from a point to the one above it. Numbers
/// grow with the layer, so on each side face the lowest is the lower of the two below.
void addTetrahedra(std::array<int, 3> triangle, int step, std::vector<std::array<int, 6>>& cells) {
  std::sort(triangle.begin(), triangle.end());
  const auto [a, b, c] = triangle;
  cells.push_back({a, b, c, c + step, 0, 0});
  cells.push_back({a, b, b + step, c + step, 0, 0});
  cells.push_back({a, a + step, b + step, c + step, 0, 0});
}

}  // namespace

BarMesh makeBarMesh(std::span<const Point2> outline, double length_m, BarElement element,
                    const BarDivision& division) {
  checkOutline(outline, length_m);
  checkDivision(outline.size(), division);
  const int count = static_cast<int>(outline.size());
  BarMesh mesh;
  mesh.cornersPerCell = element == BarElement::kWedge6 ? 6 : 4;
  mesh.pointsPerLayer = 1 + count * division.rings;
  for (int layer = 0; layer <= division.layers; ++layer) {
    const double z = length_m * layer / division.layers;
    mesh.points.push_back({0.0, 0.0, z});
    for (int ring = 1; ring <= division.rings; ++ring) {
      const double scale = static_cast<double>(ring) / division.rings;
      for (const Point2& p : outline) {
        mesh.points.push_back({scale * p[0], scale * p[1], z});
      }
    }
  }
  const std::vector<std::array<int, 3>> triangles = layerTriangles(count, division.rings);
  const int step = mesh.pointsPerLayer;
  for (int layer = 0; layer < division.layers; ++layer) {
    for (const auto& [a, b, c] : triangles) {
      const std::array<int, 3> below{a + layer * step, b + layer * step, c + layer * step};
      if (element == BarElement::kTetrahedron4) {
        addTetrahedra(below, step, mesh.cells);
      } else {
        mesh.cells.push_back(
            {below[0], below[1], below[2], below[0] + step, below[1] + step, below[2] + step});
      }
    }
  }
  return mesh;
}

}  // namespace torsio
