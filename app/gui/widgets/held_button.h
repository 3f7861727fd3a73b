// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include <QAbstractButton>
#include <QList>

namespace torsio::gui {

/// Whether a button on `page` is pressed and not let go yet. A page that brings itself up to date by a clock
/// waits meanwhile: a button that moves, goes or is switched off under the pointer would lose its press.
[[nodiscard]] inline bool holdsButton(const QWidget& page) {
  const auto buttons = page.findChildren<QAbstractButton*>();
  return std::any_of(buttons.begin(), buttons.end(),
                     [](const QAbstractButton* button) { return button->isDown(); });
}

}  // namespace torsio::gui
