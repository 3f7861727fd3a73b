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

class QWidget;

namespace torsio::gui::testing {

/// Returns the clipped texts of a window: labels, buttons, headers, tabs, combo boxes, fields or list lines
/// narrower than their text, and anything that extends beyond its parent. Includes all pages of tab widgets,
/// but not cells of long lists, whose columns can be widened.
[[nodiscard]] QStringList clippedTexts(QWidget& window);

}  // namespace torsio::gui::testing
