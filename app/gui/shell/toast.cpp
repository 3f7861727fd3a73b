// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/toast.h"

#include <algorithm>

#include <QAccessible>
#include <QEvent>

#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr int kShown_ms = 6000;
constexpr int kLongest = 720;

}  // namespace

Toast::Toast(QWidget* parent) : QLabel(parent) {
  setObjectName(QStringLiteral("toast"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setWordWrap(true);
  setTextFormat(Qt::PlainText);
  setAlignment(Qt::AlignCenter);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &QWidget::hide);
  parent->installEventFilter(this);
  hide();
}

void Toast::say(const QString& sentence) {
  setText(sentence);
  setAccessibleName(sentence);
  place();
  raise();
  show();
  timer_.start(kShown_ms);
  QAccessibleEvent heard(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&heard);
}

bool Toast::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) {
    place();
  }
  return QLabel::eventFilter(watched, event);
}

void Toast::place() {
  const QWidget* ground = parentWidget();
  const int widest = std::min(kLongest, ground->width() - 4 * kSpace);
  setWordWrap(false);
  const int wanted = sizeHint().width();
  setWordWrap(true);
  const int width = std::min(wanted, widest);
  const int height = heightForWidth(width);
  setGeometry((ground->width() - width) / 2, ground->height() - height - 3 * kSpace, width, height);
}

}  // namespace torsio::gui
