// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace torsio::gui {

/// Returns the heading of a printed card or form: the centre's name, or "Torsio" if it has none.
[[nodiscard]] inline QString centreHeadline(const QString& centre) {
  return centre.isEmpty() ? QStringLiteral("Torsio") : centre;
}

}  // namespace torsio::gui
