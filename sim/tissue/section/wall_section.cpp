// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/section/wall_section.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/core/short_number.h"
#include "sim/tissue/section/section_outline.h"

namespace torsio {

namespace {

constexpr double kMaxOfRadius = 0.45;   // t / R beyond which the middle line says nothing
constexpr double kSharpestMitre = 0.3;  // 1 + cos of the turn at a corner of the inner outline

// Edges and normals of a closed polygon, anticlockwise.
class Loop {
 public:
  explicit Loop(std::span<const Point2> points) : points_(points) {}

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] const Point2& point(std::size_t i) const { return points_[i % points_.size()]; }
  [[nodiscard]] double edge(std::size_t i) const {
    return length({point(i + 1)[0] - point(i)[0], point(i + 1)[1] - point(i)[1]});
  }
  /// Inward normal of the edge that leaves point i.
  [[nodiscard]] Point2 normal(std::size_t i) const {
    const double l = edge(i);
    return {-(point(i + 1)[1] - point(i)[1]) / l, (point(i + 1)[0] - point(i)[0]) / l};
  }
  static double length(const Point2& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1]); }

 private:
  std::span<const Point2> points_;
};

Text unitRemedy(const SaidUnit& said) {
  return said.name.empty() ? Text::verbatim("Give the thickness in the unit of the outline.")
                           : Text::verbatim("Give the thickness in %1.", std::string(said.name));
}

void checkThickness(std::span<const double> thickness, std::size_t points, const SaidUnit& said) {
  if (thickness.size() != 1 && thickness.size() != points) {
    refuseParameter(Text::verbatim("%1 thicknesses for %2 points of the outline",
                                   std::to_string(thickness.size()), std::to_string(points)),
                    Text::verbatim("wall"), Text::verbatim("Give one thickness, or one for each point."));
  }
  for (const double t : thickness) {
    if (!(t > 0.0) || !std::isfinite(t)) {
      refuseParameter(Text::verbatim("the wall is %1 thick, but must be thicker than 0", said.length(t)),
                      Text::verbatim("wall"), unitRemedy(said));
    }
  }
}

// Least radius of curvature of a convex corner, from the turn over the mean of the edges beside it.
double leastConvexRadius(const Loop& loop) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 before = loop.normal(i + loop.size() - 1);
    const Point2 after = loop.normal(i);
    const double sine = before[0] * after[1] - before[1] * after[0];
    if (sine > 0.0) {
      least = std::min(least, 0.5 * (loop.edge(i + loop.size() - 1) + loop.edge(i)) / sine);
    }
  }
  return least;
}

// Smallest chord from the middle of an edge along its inward normal to the other side.
double narrowestPlace(const Loop& loop) {
  double narrowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 n = loop.normal(i);
    const Point2 from{0.5 * (loop.point(i)[0] + loop.point(i + 1)[0]),
                      0.5 * (loop.point(i)[1] + loop.point(i + 1)[1])};
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Point2 a{loop.point(k)[0] - from[0], loop.point(k)[1] - from[1]};
      const Point2 b{loop.point(k + 1)[0] - from[0], loop.point(k + 1)[1] - from[1]};
      const double sideA = n[0] * a[1] - n[1] * a[0];
      const double sideB = n[0] * b[1] - n[1] * b[0];
      if (k == i || (sideA > 0.0) == (sideB > 0.0)) {
        continue;
      }
      const double share = sideA / (sideA - sideB);
      const double along = n[0] * (a[0] + share * (b[0] - a[0])) + n[1] * (a[1] + share * (b[1] - a[1]));
      if (along > 0.0) {
        narrowest = std::min(narrowest, along);
      }
    }
  }
  return narrowest;
}

}  // namespace

WallMap::WallMap(std::vector<std::array<double, 2>> places) : places_(std::move(places)) {
  double before = -1.0;
  for (const auto& [share, thickness_m] : places_) {
    if (!(share >= 0.0 && share <= 1.0 && share > before && thickness_m > 0.0) ||
        !std::isfinite(thickness_m)) {
      refuseParameter(Text::verbatim("the wall is %1 mm thick at %2 of the length",
                                     std::to_string(1000.0 * thickness_m), std::to_string(share)),
                      Text::verbatim("wall"),
                      Text::verbatim("Give thicknesses above 0 at ascending shares of the length, 0 to 1."));
    }
    before = share;
  }
}

double WallMap::thickness_m(double share) const noexcept {
  if (places_.empty()) {
    return 0.0;
  }
  for (std::size_t i = 1; i < places_.size(); ++i) {
    if (share < places_[i][0]) {
      const double way = std::max(0.0, share - places_[i - 1][0]) / (places_[i][0] - places_[i - 1][0]);
      return places_[i - 1][1] + way * (places_[i][1] - places_[i - 1][1]);
    }
  }
  return places_.back()[1];
}

std::string SaidUnit::length(double length) const {
  std::string words = shortNumber(ofOutline * length);
  return name.empty() ? words : words.append(1, ' ').append(name);
}

std::string SaidUnit::area(double area) const {
  std::string words = shortNumber(ofOutline * ofOutline * area);
  return name.empty() ? words : words.append(1, ' ').append(name).append(1, '2');
}

WallSection wallSection(std::span<const Point2> outline, std::span<const double> thickness,
                        const SaidUnit& said) {
  const auto [points, given] = checkedOutline(outline);
  checkThickness(thickness, outline.size(), said);
  std::vector<double> wall;
  for (const int point : given) {
    wall.push_back(thickness[thickness.size() > 1 ? static_cast<std::size_t>(point) : 0]);
  }
  const double area = polygonMoments(points).area;
  const Loop loop(points);
  const double outer = perimeter(points);
  double swept = 0.0;      // closed integral of t ds on the outline
  double perLength = 0.0;  // of ds / t
  double strip = 0.0;      // of t^3 ds
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double t = 0.5 * (wall[i] + wall[(i + 1) % wall.size()]);
    swept += loop.edge(i) * t;
    perLength += loop.edge(i) / t;
    strip += loop.edge(i) * t * t * t;
  }
  const double mean = swept / outer;
  WallSection section;
  section.areaMid = area - 0.5 * swept + 0.25 * kPi * mean * mean;
  section.perimeterMid = outer - kPi * mean;
  section.radius = section.perimeterMid / (2.0 * kPi);
  section.thickest = *std::max_element(wall.begin(), wall.end());
  const double share = section.perimeterMid / outer;  // length of the middle line against the outline
  section.area = swept * share;
  // A wall with more in it than the outline holds lies on itself where the section is narrow.
  if (!(section.areaMid > 0.0) || !(section.thickest <= kMaxOfRadius * section.radius) ||
      !(section.area < area)) {
    refuseParameter(
        Text::verbatim("a wall %1 thick leaves no tube in a section of area %2 and perimeter %3",
                       said.length(section.thickest), said.area(area), said.length(outer)),
        Text::verbatim("wall"),
        Text::verbatim("Give a wall below 0.45 of the radius of its middle line (%1 here, where it is even) "
                       "and below half of the narrowest place, or leave it out: a filled organ.",
                       said.length(kMaxOfRadius / (1.0 + 0.5 * kMaxOfRadius) * outer / (2.0 * kPi))));
  }
  section.torsionConstant =
      4.0 * section.areaMid * section.areaMid / (perLength * share) + strip * share / 3.0;
  section.maxShear =
      section.torsionConstant / (2.0 * section.areaMid * *std::min_element(wall.begin(), wall.end()));
  if (!std::isnormal(section.torsionConstant)) {
    refuseParameter(
        Text::verbatim("a wall %1 thick is too thin to compute with", said.length(section.thickest)),
        Text::verbatim("wall"), unitRemedy(said));
  }
  section.mostThickness = std::min(leastConvexRadius(loop), 0.5 * narrowestPlace(loop));
  return section;
}

std::vector<Point2> innerOutline(std::span<const Point2> outline, double thickness) {
  const Loop loop(outline);
  std::vector<Point2> inner;
  inner.reserve(outline.size());
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 before = loop.normal(i + loop.size() - 1);
    const Point2 after = loop.normal(i);
    const double mitre = std::max(kSharpestMitre, 1.0 + before[0] * after[0] + before[1] * after[1]);
    inner.push_back({outline[i][0] + thickness * (before[0] + after[0]) / mitre,
                     outline[i][1] + thickness * (before[1] + after[1]) / mitre});
  }
  return inner;
}

}  // namespace torsio
