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

/// "7.5" in the reader's notation, without needless decimals.
[[nodiscard]] QString pointsText(double points);
[[nodiscard]] QString scoreText(std::int64_t score_steps, const ScoreScale& scale);
/// "+0.8", "-0.5", "0.0".
[[nodiscard]] QString signedText(double points);

/// For Page::keys(): what scores a sheet, and what moves a recording.
[[nodiscard]] std::vector<std::pair<QString, QString>> sheetKeys();
[[nodiscard]] std::vector<std::pair<QString, QString>> replayKeys();

}  // namespace torsio::gui
