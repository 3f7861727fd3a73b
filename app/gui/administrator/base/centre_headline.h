// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace torsio::gui {

/// What stands above a printed card or form: the centre's name, or the program's while the centre has none.
[[nodiscard]] inline QString centreHeadline(const QString& centre) {
  return centre.isEmpty() ? QStringLiteral("Torsio") : centre;
}

}  // namespace torsio::gui
