// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "sim/core/error.h"

namespace torsio::gui {

/// Refuses what was written on the command line of the window: throws Error{kUsage}. `option`: with its
/// dashes, or what was read; `remedy`: one imperative sentence. Any thread.
[[noreturn]] inline void refuseOption(const Text& what, const QString& option, const Text& remedy) {
  throw Error(ErrorCode::kUsage, what, option.toStdString(), remedy);
}

}  // namespace torsio::gui
