// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "app/services/base/csv_style.h"

class QWidget;

namespace torsio::gui {

/// Where to save a table and for which spreadsheet.
struct TableChoice {
  QString file{};  ///< empty: given up
  CsvStyle look{};
};
/// Asks where to save; the kinds of file say for whom the table is written. The kind that was chosen last is
/// offered first; at first that of the language of the computer. `name` without its ending.
[[nodiscard]] TableChoice askTableToSave(QWidget* parent, const QString& title, const QString& name);
/// The kind that was chosen last, for tables that are saved several at once.
[[nodiscard]] CsvStyle usualTableLook();

}  // namespace torsio::gui
