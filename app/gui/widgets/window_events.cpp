// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/window_events.h"

#include <utility>

#include <QApplication>
#include <QKeyEvent>
#include <QPushButton>
#include <QToolButton>

namespace torsio::gui {

namespace {

class EnterPresses final : public QObject {
 public:
  explicit EnterPresses(QWidget& window) : QObject(&window), window_(window) {
    qApp->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::KeyPress) {
      return false;
    }
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool enter = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    const bool plain = (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    auto* button = qobject_cast<QAbstractButton*>(watched);
    const bool pressable =
        qobject_cast<QPushButton*>(watched) != nullptr || qobject_cast<QToolButton*>(watched) != nullptr;
    if (!enter || !plain || key.isAutoRepeat() || !pressable || button->window() != &window_) {
      return false;
    }
    button->click();
    return true;
  }

 private:
  QWidget& window_;
};

class LanguageFollower final : public QObject {
 public:
  LanguageFollower(QWidget* widget, std::function<void()> retranslate)
      : QObject(widget), retranslate_(std::move(retranslate)) {
    widget->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::LanguageChange) {
      retranslate_();
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  std::function<void()> retranslate_;
};

}  // namespace

void pressButtonsByEnter(QWidget& window) {
  new EnterPresses(window);  // owned by the window
}

void followLanguage(QWidget* widget, std::function<void()> retranslate) {
  retranslate();
  new LanguageFollower(widget, std::move(retranslate));  // owned by the widget
}

}  // namespace torsio::gui
