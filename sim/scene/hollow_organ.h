// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim/base/vec3.h"
#include "sim/geometry/lattice/section_lattice.h"
#include "sim/scene/organ_state.h"
#include "sim/tissue/hollow/wrung_organ.h"
#include "sim/tissue/perfusion/perfusion.h"

namespace torsio {

/// Wall and content of a hollow organ, as a scene file states them; a solid cord has no wall.
struct HollowWall {
  std::vector<std::array<double, 2>> thickness_m;  ///< share of the length, thickness; empty: a solid cord
  double gentLimit = 1.0;
  double restPressure_Pa = 0.0;  ///< at which the organ is drawn
  double pressure_Pa = 0.0;      ///< with which the trial begins
  bool vent = false;             ///< whether the content can be let out
  double ventedPressure_Pa = 0.0;
  std::string source;
};

/// A stretch of the organ that is wrung between a held section and the mobile part.
struct WrungSpan {
  double held = 0.0;    ///< fraction of the organ's length where it is held
  double mobile = 1.0;  ///< fraction where the mobile part begins; below `held` of a limb that ends the organ
};

/// With which twist a trial begins, drawn from its seed.
struct InitialTwist {
  double least_rad = 0.0;
  double most_rad = 0.0;
  double step_rad = 0.0;       ///< the angle is a multiple of it above `least_rad`; 0: any
  int sign = 1;                ///< usual direction: +1 or -1 about the organ's axis
  double oppositeShare = 0.0;  ///< of trials that turn the other way
  double since_s = 0.0;        ///< tissue time that it has lain so
  std::string source;
};

/// What keeps the organ twisted (docs/model.md): friction at its base, and weight and gas that turn it back.
struct BaseFriction {
  double stickShare = 0.5;    ///< mu_s: of the peak torque
  double relapseShare = 0.3;  ///< of the peak torque, towards the start, beyond relapseFrom_rad
  double relapseFrom_rad = 0.0;
  double relapseTime_s = 3.0;  ///< of a whole relapse
  std::string source;
};

/// What tissue bears, and what counts as done.
struct DetorsionLimits {
  double jawArea_m2 = 12e-6;
  double jawForce_N = 6.0;  ///< of a jaw that is closed fully
  double bruise_Pa = 330e3;
  double bruise_s = 0.3;
  double tear_Pa = 660e3;
  double pull_N = 10.0;       ///< force of the hand on the organ that tears it
  double residual_rad = 0.0;  ///< least turn that counts as undone
  double patency = 0.8;
  double flow = 0.8;
  double handsOff_s = 10.0;
  std::string source;
};

/// The untwisting of a hollow organ, as a scene file states it.
struct Detorsion {
  HollowWall wall;
  std::vector<WrungSpan> spans;           ///< one, or two limbs that are wrung alike
  double cordStiffness_Nm_per_rad = 0.0;  ///< of a solid cord, in place of a wall
  InitialTwist start;
  PerfusionParameters vessels;
  BaseFriction base;
  DetorsionLimits limits;
  double timeScale = 60.0;  ///< seconds of the tissue for a second of the hand
  double pause_s = 0.0;     ///< of the tissue, after each turn, where the goal is a gradual one; 0: none
  std::string validity;     ///< in plain words: what of this is measured, sourced, assumed
};

/// A hollow organ that came twisted: its mobile part turns as a whole, the spans beside it are wrung.
/// Immutable after construction; queries are noexcept and allocate nothing.
class HollowOrgan {
 public:
  struct Parts {
    const SectionLattice* lattice = nullptr;
    double shearModulus_Pa = 0.0;
    Detorsion detorsion;
  };
  /// Solves the tables of the spans; at most 1 s. Throws Error{kBadParameter}.
  explicit HollowOrgan(const Parts& parts);

  [[nodiscard]] const Detorsion& detorsion() const noexcept { return detorsion_; }
  [[nodiscard]] const Perfusion& vessels() const noexcept { return vessels_; }
  /// Returns how the organ lies at the start of a trial with this seed.
  [[nodiscard]] OrganState start(std::uint64_t seed) const;
  /// Returns the torque that holds the mobile part against the wrung spans alone, N m.
  [[nodiscard]] double torque_Nm(double angle_rad, double pressure_Pa) const noexcept;
  /// Returns the largest torque on the way to closing, N m.
  [[nodiscard]] double peakTorque_Nm(double pressure_Pa) const noexcept;
  /// Returns the free cross-section of the narrowest place.
  [[nodiscard]] double patency(double angle_rad, double pressure_Pa) const noexcept;
  /// Returns the angles at which folds begin and at which the narrowest place is closed.
  [[nodiscard]] double onset_rad(double pressure_Pa) const;
  [[nodiscard]] double closing_rad(double pressure_Pa) const noexcept;
  /// Returns the span that a place belongs to, -1 of the mobile part; and where in it, 0 held to 1 mobile.
  struct Place {
    int span = -1;
    double share = 1.0;
  };
  [[nodiscard]] Place placeOf(double arc_m) const noexcept;
  /// Returns how far the section at an arc length is turned, rad, and its mean radius against rest.
  struct Section {
    double turn_rad = 0.0;
    double radius = 1.0;
  };
  [[nodiscard]] Section sectionAt(double arc_m, const OrganState& state) const noexcept;
  /// Returns the wrung tube of a span; null of a cord.
  [[nodiscard]] const WrungOrgan* tube(int span) const noexcept;

 private:
  Detorsion detorsion_;
  Perfusion vessels_;
  std::vector<WrungOrgan> tubes_;
  double length_m_ = 0.0;
};

}  // namespace torsio
