// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>

namespace torsio::gui {

/// Sent to the page that is shown when the database answers again after it was away: what could not be read
/// or kept meanwhile is tried again.
[[nodiscard]] inline QEvent::Type databaseAnsweredEvent() {
  static const auto kType = static_cast<QEvent::Type>(QEvent::registerEventType());
  return kType;
}

}  // namespace torsio::gui
