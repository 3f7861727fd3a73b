// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDialog>

namespace torsio::gui {

class LockPanel;

/// The lock of a place with open dialogs, which would stay readable beside the window's lock panel and block
/// it: covers each dialog and shows a separate lock panel above them. Their input is kept. GUI thread.
class DialogLock : public QDialog {
  Q_OBJECT

 public:
  explicit DialogLock(QWidget* window);

  [[nodiscard]] LockPanel& panel() const noexcept { return *panel_; }
  /// Covers the open dialogs and shows the lock panel; no effect if there are none.
  void cover();
  void uncover();
  /// Rejects all open dialogs without asking. Their callers continue when the event loop runs.
  void closeOthers();
  /// Escape must not unlock.
  void reject() override {}

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] std::vector<QDialog*> openDialogs() const;

  LockPanel* panel_;
};

}  // namespace torsio::gui
