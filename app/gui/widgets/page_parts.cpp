// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/page_parts.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
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

FoldLine::FoldLine(QWidget* parent) : QWidget(parent), label_(new QLabel(this)), button_(linkButton(this)) {
  label_->setTextFormat(Qt::PlainText);
  label_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  button_->setObjectName(QStringLiteral("unfold"));
  auto* row = bareLayout<QHBoxLayout>(this, kSpace);
  row->addWidget(label_, 1);
  row->addWidget(button_);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  connect(button_, &QPushButton::clicked, this, [this] {
    setOpen(!open_);
    Q_EMIT toggled(open_);
  });
  retranslate();
}

void FoldLine::setText(const QString& text) {
  text_ = text;
  showText();
  retranslate();
}

void FoldLine::setFoldable(bool foldable) {
  button_->setVisible(foldable);
}

void FoldLine::setOpen(bool open) {
  open_ = open;
  retranslate();
}

void FoldLine::showText() {
  const QString shown =
      isVisible() ? label_->fontMetrics().elidedText(text_, Qt::ElideRight, label_->width()) : text_;
  label_->setText(shown);
  label_->setToolTip(shown == text_ ? QString() : text_);
  label_->setAccessibleName(text_);
}

void FoldLine::retranslate() {
  button_->setText(open_ ? tr("Hide") : tr("Show"));
  button_->setAccessibleName(tr("%1: %2").arg(button_->text(), text_));
}

void FoldLine::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  layout()->activate();
  showText();
}

void FoldLine::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  layout()->activate();
  showText();
}

}  // namespace torsio::gui
