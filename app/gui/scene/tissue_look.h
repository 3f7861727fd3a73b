// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include <QColor>

#include "sim/base/vec3.h"

namespace torsio::gui {

/// How a tissue answers to light. Chosen by the scene's id; anything unknown looks like serosa.
struct TissueLook {
  QColor colour;           ///< sRGB
  float roughness = 0.5F;  ///< of the tissue itself
  float clearcoat = 0.0F;  ///< the film of moisture on it, 0 dry .. 1 wet
  float filmRoughness = 0.2F;
  float mottling = 0.1F;  ///< how far the colour wanders, 0..1
  double patch_m = 0.02;  ///< size of the largest patches of colour
};

[[nodiscard]] TissueLook tissueLook(std::string_view sceneId);

/// Factor on the tissue's linear colour at a rest point: smooth noise with red and pale patches, mean
/// about 1.
[[nodiscard]] std::array<float, 3> mottle(const TissueLook& look, const Vec3& rest_m);

}  // namespace torsio::gui
