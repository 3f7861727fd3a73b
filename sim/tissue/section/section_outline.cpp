// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/section/section_outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "sim/core/error.h"

namespace torsio {

namespace {

/// Points closer than this part of the extent are one point (slices of a mesh repeat points up to rounding).
constexpr double kSamePoint = 1e-9;
/// Area below this part of the squared perimeter: no torsion problem left that numbers could solve.
constexpr double kLeastArea = 1e-7;
/// J grows with the fourth power of a length: beyond this it overflows.
constexpr double kWidest = 1e75;
constexpr double kNarrowest = 1e-75;

/// One loop while it is checked: its own points, anticlockwise, and what became of each given point.
struct CheckedLoop {
  std::string name;
  std::vector<Point2> points;
  std::vector<int> given;  // per own point: the given point (from 0)
  std::vector<int> ownOf;  // per given point: the own point
  PolygonMoments moments;  // after turning anticlockwise
};

std::string edgeName(const CheckedLoop& loop, int edge, std::size_t givenCount) {
  const std::size_t own = static_cast<std::size_t>(edge);
  const int a = loop.given[own] + 1;
  const int b = loop.given[(own + 1) % loop.points.size()] + 1;
  // An outline given clockwise was turned round: name the edge by its lower end, as the file has it.
  const bool closing =
      std::abs(a - b) != 1 && (a == 1 || b == 1) && std::max(a, b) == static_cast<int>(givenCount);
  const int first = closing ? std::max(a, b) : std::min(a, b);
  const int second = closing ? std::min(a, b) : std::max(a, b);
  return "edge " + std::to_string(first) + " (points " + std::to_string(first) + " and " +
         std::to_string(second) + ")";
}

double extent(std::span<const Point2> points) {
  Point2 low = points.front(), high = points.front();
  for (const Point2& p : points) {
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  return std::max(high[0] - low[0], high[1] - low[1]);
}

void checkNumbers(std::span<const Point2> points, const std::string& name) {
  if (points.size() < 3) {
    refuseParameter(
        Text::verbatim("a section needs at least 3 points, this one has %1", std::to_string(points.size())),
        name, Text::verbatim("Give the outline as a polygon"));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i][0]) || !std::isfinite(points[i][1])) {
      refuseParameter(Text::verbatim("a coordinate is not a finite number"),
                      Text::verbatim("%1, point %2", name, std::to_string(i + 1)),
                      Text::verbatim("Remove or correct the point"));
    }
  }
}

void checkExtent(std::span<const Point2> points, const std::string& name) {
  const double size = extent(points);
  if (size > kWidest || (size > 0.0 && size < kNarrowest)) {
    refuseParameter(Text::verbatim("the polygon is too large or too small to compute with"), name,
                    Text::verbatim("Give its points in another unit"));
  }
}

/// Joins points that repeat; the values at the repeated points are those of the first.
CheckedLoop joinRepeated(std::span<const Point2> points, const std::string& name) {
  CheckedLoop loop;
  loop.name = name;
  const double same = kSamePoint * extent(points);
  const auto close = [same](const Point2& a, const Point2& b) {
    return std::abs(a[0] - b[0]) <= same && std::abs(a[1] - b[1]) <= same;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (loop.points.empty() || !close(points[i], loop.points.back())) {
      loop.points.push_back(points[i]);
      loop.given.push_back(static_cast<int>(i));
    }
    loop.ownOf.push_back(static_cast<int>(loop.points.size()) - 1);
  }
  while (loop.points.size() > 1 && close(loop.points.front(), loop.points.back())) {
    const int last = static_cast<int>(loop.points.size()) - 1;
    std::replace(loop.ownOf.begin(), loop.ownOf.end(), last, 0);
    loop.points.pop_back();
    loop.given.pop_back();
  }
  return loop;
}

bool onOneLine(std::span<const Point2> points) {
  const double size = extent(points);
  std::size_t far = 0;
  double best = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double d = std::max(std::abs(points[i][0] - points[0][0]), std::abs(points[i][1] - points[0][1]));
    if (d > best) {
      best = d, far = i;
    }
  }
  return std::all_of(points.begin(), points.end(), [&](const Point2& p) {
    return std::abs(orientation(points[0], points[far], p)) <= kSamePoint * size * size;
  });
}

CheckedLoop checkLoop(std::span<const Point2> points, const std::string& name) {
  checkNumbers(points, name);
  checkExtent(points, name);
  CheckedLoop loop = joinRepeated(points, name);
  if (loop.points.size() < 3 || onOneLine(loop.points)) {
    refuseParameter(Text::verbatim("the polygon has no area"), name,
                    Text::verbatim("Give points that go round an area"));
  }
  if (const auto edges = firstSelfCrossing(loop.points)) {
    refuseParameter(Text::verbatim("the outline crosses or touches itself: %1 and %2",
                                   edgeName(loop, edges->first, points.size()),
                                   edgeName(loop, edges->second, points.size())),
                    name, Text::verbatim("List the points in order round the section"));
  }
  loop.moments = polygonMoments(loop.points);
  const double length = perimeter(loop.points);
  if (std::abs(loop.moments.area) <= kLeastArea * length * length) {
    refuseParameter(
        Text::verbatim("the polygon is too thin: its area is below 1e-7 of its squared perimeter"), name,
        Text::verbatim("Give a section that is wider"));
  }
  if (loop.moments.area < 0.0) {
    std::reverse(loop.points.begin(), loop.points.end());
    std::reverse(loop.given.begin(), loop.given.end());
    const int last = static_cast<int>(loop.points.size()) - 1;
    for (int& own : loop.ownOf) {
      own = last - own;
    }
    loop.moments = polygonMoments(loop.points);
  }
  return loop;
}

void checkHoles(const CheckedLoop& outline, const std::vector<CheckedLoop>& holes) {
  for (std::size_t k = 0; k < holes.size(); ++k) {
    const CheckedLoop& hole = holes[k];
    if (const auto edges = firstCrossing(hole.points, outline.points)) {
      refuseParameter(Text::verbatim("a hole crosses or touches the outline: its %1 and %2 of the outline",
                                     edgeName(hole, edges->first, hole.ownOf.size()),
                                     edgeName(outline, edges->second, outline.ownOf.size())),
                      hole.name, Text::verbatim("Keep holes inside the outline"));
    }
    if (!contains(outline.points, hole.points.front())) {
      refuseParameter(Text::verbatim("a hole is outside the outline"), hole.name,
                      Text::verbatim("Keep holes inside the outline"));
    }
    for (std::size_t j = 0; j < k; ++j) {
      if (firstCrossing(hole.points, holes[j].points) || contains(holes[j].points, hole.points.front()) ||
          contains(hole.points, holes[j].points.front())) {
        refuseParameter(Text::verbatim("two holes overlap: %1 and %2", holes[j].name, hole.name), hole.name,
                        Text::verbatim("Give the holes as one polygon"));
      }
    }
  }
}

/// Moves, scales, divides long edges; holes are turned clockwise so that the material is on the left.
SampledLoop sampleLoop(CheckedLoop loop, const SectionShape& shape, double spacing, bool hole) {
  if (hole) {
    std::reverse(loop.points.begin(), loop.points.end());
    const int last = static_cast<int>(loop.points.size()) - 1;
    for (int& own : loop.ownOf) {
      own = last - own;
    }
  }
  for (Point2& p : loop.points) {
    p = {(p[0] - shape.origin[0]) / shape.unit, (p[1] - shape.origin[1]) / shape.unit};
  }
  SampledLoop out;
  const std::size_t n = loop.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point2& before = loop.points[(i + n - 1) % n];
    const Point2& a = loop.points[i];
    const Point2& b = loop.points[(i + 1) % n];
    const double ux = a[0] - before[0], uy = a[1] - before[1];
    const double vx = b[0] - a[0], vy = b[1] - a[1];
    const double length = std::sqrt(vx * vx + vy * vy);
    out.corners.push_back(static_cast<int>(out.boundary.points.size()));
    out.turn.push_back((ux * vy - uy * vx) / (std::sqrt(ux * ux + uy * uy) * length));
    out.sharpTurn.push_back(ux * vx + uy * vy <= 0.0);
    const int parts = std::max(1, static_cast<int>(std::lround(length / spacing)));
    for (int k = 0; k < parts; ++k) {
      const double f = static_cast<double>(k) / parts;
      out.boundary.points.push_back({a[0] + f * vx, a[1] + f * vy});
      out.boundary.arc.push_back(out.boundary.length + f * length);
    }
    out.boundary.length += length;
  }
  for (const int own : loop.ownOf) {
    out.sampleOf.push_back(out.corners[static_cast<std::size_t>(own)]);
  }
  return out;
}

/// Moments of the material: the outline less the holes, about the common centroid, in given units.
void addMoments(SectionShape& shape, const CheckedLoop& outline, const std::vector<CheckedLoop>& holes) {
  double area = outline.moments.area, sx = 0.0, sy = 0.0;
  // About the centroid of the outline, to which the holes are near.
  for (const CheckedLoop& hole : holes) {
    area -= hole.moments.area;
    sx -= hole.moments.area * (hole.moments.centroid[0] - outline.moments.centroid[0]);
    sy -= hole.moments.area * (hole.moments.centroid[1] - outline.moments.centroid[1]);
  }
  shape.unit = std::sqrt(outline.moments.area);
  shape.origin = {outline.moments.centroid[0] + sx / area, outline.moments.centroid[1] + sy / area};
  const auto add = [&shape](const PolygonMoments& m, double sign) {
    const double dx = m.centroid[0] - shape.origin[0], dy = m.centroid[1] - shape.origin[1];
    shape.xx += sign * (m.xx + m.area * dx * dx);
    shape.xy += sign * (m.xy + m.area * dx * dy);
    shape.yy += sign * (m.yy + m.area * dy * dy);
  };
  add(outline.moments, 1.0);
  for (const CheckedLoop& hole : holes) {
    add(hole.moments, -1.0);
  }
  const double unit2 = shape.unit * shape.unit;
  shape.area = area / unit2;
  for (double* m : {&shape.xx, &shape.xy, &shape.yy}) {
    *m /= unit2 * unit2;
  }
  shape.polarMoment = shape.xx + shape.yy;
}

}  // namespace

OwnPoints checkedOutline(std::span<const Point2> outline) {
  CheckedLoop loop = checkLoop(outline, "outline");
  return {std::move(loop.points), std::move(loop.given)};
}

SectionShape prepareSection(std::span<const Point2> outline, std::span<const std::vector<Point2>> holes,
                            int outlinePoints) {
  const CheckedLoop checked = checkLoop(outline, "outline");
  std::vector<CheckedLoop> checkedHoles;
  for (std::size_t k = 0; k < holes.size(); ++k) {
    checkedHoles.push_back(checkLoop(holes[k], "hole " + std::to_string(k + 1)));
  }
  checkHoles(checked, checkedHoles);
  SectionShape shape;
  addMoments(shape, checked, checkedHoles);
  const double length = perimeter(checked.points) / shape.unit;
  double wholeLength = length;
  for (const CheckedLoop& hole : checkedHoles) {
    wholeLength += perimeter(hole.points) / shape.unit;
  }
  // On a strip or a thin tube the spacing follows the thickness, within reason.
  const double spacing =
      std::clamp(2.0 * shape.area / wholeLength, 0.25 * length / outlinePoints, length / outlinePoints);
  shape.outline = sampleLoop(checked, shape, spacing, false);
  for (const CheckedLoop& hole : checkedHoles) {
    shape.holes.push_back(sampleLoop(hole, shape, spacing, true));
    shape.holeAreas.push_back(hole.moments.area / (shape.unit * shape.unit));
  }
  return shape;
}

}  // namespace torsio
