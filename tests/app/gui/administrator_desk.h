// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <QApplication>
#include <QDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTimer>
#include <QVariant>
#include <gtest/gtest.h>

#include "app/gui/base/page.h"
#include "app/gui/base/shell_context.h"
#include "tests/app/support/study_centre.h"

namespace torsio::gui::testing {

using torsio::testing::StudyCentre;

/// A centre with the surroundings of its pages; what a page reports as failed is kept.
class AdministratorDesk {
 public:
  AdministratorDesk() : shell_(centre.session(), centre.assets(), ThemeKind::kLight) {
    QSettings().clear();
    QObject::connect(&shell_, &ShellContext::failed,
                     [this](const QString& happened, const QString& remedy, const QString& details) {
                       failures << QStringLiteral("%1 | %2 | %3").arg(happened, remedy, details);
                       ADD_FAILURE() << failures.last().toStdString();
                     });
  }

  StudyCentre centre;
  QStringList failures;

  ShellContext& shell() { return shell_; }

  template <typename Made>
  std::unique_ptr<Made> open(const std::string& role, const QVariant& argument = {}) {
    centre.as(role);
    auto page = std::make_unique<Made>(shell_);
    page->resize(1366, 768);
    page->enter(argument);
    shell_.waitForJobs();
    QApplication::processEvents();
    return page;
  }

 private:
  ShellContext shell_;
};

/// The button with this text, mnemonics and dots apart.
inline QPushButton* button(QWidget& in, const QString& text) {
  for (QPushButton* found : in.findChildren<QPushButton*>()) {
    QString plain = found->text();
    if (plain.remove(QLatin1Char('&')).remove(QChar(0x2026)) == text) {
      return found;
    }
  }
  return nullptr;
}

inline void press(QWidget& in, const QString& text) {
  QPushButton* found = button(in, text);
  ASSERT_NE(found, nullptr) << text.toStdString();
  ASSERT_TRUE(found->isEnabled()) << text.toStdString();
  found->click();
}

/// Answers the next modal dialog.
inline void answer(const std::function<void(QDialog&)>& fill) {
  QTimer::singleShot(0, [fill] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    fill(*dialog);
  });
}

inline void type(QDialog& dialog, const QString& text) {
  if (auto* input = qobject_cast<QInputDialog*>(&dialog)) {
    input->setTextValue(text);
  } else {
    dialog.findChild<QLineEdit*>()->setText(text);
  }
  dialog.accept();
}

}  // namespace torsio::gui::testing
