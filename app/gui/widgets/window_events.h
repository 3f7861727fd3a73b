// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

class QWidget;

namespace torsio::gui {

/// Lets Enter press the focused button of a window, as in dialogs.
void pressButtonsByEnter(QWidget& window);

/// Calls `retranslate` now and after each change of the window's language while the widget lives. A Page has
/// its own retranslate().
void followLanguage(QWidget* widget, std::function<void()> retranslate);

}  // namespace torsio::gui
