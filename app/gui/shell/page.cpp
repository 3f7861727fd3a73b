// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/page.h"

#include <QEvent>

namespace torsio::gui {

void Page::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace torsio::gui
