// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include "sim/core/contracts.h"

namespace torsio::gui {

/// Finds a child widget by object name: tests and screenshots reach parts of a page this way, so that the
/// page need not expose them. Throws ContractError if there is none. GUI thread.
template <typename Widget>
[[nodiscard]] Widget& child(const QWidget& parent, const char* name) {
  auto* found = parent.findChild<Widget*>(QLatin1String(name));
  TORSIO_EXPECTS(found != nullptr);
  return *found;
}

}  // namespace torsio::gui
