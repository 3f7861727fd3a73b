// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/tissue_look.h"

#include <cmath>
#include <cstdint>

namespace torsio {

namespace {

/// A number in [-1, 1] for a lattice point: same picture on every machine.
float latticeNoise(std::int64_t x, std::int64_t y, std::int64_t z) {
  auto h = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15ULL;
  h ^= static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4FULL;
  h ^= static_cast<std::uint64_t>(z) * 0x165667B19E3779F9ULL;
  h ^= h >> 31U;
  h *= 0xBF58476D1CE4E5B9ULL;
  h ^= h >> 27U;
  return static_cast<float>(h >> 40U) / static_cast<float>(1ULL << 23U) - 1.0F;
}

float quintic(float t) {
  return t * t * t * (t * (6.0F * t - 15.0F) + 10.0F);
}

float blend(float a, float b, float t) {
  return a + (b - a) * t;
}

}  // namespace

float tissueNoise(const Vec3& p) {
  const double floorX = std::floor(p.x);
  const double floorY = std::floor(p.y);
  const double floorZ = std::floor(p.z);
  const auto x = static_cast<std::int64_t>(floorX);
  const auto y = static_cast<std::int64_t>(floorY);
  const auto z = static_cast<std::int64_t>(floorZ);
  const float tx = quintic(static_cast<float>(p.x - floorX));
  const float ty = quintic(static_cast<float>(p.y - floorY));
  const float tz = quintic(static_cast<float>(p.z - floorZ));
  const auto plane = [&](std::int64_t level) {
    const float near = blend(latticeNoise(x, y, level), latticeNoise(x + 1, y, level), tx);
    const float far = blend(latticeNoise(x, y + 1, level), latticeNoise(x + 1, y + 1, level), tx);
    return blend(near, far, ty);
  };
  return blend(plane(z), plane(z + 1), tz);
}

namespace {

/// Four octaves, about [-1, 1].
float patchNoise(const Vec3& p) {
  float sum = 0.0F;
  float share = 0.55F;
  double frequency = 1.0;
  for (int octave = 0; octave < 4; ++octave) {
    sum += share * tissueNoise(p * frequency);
    share *= 0.55F;
    frequency *= 2.17;
  }
  return sum;
}

/// The moist coat of the organs of the abdomen.
TissueLook serosa() {
  return {.colour = {203, 130, 120},
          .roughness = 0.46F,
          .clearcoat = 0.38F,
          .filmRoughness = 0.24F,
          .mottling = 0.48F,
          .patch_m = 0.030,
          .scatter = 1.0F,
          .relief_mm = {0.22F, 0.08F, 0.012F},
          .borderFat = 0.85F};
}

}  // namespace

TissueLook tissueLook(std::string_view sceneId) {
  if (sceneId.find("forearm") != std::string_view::npos) {
    return {.kind = TissueKind::kSkin,
            .colour = {214, 168, 146},
            .roughness = 0.52F,
            .clearcoat = 0.06F,
            .filmRoughness = 0.45F,
            .mottling = 0.16F,
            .patch_m = 0.022,
            .scatter = 0.7F,
            .poreDepth = 0.05F,
            .relief_mm = {0.10F, 0.04F, 0.03F}};
  }
  TissueLook look = serosa();
  if (sceneId.find("intestine") != std::string_view::npos ||
      sceneId.find("bowel") != std::string_view::npos) {
    look.kind = TissueKind::kIntestine;
    look.colour = {208, 136, 124};
    look.roughness = 0.44F;
    look.clearcoat = 0.42F;
    look.filmRoughness = 0.22F;
    look.mottling = 0.45F;
    look.patch_m = 0.014;
    look.foldDepth = 0.08F;
    look.relief_mm = {0.14F, 0.07F, 0.012F};
    look.bands = 1;
    look.bandShare = 0.42F;
    look.bandHalf_rad = 0.20;
    look.borderFat = 0.90F;
  } else if (sceneId.find("sigmoid") != std::string_view::npos) {
    look.colour = {203, 142, 130};
    look.mottling = 0.40F;
    look.bands = 3;
    look.bandShare = 0.75F;
    look.borderFat = 0.75F;
  } else if (sceneId.find("midgut") != std::string_view::npos) {
    look.bands = 3;  // strands of the mesentery in its stalk
    look.bandShare = 0.55F;
    look.bandHalf_rad = 0.22;
    look.borderFat = 0.6F;
  }
  return look;
}

std::array<float, 3> mottle(const TissueLook& look, const Vec3& rest_m) {
  const Vec3 p = rest_m / look.patch_m;
  const float depth = look.mottling * patchNoise(p);
  const float warmth = look.mottling * patchNoise(p * 0.63 + Vec3{17.3, -4.1, 9.7});
  // Blood lies under the surface: where there is more of it green and blue are lost, red hardly.
  return {1.0F + 0.45F * depth + 0.12F * warmth, 1.0F + 0.9F * depth - 0.55F * warmth,
          1.0F + 0.9F * depth - 0.50F * warmth};
}

}  // namespace torsio
