// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QString>
#include <QTest>
#include <gtest/gtest.h>

#include "app/gui/base/background.h"
#include "app/gui/shell/main_window.h"

namespace torsio::gui::testing {

/// Returns the name of what the window shows: "first run", "sign-in", "password", "lock", "desk" or
/// "trouble".
[[nodiscard]] inline QString screenOf(const MainWindow& window) {
  const auto* stack = window.findChild<QStackedWidget*>(QString(), Qt::FindDirectChildrenOnly);
  return stack == nullptr ? QString() : stack->currentWidget()->objectName();
}

/// Waits until work off the window's thread and what follows it are done.
inline void waitFor(const Background& background) {
  constexpr int kPatience_ms = 120'000;
  EXPECT_TRUE(QTest::qWaitFor([&] { return !background.working(); }, kPatience_ms));
}

/// The field of this name that can be seen.
template <typename Widget>
Widget* named(QWidget& where, const QString& name) {
  for (Widget* widget : where.findChildren<Widget*>()) {
    if (widget->accessibleName() == name && widget->isVisibleTo(&where)) {
      return widget;
    }
  }
  ADD_FAILURE() << "no field " << name.toStdString();
  return nullptr;
}

/// Presses the button with this text.
inline void press(QWidget& where, const QString& text) {
  for (QPushButton* button : where.findChildren<QPushButton*>()) {
    if (button->text() == text && button->isVisible() && button->isEnabled()) {
      QTest::mouseClick(button, Qt::LeftButton);
      return;
    }
  }
  ADD_FAILURE() << "no button " << text.toStdString();
}

/// Whether a sentence with this part can be read.
[[nodiscard]] inline bool says(QWidget& where, const QString& part) {
  for (const QLabel* label : where.findChildren<QLabel*>()) {
    if (label->isVisible() && label->text().contains(part)) {
      return true;
    }
  }
  return false;
}

}  // namespace torsio::gui::testing
