// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/services/comparison/comparison_run.h"

namespace torsio {

/// Formats all numbers of a comparison as indented JSON, units in the names. Undefined values are
/// {"undefined": reason}.
[[nodiscard]] std::string comparisonJson(const ComparisonResult& result);

/// Writes comparison.json, models.csv (one row per model), meshes.csv (coarser meshes), markers.csv
/// (per marker: Fig. 13) and course.csv (per moment and model: Fig. 14) into a folder, created if missing.
/// Returns their names. Throws Error{kFileUnwritable}.
std::vector<std::string> writeComparisonFiles(const ComparisonResult& result,
                                              const std::filesystem::path& folder);

}  // namespace torsio
