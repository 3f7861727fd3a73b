// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio::gui {

/// Starts the window and returns the exit code when it is closed. Options (docs/cli.md):
///
///     torsio [--kiosk] [--theme light|dark] [--database FILE|URL]
///     torsio --organ ID|FILE [--organ-unit mm|cm|m] [--pattern ID] [--formulation paper|saint-venant]
///     torsio --screenshot FILE [--angle DEG] [--size WxH] [--scene-only] [--lattice] [--wireframe]
///            [--quality fast|fine] [--orbit DEG]
///     torsio --frame-rate SECONDS [...]   measures and prints frames per second
///
/// The first is the whole program: sign-in, stations, review, administration. With an organ only the
/// simulator opens, without record or sign-in; its recordings are files of the user. With --screenshot a
/// scripted hand twists the organ on a manual clock up to the angle, one picture is written, and 0 is
/// returned. Throws Error for unknown options, files that cannot be used, and a display that cannot draw.
[[nodiscard]] int runWindow(int argc, char** argv);

}  // namespace torsio::gui
