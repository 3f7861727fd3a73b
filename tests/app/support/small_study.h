// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/services/recording/trial_digests.h"
#include "tests/app/support/study_centre.h"

namespace torsio {

/// Six trainees in three groups without marks, and a request for them.
template <typename Request>
struct SmallStudyFor {
  StudyCentre centre;
  Request request;
  TrialDigests digests{centre.assets()};

  SmallStudyFor() {
    request.cohortId = centre.addStudy(6).cohortId;
    centre.allocate(request.cohortId);
  }
};

}  // namespace torsio
