// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDialog>

namespace torsio::gui {

class LockPanel;

/// The lock of a place where dialogs stand open. They would be readable beside the window's lock panel, and
/// keep it out of reach: so each is covered, and a lock panel of their own stands above them. What was typed
/// in them stays. GUI thread.
class DialogLock : public QDialog {
  Q_OBJECT

 public:
  explicit DialogLock(QWidget* window);

  [[nodiscard]] LockPanel& panel() const noexcept { return *panel_; }
  /// Covers the open dialogs and asks above them; does nothing when there are none.
  void cover();
  void uncover();
  /// Closes all open dialogs as if given up, without a question. Whoever waits for them goes on only when the
  /// event loop comes round.
  void closeOthers();
  /// Escape opens no lock.
  void reject() override {}

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] std::vector<QDialog*> openDialogs() const;

  LockPanel* panel_;
};

}  // namespace torsio::gui
