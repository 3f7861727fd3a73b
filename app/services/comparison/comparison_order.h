// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/services/comparison/comparison_run.h"
#include "sim/core/text.h"

namespace torsio {

/// Returns a model's name for tables and legends.
[[nodiscard]] Text shortName(const std::string& id);

/// Models with their errors, m, from the smallest; without those that have none, and without the reference.
using OrderedModels = std::vector<std::pair<const ModelResult*, double>>;

/// Orders the models by their errors against the measured markers; empty: none was measured.
[[nodiscard]] OrderedModels byMeasured(const ComparisonResult& result);

/// Orders the models by their errors against the reference.
[[nodiscard]] OrderedModels byReference(const ComparisonResult& result);

/// Returns whether the order has the twist model before the elements and these before the springs, as the
/// paper's.
[[nodiscard]] bool isThePapers(const OrderedModels& order);

/// Says in which order of accuracy this run finds the models, against the reference and, if there are any,
/// against the measured markers, whether that is the paper's order, and what the order depends on.
[[nodiscard]] std::vector<Text> comparisonOrder(const ComparisonResult& result);

}  // namespace torsio
