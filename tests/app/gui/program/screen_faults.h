// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace torsio::gui::testing {

/// Returns labels and buttons with clipped text.
[[nodiscard]] QStringList cutTexts(QWidget& window);
/// Returns Alt keys claimed twice on a screen: neither gets it at the first press.
[[nodiscard]] QStringList doubledKeys(QWidget& window);
/// Returns titles of the header that the page repeats.
[[nodiscard]] QStringList doubledTitles(QWidget& window);
/// Returns numbers in labels, buttons, lists and tables that are not in screen format: a hyphen instead of
/// the minus, four or more digits without grouping, ambiguous dates (03/12/2026). Excludes years, times and
/// identifiers.
[[nodiscard]] QStringList roughNumbers(QWidget& window);
/// Returns an error if a page on a wide screen is in a corner, neither centred nor using the width; empty:
/// none.
[[nodiscard]] QString crowded(const QWidget& page);

}  // namespace torsio::gui::testing
