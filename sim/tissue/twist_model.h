// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <type_traits>
#include <vector>

#include "sim/base/vec3.h"
#include "sim/geometry/section_lattice.h"
#include "sim/tissue/material.h"
#include "sim/tissue/twist_operation.h"

namespace torsio {

/// The two readings of the paper's equations (docs/model.md).
enum class Formulation {
  kSaintVenant,  ///< C(s) = integral ds / (G J), finite rotation, warping: the default
  kPaper,        ///< Eqs. 14, 17-23 as printed with the named fixes
};

enum class EndCondition {
  kClampedFree,  ///< fixed at s = 0, free at s = length: the arm
  kBothHeld,     ///< fixed at both ends: the stomach between cardia and pylorus
};

/// All that changes while tissue is twisted: one grasp. Trivially copyable: can be saved, replayed, compared.
struct TwistState {
  double graspArc_m = 0.0;
  double graspAngle_rad = 0.0;
  friend constexpr bool operator==(const TwistState&, const TwistState&) = default;
};
static_assert(std::is_trivially_copyable_v<TwistState>);

struct TwistModelOptions {
  Formulation formulation = Formulation::kSaintVenant;
  EndCondition ends = EndCondition::kClampedFree;
  bool warping = true;  ///< dZ = theta psi (Saint-Venant only)
  /// What a twist does, in this order; empty: one elastic operation about the centreline.
  std::vector<TwistOperation> operations;
};

/// How the organ answers a twist. Immutable after construction; every query below is noexcept and allocates
/// nothing. What the servo records comes from these double-precision functions; the wide single-precision
/// kernels of twist_kernels.h serve views only.
class TwistModel {
 public:
  /// Throws Error{kBadParameter} for G <= 0 or a section without area.
  TwistModel(const TriangleMesh& mesh, const SectionLattice& lattice, const Material& material,
             const TwistModelOptions& options);

  [[nodiscard]] const TwistModelOptions& options() const noexcept { return options_; }
  [[nodiscard]] const SectionLattice& lattice() const noexcept { return lattice_; }

  /// Angle at section g for one newton metre applied there, rad/(N m) (section G: phi_g = T C_g).
  [[nodiscard]] double graspCompliance(double graspArc_m) const noexcept;
  /// Torque that holds the state, N m.
  [[nodiscard]] double torque_Nm(const TwistState& state) const noexcept;
  /// Twist angle at arc length s, rad.
  [[nodiscard]] double angleAt(double arc_m, const TwistState& state) const noexcept;
  /// Tangential force on the tool that grips at `grip_m` (deformed world position), N: magnitude torque /
  /// arm, direction against the twist; the arm is clamped from below (stiffness cap of section G).
  [[nodiscard]] Vec3 graspForce_N(const TwistState& state, const Vec3& grip_m) const noexcept;

  /// Maps a world point near the deformed organ back to where it would be at rest.
  [[nodiscard]] Vec3 toRest_m(const Vec3& deformed_m, const TwistState& state) const noexcept;
  /// Maps a rest point of the organ (and directions with it) to its twisted place, without warping.
  [[nodiscard]] Vec3 toDeformed_m(const Vec3& rest_m, const TwistState& state) const noexcept;
  /// All mesh vertices, twisted and warped. `out_m` has one entry a mesh vertex.
  void deform(const TwistState& state, std::span<Vec3> out_m) const noexcept;

 private:
  TwistModelOptions options_;
  SectionLattice lattice_;
  Material material_;
  // ... tables
};

}  // namespace torsio
