// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

class QCoreApplication;

namespace torsio {

/// The Qt application that charts and PDF need, on the `offscreen` platform: no display is ever opened.
/// `argc` and `argv` must outlive it. One a process, before any other Qt object.
[[nodiscard]] std::unique_ptr<QCoreApplication> makeHeadlessGraphicsApplication(int& argc, char** argv);

}  // namespace torsio
