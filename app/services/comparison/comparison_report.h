// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/services/comparison/comparison_run.h"
#include "assessment/results/report_model.h"

namespace torsio {

/// The name of the report beside the files of writeComparisonFiles().
inline constexpr const char* kComparisonReportName = "comparison.pdf";

/// Makes the report of a comparison: Figs. 10, 13 and 14 of the paper with this organ, the tables of accuracy
/// and time, the machine, and what the figures do not show. English only.
[[nodiscard]] ReportModel comparisonReport(const ComparisonResult& result, const std::string& softwareVersion,
                                           std::int64_t createdUtc_us);

/// Says what the figures of a comparison do not: that a linear FEM could compute in advance too, that set-up
/// counts, that linear tetrahedra lock, how the ends differ. A paragraph each.
[[nodiscard]] std::vector<Text> comparisonLimits();

/// Puts all numbers of a comparison in JSON, units in the names, indented. What is not defined is
/// {"undefined": reason}.
[[nodiscard]] std::string comparisonJson(const ComparisonResult& result);

/// Writes comparison.json, models.csv (a line a model), markers.csv (a line a marker: Fig. 13) and course.csv
/// (a line a moment and model: Fig. 14) into a folder, which is made if missing. Returns their names. Throws
/// Error{kFileUnwritable}.
std::vector<std::string> writeComparisonFiles(const ComparisonResult& result,
                                              const std::filesystem::path& folder);

}  // namespace torsio
