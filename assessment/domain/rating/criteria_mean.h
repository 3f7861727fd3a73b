// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"

namespace torsio {

/// Weighs the criteria of a sheet: each as its place between the ends of its own scale, the mean of these on
/// the scale of the overall mark, in points. It is shown beside the overall mark and takes its place nowhere.
/// Empty: a criterion that has a weight was not scored.
[[nodiscard]] std::optional<double> criteriaMean(const RubricRevision& rubric,
                                                 std::span<const SheetRow> answers);

}  // namespace torsio
