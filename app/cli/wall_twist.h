// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/cli/rod_twist.h"

namespace torsio::cli {

/// What a hollow organ holds.
struct WallTwistRequest {
  double pressure_Pa = 0.0;      ///< over outside, now
  double restPressure_Pa = 0.0;  ///< over outside, at which the surface is drawn
  bool sealed = false;           ///< whether the gas stays inside while the organ is wrung
};

/// What the wall of a wrung organ comes to.
struct WallTwistResult {
  double torque_Nm = 0.0;      ///< with folds; the sign of the angle
  double pressure_Pa = 0.0;    ///< at this angle
  double patency = 1.0;        ///< free cross-section at the waist: 1 unfolded, 0 closed
  double waist_m = 0.0;        ///< mean radius of the wall at its narrowest place
  double waistPlace = 0.5;     ///< share of the twisted stretch, from the fixed end
  double onset_rad = 0.0;      ///< at which the wall begins to fold
  double closing_rad = 0.0;    ///< at which the waist is packed with wall
  double peakTorque_Nm = 0.0;  ///< largest on the way to closing
  double shortening_m = 0.0;   ///< by which free ends come nearer
  int waves = 0;               ///< folds round the organ
  double setUp_ms = 0.0;       ///< of the table
};

/// Reads `--wall`: a thickness in millimetres, or places of it along the organ, `0:2,0.6:3`, each a share of
/// the length and a thickness. Throws Error{kUsage} for anything else.
[[nodiscard]] WallMap wallMap(const std::string& words);

/// Returns the wall of a user's organ in the words of wallMap: what a scan showed, else its one thickness.
/// Empty: it is not known.
[[nodiscard]] std::string wallWords(const Scene& scene);

/// Wrings the hollow organ of a scene that the rod `twist` has turned: the folded wall of a straight tube
/// with the organ's perimeters, its torque scaled by what section and bend add to that of the rod. Throws
/// Error{kBadParameter} for a wall or a pressure out of range.
[[nodiscard]] WallTwistResult wallTwist(const Scene& scene, const RodTwistRequest& rod,
                                        const WallTwistRequest& request);

}  // namespace torsio::cli
