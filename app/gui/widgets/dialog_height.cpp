// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/dialog_height.h"

#include <algorithm>

#include <QLayout>
#include <QWidget>

namespace torsio::gui {

void growToSentences(QWidget* dialog) {
  dialog->layout()->activate();
  const int width = std::max(dialog->width(), dialog->minimumWidth());
  dialog->setMinimumHeight(std::max(dialog->minimumHeight(), dialog->layout()->totalHeightForWidth(width)));
}

}  // namespace torsio::gui
