// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <QString>

#include "app/gui/base/translated_text.h"
#include "app/services/review/case_sheet.h"

namespace torsio::gui {

/// Formats points in the user's locale without needless decimals: "7.5".
[[nodiscard]] QString pointsText(double points);
[[nodiscard]] QString scoreText(std::int64_t score_steps, const ScoreScale& scale);
/// "+0.8", "-0.5", "0.0".
[[nodiscard]] QString signedText(double points);

/// Keys of a sheet and of playback, for Page::keys().
[[nodiscard]] std::vector<std::pair<QString, QString>> sheetKeys();
[[nodiscard]] std::vector<std::pair<QString, QString>> replayKeys();

}  // namespace torsio::gui
