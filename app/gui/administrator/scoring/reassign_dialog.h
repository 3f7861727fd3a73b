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

/// Which sheets change hands.
struct SheetsChosen {
  std::vector<AssignmentId> sheets{};
  RaterId newRaterId{};  ///< empty: taken back only
  std::string reason{};
};
/// Whose sheets of these lines of `matrix` go to whom: the open ones of a rater to another one or to nobody,
/// or those that were taken back from a rater to the same one again. `raters`: who can be asked. Fields are
/// called "from", "to", "reason" and "what". Empty: given up.
[[nodiscard]] std::optional<SheetsChosen> askReassignment(QWidget* parent, const ScoringMatrix& matrix,
                                                          const std::vector<std::size_t>& lines,
                                                          const std::vector<PersonRow>& raters);

}  // namespace torsio::gui
