// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QStringList>

namespace torsio {

/// Names of categories as the axis of a chart takes them.
struct CategoryLabels {
  QStringList html;  ///< one a category, of up to three lines where they fit
  QFont font;
};

/// In letters as large as they fit side by side below a figure on paper, `largest_px` at the most, at last in
/// narrow ones: Qt cuts a label that is wider than its share of the axis. Needs a QGuiApplication.
[[nodiscard]] CategoryLabels categoryLabels(const QStringList& names, int largest_px);

}  // namespace torsio
