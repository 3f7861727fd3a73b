// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QFocusEvent>
#include <QLabel>
#include <QLineEdit>
#include <QRect>
#include <QString>
#include <QWidget>

namespace torsio::gui::testing {

/// The hint that stands directly below a field; "" where none is shown.
inline QString hintBelow(const QWidget& window, const QWidget& field) {
  constexpr int kNear_px = 60;
  QApplication::processEvents();
  const QRect place(field.mapTo(&window, QPoint()), field.size());
  for (const QLabel* hint : window.findChildren<QLabel*>(QStringLiteral("fieldHint"))) {
    const QRect said(hint->mapTo(&window, QPoint()), hint->size());
    const bool below = said.top() >= place.bottom() - 2 && said.top() < place.bottom() + kNear_px;
    if (hint->isVisible() && below && said.right() > place.left() && said.left() < place.right()) {
      return hint->text();
    }
  }
  return {};
}

/// As the keyboard leaves a field.
inline void leave(QWidget& field) {
  QFocusEvent out(QEvent::FocusOut, Qt::TabFocusReason);
  QApplication::sendEvent(&field, &out);
}

inline void retype(QLineEdit& field, const QString& text) {
  field.setText(text);
  Q_EMIT field.textEdited(text);
}

}  // namespace torsio::gui::testing
