// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QStringList>

namespace torsio {

/// Category names formatted for a chart's axis.
struct CategoryLabels {
  QStringList html;  ///< one per category, up to three lines if they fit
  QFont font;
};

/// Chooses the largest font, up to `largest_px`, in which the names fit side by side on a printed figure, or
/// a narrow one as a last resort: Qt truncates labels wider than their share of the axis. Needs a
/// QGuiApplication.
[[nodiscard]] CategoryLabels categoryLabels(const QStringList& names, int largest_px);

}  // namespace torsio
