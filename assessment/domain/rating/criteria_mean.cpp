// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/rating/criteria_mean.h"

#include <algorithm>
#include <cstdint>

namespace torsio {

std::optional<double> criteriaMean(const RubricRevision& rubric, std::span<const SheetRow> answers) {
  double sum = 0.0;
  std::int64_t weights_milli = 0;
  for (const RubricLine& line : rubric.rows) {
    if (line.weight_milli == 0) {
      continue;
    }
    const auto answer = std::find_if(answers.begin(), answers.end(),
                                     [&](const SheetRow& one) { return one.code == line.code; });
    if (answer == answers.end() || !answer->score_steps) {
      return std::nullopt;
    }
    const auto above = static_cast<double>(*answer->score_steps - line.scale.lo);
    sum +=
        static_cast<double>(line.weight_milli) * above / static_cast<double>(line.scale.hi - line.scale.lo);
    weights_milli += line.weight_milli;
  }
  if (weights_milli == 0) {
    return std::nullopt;
  }
  const double lo = pointsFromSteps(rubric.overall.lo, rubric.overall);
  const double hi = pointsFromSteps(rubric.overall.hi, rubric.overall);
  return lo + (hi - lo) * sum / static_cast<double>(weights_milli);
}

}  // namespace torsio
