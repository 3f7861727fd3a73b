// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QString>

namespace torsio::gui {

/// Gives a time of a recording, or a span, as every screen says it: minutes and whole seconds, "2:05". Any
/// thread.
[[nodiscard]] QString clockTime(std::int64_t time_us);

}  // namespace torsio::gui
