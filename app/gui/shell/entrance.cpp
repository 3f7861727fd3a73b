// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/entrance.h"

#include <utility>

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/shell/open_record.h"
#include "app/gui/shell/password_panel.h"
#include "app/gui/shell/sign_in_panel.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/kiosk_codes.h"

namespace torsio::gui {

CredentialsDialog::CredentialsDialog(const QString& title, const QString& why, QWidget* parent)
    : QDialog(parent), login_(new QLineEdit(this)), password_(secretField(this)) {
  setWindowTitle(title);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
  QLabel* reason = sentence(this);
  reason->setText(why);
  column->addWidget(reason);
  nameField(addField(column, login_), tr("Sign-in &name"));
  nameField(addField(column, password_), tr("&Password"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
}

QString CredentialsDialog::login() const {
  return login_->text().trimmed();
}

QString CredentialsDialog::password() const {
  return password_->text();
}

Entrance::Entrance(Background& background, OpenRecord& record, QWidget* window)
    : QObject(window),
      background_(background),
      record_(record),
      window_(window),
      signIn_(new SignInPanel(window)),
      password_(new PasswordPanel(window)) {
  connect(signIn_, &SignInPanel::passwordGiven, this, [this](const QString& login, const QString& password) {
    attempt(
        [=](SessionContext& own) { return torsio::signIn(own, login.toStdString(), password.toStdString()); },
        [=, this](const SignInAnswer& answer) { took(answer, login, password); });
  });
  connect(signIn_, &SignInPanel::pinGiven, this, [this](const QString& login, const QString& pin) {
    attempt(
        [=](SessionContext& own) { return signInForPractice(own, login.toStdString(), pin.toStdString()); },
        [=, this](const SignInAnswer& answer) { took(answer, login, {}); });
  });
  connect(signIn_, &SignInPanel::codeGiven, this, &Entrance::tryCode);
  connect(signIn_, &SignInPanel::guestChosen, this, &Entrance::enterAsGuest);
  connect(signIn_, &SignInPanel::leaveKioskWanted, this, &Entrance::leaveKiosk);
  connect(password_, &PasswordPanel::chosen, this, &Entrance::change);
}

void Entrance::setWorking(bool working) {
  signIn_->setWorking(working);
  password_->setWorking(working);
}

void Entrance::attempt(Try attempt, Then then) {
  background_.run(
      record_.key(), std::move(attempt), std::move(then),
      [this](const std::exception_ptr& problem) { signIn_->say(problemSentence(problem), true); });
}

void Entrance::tryCode(const QString& code) {
  attempt([code](SessionContext& own) { return signInWithCode(own, code.toStdString()); },
          [this](const SignInAnswer& answer) {
            if (answer.outcome == SignIn::kWrong) {
              signIn_->say(tr("No card with this code is in force. Sign in with your name and password"),
                           true);
            } else {
              took(answer, {}, {});
            }
          });
}

void Entrance::took(const SignInAnswer& answer, const QString& login, const QString& password) {
  switch (answer.outcome) {
    case SignIn::kOk:
      record_.session()->setActor(answer.actor);
      Q_EMIT entered();
      break;
    case SignIn::kMustChange:
      beginChange(login, password, true);
      break;
    case SignIn::kWrong:
      signIn_->say(tr("Name and password do not match. Please try again"), true);
      break;
    case SignIn::kWait:
      signIn_->waitUntil(answer.waitUntilUtc_us, record_.session()->now_us());
      break;
    case SignIn::kDisabled:
      signIn_->say(tr("This account is disabled. Ask your administrator"), true);
      break;
  }
}

void Entrance::enterAsGuest() {
  Actor guest;
  guest.practiceOnly = true;
  record_.session()->setActor(guest);
  Q_EMIT entered();
}

void Entrance::changeOwnPassword() {
  beginChange(toQString(record_.session()->actor().login), {}, false);
}

void Entrance::beginChange(const QString& login, const QString& password, bool forced) {
  forced_ = forced;
  password_->begin(login, password, forced);
  Q_EMIT passwordWanted();
}

void Entrance::change(const QString& login, const QString& oldPassword, const QString& newPassword) {
  background_.run(
      record_.key(),
      [=, cost = record_.session()->passwordCost()](SessionContext& own) {
        own.setPasswordCost(cost);
        return torsio::changeOwnPassword(own, login.toStdString(), oldPassword.toStdString(),
                                         newPassword.toStdString());
      },
      [this, login](const SignInAnswer& answer) {
        if (forced_) {
          took(answer, login, {});
        } else {
          Q_EMIT passwordChanged();
        }
      },
      [this](const std::exception_ptr& problem) { password_->say(problemSentence(problem)); });
}

/// Leaves kiosk mode; needs the right to change the centre's settings.
void Entrance::leaveKiosk() {
  CredentialsDialog dialog(tr("Leave kiosk mode"),
                           tr("An administrator ends the kiosk with name and password."), window_);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  background_.run(
      record_.key(),
      [login = dialog.login().toStdString(),
       password = dialog.password().toStdString()](SessionContext& own) {
        const bool known = torsio::signIn(own, login, password).outcome == SignIn::kOk;
        const bool may = known && own.may(Operation::kSettingsEdit);
        if (known) {
          torsio::signOut(own);
        }
        return may;
      },
      [this](bool may) {
        if (may) {
          Q_EMIT kioskEnded();
        } else {
          signIn_->say(tr("Only an administrator can end the kiosk"), true);
        }
      },
      [this](const std::exception_ptr& problem) { signIn_->say(problemSentence(problem), true); });
}

}  // namespace torsio::gui
