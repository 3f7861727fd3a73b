// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/simulated_desks.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>

#include "app/gui/base/language.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/shell/founding.h"
#include "app/gui/shell/open_record.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/window_events.h"
#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"

namespace torsio::gui {

VisitBar::VisitBar(QWidget* parent) : QFrame(parent), sentence_(new QLabel(this)) {
  setObjectName(QStringLiteral("visit"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(3 * kSpace, kSpace / 2, 3 * kSpace, kSpace / 2);
  row->setSpacing(kSpace);
  row->addWidget(sentence_);
  row->addSpacing(kSpace);
  constexpr std::pair<VisitedDesk, const char*> kDesks[] = {
      {VisitedDesk::kTrainee, "visitTrainee"},
      {VisitedDesk::kPhysician, "visitPhysician"},
      {VisitedDesk::kAdministrator, "visitAdministrator"}};
  for (const auto& [desk, name] : kDesks) {
    auto* button = new QPushButton(this);
    button->setObjectName(QLatin1String(name));
    button->setCheckable(true);
    row->addWidget(button);
    desks_.emplace(desk, button);
    connect(button, &QPushButton::clicked, this, [this, desk = desk] {
      setSeen(seen_);
      if (desk != seen_) {
        Q_EMIT wanted(desk);
      }
    });
  }
  row->addStretch(1);
  setSeen(seen_);
  followLanguage(this, [this] { retranslate(); });
}

void VisitBar::setSeen(VisitedDesk desk) {
  seen_ = desk;
  for (const auto& [which, button] : desks_) {
    button->setChecked(which == desk);
  }
}

void VisitBar::retranslate() {
  sentence_->setText(tr("Sample data. View as:"));
  desks_.at(VisitedDesk::kTrainee)->setText(tr("Trainee"));
  desks_.at(VisitedDesk::kPhysician)->setText(tr("Physician"));
  desks_.at(VisitedDesk::kAdministrator)->setText(tr("Administrator"));
}

/// A temporary record for a visitor; its folder is deleted with it.
struct SimulatedDesks::Round {
  QTemporaryDir folder{};
  QString before{};  ///< locator to restore afterwards
  Actor visitor{};   ///< the visitor, even when seen as a simulated person
  VisitedDesk first = VisitedDesk::kAdministrator;
};

SimulatedDesks::SimulatedDesks(OpenRecord& record, Founding& founding, QWidget* window)
    : QObject(window), record_(record), founding_(founding), bar_(new VisitBar(window)) {}

SimulatedDesks::~SimulatedDesks() = default;

QString SimulatedDesks::visitorsSentence() {
  return tr("Sample data: everybody here is simulated, and everything is deleted at sign-out");
}

void SimulatedDesks::lookRound(VisitedDesk first) {
  round_ = std::make_unique<Round>();
  if (!round_->folder.isValid()) {
    founding_.panel().say(tr("No folder can be made for it: %1").arg(round_->folder.errorString()));
    round_.reset();
    return;
  }
  round_->before = record_.locator();
  round_->first = first;
  FirstRunChoice choice;
  choice.locator = round_->folder.filePath(QStringLiteral("torsio.sqlite"));
  choice.first.centre = tr("Sample data").toStdString();
  choice.first.login = "visitor";
  choice.first.password = randomStartPassword();
  choice.first.language = languageCode(founding_.panel().language()).toStdString();
  choice.first.demonstration = true;
  founding_.begin(choice);
}

VisitedDesk SimulatedDesks::begin() {
  // A visitor has no device, and results do not count.
  setCentreSetting<kGradedWithMouse>(*record_.session(), true);
  round_->visitor = record_.session()->actor();
  bar_->setSeen(VisitedDesk::kAdministrator);
  return round_->first;
}

void SimulatedDesks::visit(VisitedDesk desk, ShellContext& shell) {
  Actor next = round_->visitor;
  if (desk == VisitedDesk::kAdministrator) {
    // The visitor has no known password, and signatures are deleted with the folder.
    next.passwordShownUtc_us = record_.session()->now_us();
  } else {
    const Actor before = record_.session()->actor();
    record_.session()->setActor(round_->visitor);
    const bool found = attempt(shell, [&] {
      next = simulatedPerson(*record_.session(), desk == VisitedDesk::kTrainee ? SimulatedRole::kTrainee
                                                                               : SimulatedRole::kPhysician);
    });
    record_.session()->setActor(before);
    if (!found) {
      return;
    }
  }
  bar_->setSeen(desk);
  Q_EMIT wanted(next, visitorsSentence());
}

void SimulatedDesks::view(SimulatedRole role, ShellContext& shell) {
  const bool trainee = role == SimulatedRole::kTrainee;
  if (lookingRound()) {
    visit(trainee ? VisitedDesk::kTrainee : VisitedDesk::kPhysician, shell);
    return;
  }
  Actor person;
  if (!attempt(shell, [&] { person = simulatedPerson(shell.session(), role); })) {
    return;
  }
  simulated_ = true;
  Q_EMIT wanted(person, trainee
                            ? tr("You are a simulated trainee. Sign out to return to your own account")
                            : tr("You are a simulated physician. Sign out to return to your own account"));
}

bool SimulatedDesks::end() {
  simulated_ = false;
  if (!lookingRound()) {
    return false;
  }
  record_.close();
  record_.setLocator(round_->before);
  round_.reset();
  return true;
}

}  // namespace torsio::gui
