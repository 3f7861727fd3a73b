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

/// Light that comes from a direction of the surroundings which a wet surface mirrors: a neutral room, an
/// operating lamp above, a second lamp, a wall panel at the left and a lamp behind that draws the rim.
[[nodiscard]] Radiance studioRadiance(const Direction& direction);

/// Light from a mirror direction as a surface of `roughness` (0 mirror .. 1) shows it: the mean over the lobe
/// of a GGX surface seen along its normal.
[[nodiscard]] Radiance mirroredRadiance(const Direction& direction, float roughness, int samples);

/// Irradiance over pi: what a white matt surface with this normal sends back.
[[nodiscard]] Radiance diffuseRadiance(const Direction& normal, int samples);

/// All of it as a cube map in a KTX file of the layout in which Qt Quick 3D keeps its own light probes:
/// halves, six levels, of which the first five are mirrors of roughness 0, 0.2 .. 0.8 and the last is
/// diffuse. Baking the same at run time takes a software renderer more than a minute. `across`: pixels of a
/// side of the first level, a power of two >= 32.
[[nodiscard]] std::string studioLightFile(int across);

}  // namespace torsio::gui
