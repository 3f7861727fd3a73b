// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

namespace torsio::gui {

struct Theme;

/// Returns an icon of assets/icons in the theme's colours: text when idle, accent when on, disabledText when
/// disabled.
[[nodiscard]] QIcon icon(const QString& name, const Theme& theme);

/// Returns an icon of assets/icons in one colour, to stand out (recording).
[[nodiscard]] QIcon icon(const QString& name, const QColor& colour);

/// Returns the program's icon, for title bars and task bars. GUI thread.
[[nodiscard]] QIcon applicationIcon();

}  // namespace torsio::gui
