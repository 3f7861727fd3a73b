// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/gui/base/background.h"
#include "app/services/access/session_context.h"

namespace torsio::gui {

class DialogLock;
class LockPanel;

/// The lock of a desk: one panel in place of the desk, and one over open dialogs. Only the owner's password
/// opens it. GUI thread.
class ScreenLock : public QObject {
  Q_OBJECT

 public:
  /// `background`: checks passwords; must outlive it.
  ScreenLock(Background& background, QWidget* window);

  [[nodiscard]] QWidget* panel() const noexcept;
  /// Covers open dialogs; the window shows the panel. `session`: the desk's; must outlive the lock.
  void close(SessionContext& session, const SessionKey& key);
  /// Rejects open dialogs.
  void closeDialogs();
  void say(const QString& sentence);
  void setWorking(bool working);

 Q_SIGNALS:
  /// The actor has re-entered the password.
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
