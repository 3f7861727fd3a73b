// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/study/coded_records.h"

namespace torsio {

std::vector<TrialListing> codedTrials(SessionContext& workplace, const TrialFilter& filter) {
  workplace.require(Operation::kTrialViewCoded);
  return TrialRepository(workplace.connection()).list(filter);
}

std::vector<StoredTrainingMark> codedMarks(SessionContext& workplace, const std::string& cohortId) {
  workplace.require(Operation::kMarkViewCoded);
  return RatingRepository(workplace.connection()).marks(cohortId);
}

}  // namespace torsio
