// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "sim/base/vec3.h"
#include "sim/geometry/lattice/centreline.h"
#include "sim/tissue/twist/saint_venant.h"
#include "sim/tissue/twist/twist_operation.h"

namespace torsio {

/// The organ as an operation sees it: its axis and the angle of each fine node for one newton metre.
struct OperationBase {
  const Centreline* axis = nullptr;  ///< used during construction only
  const HermiteTable* compliance = nullptr;
  /// Integral of the twist rate for one newton metre, never falling: `compliance` itself, or for the paper,
  /// whose H theta may fall, the integral of theta. On the same nodes.
  const HermiteTable* series = nullptr;
  /// Integral of ds / (E I) of the organ as a slender rod, E I = 3 G Ip / 2, which a turn about an axis
  /// across the organ bends. On the nodes of `compliance`.
  const HermiteTable* bending = nullptr;
  EndCondition ends = EndCondition::kClampedFree;
  double foundation_m = 0.0;  ///< sqrt(G J / k); 0: none
  bool paperAngles = false;   ///< `compliance` holds H theta of the paper
};

/// One operation of a pattern, prepared for queries: where along its own coordinate (arc length, or the way
/// along its straight axis, metres) the organ turns how far. Immutable; queries are noexcept,
/// allocation-free.
class PreparedOperation {
 public:
  /// Prepares `operation`, whose `index` is for messages. Throws Error{kBadParameter} for an elastic
  /// operation about an axis along which the organ does not reach.
  PreparedOperation(const TwistOperation& operation, int index, const OperationBase& base);

  [[nodiscard]] const TwistOperation& definition() const noexcept { return definition_; }
  [[nodiscard]] bool aboutCentreline() const noexcept { return definition_.axis == TwistAxis::kCentreline; }
  /// Tells whether the coordinate is the way along the straight axis; else it is the arc length.
  [[nodiscard]] bool alongAxis() const noexcept { return alongAxis_; }
  [[nodiscard]] double ratio() const noexcept { return definition_.ratio; }
  [[nodiscard]] const Vec3& origin_m() const noexcept { return definition_.axisFrom_m; }
  /// Returns the unit vector of the straight axis.
  [[nodiscard]] const Vec3& direction() const noexcept { return direction_; }
  /// Returns the way of a point along the straight axis.
  [[nodiscard]] double way(const Vec3& point_m) const noexcept {
    return dot(point_m - definition_.axisFrom_m, direction_);
  }

  /// Returns the coordinate at which the full angle is reached when the organ is grasped at this arc
  /// length.
  [[nodiscard]] double peakFor(double graspArc_m) const noexcept;
  /// Returns the share of the full angle, and its derivative with the coordinate, for a peak from peakFor.
  [[nodiscard]] ValueSlope share(double coordinate, double peak) const noexcept;
  /// Returns the share of the full angle with its slope blended over `width` about the peak, for warping.
  [[nodiscard]] ValueSlope blendedShare(double coordinate, double peak, double width) const noexcept;
  /// Returns the torque about the operation's axis for one radian at the peak, N m/rad. About a straight
  /// axis the organ answers as a rod: the component along its own centreline twists it, the rest bends it.
  /// A given profile is at least as stiff as the whole organ left to itself.
  [[nodiscard]] double stiffness(double graspArc_m) const noexcept;
  /// Returns the table of an elastic operation; of elastic operations only.
  [[nodiscard]] const TorsionTable& elastic() const noexcept { return elastic_; }
  [[nodiscard]] bool isElastic() const noexcept { return definition_.profile == TwistProfile::kElastic; }

 private:
  void prepareElastic(int index, const OperationBase& base);
  void prepareStiffness(const OperationBase& base);
  [[nodiscard]] double profileStiffness(const OperationBase& base, double peak) const;
  [[nodiscard]] double cellCompliance(const OperationBase& base, int cell) const;
  [[nodiscard]] double coordinateAt(const Centreline& axis, double arc_m) const;

  TwistOperation definition_;
  Vec3 direction_{0.0, 0.0, 1.0};
  bool alongAxis_ = false;
  double unit_m_ = 1.0;  // one fraction of the definition in metres of the coordinate
  TorsionTable elastic_;
  HermiteTable peak_;       // arc of the grasp -> coordinate of the peak
  HermiteTable stiffness_;  // arc of the grasp -> N m/rad
};

}  // namespace torsio
