// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/scene/skin/linear_light.h"
#include "sim/scene/tissue_look.h"

namespace torsio {

/// How the layers of a tissue are mixed.
struct TissuePalette {
  Light vessel;  ///< factor in the middle of a vessel
  float vesselShare;
  Light blush;  ///< factor round a vessel
  float blushShare;
  Light fat;   ///< colour of the fat along the borders
  Light band;  ///< colour of bands along the organ
  float fibres;
  float folds;
  float grain;
  double softness_m;  ///< how deep the vessels lie
};

/// Gives how the layers of a kind of tissue are mixed.
[[nodiscard]] TissuePalette paletteOf(TissueKind kind);

}  // namespace torsio
