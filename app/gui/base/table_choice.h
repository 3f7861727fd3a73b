// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "app/services/base/csv_style.h"

class QWidget;

namespace torsio::gui {

/// File and CSV style of a table to save.
struct TableChoice {
  QString file{};  ///< empty: cancelled
  CsvStyle look{};
};
/// Asks where to save; the file types offer the CSV styles. Preselects the last one chosen; at first, that of
/// the computer's language. `name` without extension.
[[nodiscard]] TableChoice askTableToSave(QWidget* parent, const QString& title, const QString& name);
/// Returns the last style chosen, for saving several tables at once.
[[nodiscard]] CsvStyle usualTableLook();

}  // namespace torsio::gui
