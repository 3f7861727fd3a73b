// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include <QAbstractButton>
#include <QList>

namespace torsio::gui {

/// Returns whether a button on `page` is pressed. A page that refreshes itself must wait: a button that
/// moves, disappears or is disabled under the pointer loses its click.
[[nodiscard]] inline bool holdsButton(const QWidget& page) {
  const auto buttons = page.findChildren<QAbstractButton*>();
  return std::any_of(buttons.begin(), buttons.end(),
                     [](const QAbstractButton* button) { return button->isDown(); });
}

}  // namespace torsio::gui
