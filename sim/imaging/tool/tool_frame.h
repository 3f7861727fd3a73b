// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/imaging/scan/scan_volume.h"

namespace torsio {

inline constexpr double kToolMetre_mm = 1e3;

/// How far behind the hinge an instrument is nothing but its shaft.
inline constexpr double kBehindHinge_mm = 5.0;

/// What somebody says of where an instrument's tip, shaft and hinge are, in the axes of the scan or file it
/// comes from. Millimetres.
struct ToolPlaces {
  std::optional<Vec3> tip_mm;   ///< near its tip; none: the narrower end
  std::optional<Vec3> shaft;    ///< direction from the tip to the hand; none: found
  std::optional<Vec3> jawAxis;  ///< that the jaws turn about; none: across the broad side of the jaws
  double pivot_mm = 20.0;       ///< from the tip to the hinge of the jaws
};

/// Points of an instrument and how much of it each stands for.
struct ToolPoints {
  std::vector<Vec3> places_mm;
  std::vector<double> shares;
  double solid = 0.0;         ///< a point with a smaller share is not an end of the instrument
  double halfPoint_mm = 0.0;  ///< how far the instrument reaches beyond its last point
};

/// A line through a tool, and the frame on it.
struct ToolFrame {
  Vec3 tip_mm;
  Vec3 x;
  Vec3 y;
  Vec3 z;  ///< from the tip to the hand
  [[nodiscard]] Vec3 local_mm(const Vec3& place_mm) const {
    const Vec3 from = place_mm - tip_mm;
    return {dot(from, x), dot(from, y), dot(from, z)};
  }
};

/// Least and most of the points along a direction.
[[nodiscard]] std::pair<double, double> reachAlong(const ToolPoints& points, const Vec3& from,
                                                   const Vec3& direction);

/// Sum of the shares of the points between two places along a direction.
[[nodiscard]] double shareBetween(const ToolPoints& points, const Vec3& from, const Vec3& direction,
                                  double low_mm, double high_mm);

/// The direction across the shaft in which the jaws are broadest, which their hinge runs along when they are
/// closed.
[[nodiscard]] Vec3 broadestAcross(const ToolPoints& points, const ToolFrame& frame, double pivot_mm);

/// About where the shaft is, where that is known better than by the longest way through all points.
struct ToolLine {
  Vec3 point_mm;
  Vec3 direction;
  double within_mm = 0.0;  ///< points further from it are none of the shaft's
};

/// Finds the line of the shaft without what lies before the hinge, the tip where the points end on it, and
/// the axis of the jaws.
[[nodiscard]] ToolFrame toolFrame(const ToolPoints& points, const ToolPlaces& places,
                                  const std::optional<ToolLine>& shaft = std::nullopt);

/// Checks what is said of an instrument before anything is read; `others`: whether all else that is said is
/// in range. Throws Error{kBadParameter}.
void requireToolPlaces(const ToolPlaces& places, bool others = true);

/// Says where the hinge was assumed, and that the force knows jaws of one length only: D22.
void tellPlaces(const ToolPlaces& places, const Vec3& jawAxis, double pivot_mm,
                std::vector<ScanRemark>& remarks);

}  // namespace torsio
