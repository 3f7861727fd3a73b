// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "sim/core/vec3.h"

namespace torsio {

/// What is drawn on it: fibres and vessels, pores and creases, folds and arcades.
enum class TissueKind : std::uint8_t { kSerosa, kSkin, kIntestine };

/// How a tissue answers to light. Chosen by the scene's id; anything unknown looks like serosa.
struct TissueLook {
  TissueKind kind = TissueKind::kSerosa;
  std::array<std::uint8_t, 3> colour{};  ///< sRGB
  float roughness = 0.5F;                ///< of the tissue itself
  float clearcoat = 0.0F;                ///< the film of moisture on it, 0 dry .. 1 wet
  float filmRoughness = 0.2F;
  float mottling = 0.1F;             ///< how far the colour wanders, 0..1
  double patch_m = 0.02;             ///< size of the largest patches of colour
  float scatter = 1.0F;              ///< how far light wanders in it, 0 stone .. 1 blood-filled tissue
  float foldDepth = 0.0F;            ///< of circular folds: steepest slope
  float poreDepth = 0.0F;            ///< of pores, mm
  float paintedRelief_mm = 0.3F;     ///< height of what is painted: fibres, pores, vessels under the skin
  std::array<float, 3> relief_mm{};  ///< height of waves of 7.3, 2.6 and 0.85 mm
  // What runs along the organ, so that its twist is seen.
  int bands = 0;               ///< pale, raised bands evenly round it from ridge 0: the taeniae of a colon
  float bandShare = 0.0F;      ///< how far their colour replaces that of the tissue, 0..1
  double bandHalf_rad = 0.13;  ///< half of their breadth, as an angle about the axis
  float borderFat = 0.0F;  ///< fat along the borders where it is attached: where there is no band of ridge 0
                           ///< and half-way round, 0..1
};

[[nodiscard]] TissueLook tissueLook(std::string_view sceneId);

/// Smooth noise in [-1, 1] that changes over a unit of `p`: the same picture on every machine.
[[nodiscard]] float tissueNoise(const Vec3& p);

/// Factor on the tissue's linear colour at a rest point: smooth noise with red and pale patches, mean
/// about 1.
[[nodiscard]] std::array<float, 3> mottle(const TissueLook& look, const Vec3& rest_m);

}  // namespace torsio
