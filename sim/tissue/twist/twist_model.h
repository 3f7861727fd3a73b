// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/core/text.h"
#include "sim/core/vec3.h"
#include "sim/geometry/lattice/section_lattice.h"
#include "sim/tissue/section/section_solver.h"
#include "sim/tissue/twist/kriging.h"
#include "sim/tissue/twist/paper_formulation.h"
#include "sim/tissue/twist/saint_venant.h"

namespace torsio {

/// An isotropic tissue. Data with sources: assets/scenes/materials.json.
struct Material {
  std::string id;
  double shearModulus_Pa = 5000.0;  ///< G; for nearly incompressible tissue E / 3
  std::string source;               ///< where the number comes from
  std::string title;                ///< for people
  double lowest_Pa = 0.0;           ///< range of the published values
  double highest_Pa = 0.0;
};

/// Shear moduli that are computed: softer than any tissue to stiffer than cartilage. Far beyond, a torque
/// loses its digits.
inline constexpr double kSoftest_Pa = 1.0;
inline constexpr double kStiffest_Pa = 1e9;

/// Checks a shear modulus; `where` names whose it is. Throws Error{kBadParameter}.
void requireShearModulus(double shearModulus_Pa, const Text& where);

/// The two readings of the paper's equations (docs/model.md).
enum class Formulation {
  kSaintVenant,  ///< C(s) = integral ds / (G J), finite rotation, warping: the default
  kPaper,        ///< Eqs. 14, 17-23 as printed with the named fixes
};

/// What the paper's formulation interpolates between the key points.
enum class PaperInterpolation {
  kAngle,       ///< the angle along the axis: sections stay similar to themselves
  kComponents,  ///< dX, dY, dZ along each ridge (Eq. 15), straight across to the next: as printed
};

/// Centre that a section turns about; the two differ by a tilt of the section.
enum class TwistCentre {
  kCentreline,   ///< the section's centre on the organ's axis (its centroid), as in the paper
  kShearCentre,  ///< where a torque alone bends nothing
};

/// One grasp: all that changes while tissue is twisted. Trivially copyable: can be saved, replayed,
/// compared.
struct TwistState {
  double graspArc_m = 0.0;
  double graspAngle_rad = 0.0;
  friend constexpr bool operator==(const TwistState&, const TwistState&) = default;
};
static_assert(std::is_trivially_copyable_v<TwistState>);

/// Stiffness that a haptic device renders cleanly; the lever arm of the grasp force does not fall below
/// sqrt(K / cap).
inline constexpr double kStiffnessCap_N_per_m = 500.0;

struct TwistModelOptions {
  Formulation formulation = Formulation::kSaintVenant;
  EndCondition ends = EndCondition::kClampedFree;
  bool warping = true;  ///< dZ = theta psi (Saint-Venant only)

  KrigingOptions kriging{};  ///< along the organ: C(s), section properties, the paper's components
  TwistCentre centre = TwistCentre::kCentreline;
  /// sqrt(G J / k) of an elastic foundation (mesentery, skin on fascia) in organ lengths; 0: none. Sensible:
  /// 0.3-2.
  double foundationLengths = 0.0;
  TorsionCorrections corrections{};
  /// Whether a bar with free ends stretches axially by (1 + theta^2 Ip / (2 A))^(1/3). Clamped-free,
  /// Saint-Venant only.
  bool poynting = false;
  /// Shear strain at which the torque has doubled against the linear law: T = (phi / C)(1 + (gamma /
  /// this)^2); 0: linear.
  double stiffeningStrain = 0.0;
  double stiffnessCap_N_per_m = kStiffnessCap_N_per_m;
  PaperOptions paper{};
  PaperInterpolation paperInterpolation = PaperInterpolation::kAngle;
  /// Number of membrane problems solved at equal steps along the organ, whatever sections the lattice has;
  /// the properties between them are kriged. 97 is within 0.1 % of 193 on every organ shipped, whose rounded
  /// tips need them; 49 is 2 % too soft there.
  int solvedSections = 97;
  /// Most points of the outline in a membrane problem: one with more is drawn again with this many, of the
  /// same area (J within 3e-4 on a stomach of 228 points a section).
  int sectionPoints = 128;
  SectionSolverOptions sectionSolver{.rings = 4};
};

/// Effect of one state on the whole organ. For reports.
struct TwistSummary {
  double torque_Nm = 0.0;
  double maxDisplacement_m = 0.0;  ///< of a mesh vertex (Eq. 24)
  double maxRadiusGrowth = 1.0;    ///< distance from the axis, twisted over rest, largest of the key points
  double minDeterminant = 1.0;     ///< det F (local volume ratio) over the key points, warping left out
  double maxDeterminant = 1.0;
  double peakShear_Pa = 0.0;
  double peakShearStrain = 0.0;
};

/// How the organ answers one elastic twist about its own axis. Immutable after construction, copies share
/// their tables; every query below is noexcept and allocates nothing unless it says otherwise. Recordings
/// come from these double-precision functions, which use + - * /, square roots and portable_math.h only: the
/// same bits on every machine. The wide single-precision kernels serve views only (twist_model_view.h).
///
/// A grasp on a held end would need an infinite torque; it acts 0.5 % of the length inside.
class TwistModel {
 public:
  /// Builds the model. Throws Error{kBadParameter} for G <= 0, a section without area, or options out of
  /// range.
  TwistModel(const TriangleMesh& mesh, const SectionLattice& lattice, const Material& material,
             const TwistModelOptions& options);

  [[nodiscard]] const TwistModelOptions& options() const noexcept { return options_; }
  [[nodiscard]] const SectionLattice& lattice() const noexcept { return lattice_; }
  [[nodiscard]] const Material& material() const noexcept { return material_; }

  /// Returns the angle at section g for one newton metre applied there, rad/(N m) (section G: phi_g = T
  /// C_g).
  [[nodiscard]] double graspCompliance(double graspArc_m) const noexcept;
  /// Returns the torque that holds the state, N m.
  [[nodiscard]] double torque_Nm(const TwistState& state) const noexcept;
  /// Returns the state that a torque at this arc length leads to (the paper's forward problem: M_T is
  /// given). Throws Error{kBadParameter} for a torque that is not finite.
  [[nodiscard]] TwistState stateForTorque(double graspArc_m, double torque_Nm) const;
  /// Returns the twist angle at arc length s, rad.
  [[nodiscard]] double angleAt(double arc_m, const TwistState& state) const noexcept;
  /// Returns the twist rate, d angle / ds about the organ's own axis, rad/m.
  [[nodiscard]] double twistRateAt(double arc_m, const TwistState& state) const noexcept;
  /// Returns the axis that a grasp at this arc length turns about: the frame of the centreline, its centre
  /// the section's centre of twist.
  [[nodiscard]] AxisFrame graspFrame(double graspArc_m) const noexcept;
  /// Returns the tangential force on the tool that grips at `grip_m` (deformed world position), N:
  /// magnitude torque / arm, direction against the twist. Nearer to the axis than rho = sqrt(K / stiffness
  /// cap) the force falls as torque arm / rho^2, so that no displacement meets more than the cap.
  [[nodiscard]] Vec3 graspForce_N(const TwistState& state, const Vec3& grip_m) const noexcept;

  /// Maps a world point near the deformed organ back to where it would be at rest: the inverse of
  /// toDeformed_m up to rounding, as long as the point's nearest centreline point is unique.
  [[nodiscard]] Vec3 toRest_m(const Vec3& deformed_m, const TwistState& state) const noexcept;
  /// Maps a rest point of the organ (and directions with it) to its twisted place, without warping.
  [[nodiscard]] Vec3 toDeformed_m(const Vec3& rest_m, const TwistState& state) const noexcept;
  /// Tells whether farthestWay_m is finite: not for the paper's displacements, stretch, or shares beyond
  /// that of the grasp.
  [[nodiscard]] bool knowsWays() const noexcept;
  /// Returns a length that no point of the surface (vertices and triangles) goes from one state to the
  /// other, m.
  [[nodiscard]] double farthestWay_m(const TwistState& from, const TwistState& to) const noexcept;
  /// Computes all mesh vertices, twisted and warped, into `out_m`, one entry a mesh vertex.
  void deform(const TwistState& state, std::span<Vec3> out_m) const noexcept;

  /// Computes the shear stress of each patch of the lattice (Eq. 13), Pa: G |theta| times the slope of the
  /// stress function on the outline (Eq. 12). `out_Pa`: lattice().patches() entries, patch of ridge K, K +
  /// 1 and sections j, j + 1 at [j N + K].
  void patchShear(const TwistState& state, std::span<double> out_Pa) const noexcept;
  /// Returns the largest shear stress of the organ's surface, Pa; for tissue-safety limits in the tick.
  [[nodiscard]] double peakShear_Pa(const TwistState& state) const noexcept;

  /// Summarises a state. Allocates; not for the tick.
  [[nodiscard]] TwistSummary summary(const TwistState& state) const;

  struct Tables;
  /// Returns the tables, for twist_model_view.cpp.
  [[nodiscard]] const Tables& tables() const noexcept { return *tables_; }

 private:
  TwistModelOptions options_;
  SectionLattice lattice_;
  Material material_;
  std::shared_ptr<const Tables> tables_;
};

}  // namespace torsio
