// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/base/vec3.h"
#include "sim/baseline/swept_solid.h"

namespace torsio {

/// Elastic constants of a body. Lame's first constant is 2 G nu / (1 - 2 nu).
struct ElasticConstants {
  double shearModulus_Pa = 5000.0;  ///< G > 0
  double poissonRatio = 0.45;       ///< 0 <= nu < 0.5
  [[nodiscard]] double lame_Pa() const noexcept {
    return 2.0 * shearModulus_Pa * poissonRatio / (1.0 - 2.0 * poissonRatio);
  }
};

/// Checks the constants of a body. Throws Error{kBadParameter}.
void checkElasticConstants(const ElasticConstants& constants);

/// Most nodes of one element (quadratic wedge).
inline constexpr std::size_t kMostElementNodes = 18;

/// Something elastic between points: finite elements or springs. Immutable; every query may run in several
/// threads. `places_m`: where the nodes of the body are, one a node; forces are those that the nodes feel
/// from outside in equilibrium, d energy / d place.
class ElasticBody {
 public:
  ElasticBody() = default;
  ElasticBody(const ElasticBody&) = default;
  ElasticBody& operator=(const ElasticBody&) = default;
  virtual ~ElasticBody() = default;

  [[nodiscard]] virtual std::size_t elements() const noexcept = 0;
  /// Returns the numbers of the nodes of an element.
  [[nodiscard]] virtual std::span<const int> elementNodes(std::size_t element) const noexcept = 0;
  /// Computes energy (J) and nodal forces (N, one an own node) of an element; false when it is turned inside
  /// out and the law has no energy for that.
  [[nodiscard]] virtual bool elementForces(std::size_t element, std::span<const Vec3> places_m,
                                           double& energy_J, std::span<Vec3> forces_N) const = 0;
  /// Computes the tangent stiffness of an element, second derivative of its energy, N/m: square matrix of 3
  /// numbers a node, column by column.
  virtual void elementStiffness(std::size_t element, std::span<const Vec3> places_m,
                                std::span<double> stiffness) const = 0;
};

/// How a body is held: one end stands still, the other is turned as a rigid body about an axis and keeps its
/// place. The torque about that axis is the load.
struct TwistEnds {
  std::vector<int> held;
  std::vector<int> turned;
  Vec3 axisPoint_m;
  Vec3 axis;  ///< unit
};

/// Returns the ends of a swept solid: all points of its first and last section, the axis along the organ
/// through the centre of the last.
[[nodiscard]] TwistEnds twistEnds(const SweptSolid& solid);

/// A configuration: where each node is and how far the turned end has turned.
struct TwistPose {
  std::vector<Vec3> places_m;
  double angle_rad = 0.0;
};

/// Moves the turned end to `angle_rad`: each of its nodes from its place at rest.
void turnEnd(const TwistEnds& ends, std::span<const Vec3> rest_m, double angle_rad, TwistPose& pose);

}  // namespace torsio
