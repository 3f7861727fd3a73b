// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>

namespace torsio::gui {

/// Sent to the current page when the database answers again after an outage, so that it retries what it could
/// not read or store.
[[nodiscard]] inline QEvent::Type databaseAnsweredEvent() {
  static const auto kType = static_cast<QEvent::Type>(QEvent::registerEventType());
  return kType;
}

}  // namespace torsio::gui
