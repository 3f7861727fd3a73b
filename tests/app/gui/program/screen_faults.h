// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace torsio::gui::testing {

/// Labels and buttons that show less than they say.
[[nodiscard]] QStringList cutTexts(QWidget& window);
/// Alt with a letter that two things of one screen want: neither gets it at the first press.
[[nodiscard]] QStringList doubledKeys(QWidget& window);
/// A title of the header that the page tells again.
[[nodiscard]] QStringList doubledTitles(QWidget& window);
/// Numbers of labels, buttons, lists and the cells of tables that are not as screens show them: a hyphen in
/// place of the minus, four figures and more without groups, days that can be read two ways (03/12/2026).
/// Years, times and identifiers are none.
[[nodiscard]] QStringList roughNumbers(QWidget& window);
/// On a wide screen: whether a page crowds into a corner. It stands in the middle, or it uses the width;
/// empty: it does.
[[nodiscard]] QString crowded(const QWidget& page);

}  // namespace torsio::gui::testing
