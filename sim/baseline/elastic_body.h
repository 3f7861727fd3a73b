// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "sim/baseline/swept_solid.h"
#include "sim/core/vec3.h"

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
inline constexpr std::size_t kMaxElementNodes = 18;

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

/// How a body is held: one end stands still, and some of its sections are turned about an axis as one rigid
/// body. The torque about that axis is the load.
struct TwistEnds {
  std::vector<int> held;
  std::vector<int> turned;
  Vec3 axisPoint_m;
  Vec3 axis;  ///< unit
  /// Whether the turned part may move away, without tilting, as in a jaw that only turns; else it keeps its
  /// place, as a turned end does.
  bool placeFree = false;
};

/// How an organ is held and turned in a comparison.
struct TwistHold {
  /// The part that deforms, as fractions of the length: sections before it stand still, and without a jaw
  /// those beyond it turn as one. Other than 0 and 1 where an end rounds off to a tip that the rod takes for
  /// rigid (OrganRod).
  std::array<double, 2> span{0.0, 1.0};
  /// Where a jaw turns the organ, a fraction of its length, all beyond it free; none: the end is turned in
  /// its place.
  std::optional<double> grasp{};
};

/// Returns how a swept solid is held. Its held part are all sections up to the one nearest to the begin of
/// the span. Without a jaw all sections from the one nearest to the end of the span on turn about the
/// organ's tangent there through the centre of that section. A jaw turns the sections within half a local
/// radius of its grasp (the nearest one at least) as one about the tangent there, their place free: the rule
/// is nodesAround() of sim/tissue/rod/rod.h, the local radius that of the circle of the section's area.
/// Throws Error{kBadParameter} for a span or grasp outside [0, 1] and where the jaw reaches the held part.
[[nodiscard]] TwistEnds twistEnds(const SweptSolid& solid, const TwistHold& hold = {});

/// Returns how many numbers a solid that is held so has free: three a free node, and those of the turned
/// part.
[[nodiscard]] int freeUnknowns(const SweptSolid& solid, const TwistEnds& ends) noexcept;

/// A configuration: where each node is, how far the turned part has turned, and how far it has moved.
struct TwistPose {
  std::vector<Vec3> places_m;
  double angle_rad = 0.0;
  Vec3 way_m{};  ///< 0 unless the place of the turned part is free
};

/// Moves the turned part to `angle_rad` and its way: each of its nodes from its place at rest.
void turnEnd(const TwistEnds& ends, std::span<const Vec3> rest_m, double angle_rad, TwistPose& pose);

/// Returns d place / d angle of a turned node.
[[nodiscard]] inline Vec3 turningOf(const TwistEnds& ends, const TwistPose& pose, int node) noexcept {
  return cross(ends.axis, pose.places_m[static_cast<std::size_t>(node)] - pose.way_m - ends.axisPoint_m);
}

/// What a model in motion needs beside its elasticity.
struct DynamicsOptions {
  double frame_s = 1.0 / 60.0;
  double density_kg_per_m3 = 1000.0;  ///< of tissue: with G 4 kPa a twist runs 2 m/s
  /// Damping against the surroundings, a share of the momentum a second; 0: none.
  double drag_per_s = 0.0;
};

/// Returns the drag that just keeps the slowest twist of the bar from swinging: 2 omega with omega = (pi / 2)
/// sqrt(G / density) / length.
[[nodiscard]] double criticalDrag_per_s(const ElasticConstants& constants, double density_kg_per_m3,
                                        double length_m);

/// Returns the mass of each node: a quarter of each of its tetrahedra, kg.
[[nodiscard]] std::vector<double> nodeMasses(const SolidMesh& tetrahedra, std::span<const Vec3> rest_m,
                                             double density_kg_per_m3);

/// Returns the moment of inertia of the turned end about its axis, kg m^2.
[[nodiscard]] double endInertia(const TwistEnds& ends, std::span<const Vec3> rest_m,
                                std::span<const double> masses_kg);

}  // namespace torsio
