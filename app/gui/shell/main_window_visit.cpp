// SPDX-License-Identifier: GPL-3.0-or-later
// Of MainWindow: simulated people, of a look round and of a demonstration.
#include <QTemporaryDir>
#include <QTimer>

#include "app/gui/shell/main_window.h"
#include "app/services/access/access_service.h"

namespace torsio::gui {

void MainWindow::lookRound(VisitedDesk desk) {
  visitedFirst_ = desk;
  lookedAt_ = std::make_unique<QTemporaryDir>();
  if (!lookedAt_->isValid()) {
    firstRun_->say(tr("No folder can be made for it: %1").arg(lookedAt_->errorString()));
    lookedAt_.reset();
    return;
  }
  lookedFrom_ = setup_.locator;
  FirstRunChoice choice;
  choice.locator = lookedAt_->filePath(QStringLiteral("torsio.sqlite"));
  choice.first.centre = tr("Look round: simulated people").toStdString();
  choice.first.login = "visitor";
  choice.first.password = randomStartPassword();
  choice.first.language = languageCode(firstRun_->language()).toStdString();
  choice.first.demonstration = true;
  setUp(choice);
}

void MainWindow::endLookRound() {
  if (!lookedAt_) {
    return;
  }
  if (line_) {
    line_->leave();
  }
  line_.reset();
  lessons_.reset();
  session_.reset();  // nobody has the record open now
  lookedAt_.reset();
  setup_.locator = lookedFrom_;
}

void MainWindow::enterAsSimulated(SimulatedRole role) {
  if (desk_ == nullptr || !desk_->mayLeave()) {
    return;
  }
  if (lookedAt_) {
    visit(role == SimulatedRole::kTrainee ? VisitedDesk::kTrainee : VisitedDesk::kPhysician);
    return;
  }
  Actor person;
  if (!attempt(desk_->context(), [&] { person = simulatedPerson(desk_->context().session(), role); })) {
    return;
  }
  enterDeskAs(person, true,
              role == SimulatedRole::kTrainee
                  ? tr("You are a simulated trainee. Sign out to return to your own account")
                  : tr("You are a simulated physician. Sign out to return to your own account"));
}

void MainWindow::visit(VisitedDesk desk) {
  if (!lookedAt_ || desk_ == nullptr || !desk_->mayLeave()) {
    return;
  }
  const Actor before = session_->actor();
  Actor next = visitor_;
  const bool simulated = desk != VisitedDesk::kAdministrator;
  if (simulated) {
    session_->setActor(visitor_);
    const bool found = attempt(desk_->context(), [&] {
      next = simulatedPerson(
          *session_, desk == VisitedDesk::kTrainee ? SimulatedRole::kTrainee : SimulatedRole::kPhysician);
    });
    session_->setActor(before);
    if (!found) {
      return;
    }
  }
  if (!simulated) {  // nobody knows the password of the visitor, and what is signed goes with the folder
    next.passwordShownUtc_us = session_->now_us();
  }
  visit_->setSeen(desk);
  enterDeskAs(next, simulated, tr("Everybody here is simulated. All of it is deleted when you sign out"));
}

void MainWindow::enterDeskAs(const Actor& actor, bool simulated, const QString& sentence) {
  // Later, since the menu or page that asked dies with the desk.
  QTimer::singleShot(0, this, [this, actor, simulated, sentence] {
    leaveDesk();
    forgetActor();
    session_->setActor(actor);
    simulated_ = simulated;
    enterDesk();
    desk_->context().notify(sentence);
  });
}

}  // namespace torsio::gui
