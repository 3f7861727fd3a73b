// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <QDialog>
#include <QObject>
#include <QString>

#include "app/gui/base/background.h"
#include "app/services/access/access_service.h"

class QLineEdit;

namespace torsio::gui {

/// Asks for another user's name and password, for one action that needs special rights.
class CredentialsDialog : public QDialog {
  Q_OBJECT

 public:
  CredentialsDialog(const QString& title, const QString& why, QWidget* parent = nullptr);
  [[nodiscard]] QString login() const;
  [[nodiscard]] QString password() const;

 private:
  QLineEdit* login_;
  QLineEdit* password_;
};

class OpenRecord;
class PasswordPanel;
class SignInPanel;

/// Sign-in with name and password, PIN, card or as a guest; change of a start password; leaving the kiosk.
/// All checks are off the GUI thread. GUI thread.
class Entrance : public QObject {
  Q_OBJECT

 public:
  /// `background` and `record` must outlive it.
  Entrance(Background& background, OpenRecord& record, QWidget* window);

  [[nodiscard]] SignInPanel& signIn() const noexcept { return *signIn_; }
  [[nodiscard]] PasswordPanel& password() const noexcept { return *password_; }
  /// Lets the signed-in user choose another password.
  void changeOwnPassword();
  /// Lets the signed-in user switch the second factor on or off. Returns a sentence about it; empty: nothing
  /// has changed. Throws Error, DbError.
  [[nodiscard]] QString changeSecondFactor();
  void setWorking(bool working);

 Q_SIGNALS:
  /// The session has its actor.
  void entered();
  /// The signed-in user's password was changed.
  void passwordChanged();
  void passwordWanted();
  /// An administrator has ended the kiosk.
  void kioskEnded();

 private:
  using Try = std::function<SignInAnswer(SessionContext&)>;
  using Then = std::function<void(const SignInAnswer&)>;
  void attempt(Try attempt, Then then);
  void took(const SignInAnswer& answer, const QString& login, const QString& password);
  void tryPassword(const QString& login, const QString& password, const QString& code);
  /// Asks for the code that an attempt lacked; empty: given up.
  [[nodiscard]] std::optional<QString> codeAfter(SignIn outcome);
  /// The centre asks for a second factor: sets it up, and goes on to the desk.
  void enrol(const QString& login, const QString& password);
  void tryCode(const QString& code);
  void enterAsGuest();
  void beginChange(const QString& login, const QString& password, bool forced);
  void change(const PasswordChange& change);
  void leaveKiosk();
  void tryLeaving(const QString& login, const QString& password, const QString& code);

  Background& background_;
  OpenRecord& record_;
  QWidget* window_;
  SignInPanel* signIn_;
  PasswordPanel* password_;
  bool forced_ = false;  // the password must be changed first
};

}  // namespace torsio::gui
