// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

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

}  // namespace torsio
