// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "sim/tissue/twist/twist_model_tables.h"

namespace torsio {

/// Width over which the twist rate changes about the grasp, in radii of the section there.
inline constexpr double kBlendPerRadius = 0.5;

/// One state of a twist as a map of space; values common to all points are computed on construction. Lives
/// on the stack of a query; noexcept, allocation-free, portable arithmetic only.
class TwistMap {
 public:
  TwistMap(const TwistModel::Tables& tables, const SectionLattice& lattice, const TwistState& state) noexcept;

  /// Tells whether nothing moves: points then come back bit by bit.
  [[nodiscard]] bool identity() const noexcept { return identity_; }
  /// Returns where a rest point with this arc length goes; `line`: centreAt(arc_m), where it is known.
  [[nodiscard]] Vec3 forward(const Vec3& rest_m, double arc_m) const noexcept;
  [[nodiscard]] Vec3 forward(const Vec3& rest_m, double arc_m, TwistLine line) const noexcept;
  [[nodiscard]] Vec3 backward(const Vec3& deformed_m) const noexcept;
  /// Returns the place of a vertex with its warping (Saint-Venant) or lift (paper).
  [[nodiscard]] Vec3 vertex(const TwistVertex& vertex) const noexcept;

  /// Returns the distance from the axis after each operation over that before it, all multiplied: 1 for
  /// finite rotations.
  [[nodiscard]] double radiusGrowth(const Vec3& rest_m, double arc_m) const noexcept;
  /// Returns the sum of the operations' angles at a point of the centreline.
  [[nodiscard]] double angle(double arc_m) const noexcept;
  /// Returns the turn per length about the organ's own axis.
  [[nodiscard]] double rate(double arc_m) const noexcept;
  /// Returns the rate of the operations about the centreline, which warp the sections; it does not jump at
  /// the grasp.
  [[nodiscard]] double warpingRate(double arc_m) const noexcept;
  /// Returns the angle of operation k at its peak.
  [[nodiscard]] double fullAngle(std::size_t k) const noexcept { return steps_[k].angle_rad; }

  /// Returns the line that the section at an arc length turns about.
  [[nodiscard]] TwistLine centreAt(double arc_m) const noexcept;

 private:
  struct Step {
    const PreparedOperation* operation = nullptr;
    double angle_rad = 0.0;  // at the peak
    double peak = 0.0;       // coordinate of the peak
  };

  [[nodiscard]] Vec3 turned(const Vec3& x, const Vec3& point, const Vec3& axis,
                            double angle_rad) const noexcept;
  [[nodiscard]] Vec3 turnedBack(const Vec3& x, const Vec3& point, const Vec3& axis,
                                double angle_rad) const noexcept;
  [[nodiscard]] static TwistLine axisOf(const Step& step, const TwistLine& centreline) noexcept;
  [[nodiscard]] double angleOf(const Step& step, const Vec3& x, double arc_m) const noexcept;
  [[nodiscard]] TwistLine carried(const TwistLine& line, const Step& step, double arc_m) const noexcept;
  [[nodiscard]] Vec3 unwound(const Vec3& deformed_m, double arc_m) const noexcept;
  [[nodiscard]] double miss(const Vec3& deformed_m, double arc_m) const noexcept;
  [[nodiscard]] double firstArc(const Vec3& deformed_m) const noexcept;
  [[nodiscard]] double searchedArc(const Vec3& deformed_m) const noexcept;
  [[nodiscard]] Vec3 stretched(const Vec3& rest_m, const TwistLine& line, double arc_m) const noexcept;
  [[nodiscard]] Vec3 unstretched(const Vec3& x, const TwistLine& line, double arc_m) const noexcept;
  [[nodiscard]] Vec3 elongation(double arc_m) const noexcept;
  [[nodiscard]] double contraction(double arc_m) const noexcept;

  const TwistModel::Tables& tables_;
  const SectionLattice& lattice_;
  std::array<Step, kMostOperations> steps_;
  std::size_t count_ = 0;
  double blend_m_ = 0.0;
  double graspArc_m_ = 0.0;
  double torquePerBar_Nm_ = 0.0;  // of the one centreline operation: lift and stretch hang on it
  bool identity_ = false;
};

}  // namespace torsio
