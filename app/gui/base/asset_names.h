// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace torsio::gui {

/// The name of a shipped organ, pattern or module in the present language; names of a centre's own stay as
/// they are. `english`: as the asset file has it.
[[nodiscard]] QString assetName(const QString& english);

}  // namespace torsio::gui
