// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/look/card.h"

#include <QLabel>
#include <QVBoxLayout>

#include "app/gui/look/theme.h"

namespace torsio::gui {

Card::Card(const QString& title, QWidget* parent) : QFrame(parent), content_(new QVBoxLayout(this)) {
  setObjectName(QStringLiteral("card"));
  setAccessibleName(title);
  content_->setContentsMargins(2 * kSpace, kSpace + 2, 2 * kSpace, kSpace + 2);
  content_->setSpacing(kSpace - 2);
  auto* heading = new QLabel(title, this);
  heading->setObjectName(QStringLiteral("cardTitle"));
  content_->addWidget(heading);
}

}  // namespace torsio::gui
