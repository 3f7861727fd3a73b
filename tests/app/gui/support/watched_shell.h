// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include <QApplication>
#include <QString>
#include <QStringList>
#include <QVariant>

#include "app/gui/base/shell_context.h"

namespace torsio::gui::testing {

/// The context of a page without a window: collects what the page reports and requests.
class WatchedShell {
 public:
  explicit WatchedShell(SessionContext& session)
      : shell_(session, std::filesystem::path(TORSIO_SOURCE_DIR) / "assets", ThemeKind::kLight) {
    QObject::connect(&shell_, &ShellContext::pageWanted,
                     [this](PageId id, const QVariant& argument) { wanted.emplace_back(id, argument); });
    QObject::connect(&shell_, &ShellContext::failed,
                     [this](const QString& happened, const QString& remedy, const QString& details) {
                       failures << happened;
                       told << happened + remedy + details;
                     });
    QObject::connect(&shell_, &ShellContext::noticed, [this](const QString& text) { notices << text; });
    QObject::connect(&shell_, &ShellContext::jobStarted, [this](const QString& text) { told << text; });
  }
  ~WatchedShell() { settle(); }

  ShellContext& shell() { return shell_; }
  /// Waits for background work.
  void settle() {
    shell_.waitForJobs();
    QApplication::processEvents();
  }

  QStringList failures;  ///< what happened
  QStringList notices;
  QStringList told;  ///< complete failures and the titles of jobs
  std::vector<std::pair<PageId, QVariant>> wanted;

 private:
  ShellContext shell_;
};

}  // namespace torsio::gui::testing
