// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include <QDialog>
#include <QEvent>
#include <QWidget>

namespace torsio::gui {

/// Keeps a widget in the middle of its parent, however large that becomes.
class InTheMiddle final : public QObject {
 public:
  explicit InTheMiddle(QWidget& kept) : QObject(&kept), kept_(kept) {
    kept.parentWidget()->installEventFilter(this);
    place();
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Resize) {
      place();
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  void place() {
    const QSize free = kept_.parentWidget()->size() - kept_.size();
    kept_.move(std::max(0, free.width() / 2), std::max(0, free.height() / 2));
  }

  QWidget& kept_;
};

/// Shows a dialog as a part of its parent, in the middle: pictures of the window have it then. The dialog has
/// a parent. GUI thread.
inline void placeDialog(QDialog& dialog) {
  dialog.setWindowFlags(Qt::Widget);
  dialog.setProperty("placed", true);  // has an edge in the style sheet: no window draws one around it
  dialog.setAutoFillBackground(true);
  dialog.resize(dialog.sizeHint());
  new InTheMiddle(dialog);  // the dialog owns it
  dialog.show();
}

}  // namespace torsio::gui
