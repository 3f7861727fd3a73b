// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/visit_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "app/gui/widgets/theme.h"

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
  retranslate();
}

void VisitBar::setSeen(VisitedDesk desk) {
  seen_ = desk;
  for (const auto& [which, button] : desks_) {
    button->setChecked(which == desk);
  }
}

void VisitBar::retranslate() {
  sentence_->setText(tr("You are looking round among simulated people. Whose desk?"));
  desks_.at(VisitedDesk::kTrainee)->setText(tr("Trainee"));
  desks_.at(VisitedDesk::kPhysician)->setText(tr("Physician"));
  desks_.at(VisitedDesk::kAdministrator)->setText(tr("Administrator"));
}

void VisitBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
  }
  QFrame::changeEvent(event);
}

}  // namespace torsio::gui
