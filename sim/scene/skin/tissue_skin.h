// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/scene/skin/skin_charts.h"
#include "sim/scene/tissue_look.h"

namespace torsio {

/// What an organ's skin looks like, painted once at rest: it sticks to the tissue however that is twisted.
struct TissueSkin {
  SkinCharts charts;
  std::vector<std::uint8_t> rgba;  ///< sRGB, rows of the map from the top; alpha: height of the relief
  std::vector<std::array<float, 3>> rest_mm;  ///< of each vertex of the mesh, view frame
  std::vector<float> arc_mm;                  ///< of each vertex, along the organ
};

/// Lays the organ flat and paints mottling, fibres and vessels on it. A fraction of a second; any thread.
[[nodiscard]] TissueSkin paintSkin(const Scene& scene, const TissueLook& look);

}  // namespace torsio
