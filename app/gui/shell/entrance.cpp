// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/entrance.h"

#include <exception>
#include <optional>
#include <utility>
#include <vector>

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/shell/open_record.h"
#include "app/gui/shell/password_panel.h"
#include "app/gui/shell/second_factor_dialog.h"
#include "app/gui/shell/sign_in_panel.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/kiosk_codes.h"
#include "app/services/access/second_factor.h"

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
  connect(signIn_, &SignInPanel::passwordGiven, this,
          [this](const QString& login, const QString& password) { tryPassword(login, password, {}); });
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

void Entrance::tryPassword(const QString& login, const QString& password, const QString& code) {
  attempt(
      [=](SessionContext& own) {
        return torsio::signIn(own, login.toStdString(), password.toStdString(), {}, code.toStdString());
      },
      [=, this](const SignInAnswer& answer) { took(answer, login, password); });
}

std::optional<QString> Entrance::codeAfter(SignIn outcome) {
  signIn_->say({}, false);
  return askCode(window_, outcome == SignIn::kCodeWrong
                              ? tr("The code is not right, or was used before. Wait for the next one, or use "
                                   "a recovery code")
                              : QString());
}

void Entrance::enrol(const QString& login, const QString& password) {
  signIn_->say({}, false);
  SessionContext& session = *record_.session();
  SecondFactorWish wish{.login = login.toStdString(), .password = password.toStdString()};
  try {
    const SecondFactorOffer offer = offerSecondFactor(session, wish.login);
    wish.secret = offer.secret;
    SecondFactorDialog dialog(
        offer,
        tr("The centre asks you for a second factor: signing in takes your password and a code from "
           "your phone."),
        false,
        [&](const std::string&, const std::string& code) {
          wish.code = code;
          return switchOnSecondFactor(session, wish).recoveryCodes;
        },
        window_);
    dialog.exec();
  } catch (...) {
    signIn_->say(problemSentence(std::current_exception()), true);
  }
  if (!session.actor().userId.empty()) {  // also if the codes were closed unread
    Q_EMIT entered();
  } else if (forced_) {
    Q_EMIT password_->givenUp();  // the new password is in use: back to the sign-in
  }
  forced_ = false;
}

QString Entrance::changeSecondFactor() {
  SessionContext& session = *record_.session();
  const OwnSecondFactor own = ownSecondFactor(session);
  if (own.on) {
    SecondFactorStateDialog dialog(
        own,
        [&](const std::string& password, const std::string& code) {
          switchOffSecondFactor(session, password, code);
        },
        window_);
    return dialog.exec() == QDialog::Accepted ? tr("The second factor is off") : QString();
  }
  const SecondFactorOffer offer = offerSecondFactor(session, session.actor().login);
  SecondFactorWish wish{.login = session.actor().login, .secret = offer.secret};
  bool on = false;
  SecondFactorDialog dialog(
      offer,
      tr("With it, your password alone opens nothing: signing in also asks for a code from your phone."),
      true,
      [&](const std::string& password, const std::string& code) {
        wish.password = password;
        wish.code = code;
        std::vector<std::string> codes = switchOnSecondFactor(session, wish).recoveryCodes;
        on = true;
        return codes;
      },
      window_);
  dialog.exec();
  return on ? tr("The second factor is on") : QString();
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
    case SignIn::kCodeNeeded:
    case SignIn::kCodeWrong:
      if (const auto code = codeAfter(answer.outcome)) {
        signIn_->say(tr("Checking\u2026"), false);
        tryPassword(login, password, *code);
      }
      break;
    case SignIn::kMustEnrol:
      enrol(login, password);
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
  password_->begin(login, password, forced, !forced && ownSecondFactor(*record_.session()).on);
  Q_EMIT passwordWanted();
}

void Entrance::change(const PasswordChange& change) {
  background_.run(
      record_.key(),
      [change, cost = record_.session()->passwordCost()](SessionContext& own) {
        own.setPasswordCost(cost);
        return torsio::changeOwnPassword(own, change);
      },
      [this, change](const SignInAnswer& answer) {
        if (forced_) {
          took(answer, toQString(change.login), toQString(change.newPassword));
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
  if (dialog.exec() == QDialog::Accepted) {
    tryLeaving(dialog.login(), dialog.password(), {});
  }
}

void Entrance::tryLeaving(const QString& login, const QString& password, const QString& code) {
  struct Leaving {
    SignIn outcome;
    bool may;
  };
  background_.run(
      record_.key(),
      [=](SessionContext& own) {
        Leaving leaving{
            torsio::signIn(own, login.toStdString(), password.toStdString(), {}, code.toStdString()).outcome,
            false};
        if (leaving.outcome == SignIn::kOk) {
          leaving.may = own.may(Operation::kSettingsEdit);
          torsio::signOut(own);
        }
        return leaving;
      },
      [=, this](const Leaving& leaving) {
        if (leaving.may) {
          Q_EMIT kioskEnded();
        } else if (leaving.outcome == SignIn::kCodeNeeded || leaving.outcome == SignIn::kCodeWrong) {
          if (const auto typed = codeAfter(leaving.outcome)) {
            tryLeaving(login, password, *typed);
          }
        } else {
          signIn_->say(tr("Only an administrator can end the kiosk"), true);
        }
      },
      [this](const std::exception_ptr& problem) { signIn_->say(problemSentence(problem), true); });
}

}  // namespace torsio::gui
