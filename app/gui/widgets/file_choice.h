// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace torsio::gui {

/// Asks where to save, starting in this station's last folder (at first Documents) and proposing `name`, with
/// characters that file systems reject replaced by dashes. `chosenFilter`: initially selected one of several
/// filters (separated by ";;"), and then the final one. Empty: cancelled.
[[nodiscard]] QString askFileToSave(QWidget* parent, const QString& title, const QString& name,
                                    const QString& filter, QString* chosenFilter = nullptr);
/// Asks for a file to open, starting in the same folder, or at the file `begin` if it exists. Empty:
/// cancelled.
[[nodiscard]] QString askFileToOpen(QWidget* parent, const QString& title, const QString& filter,
                                    const QString& begin = {});

/// Asks for an output folder, which the dialog can create, starting in the same folder. Empty: cancelled.
[[nodiscard]] QString askFolder(QWidget* parent, const QString& title);

}  // namespace torsio::gui
