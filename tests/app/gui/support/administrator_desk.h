// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include <QApplication>
#include <QSettings>
#include <QVariant>
#include <gtest/gtest.h>

#include "app/gui/base/page.h"
#include "app/gui/base/shell_context.h"
#include "tests/app/gui/support/hands.h"
#include "tests/app/support/study_centre.h"

namespace torsio::gui::testing {

using torsio::testing::StudyCentre;

/// A centre with the context of its pages; collects failures.
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

}  // namespace torsio::gui::testing
