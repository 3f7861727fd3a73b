// SPDX-License-Identifier: GPL-3.0-or-later
// Of MainWindow: everything before the desk.
#include <utility>

#include <QUrl>

#include "app/connectors/built_in.h"
#include "app/connectors/xapi/lrs_worker.h"
#include "app/gui/base/clock_time.h"
#include "app/gui/base/job_panel.h"
#include "app/gui/base/problem_labels.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/shell/credentials_dialog.h"
#include "app/gui/shell/dialog_lock.h"
#include "app/gui/shell/lock_panel.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/password_panel.h"
#include "app/gui/shell/sign_in_panel.h"
#include "app/gui/shell/trouble_panel.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/first_run.h"
#include "app/services/access/kiosk_codes.h"
#include "app/services/demonstration/demonstration_people.h"
#include "app/services/maintenance/copies.h"
#include "app/services/maintenance/database_maintenance.h"
#include "app/services/maintenance/record_privacy.h"
#include "app/services/recording/station_start.h"
#include "app/services/recording/station_writer.h"
#include "assessment/domain/people/account.h"

namespace torsio::gui {

/// Only somebody who may change the centre's settings gets out of the kiosk.
void MainWindow::leaveKiosk() {
  CredentialsDialog dialog(tr("Leave kiosk mode"),
                           tr("An administrator ends the kiosk with name and password."), this);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  background_.run(
      [this, key = key(), login = dialog.login(), password = dialog.password()]() -> Background::Finish {
        SessionContext own(key);
        const SignInAnswer answer = torsio::signIn(own, login.toStdString(), password.toStdString());
        const bool may = answer.outcome == SignIn::kOk && own.may(Operation::kSettingsEdit);
        if (answer.outcome == SignIn::kOk) {
          torsio::signOut(own);
        }
        return [this, may] {
          if (!may) {
            signIn_->say(tr("Only an administrator can end the kiosk"), true);
            return;
          }
          mayClose_ = true;
          close();
        };
      },
      [this](const std::exception_ptr& problem) { signIn_->say(problemSentence(problem), true); });
}

void MainWindow::openDatabase() {
  line_.reset();
  lessons_.reset();
  try {
    if (!preferences_.database().isEmpty() && preferences_.database() == setup_.locator) {
      requireKnownRecord(key().locator);
    } else if (lookAtRecord(key().locator) != RecordPlace::kCentre) {
      session_.reset();
      enterFirstRun();
      return;
    }
    preferences_.keep(true);
    session_ = std::make_unique<SessionContext>(key());
    session_->setPasswordCost(setup_.passwordCost);
    const CentreSign sign = centreSign(session_->connectionWithoutRight());
    centre_ = toQString(sign.name);
    cardsOpen_ = setup_.kiosk && centreSetting<kKioskCodes>(session_->connectionWithoutRight());
    if (!preferences_.language({})) {
      if (const auto language = languageOf(toQString(sign.language))) {
        chooseLanguage(*language);
      }
    }
    enterSignIn();
    settle();
  } catch (...) {
    trouble_->tell(std::current_exception());
    show(trouble_);
  }
}

/// Recordings that wait in files can take long to store; until then nobody signs in.
void MainWindow::settle() {
  const bool begins = !std::exchange(filesClosed_, true);
  background_.run(
      [this, begins, key = key(),
       folder = setup_.unstored.empty() ? unstoredFolder() : setup_.unstored]() -> Background::Finish {
        sweepLeftovers(key.locator);
        std::vector<Text> closed = begins ? closeRecordFiles(key.locator, folder) : std::vector<Text>{};
        SessionContext own(key);
        if (begins) {
          const std::vector<Text> copies = closeKnownCopies(own.connectionWithoutRight());
          closed.insert(closed.end(), copies.begin(), copies.end());
        }
        const StationStart start = settleStation(own, folder);
        return [this, kept = start.kept, closed] {
          kept_ = kept;
          if (!kept_.empty()) {
            signIn_->say(translatedLines(kept_), true);
          } else if (!closed.empty()) {
            signIn_->say(translatedLines(closed), false);
          }
          startLine();
        };
      },
      [this](const std::exception_ptr& problem) {
        signIn_->say(problemSentence(problem), true);
        startLine();
      });
}

void MainWindow::startLine() {
  line_ = std::make_unique<StationWriter>(key(), setup_.linePatience);
  if constexpr (kXapiBuiltIn) {
    lessons_ = std::make_shared<LrsWorker>(key(), setup_.lessonsAgain);
  }
  answered_ = true;
  settleDue_ = false;
  if (desk_ != nullptr) {
    desk_->context().setLine(line_.get());
  }
  heartbeat();
}

/// After the database was away: recordings of the meantime wait in files.
void MainWindow::settleAgain() {
  settleDue_ = false;
  background_.run(
      [this, key = key(),
       folder = setup_.unstored.empty() ? unstoredFolder() : setup_.unstored]() -> Background::Finish {
        SessionContext own(key);
        const StationStart start = settleStation(own, folder);
        return [this, start] {
          if (desk_ == nullptr || start.trials.empty()) {
            return;
          }
          desk_->context().notify(tr("The database answers again, and what was kept meanwhile is stored"));
        };
      },
      [this](const std::exception_ptr&) { settleDue_ = true; });
}

void MainWindow::changeRecord(const RecordChange& change) {
  leaveDesk();
  const std::optional<LeftHead> head = forgetActor();
  if (line_) {
    line_->leave();
  }
  line_.reset();
  lessons_.reset();
  session_.reset();  // nobody has the record open now
  QString sentence = change.sentence;
  bool failed = false;
  try {
    if (change.swap) {
      change.swap();
    }
    if (!change.locator.isEmpty()) {
      setup_.locator = change.locator;
      preferences_.setDatabase(change.locator);
    }
  } catch (...) {
    sentence = problemSentence(std::current_exception());
    failed = true;
  }
  openDatabase();
  tellHead(head);
  signIn_->say(sentence, failed);
}

/// Nothing is written before the last step, no setting of this station either.
void MainWindow::enterFirstRun() {
  preferences_.keep(false);
  firstRun_->setLanguage(language_.present());
  show(firstRun_);
}

void MainWindow::keepFirstRun(const QString& locator) {
  preferences_.keep(true);
  preferences_.setDatabase(locator);
  if (firstRunLanguage_) {
    preferences_.setLanguage({}, *firstRunLanguage_);
  }
}

void MainWindow::setUp(const FirstRunChoice& choice) {
  if (!QUrl(choice.locator).password().isEmpty()) {
    firstRun_->say(
        tr("Leave the password out of the address; it would stand in a settings file. Put it into .pgpass"));
    return;
  }
  setup_.locator = choice.locator;
  line_.reset();
  lessons_.reset();
  session_.reset();
  setUpCancelled_->store(false);
  firstRun_->job().begin(tr("Setting up the centre"));
  background_.run(
      [this, choice, key = key()]() -> Background::Finish {
        SessionContext own(key);
        own.setPasswordCost(setup_.passwordCost);
        if (!needsFirstRun(own.connectionWithoutRight())) {
          return [this, choice] {  // a centre is there already: its people sign in
            firstRun_->job().end();
            keepFirstRun(choice.locator);
            openDatabase();
          };
        }
        const auto accounts = performFirstRun(own, choice.first, [this](SessionContext& session) {
          const ProgressCallback told = [this](const Progress& progress) {
            if (setUpCancelled_->load()) {
              throw Cancelled{};
            }
            QMetaObject::invokeMethod(this, [this, progress] {
              firstRun_->job().move(toQString(Text(progress.step)), progress.fraction, progress.remaining_s);
            });
          };
          return setup_.simulatedPeople ? setup_.simulatedPeople(session, told)
                                        : addDemonstration(session, setup_.assets, told);
        });
        return [this, actor = own.actor(), choice, accounts] {
          firstRun_->job().end();
          session_ = std::make_unique<SessionContext>(this->key());
          session_->setPasswordCost(setup_.passwordCost);
          session_->setActor(actor);
          startLine();
          centre_ = toQString(choice.first.centre);
          if (lookedAt_) {
            setCentreSetting<kGradedWithMouse>(*session_,
                                               true);  // a visitor has no device, and nothing counts
            visitor_ = actor;
            visit_->setSeen(VisitedDesk::kAdministrator);
            enterDesk();
            desk_->context().notify(
                tr("Everybody here is simulated. All of it is deleted when you sign out"));
            if (visitedFirst_ != VisitedDesk::kAdministrator) {
              visit(visitedFirst_);
            }
            return;
          }
          keepFirstRun(choice.locator);
          firstRun_->showAccounts(accounts);
        };
      },
      [this](const std::exception_ptr& problem) {
        firstRun_->job().end();
        endLookRound();
        try {
          std::rethrow_exception(problem);
        } catch (const Cancelled&) {
          firstRun_->say(tr("Cancelled; nothing was set up"));
        } catch (...) {
          firstRun_->say(problemSentence(problem));
        }
      });
}

void MainWindow::enterSignIn() {
  applyChoices({});
  signIn_->setCentre(centre_);
  signIn_->setCards(cardsOpen_);
  signIn_->clear();
  show(signIn_);
}

void MainWindow::tryPassword(const QString& login, const QString& password) {
  background_.run(
      [this, key = key(), login, password]() -> Background::Finish {
        SessionContext own(key);
        const SignInAnswer answer = torsio::signIn(own, login.toStdString(), password.toStdString());
        return [this, answer, login, password] { took(answer, login, password); };
      },
      [this](const std::exception_ptr& problem) { signIn_->say(problemSentence(problem), true); });
}

void MainWindow::tryPin(const QString& login, const QString& pin) {
  background_.run(
      [this, key = key(), login, pin]() -> Background::Finish {
        SessionContext own(key);
        const SignInAnswer answer = signInForPractice(own, login.toStdString(), pin.toStdString());
        return [this, answer, login] { took(answer, login, {}); };
      },
      [this](const std::exception_ptr& problem) { signIn_->say(problemSentence(problem), true); });
}

void MainWindow::tryCode(const QString& code) {
  background_.run(
      [this, key = key(), code]() -> Background::Finish {
        SessionContext own(key);
        const SignInAnswer answer = signInWithCode(own, code.toStdString());
        return [this, answer] {
          if (answer.outcome == SignIn::kWrong) {
            signIn_->say(tr("No card with this code is in force. Sign in with your name and password"), true);
          } else {
            took(answer, {}, {});
          }
        };
      },
      [this](const std::exception_ptr& problem) { signIn_->say(problemSentence(problem), true); });
}

void MainWindow::took(const SignInAnswer& answer, const QString& login, const QString& password) {
  switch (answer.outcome) {
    case SignIn::kOk:
      session_->setActor(answer.actor);
      enterDesk();
      break;
    case SignIn::kMustChange:
      password_->begin(login, password, true);
      show(password_);
      break;
    case SignIn::kWrong:
      signIn_->say(tr("Name and password do not match. Please try again"), true);
      break;
    case SignIn::kWait:
      signIn_->waitUntil(answer.waitUntilUtc_us, session_->now_us());
      break;
    case SignIn::kDisabled:
      signIn_->say(tr("This account is disabled. Ask your administrator"), true);
      break;
  }
}

void MainWindow::enterAsGuest() {
  Actor guest;
  guest.practiceOnly = true;
  session_->setActor(guest);
  enterDesk();
}

void MainWindow::changePassword(const QString& login, const QString& oldPassword,
                                const QString& newPassword) {
  background_.run(
      [this, key = key(), login, oldPassword, newPassword]() -> Background::Finish {
        SessionContext own(key);
        own.setPasswordCost(setup_.passwordCost);
        const SignInAnswer answer =
            changeOwnPassword(own, login.toStdString(), oldPassword.toStdString(), newPassword.toStdString());
        return [this, answer, login] {
          if (desk_ == nullptr) {
            took(answer, login, {});
            return;
          }
          show(desk_);
          desk_->context().notify(tr("The new password is now in use"));
        };
      },
      [this](const std::exception_ptr& problem) { password_->say(problemSentence(problem)); });
}

void MainWindow::sayLocked(const QString& sentence) {
  lock_->say(sentence);
  dialogLock_->panel().say(sentence);
}

void MainWindow::unlock(const QString& password) {
  background_.run(
      [this, key = key(), login = session_->actor().login, password]() -> Background::Finish {
        SessionContext own(key);
        const SignInAnswer answer = torsio::signIn(own, login, password.toStdString());
        return [this, answer] {
          if (answer.outcome == SignIn::kOk && answer.actor.userId == session_->actor().userId) {
            session_->setActor(answer.actor);  // the password was shown again
            dialogLock_->uncover();
            show(desk_);
          } else if (answer.outcome == SignIn::kWait) {
            sayLocked(tr("Too many wrong tries. Please wait %1")
                          .arg(clockTimeLeft(answer.waitUntilUtc_us - session_->now_us())));
          } else {
            sayLocked(tr("The password is not correct. Please try again"));
          }
        };
      },
      [this](const std::exception_ptr& problem) { sayLocked(problemSentence(problem)); });
}

}  // namespace torsio::gui
