// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace torsio::gui {

/// Where to save: the dialog begins in the folder that was used last at this station (at first in Documents)
/// with `name` proposed; characters that no file system takes become dashes. `chosenFilter`:
/// which of several filters (";;" between them) is chosen at first, and then was. Empty: given up.
[[nodiscard]] QString askFileToSave(QWidget* parent, const QString& title, const QString& name,
                                    const QString& filter, QString* chosenFilter = nullptr);
/// What to open; begins in the same folder, or at the file `begin` when there is one. Empty: given up.
[[nodiscard]] QString askFileToOpen(QWidget* parent, const QString& title, const QString& filter,
                                    const QString& begin = {});

/// A folder to write into, which the dialog can make; begins in the same folder. Empty: given up.
[[nodiscard]] QString askFolder(QWidget* parent, const QString& title);

}  // namespace torsio::gui
