// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/station_parts.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLayout>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/gui/widgets/form.h"
#include "app/gui/widgets/icons.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

PageColumn pageColumn(QWidget* page, int widest) {
  QVBoxLayout* outer = columnOf(page, {});
  auto* scroll = new QScrollArea(page);
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  outer->addWidget(scroll);
  auto* ground = new QWidget;
  scroll->setWidget(ground);
  auto* row = new QHBoxLayout(ground);
  row->setContentsMargins(kPageMargin, kPageMargin, kPageMargin, kPageMargin);
  auto* body = new QWidget(ground);
  if (widest > 0) {
    body->setMaximumWidth(widest);
  }
  row->addStretch(1);
  row->addWidget(body, 100);
  row->addStretch(1);
  PageColumn made{.column = new QVBoxLayout(body)};
  made.column->setContentsMargins(0, 0, 0, 0);
  made.column->setSpacing(2 * kSpace);
  made.heading = new PageHeading(body);
  made.column->addWidget(made.heading);
  return made;
}

void emptyLayout(QLayout* layout) {
  while (QLayoutItem* item = layout->takeAt(0)) {
    if (item->layout() != nullptr) {
      emptyLayout(item->layout());
    }
    if (item->widget() != nullptr) {
      // The widget's own click may still be in its slot.
      item->widget()->setParent(nullptr);
      item->widget()->deleteLater();
    }
    delete item;
  }
}

QLabel* plainLabel(QWidget* parent, const char* look) {
  QLabel* label = sentence(parent, false);
  if (look != nullptr) {
    label->setProperty(look, true);
  }
  return label;
}

void makeHuge(QLabel* label, double points) {
  // The application's style sheet overrides setFont(); a widget's own style sheet overrides both.
  label->setStyleSheet(QStringLiteral("font-size: %1pt; font-weight: 600;").arg(points));
}

FoldedText::FoldedText(QWidget* parent)
    : QWidget(parent), line_(new FoldLine(this)), text_(named(sentence(this, true), "folded")) {
  auto* column = bareLayout<QVBoxLayout>(this, 0);
  column->addWidget(line_);
  column->addWidget(text_);
  text_->hide();
  setLook(line_->label(), "quiet", true);
  connect(line_, &FoldLine::toggled, text_, &QLabel::setVisible);
}

void FoldedText::setTexts(const QString& line, const QString& text) {
  line_->setText(line);
  text_->setText(text);
}

void showIcon(QLabel* label, const QString& name, const QColor& colour, int size) {
  label->setPixmap(icon(name, colour).pixmap(size, size));
  label->setFixedSize(size, size);
}

}  // namespace torsio::gui
