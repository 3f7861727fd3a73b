// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/occasion.h"

namespace torsio {

/// Somebody who may be asked.
struct Adjudicator {
  RaterId id{};
  std::string code{};
  std::string classCode{};
  std::size_t open = 0;  ///< sheets that wait for them already
};

/// Physicians could not agree about a case and asked for one more. No mark is in it.
struct AdjudicatorRequest {
  AssignmentId assignmentId{};  ///< of the first who asked; handle for assignAdjudicator()
  std::string traineeCode{};
  Occasion occasion{};
  bool live = false;  ///< on the real arm: the trainee has to be there again
  std::size_t marks = 0;
  std::vector<std::string> askedBy{};  ///< codes
  std::vector<std::string> reasons{};
  std::int64_t askedUtc_us = 0;     ///< the first time
  std::vector<Adjudicator> free{};  ///< not asked about this case before; of the same class and the least
                                    ///< loaded first
};

/// What waits in a cohort, oldest first: cases on which a physician's newest decision is "third" and nobody
/// has been asked since. kStudySetup.
[[nodiscard]] std::vector<AdjudicatorRequest> adjudicatorRequests(SessionContext& session,
                                                                  const CohortId& cohortId);

/// Asks `raterId` about the case of a request, under a label of their own and with the same rubric. Returns
/// the new assignment. kStudySetup; audited. Throws Error{kBadData}: no request, or the rater was asked about
/// this case before or is none.
std::string assignAdjudicator(SessionContext& session, const CohortId& cohortId,
                              const AssignmentId& assignmentId, const RaterId& raterId);

}  // namespace torsio
