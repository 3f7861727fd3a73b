// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace torsio {

enum class SectionMethod {
  kFiniteElements,    ///< quadratic elements with a rigorous bracket of J: any simple outline, any holes
  kBoundaryElements,  ///< independent of the above: the cross-check
  kAutomatic,         ///< finite elements; boundary elements where no mesh can be cut
};

/// Properties of one section by the membrane analogy, for G = 1 and unit twist rate. Lengths in the unit of
/// the outline (metres in scenes): area [L^2], torsion constant [L^4], sag [L^2 per unit q/f], psi [L^2],
/// shear [L].
struct SectionProperties {
  double area = 0.0;                   ///< of the material, S_c of Eq. 19
  std::array<double, 2> centroid{};    ///< in the outline's coordinates
  double polarMoment = 0.0;            ///< Ip about the centroid, upper bound of every J
  double torsionConstant = 0.0;        ///< J = 4 V f / q, mean of the bracket
  double torsionLower = 0.0;           ///< rigorous lower bound of J (Prandtl-Galerkin)
  double torsionUpper = 0.0;           ///< rigorous upper bound of J (warping-Galerkin)
  double sag = 0.0;                    ///< l = largest membrane height for q/f = 1
  double volume = 0.0;                 ///< membrane volume for q/f = 1, plateaus included: J / 4
  double maxShear = 0.0;               ///< largest |tau| on outline and holes for G = 1, unit twist rate
  double warpingMin = 0.0;             ///< smallest psi
  double warpingMax = 0.0;             ///< largest psi
  std::vector<double> outlineWarping;  ///< psi at each outline point given
  std::vector<double> outlineShear;    ///< |tau| at each outline point given (see solveSection)
  std::vector<std::vector<double>> holeWarping;  ///< psi at each point given, per hole
  std::vector<std::vector<double>> holeShear;    ///< |tau| at each point given, per hole
  /// Centre about which psi has no moment (integral psi x = integral psi y = 0), in the outline's
  /// coordinates. Found by finite elements only; the centroid otherwise.
  std::array<double, 2> shearCentre{};
  /// Method that was used. With boundary elements lower and upper are J minus and plus its change on twice
  /// the points, an estimate only.
  SectionMethod methodUsed = SectionMethod::kFiniteElements;
};

struct SectionSolverOptions {
  SectionMethod method = SectionMethod::kAutomatic;
  /// Number of points that the outline is brought to by dividing long edges; given points are never left
  /// out.
  int outlinePoints = 128;
  int rings = 8;  ///< of the polar mesh of a star-shaped outline
  /// Largest (upper - lower) / J, until which elements are split where needed: the mean is then within half
  /// of it, 1e-4, of the true J.
  double bracket = 2e-4;
  int maxNodes = 60000;  ///< splitting stops here; the bracket then stays wider, and stays rigorous
};

/// The two fields inside a section, for stress maps. Coordinates and units of the outline that was given.
class SectionField {
 public:
  struct Value {
    double membrane = 0.0;          ///< z for q/f = 1: the stress function is 2 G theta z (Eq. 12)
    double warping = 0.0;           ///< psi
    std::array<double, 2> shear{};  ///< (tau_xz, tau_yz) for G = 1, unit twist rate
  };
  /// Returns both fields at a point; none outside the material.
  [[nodiscard]] std::optional<Value> at(const std::array<double, 2>& point) const;

  std::vector<std::array<double, 2>> nodes;
  std::vector<std::array<int, 6>> elements;  ///< corners 0, 1, 2 anticlockwise, then the middles facing them
  std::vector<double> membrane;              ///< z per node
  std::vector<double> warping;               ///< psi per node
};

/// Solves section after section; those whose meshes agree in topology share the ordering and the symbolic
/// factorisation, which is most of the work. One thread at a time; results do not depend on the order.
class SectionSolver {
 public:
  /// Makes a solver. Throws Error{kBadParameter} for options out of range.
  explicit SectionSolver(const SectionSolverOptions& options = {});
  ~SectionSolver();
  SectionSolver(SectionSolver&&) noexcept;
  SectionSolver& operator=(SectionSolver&&) noexcept;

  /// Solves one section as solveSection does. `field` (optional): filled with the fields inside; emptied by
  /// boundary elements.
  [[nodiscard]] SectionProperties solve(std::span<const std::array<double, 2>> outline,
                                        std::span<const std::vector<std::array<double, 2>>> holes = {},
                                        SectionField* field = nullptr);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Solves lap z = -q/f = -1 (membrane, Eqs. 10-12) and lap psi = 0 (warping) on a simple polygon.
/// The polygon itself is the section: its points stay, and both bounds of J are bounds for this polygon.
/// Holes: the membrane carries a weightless plate over each hole, V and J include its plateau.
/// Shear: mean of |dPhi/dn| over the neighbourhood of a point on the outline, corrected to second order; zero
/// in a sharp convex corner; in a sharp re-entrant corner, where the exact value is infinite, the plain mean
/// over one spacing of the divided outline to either side.
/// `outline`: at least 3 points, any orientation, first point not repeated; `holes` likewise.
/// Throws Error{kBadParameter}: fewer than 3 points, not finite, crosses itself (names the edges), zero area,
/// a hole that crosses the outline, lies outside it or overlaps another.
[[nodiscard]] SectionProperties solveSection(std::span<const std::array<double, 2>> outline,
                                             const SectionSolverOptions& options = {},
                                             std::span<const std::vector<std::array<double, 2>>> holes = {});

}  // namespace torsio
