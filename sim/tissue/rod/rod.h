// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/organ_pose.h"
#include "sim/tissue/rod/restraint.h"
#include "sim/tissue/rod/rod_algebra.h"

namespace torsio {

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

}  // namespace torsio
