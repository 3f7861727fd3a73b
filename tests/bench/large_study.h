// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/domain/ids.h"
#include "tests/app/support/study_centre.h"

namespace torsio::bench {

/// Stores a cohort of three groups through the repositories: 3,333 trainees with three recordings and thirty
/// marks each, 10,000 trials and 100,000 marks in total. Returns it.
CohortId fillLargeStudy(testing::StudyCentre& centre);

}  // namespace torsio::bench
