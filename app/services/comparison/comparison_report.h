// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
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

/// Describes the limitations of the figures, one paragraph each: a linear FEM could also precompute, set-up
/// counts, linear tetrahedra lock, boundary conditions differ.
[[nodiscard]] std::vector<Text> comparisonLimits();

}  // namespace torsio
