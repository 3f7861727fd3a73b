// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/gui/base/background.h"
#include "app/services/access/session_context.h"

namespace torsio::gui {

class DialogLock;
class LockPanel;

/// The lock of a desk: one panel in place of the desk, and one over the dialogs that stand open. Only the
/// owner's password opens it. GUI thread.
class ScreenLock : public QObject {
  Q_OBJECT

 public:
  /// Passwords are checked by `background`, which outlives it.
  ScreenLock(Background& background, QWidget* window);

  [[nodiscard]] QWidget* panel() const noexcept;
  /// Covers the dialogs; the panel is shown by the window. `session` belongs to the desk and outlives the
  /// lock.
  void close(SessionContext& session, const SessionKey& key);
  /// Gives up the dialogs that stand open.
  void closeDialogs();
  void say(const QString& sentence);
  void setWorking(bool working);

 Q_SIGNALS:
  /// The session's actor showed the password again.
  void opened();
  void signOutWanted();

 private:
  void unlock(const QString& password);

  Background& background_;
  LockPanel* panel_;
  DialogLock* dialogs_;
  SessionContext* session_ = nullptr;
  SessionKey key_;
};

}  // namespace torsio::gui
