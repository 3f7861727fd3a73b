// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include <QLabel>
#include <QLineEdit>
#include <QStackedWidget>
#include <QString>
#include <QTest>
#include <gtest/gtest.h>

#include "app/gui/base/background.h"
#include "app/gui/base/translated_text.h"
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

/// Returns the setup of a window that stores everything below `folder` and no settings.
[[nodiscard]] inline ShellSetup windowSetup(const std::filesystem::path& folder) {
  ShellSetup setup;
  setup.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  setup.station = "test";
  setup.locator = toQString(folder / "torsio.sqlite");
  setup.remember = false;
  setup.unstored = folder / "unstored";
  setup.passwordCost = PasswordCost::kTest;
  return setup;
}

/// Opens the program's window; recordings waiting in files have been stored.
[[nodiscard]] inline std::unique_ptr<MainWindow> openWindow(const ShellSetup& setup) {
  auto window = std::make_unique<MainWindow>(setup);
  window->QWidget::show();
  window->start();
  waitFor(window->background());
  return window;
}

/// Signs in with a password.
inline void enter(MainWindow& window, const QString& login, const QString& password) {
  named<QLineEdit>(window, QStringLiteral("Sign-in name"))->setText(login);
  named<QLineEdit>(window, QStringLiteral("Password"))->setText(password);
  press(window, QStringLiteral("Sign in"));
  waitFor(window.background());
}

}  // namespace torsio::gui::testing
