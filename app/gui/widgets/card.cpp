// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/card.h"

#include <QLabel>
#include <QVBoxLayout>

#include "app/gui/widgets/theme.h"

namespace torsio::gui {

Card::Card(const QString& title, QWidget* parent)
    : QFrame(parent), content_(new QVBoxLayout(this)), heading_(new QLabel(this)) {
  setObjectName(QStringLiteral("card"));
  setProperty("card", true);  // keeps the style under another object name
  content_->setContentsMargins(2 * kSpace, kSpace + 2, 2 * kSpace, kSpace + 2);
  content_->setSpacing(kSpace - 2);
  heading_->setObjectName(QStringLiteral("cardTitle"));
  content_->addWidget(heading_);
  setTitle(title);
}

void Card::setTitle(const QString& title) {
  setAccessibleName(title);
  heading_->setText(title);
  heading_->setVisible(!title.isEmpty());
}

}  // namespace torsio::gui
