// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

class QWidget;

namespace torsio::gui {

/// Everything that a person or a screen reader can meet in a widget and its children, hidden ones too: texts,
/// tips, titles, names for screen readers, all cells of lists in all their roles, actions, choices of boxes,
/// and what is painted as text without any of these.
[[nodiscard]] QStringList wordsOf(QWidget& page);

/// The texts that are painted when the widget is drawn now.
[[nodiscard]] QStringList paintedWordsOf(QWidget& page);

}  // namespace torsio::gui
