// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/geometry/lattice/section_lattice.h"
#include "sim/tissue/twist/saint_venant.h"
#include "sim/tissue/twist/twist_model_sections.h"

namespace torsio {

/// How the sections of an organ warp while it is twisted by a torque that is the same everywhere: by p psi
/// instead of psi times the twist rate (docs/model.md R.13). p is 0 at a held end, which is flat, and follows
/// (E Iw p')' = G (Ip - J) (p - twist rate) + E V p, with Iw = integral psi^2 and V = integral (d psi / ds)^2
/// over the section, d psi / ds being how the warping changes along the organ, less its mean, which the axial
/// strain takes up. Solved once on equal steps.
class HeldWarping {
 public:
  struct Place {
    double compliance = 1.0;  ///< twist rate over T / (G J)
    /// Integral of (p / twist rate) d psi / ds; times E it couples stretch and twist.
    double stretchShift_m3 = 0.0;
  };

  /// From `first_m` to `last_m` of the lattice's arc length; `youngOverShear` = E / G > 0. `ends`: the flat
  /// ones.
  HeldWarping(const SectionLattice& lattice, const SolvedSections& sections, double first_m, double last_m,
              double youngOverShear, EndCondition ends);

  /// Interpolates linearly; `arc_m` is clamped to the ends.
  [[nodiscard]] Place at(double arc_m) const noexcept;

 private:
  double first_m_;
  double step_m_;
  std::vector<Place> places_;
};

}  // namespace torsio
