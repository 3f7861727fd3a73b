// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

class QWidget;

namespace torsio::gui::testing {

/// Words in a window that cannot be read whole: a label, button, header, tab, choice, field or line of a list
/// that is narrower than its text, and whatever reaches over the edge of what it stands in. All pages of all
/// tabs are looked at; cells of long lists are not, since their columns can be widened.
[[nodiscard]] QStringList clippedTexts(QWidget& window);

}  // namespace torsio::gui::testing
