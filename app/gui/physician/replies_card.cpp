// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/replies_card.h"

#include <algorithm>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/review/case_remarks.h"

namespace torsio::gui {

namespace {

constexpr std::size_t kShownReplies = 3;

}  // namespace

RepliesCard::RepliesCard(ShellContext& shell, QWidget* parent)
    : Card(QString(), parent), shell_(shell), list_(new QVBoxLayout) {
  list_->setSpacing(kSpace / 2);
  content()->addLayout(list_);
  hide();
}

void RepliesCard::read() {
  const std::vector<RemarkReply> replies = repliesToMe(shell_.session());
  setVisible(!replies.empty());
  setTitle(replies.size() > kShownReplies ? tr("Answers to your remarks: %1").arg(replies.size())
                                          : tr("Answers to your remarks"));
  emptyLayout(list_);
  for (std::size_t i = 0; i < std::min(kShownReplies, replies.size()); ++i) {
    const RemarkReply& reply = replies[i];
    auto* row = new QHBoxLayout;
    auto* words = sentence(this, false);
    words->setText(tr("%1 (you wrote: %2)").arg(toQString(reply.text), toQString(reply.remark)));
    auto* done = new QPushButton(tr("Read"), this);
    done->setObjectName(QStringLiteral("readReply"));
    connect(done, &QPushButton::clicked, this, [this, id = reply.id, version = reply.version] {
      attempt(shell_, [&] {
        markReplyRead(shell_.session(), id, version);
        read();
      });
    });
    row->addWidget(words, 1);
    row->addWidget(done, 0, Qt::AlignTop);
    list_->addLayout(row);
  }
}

void RepliesCard::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange && !isHidden()) {
    attempt(shell_, [this] { read(); });
  }
  Card::changeEvent(event);
}

}  // namespace torsio::gui
