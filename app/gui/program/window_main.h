// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/gui/program/window_options.h"

class QApplication;

namespace torsio::gui {

/// Creates the application object of a process with windows.
[[nodiscard]] std::unique_ptr<QApplication> makeWindowApplication();

/// Opens the window and returns when it is closed: sign-in, stations, review, administration. The simulator
/// runs without record and sign-in; its recordings are the user's files. For a picture, a scripted hand
/// twists the organ on a manual clock to the angle. Throws Error for unusable files and a display that cannot
/// draw.
void runWindow(const WindowOptions& options);

}  // namespace torsio::gui
