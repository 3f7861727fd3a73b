// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/study/coded_records.h"

namespace torsio {

std::vector<TrialListing> codedTrials(SessionContext& session, const TrialFilter& filter) {
  session.require(Operation::kTrialViewCoded);
  return TrialRepository(session.connection()).list(filter);
}

std::vector<StoredTrainingMark> codedMarks(SessionContext& session, const std::string& cohortId) {
  session.require(Operation::kMarkViewCoded);
  return RatingRepository(session.connection()).marks(cohortId);
}

}  // namespace torsio
