// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/services/recording/trial_digests.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/cohort_service.h"
#include "assessment/domain/ids.h"
#include "tests/app/support/study_centre.h"

namespace torsio::testing {

/// Six trainees in three groups without marks, and a request for them.
template <typename Request>
struct SmallStudyFor {
  StudyCentre centre;
  Request request;
  TrialDigests digests{centre.assets()};

  SmallStudyFor() {
    const std::vector<TraineeId> trainees = centre.addTrainees(6);
    const std::string version = centre.runPaperCurriculum();
    request.cohortId = addCohort(centre.session(), {.name = "Study", .curriculumVersionId = version});
    enrolTrainees(centre.session(), request.cohortId, trainees);
    AllocationPlan plan;
    plan.cohortId = request.cohortId;
    lockAllocation(centre.as("allocator"), plan);
    allocateAll(centre.session(), request.cohortId);
  }
};

}  // namespace torsio::testing
