// SPDX-License-Identifier: GPL-3.0-or-later
// Of MainWindow: the desk of whoever signed in.
#include <QInputDialog>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QThread>
#include <QTimer>

#include "app/gui/base/translated_text.h"
#include "app/gui/shell/about_box.h"
#include "app/gui/shell/dialog_lock.h"
#include "app/gui/shell/lock_panel.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/password_panel.h"
#include "app/gui/shell/rail.h"
#include "app/gui/shell/shortcut_sheet.h"
#include "app/gui/shell/sign_in_panel.h"
#include "app/services/access/settings_service.h"
#include "app/services/maintenance/demonstration_removal.h"
#include "app/services/recording/station_writer.h"

namespace torsio::gui {

void MainWindow::tellKept() {
  if (kept_.empty() || session_->actor().practiceOnly) {
    return;
  }
  desk_->context().tell([kept = kept_] {
    return TranslatedError{
        tr("%n recording(s) of this station could not be stored", nullptr, static_cast<int>(kept.size())),
        tr("The files are kept. Please show this to your administrator"), translatedLines(kept)};
  });
  kept_.clear();
}

void MainWindow::enterDesk() {
  leaveDesk();
  if (!setup_.idle) {
    idle_.setLimits(centreIdleLimits(session_->connectionWithoutRight()));
  }
  applyChoices(userId());
  openDesk();
  tellKept();
}

void MainWindow::openDesk() {
  DeskSetup setup;
  setup.assets = setup_.assets;
  setup.centre = lookedAt_ ? QString() : centre_;  // the line of the look round says it
  setup.language = language_.present();
  setup.theme = theme_;
  setup.kiosk = setup_.kiosk;
  setup.groups = setup_.groups;
  desk_ = new Desk(*session_, setup, this);
  desk_->context().setLine(line_.get());
  desk_->setObjectName(QStringLiteral("desk"));
  stack_->addWidget(desk_);
  connect(desk_, &Desk::signOutWanted, this, [this] { signOut(); });
  connect(desk_, &Desk::lockWanted, this, &MainWindow::lock);
  connect(desk_, &Desk::languageWanted, this, &MainWindow::chooseLanguage);
  connect(desk_, &Desk::themeWanted, this, &MainWindow::chooseTheme);
  connect(desk_, &Desk::pinWanted, this, &MainWindow::choosePin);
  connect(desk_, &Desk::shortcutsWanted, this, [this] { ShortcutSheet(desk_, this).exec(); });
  connect(desk_, &Desk::aboutWanted, this, [this] { showAboutBox(this); });
  connect(desk_, &Desk::demonstrationRemovalWanted, this, &MainWindow::removeDemonstration);
  connect(desk_, &Desk::simulatedWanted, this, &MainWindow::enterAsSimulated);
  connect(desk_, &Desk::passwordChangeWanted, this, [this] {
    password_->begin(toQString(session_->actor().login), {}, false);
    show(password_);
  });
  // Later, since the page that asks for it dies with the desk.
  connect(&desk_->context(), &ShellContext::recordChangeWanted, this, [this](const RecordChange& change) {
    QTimer::singleShot(0, this, [this, change] { changeRecord(change); });
  });
  desk_->rail().setNarrow(preferences_.layout(QStringLiteral("rail_narrow")).toBool());
  connect(&desk_->rail(), &Rail::narrowChanged, this,
          [this](bool narrow) { preferences_.setLayout(QStringLiteral("rail_narrow"), narrow); });
  show(desk_);
  deskLevel_ = QThread::currentThread()->loopLevel();
  desk_->openHome(preferences_.page(userId()));
}

void MainWindow::leaveDesk() {
  if (desk_ == nullptr) {
    return;
  }
  if (desk_->pageId()) {
    preferences_.setPage(userId(), pageText(*desk_->pageId()));
  }
  stack_->removeWidget(desk_);
  delete desk_;
  desk_ = nullptr;
}

bool MainWindow::signOut(const QString& reason) {
  if (desk_ != nullptr && !desk_->mayLeave()) {
    return false;
  }
  leaveDesk();
  simulated_ = false;
  const std::optional<LeftHead> head = forgetActor();
  if (lookedAt_) {
    endLookRound();
    openDatabase();
    return true;
  }
  enterSignIn();
  if (!reason.isEmpty()) {
    signIn_->say(reason, false);
  }
  tellHead(head);
  return true;
}

bool MainWindow::lock() {
  if (desk_ == nullptr || stack_->currentWidget() != desk_ || desk_->busy()) {
    return false;
  }
  if (session_->actor().practiceOnly || lookedAt_ || simulated_) {
    return signOut();  // nothing to come back to
  }
  for (LockPanel* lock : {lock_, &dialogLock_->panel()}) {
    lock->begin(toQString(session_->actor().login));
  }
  show(lock_);
  dialogLock_->cover();
  return true;
}

void MainWindow::signOutBeyondDialogs(const QString& reason) {
  dialogLock_->closeOthers();
  if (QThread::currentThread()->loopLevel() > deskLevel_) {
    // Whoever opened a dialog still waits in its event loop, and belongs to the desk: that returns first.
    QTimer::singleShot(0, this, [this, reason] { signOutBeyondDialogs(reason); });
    return;
  }
  if (desk_ == nullptr || signOut(reason)) {
    return;
  }
  if (stack_->currentWidget() == desk_) {
    lock();
  }
  sayLocked(tr("Something is unfinished here. Only its owner can sign out"));
}

void MainWindow::choosePin() {
  bool entered = false;
  const QString pin = QInputDialog::getText(this, tr("PIN for practice"),
                                            tr("At least four digits. With it you practise at a station; "
                                               "nothing is recorded.\nLeave it empty to remove it."),
                                            QLineEdit::Password, {}, &entered);
  if (!entered) {
    return;
  }
  attempt(desk_->context(), [&] {
    setOwnPin(*session_, pin.toStdString());
    desk_->context().notify(pin.isEmpty() ? tr("The PIN was removed") : tr("The PIN is now in use"));
  });
}

void MainWindow::removeDemonstration() {
  attempt(desk_->context(), [&] {
    const DemonstrationSize size = demonstrationSize(*session_);
    if (size.rows == 0) {
      desk_->context().notify(tr("There is no demonstration data"));
      return;
    }
    const QLocale locale;
    QMessageBox question(QMessageBox::Question, tr("Remove demonstration data"),
                         tr("Remove the simulated people (%1), their runs (%2) and marks (%3)?")
                             .arg(locale.toString(static_cast<qlonglong>(size.people)),
                                  locale.toString(static_cast<qlonglong>(size.trials)),
                                  locale.toString(static_cast<qlonglong>(size.marks))),
                         QMessageBox::Cancel, this);
    question.setInformativeText(tr("Your own data stay as they are. This cannot be undone."));
    const QAbstractButton* remove = question.addButton(tr("Remove"), QMessageBox::DestructiveRole);
    question.setDefaultButton(QMessageBox::Cancel);
    question.exec();
    if (question.clickedButton() != remove) {
      return;
    }
    desk_->context().run(
        desk_, tr("Removing the demonstration"),
        [reason = tr("Removed from the user menu").toStdString()](SessionContext& own,
                                                                  const ProgressCallback&) {
          static_cast<void>(removeDemonstrationData(own, reason));
        },
        [this] { desk_->context().notify(tr("The demonstration data were removed")); });
  });
}

}  // namespace torsio::gui
