// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/services/comparison/comparison_run.h"
#include "assessment/results/report_model.h"

namespace torsio {

/// File name of the report next to the files of writeComparisonFiles().
inline constexpr const char* kComparisonReportName = "comparison.pdf";

/// Builds the report of a comparison: Figs. 10, 13 and 14 of the paper for this organ, tables of accuracy and
/// time, the machine, and limitations of the figures. English only.
[[nodiscard]] ReportModel comparisonReport(const ComparisonResult& result, const std::string& softwareVersion,
                                           std::int64_t createdUtc_us);

/// Says in which order of accuracy this run finds the models, against the reference and, if there are any,
/// against the measured markers, whether that is the paper's order, and what the order depends on.
[[nodiscard]] std::vector<Text> comparisonOrder(const ComparisonResult& result);

/// Describes the limitations of the figures, one paragraph each: a linear FEM could also precompute, set-up
/// counts, linear tetrahedra lock, boundary conditions differ.
[[nodiscard]] std::vector<Text> comparisonLimits();

/// Formats all numbers of a comparison as indented JSON, units in the names. Undefined values are
/// {"undefined": reason}.
[[nodiscard]] std::string comparisonJson(const ComparisonResult& result);

/// Writes comparison.json, models.csv (one row per model), markers.csv (per marker: Fig. 13) and course.csv
/// (per moment and model: Fig. 14) into a folder, created if missing. Returns their names. Throws
/// Error{kFileUnwritable}.
std::vector<std::string> writeComparisonFiles(const ComparisonResult& result,
                                              const std::filesystem::path& folder);

}  // namespace torsio
