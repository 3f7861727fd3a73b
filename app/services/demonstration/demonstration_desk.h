// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/rubric.h"
#include "sim/scene/scene.h"

namespace torsio {

class Connection;
class IdSource;

/// Content of the demonstration's desks.
struct DemonstrationDesk {
  CohortId cohortId{};
  RubricRevisionId rubricRevisionId{};
  CampaignId campaignId{};
  std::vector<RaterId> raterIds{};            ///< the ten chief physicians; the first one has work left
  std::vector<AssignmentId> assignmentIds{};  ///< recorded cases of the first rater, in order
};

struct DemonstrationDeskOptions {
  std::uint64_t seed = 1;
  std::int64_t utc_us = 0;  ///< time of every row
  double trial_s = 20.0;    ///< length of each recording
  int cases = 14;  ///< number of recorded and of live cases; ten are left to the first physician; not a
                   ///< multiple of 3
};

/// Stores a rubric with anchors; a second cohort of simulated trainees with one short recording each,
/// assigned twice to the ten simulated physicians R-01 ... (as a recording, and live on the real arm); two
/// reference runs; and a campaign for them. All have submitted some cases; R-01 has a draft, open cases and
/// disagreements. Every row has the demonstration flag. Needs storeDemonstrationPeople() before. One
/// transaction.
DemonstrationDesk storeDemonstrationDesk(Connection& connection, IdSource& ids, const Scene& scene,
                                         const DemonstrationDeskOptions& options);

/// Returns the demonstration's rubric: time, proficiency, accuracy, tissue care; 1 to 10 in halves; anchors.
[[nodiscard]] RubricRevision demonstrationRubric();

}  // namespace torsio
