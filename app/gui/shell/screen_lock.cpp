// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/screen_lock.h"

#include <QApplication>
#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/gui/widgets/window_events.h"
#include "app/services/access/access_service.h"

namespace torsio::gui {

namespace {

constexpr int kLockWidth = 420;

constexpr auto kVeilName = "lockVeil";

QFrame* veilOf(const QWidget& dialog) {
  return dialog.findChild<QFrame*>(QLatin1String(kVeilName), Qt::FindDirectChildrenOnly);
}

}  // namespace

LockPanel::LockPanel(QWidget* parent) : QWidget(parent) {
  QVBoxLayout* column = centredCard(this, kLockWidth);
  heading_ = new QLabel(this);
  heading_->setProperty("heading", true);
  why_ = sentence(this);
  secret_ = secretField(this);
  answer_ = sentence(this, false);
  setLook(answer_, "caution", true);
  unlock_ = primaryButton(this);
  signOut_ = linkButton(this);
  column->addWidget(heading_);
  column->addWidget(why_);
  column->addSpacing(kSpace);
  label_ = addField(column, secret_);
  column->addWidget(answer_);
  auto* row = new QHBoxLayout;
  row->addWidget(signOut_);
  row->addStretch(1);
  row->addWidget(unlock_);
  column->addLayout(row);
  const auto give = [this] {
    if (secret_->text().isEmpty() || !unlock_->isEnabled()) {
      return;
    }
    const QString password = secret_->text();
    secret_->clear();
    Q_EMIT passwordGiven(password);
  };
  connect(unlock_, &QPushButton::clicked, this, give);
  connect(secret_, &QLineEdit::returnPressed, this, give);
  connect(signOut_, &QPushButton::clicked, this, &LockPanel::signOutWanted);
  followLanguage(this, [this] { retranslate(); });
}

void LockPanel::begin(const QString& login) {
  login_ = login;
  secret_->clear();
  say({});
  setWorking(false);
  retranslate();
}

void LockPanel::say(const QString& text) {
  answer_->setText(text);
}

void LockPanel::setWorking(bool working) {
  unlock_->setEnabled(!working);
  secret_->setEnabled(!working);
  signOut_->setEnabled(!working);
  if (!working && isVisible()) {
    secret_->setFocus();  // when hidden, it would take the focus from the sign-in
  }
}

void LockPanel::retranslate() {
  heading_->setText(tr("Locked"));
  why_->setText(tr("%1 is signed in here. Nothing was lost; work continues where it was left.").arg(login_));
  nameField(label_, tr("&Password"));
  unlock_->setText(tr("Unlock"));
  signOut_->setText(tr("Sign out"));
}

void LockPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  secret_->setFocus();
}

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
        return signInAgain(own, login, password);
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

DialogLock::DialogLock(QWidget* window)
    : QDialog(window, Qt::Dialog | Qt::CustomizeWindowHint | Qt::WindowTitleHint),
      panel_(new LockPanel(this)) {
  setWindowModality(Qt::ApplicationModal);
  auto* column = bareLayout<QVBoxLayout>(this);
  column->addWidget(panel_);
}

std::vector<QDialog*> DialogLock::openDialogs() const {
  std::vector<QDialog*> open;
  for (QWidget* widget : QApplication::topLevelWidgets()) {
    auto* dialog = qobject_cast<QDialog*>(widget);
    if (dialog != nullptr && dialog != this && dialog->isVisible()) {
      open.push_back(dialog);
    }
  }
  return open;
}

void DialogLock::cover() {
  const std::vector<QDialog*> open = openDialogs();
  if (open.empty()) {
    return;
  }
  for (QDialog* dialog : open) {
    auto* veil = new QFrame(dialog);
    veil->setObjectName(QLatin1String(kVeilName));
    veil->setAutoFillBackground(true);
    veil->setGeometry(dialog->rect());
    veil->show();
    veil->raise();
    dialog->installEventFilter(this);
  }
  setWindowTitle(parentWidget()->windowTitle());
  resize(panel_->sizeHint());
  show();
  raise();
  activateWindow();
}

void DialogLock::uncover() {
  hide();
  for (QDialog* dialog : openDialogs()) {
    dialog->removeEventFilter(this);
    delete veilOf(*dialog);
  }
}

void DialogLock::closeOthers() {
  const std::vector<QDialog*> open = openDialogs();
  hide();
  // Newest first: each returns to the one that opened it.
  for (auto dialog = open.rbegin(); dialog != open.rend(); ++dialog) {
    (*dialog)->done(QDialog::Rejected);
  }
}

bool DialogLock::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    auto* dialog = static_cast<QWidget*>(watched);
    if (QFrame* veil = veilOf(*dialog)) {
      veil->setGeometry(dialog->rect());
    }
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace torsio::gui
