// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/gui/program/window_options.h"

class QApplication;

namespace torsio::gui {

/// The application object of a process that draws windows.
[[nodiscard]] std::unique_ptr<QApplication> makeWindowApplication();

/// Opens the window and returns when it is closed: sign-in, stations, review, administration. For the
/// simulator there is no record and no sign-in; its recordings are files of the user. For a picture a
/// scripted hand twists the organ on a manual clock up to the angle. Throws Error for files that cannot be
/// used and a display that cannot draw.
void runWindow(const WindowOptions& options);

}  // namespace torsio::gui
