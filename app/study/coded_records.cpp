// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/study/coded_records.h"

#include "assessment/attempt/trial_listing.h"
#include "assessment/rating/mark.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/trial/trial_repository.h"

namespace torsio {

std::vector<TrialListing> codedTrials(SessionContext& session, const TrialFilter& filter) {
  session.require(Operation::kTrialViewCoded);
  return TrialRepository(session.connection()).list(filter);
}

std::vector<SubmittedMark> codedMarks(SessionContext& session, const std::string& cohortId) {
  session.require(Operation::kMarkViewCoded);
  return RatingRepository(session.connection()).marks(cohortId);
}

}  // namespace torsio
