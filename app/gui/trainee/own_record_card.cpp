// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/own_record_card.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/people/consent_service.h"

namespace torsio::gui {

OwnRecordCard::OwnRecordCard(ShellContext& shell, QWidget* parent)
    : Card(QString(), parent),
      shell_(shell),
      words_(plainLabel(this, "quiet")),
      state_(plainLabel(this)),
      copy_(new QPushButton(this)),
      erase_(new QPushButton(this)),
      takeBack_(new QPushButton(this)) {
  copy_->setObjectName(QStringLiteral("askCopy"));
  erase_->setObjectName(QStringLiteral("askErase"));
  takeBack_->setObjectName(QStringLiteral("takeBackRequest"));
  state_->setObjectName(QStringLiteral("ownRequests"));
  content()->addWidget(words_);
  content()->addWidget(state_);
  auto* row = new QHBoxLayout;
  row->setSpacing(kSpace);
  row->addWidget(copy_);
  row->addWidget(erase_);
  row->addStretch(1);
  row->addWidget(takeBack_);
  content()->addLayout(row);
  connect(copy_, &QPushButton::clicked, this, [this] { ask(PersonRequestKind::kExport); });
  connect(erase_, &QPushButton::clicked, this, [this] { ask(PersonRequestKind::kErase); });
  connect(takeBack_, &QPushButton::clicked, this, &OwnRecordCard::takeBack);
}

void OwnRecordCard::read() {
  attempt(shell_, [&] {
    own_ = ownRequests(shell_.session());
    showState();
  });
}

const PersonRequest* OwnRecordCard::waiting(PersonRequestKind kind) const {
  const auto found = std::find_if(own_.begin(), own_.end(),
                                  [&](const PersonRequest& one) { return one.kind == kind && !one.answer; });
  return found == own_.end() ? nullptr : &*found;
}

void OwnRecordCard::showState() {
  QStringList lines;
  for (const PersonRequest& one : own_) {
    const QString what = toQString(labelOf(one.kind));
    const QString asked = dayText(one.askedUtc_us, locale());
    if (!one.answer) {
      lines << tr("You asked for %1 on %2; the centre has not answered yet.").arg(what, asked);
    } else if (*one.answer != PersonRequestAnswer::kTakenBack) {
      const QString answer = toQString(labelOf(*one.answer));
      lines << tr("You asked for %1 on %2: %3. %4").arg(what, asked, answer, toQString(one.reason)).trimmed();
    }
  }
  state_->setText(lines.join(QLatin1Char('\n')));
  state_->setVisible(!lines.isEmpty());
  copy_->setEnabled(waiting(PersonRequestKind::kExport) == nullptr);
  erase_->setEnabled(waiting(PersonRequestKind::kErase) == nullptr);
  takeBack_->setVisible(waiting(PersonRequestKind::kExport) != nullptr ||
                        waiting(PersonRequestKind::kErase) != nullptr);
}

void OwnRecordCard::ask(PersonRequestKind kind) {
  if (kind == PersonRequestKind::kErase &&
      QMessageBox::question(this, tr("Ask for erasure"),
                            tr("Your name and your recordings are removed, and nobody can bring them back; "
                               "marks stay without a person. Ask for it?")) != QMessageBox::Yes) {
    return;
  }
  attempt(shell_, [&] {
    requestAboutOwnRecord(shell_.session(), kind);
    shell_.notify(tr("The centre finds your request in its list."));
  });
  read();
}

void OwnRecordCard::takeBack() {
  attempt(shell_, [&] {
    for (const PersonRequest& one : own_) {
      if (!one.answer) {
        takeBackOwnRequest(shell_.session(), one.id);
      }
    }
  });
  read();
}

void OwnRecordCard::retranslate() {
  setTitle(tr("Your record"));
  words_->setText(
      tr("You may ask for a copy of everything that is kept about you, or that it be erased. The centre "
         "answers here."));
  copy_->setText(tr("Ask for a &copy\u2026"));
  erase_->setText(tr("Ask for &erasure\u2026"));
  takeBack_->setText(tr("Withdraw the re&quest"));
  showState();
}

}  // namespace torsio::gui
