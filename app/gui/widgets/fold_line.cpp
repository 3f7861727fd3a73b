// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/fold_line.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

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
