// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

class QWidget;

namespace torsio::gui {

/// Returns all texts of a widget and its children, including hidden ones, for people and screen readers:
/// texts, tool tips, titles, accessible names, all cells of lists in all roles, actions, combo box entries,
/// and other painted text.
[[nodiscard]] QStringList wordsOf(QWidget& page);

/// Returns the texts painted when the widget is drawn now.
[[nodiscard]] QStringList paintedWordsOf(QWidget& page);

}  // namespace torsio::gui
