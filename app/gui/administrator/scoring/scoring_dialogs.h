// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
/// Who is asked, at which occasions and until when. Chosen already: those of `matrix` who have open sheets;
/// nobody when nothing is open. Empty: given up.
[[nodiscard]] std::optional<RatersInvited> chooseInvitedRaters(QWidget* parent,
                                                               const std::vector<PersonRow>& raters,
                                                               const ScoringMatrix& matrix);

struct ReleaseChange {
  std::string occasionCode{};
  bool release = true;  ///< false: taken back
  std::string reason{};
};
[[nodiscard]] std::optional<ReleaseChange> askRelease(QWidget* parent,
                                                      const std::vector<ReleaseState>& states);

struct AdjudicatorChosen {
  AssignmentId assignmentId{};
  RaterId raterId{};
};
/// Which of the cases go to whom; the oldest request and the freest rater are chosen already. Of several
/// cases each goes to the freest, unless one rater is chosen for all. Empty: given up.
[[nodiscard]] std::vector<AdjudicatorChosen> chooseAdjudicators(
    QWidget* parent, const std::vector<AdjudicatorRequest>& requests);

}  // namespace torsio::gui
