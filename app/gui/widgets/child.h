// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include "sim/core/contracts.h"

namespace torsio::gui {

/// Finds the widget of a page or window that bears this object name: tests and the pictures of the user guide
/// reach the parts of a page so, and the page need not hand them out. The caller knows that it exists:
/// ContractError otherwise. GUI thread.
template <typename Widget>
[[nodiscard]] Widget& child(const QWidget& parent, const char* name) {
  auto* found = parent.findChild<Widget*>(QLatin1String(name));
  TORSIO_EXPECTS(found != nullptr);
  return *found;
}

}  // namespace torsio::gui
