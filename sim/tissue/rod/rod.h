// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "sim/core/organ_pose.h"
#include "sim/tissue/rod/rod_algebra.h"

namespace torsio {

/// Spring between a point of a section and a place of the world: energy stiffness/2 (|x + R arm - anchor| -
/// slack)^2, only while it is longer than its slack. Slack 0 is a pin, more is a ligament.
struct PointSpring {
  int node = 0;
  Vec3 arm_m{};     ///< the point, in the axes of the section
  Vec3 anchor_m{};  ///< the place, world frame
  double slack_m = 0.0;
  double stiffness_N_per_m = 0.0;
};

/// Spring that turns a section back to an orientation: energy stiffness/2 |4 sigma(orientation* q)|^2, where
/// 4 |sigma| = 4 tan(angle / 4).
struct TurnSpring {
  int node = 0;
  Quat orientation{};
  double stiffness_Nm_per_rad = 0.0;
};

/// A node some of whose freedoms are held where the pose has them: x, y, z of the world, turns about its own
/// e1, e2, t.
struct HeldNode {
  int node = 0;
  std::array<bool, 6> freedoms{true, true, true, true, true, true};
};

/// All that holds a rod.
struct RodRestraints {
  std::vector<PointSpring> points;
  std::vector<TurnSpring> turns;
  std::vector<HeldNode> held;
};

/// A run of neighbouring nodes.
struct NodeRange {
  int first = 0;
  int last = 0;
  [[nodiscard]] constexpr int count() const noexcept { return last - first + 1; }
};

/// Returns the nodes within `halfWidth_m` of arc length `arc_m`, `most` at most and one at least, of a rod of
/// `elements`. What holds a section is spread over the nodes within half its radius: a single
/// node that carries a point load kinks. Real time.
template <typename Elements>
[[nodiscard]] constexpr NodeRange nodesAround(const Elements& elements, double arc_m, double halfWidth_m,
                                              int most) noexcept {
  NodeRange range{.first = 0, .last = -1};
  int nearest = 0;
  double nearest_m = 1e300;
  double at_m = 0.0;
  int node = 0;
  const auto look = [&] {
    const double apart_m = at_m < arc_m ? arc_m - at_m : at_m - arc_m;
    if (apart_m < nearest_m) {
      nearest = node;
      nearest_m = apart_m;
    }
    if (apart_m <= halfWidth_m * (1.0 + 1e-9)) {
      range = {.first = range.last < 0 ? node : range.first, .last = node};
    }
  };
  look();
  for (const auto& e : elements) {
    at_m += e.length_m;
    ++node;
    look();
  }
  if (range.last < 0) {
    return {.first = nearest, .last = nearest};
  }
  while (range.count() > most) {  // give away the end that lies further from the middle of the patch
    if (nearest - range.first > range.last - nearest) {
      ++range.first;
    } else {
      --range.last;
    }
  }
  return range;
}

/// A spring of a point of the organ, shared alike by the nodes of a patch.
struct PatchSpring {
  NodeRange nodes{};
  Vec3 point_m{};   ///< at rest, world frame
  Vec3 anchor_m{};  ///< world frame
  double slack_m = 0.0;
  double stiffness_N_per_m = 0.0;
};

/// Adds the point springs of a patch on `rest`.
void addPatchSpring(const PatchSpring& spring, const RodPose& rest, RodRestraints& restraints);

/// Adds turn springs of `stiffness_Nm_per_rad` in sum towards the orientations at rest of `nodes`.
void addPatchTurn(NodeRange nodes, double stiffness_Nm_per_rad, const RodPose& rest,
                  RodRestraints& restraints);

/// Three rows of three, row after row.
using RowMajor3 = std::array<double, 9>;

/// How far a section lets itself be bent. With bend = (kappa2, -kappa1) in 1/m,
///   z = l^(-3/2) (bend . lever + sqrt(bend^T spread bend)), l = Gamma3 / Gamma03,
/// is the normalised bend of docs/model.md (R.3); above `limit` it costs stiffness h (z - limit)^2 / 2.
struct RodBendLimit {
  std::array<double, 2> lever_m{};    ///< w-bar = -2 <xi^2> bend0
  std::array<double, 3> spread_m2{};  ///< S = 4 I / A: S11, S12, S22, positive semi-definite
  double limit = 0.40;                ///< z0 > 0
  double stiffness_N = 0.0;           ///< kb E A / 4; 0 switches the limit off
};

/// One element between two neighbouring nodes: its shape at rest and its stiffness. Strains are those of
/// rodStrain(); g and k are strains less those at rest. Stored energy of the element:
///   h/2 (g^T A g + 2 g^T X k + k^T C k) + h (axial/3) Gamma03^2 (l^2/2 + 1/l - 3/2) + the bend limit,
/// l = Gamma3 / Gamma03.
struct RodElement {
  double length_m = 0.0;                        ///< h > 0, arc length at rest
  std::array<double, 3> restStrain{0, 0, 1};    ///< Gamma0 of the shape at rest; Gamma03 > 0
  std::array<double, 3> restCurvature_per_m{};  ///< kappa0 of the shape at rest
  RowMajor3 stretch_N{};                        ///< A, symmetric: shear 1, shear 2, linear axial part
  RowMajor3 coupling_Nm{};                      ///< X: rows g, columns k
  RowMajor3 bend_Nm2{};                         ///< C, symmetric: bending 1, bending 2, torsion
  double axial_N = 0.0;                         ///< EA of the neo-Hookean axial law, beside stretch_N[8]
  RodBendLimit bendLimit{};
};

/// Moves the line of the shear force of an element from the centroid to the shear centre (e1, e2) of its
/// section: the shear strain there is Gamma + kappa x e. `shear1_N`, `shear2_N`: stiffnesses 0.9 G A.
void addShearCentre(RodElement& element, double e1_m, double e2_m) noexcept;

/// Strains of an element of length h between two poses: Gamma (shear, shear, stretch; 0, 0, 1 when straight
/// and unstretched) and kappa in 1/m (bending about e1, about e2, twist). Both in the axes of the middle.
struct RodStrain {
  Vec3 stretch;
  Vec3 curvature_per_m;
};
[[nodiscard]] inline RodStrain rodStrain(double length_m, const Pose& first, const Pose& second) noexcept {
  const Vec3 sigma = quarterTangent(conjugate(first.orientation) * second.orientation);
  const Mat3 middle = rotationMatrix(first.orientation * unitFrom(sigma));
  const double perLength = 1.0 / length_m;
  return {.stretch = transposedTimes(middle, perLength * (second.position_m - first.position_m)),
          .curvature_per_m = (4.0 * perLength * angleScale(dot(sigma, sigma)).f) * sigma};
}

/// What belongs to the whole rod. Damping and drag are assumed (docs/model.md R.11).
struct RodSettings {
  double damping_s = 0.02;                     ///< eta: strain-rate damping over stiffness
  double drag_Ns_per_m = 0.02;                 ///< of a node: makes the pose at rest unique
  double contactStiffness_N_per_m = 30'000.0;  ///< of a point of the rod on another part of itself
};

/// A pair of elements that lie apart at rest and may touch, first < second.
struct RodContactPair {
  std::int16_t first = 0;
  std::int16_t second = 0;
};

/// An organ as a chain of elements with its restraints. Immutable; may be read from any thread.
class Rod {
 public:
  /// `rest`: pose at rest of elements.size() + 1 nodes. `radii_m`: one a node, of the circle that stands for
  /// the section in contact; 0 leaves contact out. Throws ContractError when counts do not fit, a length is
  /// not positive or a restraint names no node.
  Rod(std::vector<RodElement> elements, const RodPose& rest, std::vector<double> radii_m,
      RodRestraints restraints = {}, const RodSettings& settings = {});

  [[nodiscard]] int nodeCount() const noexcept { return rest_.count; }
  [[nodiscard]] std::span<const RodElement> elements() const noexcept { return elements_; }
  [[nodiscard]] const RodPose& rest() const noexcept { return rest_; }
  [[nodiscard]] const RodRestraints& restraints() const noexcept { return restraints_; }
  [[nodiscard]] const RodSettings& settings() const noexcept { return settings_; }
  /// Returns the radius of each element's capsule.
  [[nodiscard]] std::span<const double> capsuleRadii_m() const noexcept { return capsuleRadii_m_; }
  [[nodiscard]] std::span<const RodContactPair> contactPairs() const noexcept { return contactPairs_; }

 private:
  std::vector<RodElement> elements_;
  RodPose rest_;
  RodRestraints restraints_;
  RodSettings settings_;
  std::vector<double> capsuleRadii_m_;
  std::vector<RodContactPair> contactPairs_;
};

/// Most nodes that a jaw may hold.
inline constexpr int kMaxGripNodes = 16;

/// Stiffness of the virtual coupling between hand and rod.
struct GripStiffness {
  double place_N_per_m = 100.0;  ///< 0: only turns, as about the organ's own axis
  double turn_Nm_per_rad = 1.0;  ///< assumed
};

/// One node in the jaw: where the hand was when the jaw closed, in the axes of its section.
struct GripNode {
  int node = 0;
  Vec3 arm_m;       ///< the hand's place
  Quat handToNode;  ///< orientation of the section in the axes of the hand
};

/// A closed jaw: a virtual coupling of six degrees, shared alike by the nodes within half a radius of the
/// place (a single node must not carry a point load). Trivially copyable. Energy, a node:
///   K/(2 n) |x + R arm - hand|^2 + Kr/(2 n) |4 sigma((hand handToNode)* q)|^2.
struct RodGrip {
  int count = 0;
  std::array<GripNode, kMaxGripNodes> nodes{};
  GripStiffness stiffness;
};
static_assert(std::is_trivially_copyable_v<RodGrip>);

/// Closes a jaw over the nodes within `halfWidth_m` of arc length of node `node` of `pose`, the hand standing
/// at `hand`. Real time.
[[nodiscard]] RodGrip gripAt(const Rod& rod, const RodPose& pose, int node, double halfWidth_m,
                             const Pose& hand, const GripStiffness& stiffness) noexcept;

/// What the rod does to the hand: force, and torque about the hand's place, world frame.
struct GripLoad {
  Vec3 force_N;
  Vec3 torque_Nm;
  friend constexpr bool operator==(const GripLoad&, const GripLoad&) = default;
};

/// Returns the load on the hand at `hand`. Real time.
[[nodiscard]] GripLoad gripLoad(const RodGrip& grip, const RodPose& pose, const Pose& hand) noexcept;

}  // namespace torsio
