// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/connectors/foreign/foreign_map.h"

namespace torsio {

/// Reads the global rating score (GRS) of a meta file of JIGSAWS: name of the recording, self-proclaimed
/// skill, total, then its parts, separated by blanks or tabs. Lines about recordings that the map does not
/// list are left out. Throws Error: kFileMissing, kFileUnreadable; kBadData by line.
[[nodiscard]] std::vector<ForeignMark> jigsawsMarks(const std::filesystem::path& file,
                                                    const std::string& rater, const ForeignMap& map);

/// Reads marks from a table: columns recording, rater, score (points). Throws as above; also for a recording
/// or rater that the map does not list.
[[nodiscard]] std::vector<ForeignMark> tabledMarks(const std::filesystem::path& file, const ForeignMap& map);

}  // namespace torsio
