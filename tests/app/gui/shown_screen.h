// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStackedWidget>
#include <QString>

#include "app/gui/shell/main_window.h"

namespace torsio::gui::testing {

/// Returns the name of what the window shows: "first run", "sign-in", "password", "lock", "desk" or
/// "trouble".
[[nodiscard]] inline QString screenOf(const MainWindow& window) {
  const auto* stack = window.findChild<QStackedWidget*>(QString(), Qt::FindDirectChildrenOnly);
  return stack == nullptr ? QString() : stack->currentWidget()->objectName();
}

}  // namespace torsio::gui::testing
