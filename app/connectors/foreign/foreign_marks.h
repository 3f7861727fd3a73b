// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/connectors/foreign/foreign_map.h"

namespace torsio {

/// Reads global rating scores (GRS) from a JIGSAWS meta file: recording, self-proclaimed skill, total and its
/// parts, separated by spaces or tabs. Skips recordings that the map does not list. Throws Error:
/// kFileMissing, kFileUnreadable; kBadData with the line.
[[nodiscard]] std::vector<ForeignMark> jigsawsMarks(const std::filesystem::path& file,
                                                    const std::string& rater, const ForeignMap& map);

/// Reads marks from a table (CSV or Parquet) with the columns recording, rater, score (points). Throws as
/// above, and for a recording or rater that the map does not list.
[[nodiscard]] std::vector<ForeignMark> tabledMarks(const std::filesystem::path& file, const ForeignMap& map);

}  // namespace torsio
