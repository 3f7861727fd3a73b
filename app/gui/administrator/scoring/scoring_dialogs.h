// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/services/people/people_service.h"
#include "app/services/review/adjudicator.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/ids.h"

class QWidget;

namespace torsio::gui {

struct RatersInvited {
  std::vector<RaterId> raterIds{};
  std::vector<std::string> occasionCodes{};
  std::optional<std::int64_t> dueUtc_us{};  ///< end of the chosen day; empty: no deadline
};
/// Asks for raters, occasions and deadline. Preselected: raters of `matrix` with open sheets; nobody if
/// nothing is open. Empty: cancelled.
[[nodiscard]] std::optional<RatersInvited> chooseInvitedRaters(QWidget* parent,
                                                               const std::vector<PersonRow>& raters,
                                                               const ScoringMatrix& matrix);

struct ReleaseChange {
  std::string occasionCode{};
  bool release = true;  ///< false: withdrawn
  std::string reason{};
};
[[nodiscard]] std::optional<ReleaseChange> askRelease(QWidget* parent,
                                                      const std::vector<ReleaseState>& states);

struct AdjudicatorChosen {
  AssignmentId assignmentId{};
  RaterId raterId{};
};
/// Asks for the adjudicator of each case; the oldest request and the freest rater are preselected. Several
/// cases go to the freest rater each, unless one rater is chosen for all. Empty: cancelled.
[[nodiscard]] std::vector<AdjudicatorChosen> chooseAdjudicators(
    QWidget* parent, const std::vector<AdjudicatorRequest>& requests);

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
