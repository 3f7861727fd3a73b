// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/page_heading.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

PageHeading::PageHeading(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), sentence_(gui::sentence(this)), actions_(new QHBoxLayout) {
  title_->setProperty("heading", true);
  auto* texts = new QVBoxLayout;
  texts->setSpacing(kSpace / 2);
  texts->addWidget(title_);
  texts->addWidget(sentence_);
  actions_->setSpacing(kSpace);
  auto* row = bareLayout<QHBoxLayout>(this, 2 * kSpace);
  row->addLayout(texts, 1);
  row->addLayout(actions_);
  row->setAlignment(actions_, Qt::AlignTop);
}

void PageHeading::setTexts(const QString& title, const QString& sentence) {
  title_->setText(title);
  title_->setVisible(!title.isEmpty());
  sentence_->setText(sentence);
  sentence_->setVisible(!sentence.isEmpty());
  setAccessibleName(title.isEmpty() ? sentence : title);
}

void PageHeading::addAction(QWidget* button) {
  actions_->addWidget(button);
}

}  // namespace torsio::gui
