// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

namespace torsio::gui {

struct Theme;

/// One of assets/icons in the theme's colours: text when idle, accent when switched on, disabledText when
/// disabled.
[[nodiscard]] QIcon icon(const QString& name, const Theme& theme);

/// One of assets/icons in one colour, for what must stand out (recording).
[[nodiscard]] QIcon icon(const QString& name, const QColor& colour);

/// The sign of the program, for title bars and task bars. GUI thread.
[[nodiscard]] QIcon applicationIcon();

}  // namespace torsio::gui
