// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/screen_lock.h"

#include "app/gui/base/clock_time.h"
#include "app/gui/base/problem_labels.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/shell/dialog_lock.h"
#include "app/gui/shell/lock_panel.h"
#include "app/services/access/access_service.h"

namespace torsio::gui {

ScreenLock::ScreenLock(Background& background, QWidget* window)
    : QObject(window),
      background_(background),
      panel_(new LockPanel(window)),
      dialogs_(new DialogLock(window)) {
  for (LockPanel* panel : {panel_, &dialogs_->panel()}) {
    connect(panel, &LockPanel::passwordGiven, this, &ScreenLock::unlock);
    connect(panel, &LockPanel::signOutWanted, this, &ScreenLock::signOutWanted);
  }
}

QWidget* ScreenLock::panel() const noexcept {
  return panel_;
}

void ScreenLock::close(SessionContext& session, const SessionKey& key) {
  session_ = &session;
  key_ = key;
  for (LockPanel* panel : {panel_, &dialogs_->panel()}) {
    panel->begin(toQString(session.actor().login));
  }
  dialogs_->cover();
}

void ScreenLock::closeDialogs() {
  dialogs_->closeOthers();
}

void ScreenLock::say(const QString& sentence) {
  panel_->say(sentence);
  dialogs_->panel().say(sentence);
}

void ScreenLock::setWorking(bool working) {
  panel_->setWorking(working);
  dialogs_->panel().setWorking(working);
}

void ScreenLock::unlock(const QString& password) {
  background_.run(
      key_,
      [login = session_->actor().login, password = password.toStdString()](SessionContext& own) {
        return torsio::signIn(own, login, password);
      },
      [this](const SignInAnswer& answer) {
        if (answer.outcome == SignIn::kOk && answer.actor.userId == session_->actor().userId) {
          session_->setActor(answer.actor);  // re-entered with the password
          dialogs_->uncover();
          Q_EMIT opened();
        } else if (answer.outcome == SignIn::kWait) {
          say(tr("Too many wrong tries. Please wait %1")
                  .arg(clockTimeLeft(answer.waitUntilUtc_us - session_->now_us())));
        } else {
          say(tr("The password is not correct. Please try again"));
        }
      },
      [this](const std::exception_ptr& problem) { say(problemSentence(problem)); });
}

}  // namespace torsio::gui
