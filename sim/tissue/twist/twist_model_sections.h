// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/geometry/lattice/section_lattice.h"
#include "sim/tissue/section/section_solver.h"
#include "sim/tissue/twist/kriging.h"
#include "sim/tissue/twist/saint_venant.h"

namespace torsio {

/// Result of the membrane solver for one section of the organ.
struct SolvedSection {
  TorsionSection torsion;
  double sag_m2 = 0.0;
  double maxShear_m = 0.0;                ///< largest |tau| of the outline for G = 1 and unit twist rate
  std::array<double, 2> shearCentre_m{};  ///< in the section's frame
  std::vector<double> warping_m2;         ///< psi on kAngles equal steps of the ridge angle
  std::vector<double> shear_m;            ///< |tau| there
};

/// The membrane problems along an organ, solved at equal steps of the arc length, whatever sections the
/// lattice has, and kriged between them. Every property is kriged as a length or as a share of the section's
/// size, which a taper leaves linear or constant.
class SolvedSections {
 public:
  static constexpr int kAngles = 180;  ///< ridge angles of the warping and shear tables

  struct Options {
    int sections = 97;              ///< number that are solved, both ends among them
    int points = 128;               ///< an outline with more is drawn again with so many
    bool aboutShearCentre = false;  ///< psi about the shear centre instead of the frame's centre
    SectionSolverOptions solver;
    KrigingOptions kriging;
  };
  [[nodiscard]] static SolvedSections solve(const SectionLattice& lattice, const Options& options);

  [[nodiscard]] std::span<const SolvedSection> sections() const noexcept { return sections_; }
  [[nodiscard]] const SectionProfile& profile() const noexcept { return profile_; }

  [[nodiscard]] double sag_m2(double arc_m) const;
  [[nodiscard]] double maxShear_m(double arc_m) const;
  [[nodiscard]] std::array<double, 2> shearCentre_m(double arc_m) const;
  /// Returns psi on kAngles ridge angles at an arc length.
  [[nodiscard]] std::vector<double> warping_m2(double arc_m) const;
  /// Returns |tau| on kAngles ridge angles at an arc length.
  [[nodiscard]] std::vector<double> shear_m(double arc_m) const;

 private:
  SolvedSections(std::vector<double> arcs_m, std::vector<SolvedSection> sections,
                 const KrigingOptions& kriging);
  [[nodiscard]] std::vector<double> krigedRow(double arc_m, double scale,
                                              std::span<const std::vector<double>> rows) const;

  std::vector<double> arcs_m_;
  std::vector<SolvedSection> sections_;
  SectionProfile profile_;
  Kriging1d kriging_;
  std::vector<double> sagLength_;
  std::vector<double> shear_;
  std::vector<double> centreX_;
  std::vector<double> centreY_;
  std::vector<std::vector<double>> warpingShare_;  // psi / sqrt(J)
  std::vector<std::vector<double>> shearShare_;    // |tau| / J^(1/4)
};

struct TwistModelOptions;

/// Solves the sections of an organ as a twist model with these options does.
[[nodiscard]] SolvedSections solvedSections(const SectionLattice& lattice, const TwistModelOptions& options);

/// Resamples `values` at increasing `angles_rad` of [0, 2 pi) to `count` equal steps, linear between,
/// periodic.
[[nodiscard]] std::vector<double> onEqualAngles(std::span<const double> angles_rad,
                                                std::span<const double> values, int count);
/// Looks up periodically and linearly in a table over [0, 2 pi).
[[nodiscard]] double atAngle(std::span<const double> table, double angle_rad) noexcept;

}  // namespace torsio
