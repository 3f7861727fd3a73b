// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include <QAbstractButton>
#include <QList>
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

/// Returns whether a button on `page` is pressed. A page that refreshes itself must wait: a button that
/// moves, disappears or is disabled under the pointer loses its click.
[[nodiscard]] inline bool holdsButton(const QWidget& page) {
  const auto buttons = page.findChildren<QAbstractButton*>();
  return std::any_of(buttons.begin(), buttons.end(),
                     [](const QAbstractButton* button) { return button->isDown(); });
}

}  // namespace torsio::gui
