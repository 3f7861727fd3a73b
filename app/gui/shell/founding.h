// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <vector>

#include <QObject>

#include "app/gui/base/background.h"
#include "app/gui/shell/first_run_panel.h"
#include "app/gui/shell/open_record.h"

namespace torsio::gui {

/// Sets up the centre described in the first-run panel, or finds an existing one, off the GUI thread. GUI
/// thread.
class Founding : public QObject {
  Q_OBJECT

 public:
  /// All outlive it.
  Founding(Background& background, OpenRecord& record, const ShellSetup& setup, QWidget* window);

  [[nodiscard]] FirstRunPanel& panel() const noexcept { return *panel_; }
  /// Closes the open record; then emits founded(), foundThere() or failed(), unless the choice is refused.
  void begin(const FirstRunChoice& choice);

 Q_SIGNALS:
  /// The centre is set up; the session's actor is its founder.
  void founded(const torsio::gui::FirstRunChoice& choice, const std::vector<torsio::StartAccount>& accounts);
  void foundThere(const QString& locator);
  /// The panel has shown the reason.
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
