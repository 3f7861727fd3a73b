// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/scoring_due.h"

#include <algorithm>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/scoring/scoring_service.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"

namespace torsio {

namespace {

constexpr std::string_view kTrainedBefore = storedText(DeviationKind::kTrainedBeforeScoring);

/// Returns the beginning of such a deviation's description.
std::string aboutOccasion(const Occasion& occasion) {
  return "\"" + occasion.label + "\": ";
}

}  // namespace

std::optional<ScoringDue> scoringDue(Connection& connection, const CohortId& cohortId,
                                     const EnrolmentId& enrolmentId, std::int64_t trained_us) {
  ScoringDue due;
  for (const Occasion& occasion : occasionsOfCohort(connection, cohortId)) {
    if (occasion.afterExposure_us && *occasion.afterExposure_us <= trained_us) {
      due.occasion = occasion;
    }
  }
  if (due.occasion.code.empty()) {
    return std::nullopt;
  }
  for (const AssignmentStatus& status : SheetRepository(connection).assignments(cohortId)) {
    const Assignment& one = status.assignment;
    if (one.enrolmentId == enrolmentId && one.occasionCode == due.occasion.code && one.trialId.empty() &&
        status.state != SheetState::kWithdrawn) {
      ++due.asked;
      due.submitted += status.state == SheetState::kSubmitted ? 1 : 0;
    }
  }
  if (due.submitted == due.asked) {
    return std::nullopt;
  }
  const std::vector<ProtocolDeviation> noted = StudyRepository(connection).deviations(cohortId);
  const bool known = std::any_of(noted.begin(), noted.end(), [&](const ProtocolDeviation& one) {
    return one.enrolmentId == enrolmentId && one.kind == kTrainedBefore &&
           one.description.starts_with(aboutOccasion(due.occasion));
  });
  return known ? std::nullopt : std::optional(due);
}

ProtocolDeviation trainedBeforeScoring(const SessionContext& session, const ScoringDue& due,
                                       const CohortId& cohortId, const EnrolmentId& enrolmentId,
                                       const std::string& reason, bool demonstration) {
  return {.id = session.ids().newUuid(),
          .cohortId = cohortId,
          .enrolmentId = enrolmentId,
          .kind = std::string(kTrainedBefore),
          .description = aboutOccasion(due.occasion) + std::to_string(due.submitted) + " of " +
                         std::to_string(due.asked) + " sheets were in: " + reason,
          .happenedUtc_us = session.now_us(),
          .reportedBy = session.actor().userId,
          .reportedUtc_us = session.now_us(),
          .demonstration = demonstration};
}

}  // namespace torsio
