// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include <QSettings>
#include <QVariant>
#include <gtest/gtest.h>

#include "app/gui/base/page.h"
#include "tests/app/gui/support/hands.h"
#include "tests/app/gui/support/watched_shell.h"
#include "tests/app/support/study_centre.h"

namespace torsio::gui::testing {

using torsio::testing::StudyCentre;

/// A centre with the context of its pages; collects failures.
class AdministratorDesk {
 public:
  AdministratorDesk() {
    QSettings().clear();
    QObject::connect(&shell(), &ShellContext::failed,
                     [this] { ADD_FAILURE() << watched_.told.last().toStdString(); });
  }

  StudyCentre centre;

 private:
  WatchedShell watched_{centre.session()};

 public:
  QStringList& failures = watched_.failures;

  ShellContext& shell() { return watched_.shell(); }

  template <typename Made>
  std::unique_ptr<Made> open(const std::string& role, const QVariant& argument = {}) {
    centre.as(role);
    auto page = std::make_unique<Made>(shell());
    page->resize(1366, 768);
    page->enter(argument);
    watched_.settle();
    return page;
  }
};

}  // namespace torsio::gui::testing
