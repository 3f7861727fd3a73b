// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/studio_light.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include <qfloat16.h>

#include "sim/core/angle.h"
#include "sim/core/contracts.h"

namespace torsio::gui {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kLevels = 6;
constexpr float kRoughnessPerLevel = 0.2F;  // the renderer's choice of levels

float dotOf(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Direction unit(const Direction& v) {
  const float length = std::sqrt(dotOf(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

Direction crossOf(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A round lamp with a soft rim.
struct Lamp {
  Direction towards;
  float radius_rad;
  float softness_rad;
  Radiance radiance;
};

constexpr float kRadiansPerDegree_f = static_cast<float>(kRadiansPerDegree);

const std::array<Lamp, 4>& lamps() {
  static const std::array<Lamp, 4> kLamps = {{
      {unit({-0.35F, 0.85F, 0.55F}),
       15.0F * kRadiansPerDegree_f,
       7.0F * kRadiansPerDegree_f,
       {14.0F, 13.6F, 13.0F}},  // operating lamp
      {unit({0.75F, 0.55F, 0.55F}),
       11.0F * kRadiansPerDegree_f,
       9.0F * kRadiansPerDegree_f,
       {4.6F, 4.8F, 5.2F}},  // second lamp
      {unit({-0.95F, 0.05F, 0.30F}),
       20.0F * kRadiansPerDegree_f,
       16.0F * kRadiansPerDegree_f,
       {1.1F, 1.2F, 1.35F}},  // wall panel
      {unit({0.25F, 0.25F, -0.95F}),
       18.0F * kRadiansPerDegree_f,
       14.0F * kRadiansPerDegree_f,
       {2.2F, 2.3F, 2.5F}},  // from behind
  }};
  return kLamps;
}

/// Returns the i-th of n evenly distributed points of the unit square (Hammersley).
std::array<float, 2> spreadPoint(int i, int n) {
  auto bits = static_cast<std::uint32_t>(i);
  bits = (bits << 16U) | (bits >> 16U);
  bits = ((bits & 0x55555555U) << 1U) | ((bits & 0xAAAAAAAAU) >> 1U);
  bits = ((bits & 0x33333333U) << 2U) | ((bits & 0xCCCCCCCCU) >> 2U);
  bits = ((bits & 0x0F0F0F0FU) << 4U) | ((bits & 0xF0F0F0F0U) >> 4U);
  bits = ((bits & 0x00FF00FFU) << 8U) | ((bits & 0xFF00FF00U) >> 8U);
  return {(static_cast<float>(i) + 0.5F) / static_cast<float>(n), static_cast<float>(bits) * 0x1p-32F};
}

/// Returns the direction at an angle from `pole` and a turn about it.
Direction around(const Direction& pole, float cosine, float turn) {
  const Direction other = std::abs(pole[1]) < 0.9F ? Direction{0, 1, 0} : Direction{1, 0, 0};
  const Direction side = unit(crossOf(other, pole));
  const Direction front = crossOf(pole, side);
  const float sine = std::sqrt(std::max(0.0F, 1.0F - cosine * cosine));
  Direction d{};
  for (std::size_t k = 0; k < 3; ++k) {
    d[k] = pole[k] * cosine + sine * (side[k] * std::cos(turn) + front[k] * std::sin(turn));
  }
  return d;
}

/// Returns the direction through a pixel of a cube map's side, sides in the order +x -x +y -y +z -z.
Direction throughPixel(int side, int row, int column, int across) {
  const float s = 2.0F * (static_cast<float>(column) + 0.5F) / static_cast<float>(across) - 1.0F;
  const float t = 2.0F * (static_cast<float>(row) + 0.5F) / static_cast<float>(across) - 1.0F;
  const std::array<Direction, 6> through = {
      {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}}};
  return unit(through[static_cast<std::size_t>(side)]);
}

Radiance atLevel(int level, const Direction& direction) {
  if (level == 0) {
    return studioRadiance(direction);
  }
  if (level == kLevels - 1) {
    return diffuseRadiance(direction, 4096);
  }
  return mirroredRadiance(direction, kRoughnessPerLevel * static_cast<float>(level), level == 1 ? 128 : 512);
}

void append(std::string& bytes, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<char>((value >> shift) & 0xFFU));
  }
}

void append(std::string& bytes, float value) {
  const qfloat16 half(value);
  std::array<char, sizeof half> raw{};
  std::memcpy(raw.data(), &half, sizeof half);
  bytes.append(raw.data(), raw.size());
}

std::string fileHead(int across) {
  constexpr std::uint32_t kHalfFloat = 0x140B;
  constexpr std::uint32_t kRgba = 0x1908;
  constexpr std::uint32_t kRgbaOfHalves = 0x881A;
  // Tells the renderer that the levels are already filtered.
  std::string note("QT_IBL_BAKER_VERSION\0001\000", 23);
  const auto noteLength = static_cast<std::uint32_t>(note.size());
  note.append((4 - note.size() % 4) % 4, '\0');
  std::string head("\xABKTX 11\xBB\r\n\x1A\n", 12);
  const auto side = static_cast<std::uint32_t>(across);
  for (const std::uint32_t field :
       {0x04030201U, kHalfFloat, 2U, kRgba, kRgbaOfHalves, kRgba, side, side, 0U, 0U, 6U,
        static_cast<std::uint32_t>(kLevels), static_cast<std::uint32_t>(note.size()) + 4U, noteLength}) {
    append(head, field);
  }
  return head + note;
}

}  // namespace

Radiance studioRadiance(const Direction& direction) {
  // Ceiling, walls, floor: slightly warm from below, from light reflected by tissue.
  const float t = 0.5F + 0.5F * direction[1];
  const Radiance below{0.26F, 0.225F, 0.21F};
  const Radiance above{0.62F, 0.65F, 0.68F};
  Radiance sum{};
  for (std::size_t k = 0; k < 3; ++k) {
    sum[k] = below[k] + (above[k] - below[k]) * t;
  }
  for (const Lamp& lamp : lamps()) {
    const float angle = std::acos(std::clamp(dotOf(direction, lamp.towards), -1.0F, 1.0F));
    const float rim =
        std::clamp((lamp.radius_rad + lamp.softness_rad - angle) / lamp.softness_rad, 0.0F, 1.0F);
    const float share = rim * rim * (3.0F - 2.0F * rim);
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += lamp.radiance[k] * share;
    }
  }
  return sum;
}

Radiance mirroredRadiance(const Direction& direction, float roughness, int samples) {
  TORSIO_EXPECTS(samples > 0);
  const float spread =
      roughness * roughness * roughness * roughness;  // alpha squared, alpha = roughness squared
  Radiance sum{};
  float weight = 0.0F;
  for (int i = 0; i < samples; ++i) {
    const auto [u, v] = spreadPoint(i, samples);
    const float cosine = std::sqrt((1.0F - u) / (1.0F + (spread - 1.0F) * u));
    const Direction half = around(direction, cosine, 2.0F * kPi * v);
    Direction light{};
    for (std::size_t k = 0; k < 3; ++k) {
      light[k] = 2.0F * cosine * half[k] - direction[k];
    }
    const float facing = dotOf(light, direction);
    if (facing <= 0.0F) {
      continue;
    }
    const Radiance arriving = studioRadiance(light);
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += facing * arriving[k];
    }
    weight += facing;
  }
  for (float& channel : sum) {
    channel /= weight;
  }
  return sum;
}

Radiance diffuseRadiance(const Direction& normal, int samples) {
  TORSIO_EXPECTS(samples > 0);
  Radiance sum{};
  for (int i = 0; i < samples; ++i) {
    const auto [u, v] = spreadPoint(i, samples);
    const Radiance arriving = studioRadiance(around(normal, std::sqrt(1.0F - u), 2.0F * kPi * v));
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += arriving[k] / static_cast<float>(samples);
    }
  }
  return sum;
}

std::string studioLightFile(int across) {
  TORSIO_EXPECTS(across >= 32 && (across & (across - 1)) == 0);
  std::string file = fileHead(across);
  for (int level = 0; level < kLevels; ++level) {
    const int pixels = across >> level;
    append(file, static_cast<std::uint32_t>(pixels * pixels * 8));
    for (int side = 0; side < 6; ++side) {
      for (int row = 0; row < pixels; ++row) {
        for (int column = 0; column < pixels; ++column) {
          const Radiance radiance = atLevel(level, throughPixel(side, row, column, pixels));
          for (const float channel : radiance) {
            append(file, channel);
          }
          append(file, 1.0F);
        }
      }
    }
  }
  return file;
}

}  // namespace torsio::gui
