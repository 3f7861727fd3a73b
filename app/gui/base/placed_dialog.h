// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include <QDialog>
#include <QEvent>
#include <QFrame>
#include <QPointer>
#include <QWidget>

namespace torsio::gui {

/// Keeps a widget centred in its parent, with a border in place of a window frame.
class InTheMiddle final : public QObject {
 public:
  explicit InTheMiddle(QWidget& kept) : QObject(&kept), kept_(kept), edge_(new QFrame(kept.parentWidget())) {
    edge_->setProperty("around", true);  // for the style sheet
    edge_->setAttribute(Qt::WA_TransparentForMouseEvents);
    kept.parentWidget()->installEventFilter(this);
    kept.installEventFilter(this);
    place();
  }
  ~InTheMiddle() override { delete edge_; }
  InTheMiddle(const InTheMiddle&) = delete;
  InTheMiddle& operator=(const InTheMiddle&) = delete;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (edge_ == nullptr) {
      return false;  // the parent is being destroyed
    }
    if (event->type() == QEvent::Resize) {
      place();
    }
    if (watched == &kept_ && (event->type() == QEvent::Show || event->type() == QEvent::Hide)) {
      edge_->setVisible(event->type() == QEvent::Show);
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  void place() {
    const QSize free = kept_.parentWidget()->size() - kept_.size();
    kept_.move(std::max(0, free.width() / 2), std::max(0, free.height() / 2));
    edge_->setGeometry(kept_.geometry().adjusted(-1, -1, 1, 1));
    edge_->stackUnder(&kept_);
  }

  QWidget& kept_;
  QPointer<QFrame> edge_;
};

/// Shows a dialog centred inside its parent, so that screenshots of the window include it. The dialog must
/// have a parent. GUI thread.
inline void placeDialog(QDialog& dialog) {
  dialog.setWindowFlags(Qt::Widget);
  dialog.setAutoFillBackground(true);
  dialog.resize(dialog.sizeHint());
  new InTheMiddle(dialog);  // owned by the dialog
  dialog.show();
}

}  // namespace torsio::gui
