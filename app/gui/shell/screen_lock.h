// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDialog>
#include <QObject>
#include <QString>
#include <QWidget>

#include "app/gui/base/background.h"
#include "app/services/access/session_context.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace torsio::gui {

/// Covers a desk whose owner is away; the work behind is unchanged.
class LockPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LockPanel(QWidget* parent = nullptr);
  void begin(const QString& login);
  void say(const QString& sentence);
  void setWorking(bool working);

 Q_SIGNALS:
  void passwordGiven(const QString& password);
  void signOutWanted();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void retranslate();
  QString login_;
  QLabel* heading_;
  QLabel* why_;
  QLabel* label_;
  QLineEdit* secret_;
  QLabel* answer_;
  QPushButton* unlock_;
  QPushButton* signOut_;
};

class DialogLock;

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
