// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/head_notice.h"

#include <QClipboard>
#include <QDateTime>
#include <QEvent>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/date_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/maintenance/anchor.h"

namespace torsio::gui {

HeadNotice::HeadNotice(QWidget* parent)
    : QWidget(parent),
      heading_(new QLabel(this)),
      facts_(sentence(this, false)),
      hash_(new QLabel(this)),
      where_(sentence(this)),
      copy_(linkButton(this)) {
  setObjectName(QStringLiteral("headNotice"));
  heading_->setProperty("subheading", true);
  hash_->setObjectName(QStringLiteral("headHash"));
  hash_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  hash_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  where_->setProperty("small", true);
  copy_->setObjectName(QStringLiteral("copyHead"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kSpace / 2);
  auto* top = new QHBoxLayout;
  top->addWidget(heading_);
  top->addStretch(1);
  top->addWidget(copy_);
  column->addLayout(top);
  for (QLabel* label : {facts_, hash_, where_}) {
    column->addWidget(label);
  }
  connect(copy_, &QPushButton::clicked, this, [this] {
    QGuiApplication::clipboard()->setText(toQString(head_.line));
    copy_->setText(tr("Copied"));
  });
  hide();
}

void HeadNotice::tell(const LeftHead& head) {
  head_ = head;
  retranslate();
  show();
}

void HeadNotice::forget() {
  head_ = {};
  hide();
}

void HeadNotice::retranslate() {
  if (head_.line.empty()) {
    return;
  }
  const AnchoredHead head = readHead(head_.line);
  const QDateTime time = QDateTime::fromMSecsSinceEpoch(head.utc_us / 1000, Qt::UTC);
  heading_->setText(tr("Head of the audit trail"));
  facts_->setText(tr("%Ln entry(s), %1 UTC, %2", nullptr, static_cast<int>(head.length))
                      .arg(QStringLiteral("%1 %2").arg(dateText(time.date()),
                                                       time.time().toString(QStringLiteral("HH:mm:ss"))),
                           head.isSigned() ? tr("signed") : tr("not signed")));
  const QString hash = toQString(head.hash);
  hash_->setText(hash.left(hash.size() / 2) + QLatin1Char('\n') + hash.mid(hash.size() / 2));
  hash_->setAccessibleName(tr("Hash of the newest entry: %1").arg(hash));
  if (!head_.trouble.str().empty()) {
    where_->setText(tr("The head was not saved. %1").arg(toQString(head_.trouble)));
  } else if (!head_.witness.empty()) {
    where_->setText(
        tr("It was added to the witness file of this station: %1").arg(toQString(head_.witness.string())));
  } else {
    where_->setText(
        tr("This station keeps no heads. Copy the head or write it down and keep it away from the record: it "
           "shows later whether the trail was truncated or rewritten."));
  }
  setLook(where_, "caution", !head_.trouble.str().empty());
  copy_->setText(tr("&Copy the head"));
}

void HeadNotice::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
  }
  QWidget::changeEvent(event);
}

}  // namespace torsio::gui
