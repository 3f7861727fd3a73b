// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAccessible>

class QWidget;

namespace torsio::gui {

/// Tells screen readers the role of a widget whose class does not: a drawn row of marks is a slider, the
/// navigation a list. Its value is the accessible description; a button that became a list item can still be
/// pressed. GUI thread; call before anybody asks for the widget's accessible interface.
void setAccessibleRole(QWidget* widget, QAccessible::Role role);

}  // namespace torsio::gui
