// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/scroll_gap.h"

#include <QEvent>
#include <QLayout>
#include <QScrollArea>
#include <QScrollBar>

#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

class ScrollGap final : public QObject {
 public:
  explicit ScrollGap(QLayout& content) : QObject(&content), content_(content) {}

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Show || event->type() == QEvent::Hide) {
      QMargins margins = content_.contentsMargins();
      margins.setRight(event->type() == QEvent::Show ? kSpace : 0);
      content_.setContentsMargins(margins);
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  QLayout& content_;
};

}  // namespace

void keepOffScrollBar(QScrollArea& area, QLayout& content) {
  QMargins margins = content.contentsMargins();
  margins.setRight(0);
  content.setContentsMargins(margins);
  area.verticalScrollBar()->installEventFilter(new ScrollGap(content));
}

}  // namespace torsio::gui
