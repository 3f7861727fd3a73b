// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "sim/core/vec3.h"

namespace torsio {

/// Right-handed frame of the centreline: e1 x e2 = tangent. Rotation-minimising along a curved organ.
struct AxisFrame {
  Vec3 centre_m;
  Vec3 tangent;
  Vec3 e1;
  Vec3 e2;
};

/// The organ's axis: a smooth curve (continuous tangent) through equally spaced stations, with a frame that
/// does not turn about it. Immutable; the queries allocate nothing, throw nothing and use + - * / and square
/// roots only, so that they give the same bits on every machine.
class Centreline {
 public:
  Centreline() = default;

  /// Makes a curved centreline. `line_m` runs from the fixed to the free end, at least 2 points. The line
  /// is resampled, smoothed over `smoothing_m` (its ends stay, a straight line stays as it is) and given
  /// `intervals` equal steps with rotation-minimising frames (double reflection). The frame at the fraction
  /// `e1At` of the length has its e1 nearest to `e1`; zero: any. `arcs_m` receives the arc length of each
  /// point of `line_m`, never decreasing, 0 and the length for the ends.
  [[nodiscard]] static Centreline curved(std::span<const Vec3> line_m, double smoothing_m, int intervals,
                                         const Vec3& e1, double e1At, std::vector<double>& arcs_m);

  /// Makes a straight centreline: all frames parallel, arc length is the height above the first plane.
  /// `centres_m`: one a station, equally spaced along the unit vector `axis`, at least 2. The centres may
  /// wander sideways.
  [[nodiscard]] static Centreline straightAlong(const Vec3& axis, double length_m,
                                                std::span<const Vec3> centres_m, const Vec3& e1);

  [[nodiscard]] bool straight() const noexcept { return straight_; }
  [[nodiscard]] double length_m() const noexcept { return length_m_; }
  [[nodiscard]] std::span<const AxisFrame> stations() const noexcept { return stations_; }

  /// Returns the frame at an arc length, clamped to [0, length].
  [[nodiscard]] AxisFrame frameAt(double arc_m) const noexcept;
  /// Returns the arc length of the point of the line nearest to `point_m`; on a straight line the height of
  /// the point, clamped.
  [[nodiscard]] double nearestArc_m(const Vec3& point_m) const noexcept;

 private:
  void setSlopes();
  void transportFrames(const Vec3& e1, double e1At);
  /// Evaluates the cubic Hermite curve between station i and the next; x in 0..1.
  [[nodiscard]] Vec3 point(std::size_t i, double x) const noexcept;
  [[nodiscard]] Vec3 slope(std::size_t i, double x) const noexcept;
  [[nodiscard]] double footInInterval(std::size_t i, const Vec3& point_m) const noexcept;

  bool straight_ = false;
  double length_m_ = 0.0;
  double spacing_m_ = 1.0;
  std::vector<AxisFrame> stations_;  // equally spaced in arc length, from fixed to free end
  std::vector<Vec3> slopes_;         // d centre / d arc at each station
};

}  // namespace torsio
