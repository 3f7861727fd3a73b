// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "sim/scene/tissue_look.h"

namespace torsio {

/// Linear red, green, blue.
using Light = std::array<float, 3>;

/// Gives the light of a colour of the screen, sRGB bytes.
[[nodiscard]] inline Light linear(const std::array<std::uint8_t, 3>& colour) {
  const auto one = [](std::uint8_t byte) {
    const double c = byte / 255.0;
    return static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  };
  return {one(colour[0]), one(colour[1]), one(colour[2])};
}

/// Gives the byte of the screen for a part of light, 0 to 1.
[[nodiscard]] inline std::uint8_t encoded(float value) {
  const double c = std::clamp(static_cast<double>(value), 0.0, 1.0);
  const double s = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(s * 255.0));
}

/// Gives encoded() of i / 4095, looked up: a map has a million pixels.
[[nodiscard]] inline const std::array<std::uint8_t, 4096>& encodedTable() {
  static const std::array<std::uint8_t, 4096> kTable = [] {
    std::array<std::uint8_t, 4096> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
      table[i] = encoded(static_cast<float>(i) / 4095.0F);
    }
    return table;
  }();
  return kTable;
}

/// Rises softly from 0 at `low` to 1 at `high`.
[[nodiscard]] inline float ease(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

/// Multiplies by a share of a factor: 0 leaves the light, 1 takes the whole factor.
[[nodiscard]] inline Light scaled(const Light& a, const Light& factor, float share) {
  Light sum{};
  for (std::size_t k = 0; k < 3; ++k) {
    sum[k] = a[k] * (1.0F + (factor[k] - 1.0F) * share);
  }
  return sum;
}

/// Mixes two lights: 0 gives `a`, 1 gives `b`.
[[nodiscard]] inline Light mixed(const Light& a, const Light& b, float share) {
  Light sum{};
  for (std::size_t k = 0; k < 3; ++k) {
    sum[k] = a[k] + (b[k] - a[k]) * share;
  }
  return sum;
}

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
