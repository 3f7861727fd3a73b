// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/services/people/people_service.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/ids.h"

class QWidget;

namespace torsio::gui {

/// Sheets to reassign.
struct SheetsChosen {
  std::vector<AssignmentId> sheets{};
  RaterId newRaterId{};  ///< empty: only revoked
  std::string reason{};
};
/// Asks which sheets of `matrix` to reassign: a rater's open sheets to another rater or nobody, or revoked
/// ones back to the same rater. `raters`: possible raters. Object names of fields: "from", "to", "reason" and
/// "what". Empty: cancelled.
[[nodiscard]] std::optional<SheetsChosen> askReassignment(QWidget* parent, const ScoringMatrix& matrix,
                                                          const std::vector<std::size_t>& lines,
                                                          const std::vector<PersonRow>& raters);

}  // namespace torsio::gui
