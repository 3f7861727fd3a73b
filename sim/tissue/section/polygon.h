// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace torsio {

/// (x, y) in the plane of a section.
using Point2 = std::array<double, 2>;

/// Moments of the area inside a simple polygon, by exact edge formulas. The area is negative for a clockwise
/// polygon; the second moments are about the centroid and carry the sign of the area.
struct PolygonMoments {
  double area = 0.0;
  Point2 centroid{};
  double xx = 0.0;  ///< integral of x^2
  double xy = 0.0;  ///< integral of x y
  double yy = 0.0;  ///< integral of y^2
};

[[nodiscard]] PolygonMoments polygonMoments(std::span<const Point2> polygon);

/// Returns the length of the closed outline.
[[nodiscard]] double perimeter(std::span<const Point2> polygon);

/// Returns twice the signed area of the triangle a, b, c: positive when anticlockwise.
[[nodiscard]] inline double orientation(const Point2& a, const Point2& b, const Point2& c) noexcept {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Finds two edges (by index of their first point) of one polygon that cross, touch or run back on each
/// other; none for a simple polygon. Edges that share a point may share nothing else.
[[nodiscard]] std::optional<std::pair<int, int>> firstSelfCrossing(std::span<const Point2> polygon);

/// Finds an edge of `a` and an edge of `b` that have a point in common; none when the two do not touch.
[[nodiscard]] std::optional<std::pair<int, int>> firstCrossing(std::span<const Point2> a,
                                                               std::span<const Point2> b);

/// Tells whether `point` lies inside the polygon (a point on an edge may count as either).
[[nodiscard]] bool contains(std::span<const Point2> polygon, const Point2& point);

/// Returns the smallest sine of the angle between an edge and the ray from `centre` to one of its ends;
/// positive exactly when the anticlockwise polygon is star-shaped about `centre`, small when a ray grazes
/// an edge.
[[nodiscard]] double grazingSine(std::span<const Point2> polygon, const Point2& centre);

/// Reads the outline of a section: one point a line, `x,y` (comma, semicolon or blanks between; a decimal
/// point, whatever the locale), in any unit. Empty lines and lines that start with # are passed over, and so
/// is one line of column names before the first point. A last point that repeats the first is dropped. Throws
/// Error{kFileMissing, kFileUnreadable} when it cannot be read, Error{kBadData} that names the line for
/// anything but two finite numbers, and for fewer than 3 points.
[[nodiscard]] std::vector<Point2> readOutline(const std::filesystem::path& file);

}  // namespace torsio
