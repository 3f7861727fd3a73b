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

/// What was laid on the desks.
struct DemonstrationDesk {
  CohortId cohortId{};
  RubricRevisionId rubricRevisionId{};
  CampaignId campaignId{};
  std::vector<RaterId> raterIds{};            ///< the ten chief physicians; the first one has work left
  std::vector<AssignmentId> assignmentIds{};  ///< recorded cases of the first one, in order
};

struct DemonstrationDeskOptions {
  std::uint64_t seed = 1;
  std::int64_t utc_us = 0;  ///< stamped on every row
  double trial_s = 20.0;    ///< length of each recording
  int cases = 14;  ///< recorded and live ones each: ten are left to the first physician; no multiple of 3
};

/// A rubric with anchors; a second cohort of simulated trainees with one short recording each, twice assigned
/// to the ten simulated physicians R-01 ... (a recording, and a live case on the real arm); two reference
/// runs; and a campaign that asks them. Everybody has submitted some cases, R-01 has a draft, cases that wait
/// and disagreements. Every row carries the demonstration flag. Needs storeDemonstrationPeople() before. One
/// transaction.
DemonstrationDesk storeDemonstrationDesk(Connection& connection, IdSource& ids, const Scene& scene,
                                         const DemonstrationDeskOptions& options);

/// Rubric of the demonstration: time, proficiency, accuracy, tissue care; 1 to 10 in halves; anchors.
[[nodiscard]] RubricRevision demonstrationRubric();

}  // namespace torsio
