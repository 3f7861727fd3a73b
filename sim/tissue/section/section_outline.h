// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "sim/tissue/section/plane_mesh.h"
#include "sim/tissue/section/polygon.h"

namespace torsio {

/// A boundary loop with the way back to the points that were given.
struct SampledLoop {
  BoundaryLoop boundary;        ///< every point of the loop, long edges divided
  std::vector<int> sampleOf;    ///< per given point: its place in `boundary`
  std::vector<int> corners;     ///< places in `boundary` of the loop's own points, ascending
  std::vector<double> turn;     ///< per corner: sine of the turn, positive where the material is convex
  std::vector<bool> sharpTurn;  ///< per corner: turns by 90 degrees or more
};

/// A section prepared for the solvers: checked, moved to its centroid and scaled to an outline area of 1,
/// so that metres and unit shapes run through the same numbers.
struct SectionShape {
  double unit = 1.0;  ///< given length = unit x length here
  Point2 origin{};    ///< centroid of the material, in given coordinates
  SampledLoop outline;
  std::vector<SampledLoop> holes;
  std::vector<double> holeAreas;  ///< positive
  double area = 0.0;              ///< of the material
  double polarMoment = 0.0;       ///< of the material about the centroid
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

/// A polygon's own points, anticlockwise: of points that repeat, the first.
struct OwnPoints {
  std::vector<Point2> points;
  std::vector<int> given;  ///< per point: which of the given ones, from 0
};

/// Checks an outline as prepareSection does.
[[nodiscard]] OwnPoints checkedOutline(std::span<const Point2> outline);

/// Checks outline and holes and divides long edges so that the outline has about `outlinePoints` points;
/// given points are never left out, because the polygon is the section. Throws Error{kBadParameter} that
/// names the loop, the point or the edges (counted from 1).
[[nodiscard]] SectionShape prepareSection(std::span<const Point2> outline,
                                          std::span<const std::vector<Point2>> holes, int outlinePoints);

}  // namespace torsio
