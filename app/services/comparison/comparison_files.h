// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/services/comparison/comparison_run.h"

namespace torsio {

/// Puts all numbers of a comparison in JSON, units in the names, indented. What is not defined is
/// {"undefined": reason}.
[[nodiscard]] std::string comparisonJson(const ComparisonResult& result);

/// Writes comparison.json, models.csv (a line a model), markers.csv (a line a marker: Fig. 13) and course.csv
/// (a line a moment and model: Fig. 14) into a folder, which is made if missing. Returns their names. Throws
/// Error{kFileUnwritable}.
std::vector<std::string> writeComparisonFiles(const ComparisonResult& result,
                                              const std::filesystem::path& folder);

}  // namespace torsio
