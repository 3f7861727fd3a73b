// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "app/gui/trial_recording.h"

namespace torsio::gui {

/// Starts the window and returns the exit code when it is closed. Options (docs/cli.md):
///
///     torsio [--organ ID|FILE] [--organ-unit mm|cm|m] [--pattern ID] [--formulation paper|saint-venant]
///            [--theme light|dark]
///     torsio --screenshot FILE [--angle DEG] [--size WxH] [--scene-only] [--lattice] [--wireframe]
///            [--quality fast|fine] [--orbit DEG]
///     torsio --frame-rate SECONDS [...]   measures and prints frames per second
///
/// With --screenshot a scripted hand twists the organ on a manual clock up to the angle, one picture is
/// written, and 0 is returned. Throws Error for unknown options, files that cannot be used, and a display
/// that cannot draw.
[[nodiscard]] int runWindow(int argc, char** argv);

/// The same with a place for recordings; `recording` is called once QApplication exists.
[[nodiscard]] int runWindow(int argc, char** argv, const std::function<TrialRecording()>& recording);

}  // namespace torsio::gui
