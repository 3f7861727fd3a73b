// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

class QCoreApplication;

namespace torsio {

/// Creates the Qt application that charts and PDF need, on the `offscreen` platform without a display. `argc`
/// and `argv` must outlive it. One per process, before any other Qt object.
[[nodiscard]] std::unique_ptr<QCoreApplication> makeHeadlessGraphicsApplication(int& argc, char** argv);

}  // namespace torsio
