// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QStackedWidget>
#include <QString>
#include <QTest>
#include <gtest/gtest.h>

#include "app/gui/base/background.h"
#include "app/gui/shell/main_window.h"
#include "tests/app/gui/support/hands.h"

namespace torsio::gui::testing {

/// Returns the name of what the window shows: "first run", "sign-in", "password", "lock", "desk" or
/// "trouble".
[[nodiscard]] inline QString screenOf(const MainWindow& window) {
  const auto* stack = window.findChild<QStackedWidget*>(QString(), Qt::FindDirectChildrenOnly);
  return stack == nullptr ? QString() : stack->currentWidget()->objectName();
}

/// Waits until background work and its continuation are done.
inline void waitFor(const Background& background) {
  constexpr int kPatience_ms = 120'000;
  EXPECT_TRUE(QTest::qWaitFor([&] { return !background.working(); }, kPatience_ms));
}

/// Returns whether a visible sentence contains this part.
[[nodiscard]] inline bool says(QWidget& where, const QString& part) {
  for (const QLabel* label : where.findChildren<QLabel*>()) {
    if (label->isVisible() && label->text().contains(part)) {
      return true;
    }
  }
  return false;
}

}  // namespace torsio::gui::testing
