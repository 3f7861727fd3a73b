// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/tissue/twist/twist_model_tables.h"

namespace torsio {

/// Width over which the twist rate changes about the grasp, in radii of the section there.
inline constexpr double kBlendPerRadius = 0.5;

/// An arc length, and by how much it misses.
struct ArcFound {
  double arc_m = 0.0;
  double miss_m = 0.0;
};

/// Looks for the arc length whose signed `miss(arc_m)` is 0 by secant steps from `from_m`, within an organ of
/// this length; the best arc length met counts. In the tick.
template <typename Miss>
[[nodiscard]] ArcFound secantSteps(const Miss& miss, double from_m, double length_m) noexcept {
  constexpr int kSteps = 12;
  constexpr double kTolerance = 1e-14;  // of the length
  constexpr double kLargestStep = 0.1;  // of the length
  double before_m = from_m;
  double missBefore_m = miss(before_m);
  ArcFound best{before_m, std::abs(missBefore_m)};
  double arc_m = std::clamp(before_m + missBefore_m, 0.0, length_m);
  for (int i = 0; i < kSteps && best.miss_m > kTolerance * length_m; ++i) {
    const double here_m = miss(arc_m);
    if (std::abs(here_m) < best.miss_m) {
      best = {arc_m, std::abs(here_m)};
    }
    const double change_m = here_m - missBefore_m;
    double next_m = change_m != 0.0 ? arc_m - here_m * (arc_m - before_m) / change_m : arc_m + here_m;
    if (!(std::abs(next_m - arc_m) <= kLargestStep * length_m)) {
      next_m = arc_m + 0.5 * here_m;
    }
    before_m = arc_m;
    missBefore_m = here_m;
    arc_m = std::clamp(next_m, 0.0, length_m);
  }
  return best;
}

/// One state of a twist as a map of space; values common to all points are computed on construction. Lives
/// on the stack of a query; noexcept, allocation-free, portable arithmetic only.
class TwistMap {
 public:
  TwistMap(const TwistModel::Tables& tables, const SectionLattice& lattice, const TwistState& state) noexcept;

  /// Tells whether nothing moves: points then come back bit by bit.
  [[nodiscard]] bool identity() const noexcept { return identity_; }
  /// Returns where a rest point with this arc length goes; `line`: centreAt(arc_m), where it is known.
  [[nodiscard]] Vec3 forward(const Vec3& rest_m, double arc_m) const noexcept;
  [[nodiscard]] Vec3 forward(const Vec3& rest_m, double arc_m, const TwistLine& line) const noexcept;
  [[nodiscard]] Vec3 backward(const Vec3& deformed_m) const noexcept;
  /// Returns the place of a vertex with its warping (Saint-Venant) or lift (paper).
  [[nodiscard]] Vec3 vertex(const TwistVertex& vertex) const noexcept;

  /// Returns the distance from the axis after the twist over that before it: 1 for finite rotations.
  [[nodiscard]] double radiusGrowth(const Vec3& rest_m, double arc_m) const noexcept;
  /// Returns the twist angle at an arc length.
  [[nodiscard]] double angle(double arc_m) const noexcept;
  /// Returns the turn per length about the organ's own axis.
  [[nodiscard]] double rate(double arc_m) const noexcept;
  /// Returns the rate that warps the sections; it does not jump at the grasp.
  [[nodiscard]] double warpingRate(double arc_m) const noexcept;
  /// Returns the line that the section at an arc length turns about.
  [[nodiscard]] TwistLine centreAt(double arc_m) const noexcept;

 private:
  [[nodiscard]] Vec3 turned(const Vec3& x, const TwistLine& axis, double angle_rad) const noexcept;
  [[nodiscard]] Vec3 turnedBack(const Vec3& x, const TwistLine& axis, double angle_rad) const noexcept;
  [[nodiscard]] double turnAt(double arc_m) const noexcept;
  [[nodiscard]] Vec3 turnedAbout(const Vec3& rest_m, const TwistVertex& vertex) const noexcept;
  [[nodiscard]] Vec3 unwound(const Vec3& deformed_m, double arc_m) const noexcept;
  [[nodiscard]] double miss(const Vec3& deformed_m, double arc_m) const noexcept;
  [[nodiscard]] Vec3 stretched(const Vec3& rest_m, const TwistLine& line, double arc_m) const noexcept;
  [[nodiscard]] Vec3 unstretched(const Vec3& x, const TwistLine& line, double arc_m) const noexcept;
  [[nodiscard]] Vec3 elongation(double arc_m) const noexcept;
  [[nodiscard]] double contraction(double arc_m) const noexcept;

  const TwistModel::Tables& tables_;
  const SectionLattice& lattice_;
  double angle_rad_ = 0.0;  // at the grasp
  double graspArc_m_ = 0.0;
  TorsionTable::Place grasp_;
  double blend_m_ = 0.0;
  double torquePerBar_Nm_ = 0.0;  // lift and stretch hang on it
  bool identity_ = false;
};

}  // namespace torsio
