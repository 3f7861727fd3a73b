// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace torsio::gui {

/// Shows a dialog as a part of its parent, at the top left: pictures of the window have it then. GUI thread.
inline void placeDialog(QDialog& dialog) {
  dialog.setWindowFlags(Qt::Widget);
  dialog.setAutoFillBackground(true);
  dialog.resize(dialog.sizeHint());
  dialog.show();
}

}  // namespace torsio::gui
