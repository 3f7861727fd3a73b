// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace torsio::gui {

/// Red, green and blue, linear.
using Radiance = std::array<float, 3>;
/// A unit direction in the view frame: x right, y up, z towards the viewer.
using Direction = std::array<float, 3>;

/// Radiance of the surroundings in a direction, as mirrored by a wet surface: a neutral room, an operating
/// lamp above, a second lamp, a wall panel at the left, and a rim light from behind.
[[nodiscard]] Radiance studioRadiance(const Direction& direction);

/// Radiance in a mirror direction for a surface of `roughness` (0 mirror .. 1): the mean over the lobe of a
/// GGX surface seen along its normal.
[[nodiscard]] Radiance mirroredRadiance(const Direction& direction, float roughness, int samples);

/// Irradiance over pi: radiance of a white matt surface with this normal.
[[nodiscard]] Radiance diffuseRadiance(const Direction& normal, int samples);

/// Returns the lighting as a cube map in a KTX file with the layout of Qt Quick 3D's light probes: half
/// floats, six levels, of which the first five are mirrors of roughness 0, 0.2 .. 0.8 and the last is
/// diffuse. Baking it at run time would take a software renderer more than a minute. `across`: pixels of a
/// side of the first level, a power of two >= 32.
[[nodiscard]] std::string studioLightFile(int across);

}  // namespace torsio::gui
