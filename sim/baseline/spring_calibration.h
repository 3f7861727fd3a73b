// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "sim/baseline/spring_lattice.h"
#include "sim/tissue/twist/twist_model.h"

namespace torsio {

/// How the common stiffness of all springs is found.
enum class Calibration {
  /// Turning every section as the membrane analogy says for a small torque T takes T^2 / (2 K), the energy it
  /// gives: the usual way. The springs then give way further, and are too soft.
  kAffine,
  /// In equilibrium the free end turns as far under a small torque as the membrane analogy says.
  kEquilibrium,
};

/// Returns the springs of a solid with the stiffness that `model` calibrates: of this organ, clamped and
/// free, twisted about its own axis. `check`: see Equilibrium. Throws as SpringLattice and Equilibrium.
[[nodiscard]] SpringLattice calibratedSprings(const SweptSolid& solid, const SectionLattice& lattice,
                                              const ElasticConstants& constants, const TwistModel& model,
                                              Calibration calibration,
                                              const std::function<void()>& check = {});

}  // namespace torsio
