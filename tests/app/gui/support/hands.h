// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QApplication>
#include <QDialog>
#include <QFocusEvent>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRect>
#include <QString>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/gui/widgets/child.h"

namespace torsio::gui::testing {

/// Returns a button's text without mnemonic and ellipsis.
inline QString plainText(QString text) {
  return text.remove(QLatin1Char('&')).remove(QChar(0x2026));
}

/// Finds the button with this text, ignoring mnemonics and ellipsis; prefers visible ones.
inline QPushButton* button(const QWidget& in, const QString& text) {
  QPushButton* hidden = nullptr;
  for (QPushButton* found : in.findChildren<QPushButton*>()) {
    if (plainText(found->text()) != plainText(text)) {
      continue;
    }
    if (found->isVisibleTo(&in)) {
      return found;
    }
    hidden = hidden == nullptr ? found : hidden;
  }
  return hidden;
}

inline void press(const QWidget& in, const QString& text) {
  QPushButton* found = button(in, text);
  ASSERT_NE(found, nullptr) << text.toStdString();
  ASSERT_TRUE(found->isEnabled()) << text.toStdString();
  found->click();
}

/// Finds the visible field with this name.
template <typename Widget>
Widget* named(const QWidget& where, const QString& name) {
  for (Widget* widget : where.findChildren<Widget*>()) {
    if (widget->accessibleName() == name && widget->isVisibleTo(&where)) {
      return widget;
    }
  }
  ADD_FAILURE() << "no field " << name.toStdString();
  return nullptr;
}

/// Answers the next modal dialog.
inline void answer(const std::function<void(QDialog&)>& fill) {
  QTimer::singleShot(0, [fill] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    fill(*dialog);
  });
}

/// Gives the reason that a dialog asks for, and accepts it.
inline void giveReason(QDialog& dialog) {
  child<QLineEdit>(dialog, "reason").setText(QStringLiteral("asked for it"));
  dialog.accept();
}

inline void type(QDialog& dialog, const QString& text) {
  if (auto* input = qobject_cast<QInputDialog*>(&dialog)) {
    input->setTextValue(text);
  } else {
    dialog.findChild<QLineEdit*>()->setText(text);
  }
  dialog.accept();
}

/// Returns the error message directly below a field; empty: none.
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

/// Sends the focus-out event of a field.
inline void leave(QWidget& field) {
  QFocusEvent out(QEvent::FocusOut, Qt::TabFocusReason);
  QApplication::sendEvent(&field, &out);
}

inline void retype(QLineEdit& field, const QString& text) {
  field.setText(text);
  Q_EMIT field.textEdited(text);
}

}  // namespace torsio::gui::testing
