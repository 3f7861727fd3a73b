// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "sim/tissue/section/polygon.h"

namespace torsio {

/// Reads the outline of a section: one point a line, `x,y` (comma, semicolon or blanks between; a decimal
/// point, whatever the locale), in any unit. Empty lines and lines that start with # are passed over, and so
/// is one line of column names before the first point. A last point that repeats the first is dropped. Throws
/// Error{kFileMissing, kFileUnreadable} when it cannot be read, Error{kBadData} that names the line for
/// anything but two finite numbers, and for fewer than 3 points.
[[nodiscard]] std::vector<Point2> readOutline(const std::filesystem::path& file);

}  // namespace torsio
