// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/cli/rod_twist.h"
#include "sim/scene/hollow_validity.h"

namespace torsio::cli {

/// Contents of a hollow organ.
struct WallTwistRequest {
  double pressure_Pa = 0.0;      ///< gauge pressure now
  double restPressure_Pa = 0.0;  ///< gauge pressure at which the surface was drawn
  bool sealed = false;           ///< the gas cannot escape while the organ is twisted
  bool ofOrgan = false;          ///< the wall is the organ's own and was not asked for
};

struct WallTwistResult {
  double torque_Nm = 0.0;      ///< with folds; same sign as the angle
  double pressure_Pa = 0.0;    ///< at this angle
  double patency = 1.0;        ///< free cross-section at the waist: 1 unfolded, 0 closed
  double waist_m = 0.0;        ///< mean radius at the narrowest place
  double waistPlace = 0.5;     ///< fraction of the twisted length, from the fixed end
  double onset_rad = 0.0;      ///< angle at which the wall begins to fold
  double closing_rad = 0.0;    ///< angle at which the waist is filled with wall
  double peakTorque_Nm = 0.0;  ///< maximum before closing
  double shortening_m = 0.0;   ///< approach of free ends
  int waves = 0;               ///< number of folds around the organ
  double setUp_ms = 0.0;       ///< time to compute the table
  WallValidity validity;       ///< of the law of the wall
};

/// Converts a pressure option to pascal. Throws Error{kBadParameter} outside 0 to 100 mmHg.
[[nodiscard]] double pressureOf_Pa(const char* option, double pressure_mmHg);

/// Returns the limit that the organ of a pattern passes, of tissue or of the law of its wall, and how far
/// that law is off.
[[nodiscard]] WallValidity validityOf(const Scene& scene, const FoldReport& fold, const OrganState& state);

/// Parses `--wall`: a thickness in millimetres, or thicknesses along the organ, `0:2,0.6:3`, each a fraction
/// of the length and a thickness. Throws Error{kUsage} otherwise.
[[nodiscard]] WallMap wallMap(const std::string& words);

/// Returns the wall of a user's organ in the format of wallMap(): as scanned, otherwise its single thickness.
/// Empty: unknown.
[[nodiscard]] std::string wallWords(const Scene& scene);

/// Twists the hollow organ of a scene that `rod` has rotated, as the folded wall of a straight tube with the
/// organ's perimeters; its torque is scaled by the rod's effects of section and bend. Where the wall finds no
/// balance, or the organ's own is no thin one, `validity` says so, and the torque is that of the taut wall.
/// Throws Error{kBadParameter} for a wall that was asked for or a pressure out of range.
[[nodiscard]] WallTwistResult wallTwist(const Scene& scene, const RodTwistRequest& rod,
                                        const WallTwistRequest& request);

}  // namespace torsio::cli
