// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/occasion.h"

namespace torsio {

/// A rater who can be assigned.
struct Adjudicator {
  RaterId id{};
  std::string code{};
  std::string classCode{};
  std::size_t open = 0;  ///< open sheets already assigned
};

/// A case on which physicians disagreed and requested another rater. Contains no marks.
struct AdjudicatorRequest {
  AssignmentId assignmentId{};  ///< of the first request; argument of assignAdjudicator()
  std::string traineeCode{};
  Occasion occasion{};
  bool live = false;  ///< on the real arm: the trainee has to be there again
  std::size_t marks = 0;
  std::vector<std::string> askedBy{};  ///< codes
  std::vector<std::string> reasons{};
  std::int64_t askedUtc_us = 0;     ///< time of the first request
  std::vector<Adjudicator> free{};  ///< not assigned to this case before; same class and fewest open sheets
                                    ///< first
};

/// Returns the pending requests of a cohort, oldest first: cases with a physician's latest decision "third"
/// and no assignment since. kStudySetup.
[[nodiscard]] std::vector<AdjudicatorRequest> adjudicatorRequests(SessionContext& session,
                                                                  const CohortId& cohortId);

/// Assigns `raterId` to the case of a request, with a new label and the same rubric. Returns the new
/// assignment. kStudySetup; audited. Throws Error{kBadData} without a request, or if the rater was assigned
/// to this case before or does not exist.
std::string assignAdjudicator(SessionContext& session, const CohortId& cohortId,
                              const AssignmentId& assignmentId, const RaterId& raterId);

}  // namespace torsio
