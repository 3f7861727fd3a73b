// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/anatomy/organ_places.h"
#include "sim/anatomy/stomach.h"
#include "sim/core/vec3.h"

namespace torsio {

/// Thickness of the wall at a share of the length from the pylorus (0) to the top of the fundus (1).
struct WallThickness {
  double share = 0.0;
  double thickness_mm = 0.0;
};

/// The stomach with what belongs to it. Metres, LPS.
struct WholeStomach {
  TubeOrgan organ;
  double length_mm = 0.0;  ///< of the centreline from the pylorus to the top of the fundus
  Vec3 cardia_m;           ///< middle of the opening of the oesophagus
  Vec3 oesophagus;         ///< direction of its stub, outwards
  /// Ten; angles from the lesser curvature over the front.
  std::vector<OrganPlace> markers;
  std::vector<OrganPlace> landmarks;   ///< others of the anatomy
  std::vector<WallThickness> wall;     ///< ascending shares
  std::vector<Vec3> greaterOmentum_m;  ///< where it is fixed, pylorus to fundus
  std::vector<Vec3> lesserOmentum_m;   ///< pylorus to cardia
  std::vector<Vec3> zeroLine_m;        ///< lesser curvature, pylorus to cardia
};

/// Draws the J-shaped stomach with stub of the oesophagus, cardia, angle of His, a fundus that rises above
/// the cardia, incisura angularis, antrum, pylorus and bulb of the duodenum: fixed at the pylorus, the top of
/// the fundus free. `edges`: as for makeIntestine().
[[nodiscard]] WholeStomach makeWholeStomach(double edges = 1.0);

}  // namespace torsio
