// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"

namespace torsio {

/// Mean of the criteria of a sheet in points: each score as its relative position on its own scale, weighted
/// and mapped to the scale of the overall mark. Shown beside the overall mark, never in place of it. Empty if
/// a criterion with a weight was not scored.
[[nodiscard]] std::optional<double> criteriaMean(const RubricRevision& rubric,
                                                 std::span<const SheetRow> answers);

}  // namespace torsio
