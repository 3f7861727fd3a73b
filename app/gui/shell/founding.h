// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <vector>

#include <QObject>

#include "app/gui/base/background.h"
#include "app/gui/shell/first_run_panel.h"
#include "app/gui/shell/open_record.h"

namespace torsio::gui {

/// Sets up the centre that the panel of the first run describes, or finds one there, off the GUI thread. GUI
/// thread.
class Founding : public QObject {
  Q_OBJECT

 public:
  /// All outlive it.
  Founding(Background& background, OpenRecord& record, const ShellSetup& setup, QWidget* window);

  [[nodiscard]] FirstRunPanel& panel() const noexcept { return *panel_; }
  /// Closes the record that is open; founded(), foundThere() or failed() follows, unless the choice is
  /// refused.
  void begin(const FirstRunChoice& choice);

 Q_SIGNALS:
  /// The session has the actor who set it up.
  void founded(const torsio::gui::FirstRunChoice& choice, const std::vector<torsio::StartAccount>& accounts);
  void foundThere(const QString& locator);
  /// The panel has said why.
  void failed();

 private:
  [[nodiscard]] std::vector<StartAccount> addPeople(SessionContext& session);

  Background& background_;
  OpenRecord& record_;
  const ShellSetup& setup_;
  FirstRunPanel* panel_;
  std::atomic<bool> cancelled_{false};
};

}  // namespace torsio::gui
