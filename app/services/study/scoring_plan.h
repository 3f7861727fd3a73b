// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/study/occasion.h"

namespace torsio {

/// A recording of a trainee at an occasion. Cases without one are scored live, on the real arm.
struct CaseRecording {
  EnrolmentId enrolmentId{};
  std::string occasionCode{};
  TrialId trialId{};
};

/// Who scores whom, and when.
struct ScoringPlan {
  CohortId cohortId{};
  std::vector<std::string> occasionCodes{};  ///< occasion codes
  std::vector<RaterId> raterIds{};
  std::vector<EnrolmentId> enrolmentIds{};  ///< empty: everybody who has not withdrawn
  std::vector<CaseRecording> recordings{};
  RubricRevisionId rubricRevisionId{};
  std::optional<std::int64_t> dueUtc_us{};
  std::optional<std::uint64_t> seed{};  ///< of order and labels; empty: drawn, and audited
};

/// Result of createAssignments().
struct ScoringPlanOutcome {
  std::size_t created = 0;
  std::size_t already = 0;  ///< already assigned, unchanged
  std::uint64_t seed = 0;
};

/// Creates one assignment per rater, trainee and occasion. Each rater gets a separate order with groups and
/// stages spread evenly over the session (counterbalanced), so that fatigue and drift affect all alike. Case
/// labels ("7F") are random, and neither they nor the order reveal stage or group; a live case has the same
/// label for all raters (it is called out in the room), a recorded one a different label for each. Audited.
/// kStudySetup. Throws Error{kBadParameter} without cases, or for an unknown rater, rubric or occasion.
ScoringPlanOutcome createAssignments(SessionContext& session, const ScoringPlan& plan);

/// One cell of the matrix.
struct ScoringCell {
  AssignmentId assignmentId{};  ///< empty: not assigned to this rater
  SheetState state = SheetState::kOpen;
  std::string caseLabel{};
  std::optional<std::int64_t> dueUtc_us{};
  std::int64_t changedUtc_us = 0;  ///< of the latest draft or mark; 0: none
};
struct ScoringMatrix {
  struct Rater {
    RaterId id{};
    std::string code{};
    std::string classCode{};
    std::size_t open = 0;  ///< open sheets and drafts
    std::size_t submitted = 0;
  };
  struct Line {
    EnrolmentId enrolmentId{};
    std::string traineeCode{};
    Occasion occasion{};
    std::vector<ScoringCell> cells{};  ///< one per rater
    std::size_t missing = 0;           ///< open or draft
  };
  std::vector<Rater> raters{};
  std::vector<Line> lines{};  ///< by occasion, then trainee
  Occasions occasions{};      ///< of the cohort, which sheets can be requested for
};
/// Returns who has scored whom, without marks. kStudySetup.
[[nodiscard]] ScoringMatrix scoringMatrix(SessionContext& session, const CohortId& cohortId);

/// Status of an occasion before its release.
struct ReleaseState {
  Occasion occasion{};
  bool released = false;
  std::size_t sheets = 0;
  std::size_t missing = 0;  ///< not submitted yet
};
/// In order of time. kMarkRelease.
[[nodiscard]] std::vector<ReleaseState> releaseStates(SessionContext& session, const CohortId& cohortId);
/// Releases the marks of an occasion to the trainees; needs a reason while sheets are missing. Audited.
/// kMarkRelease.
void releaseMarks(SessionContext& session, const CohortId& cohortId, const std::string& occasionCode,
                  const std::string& reason = {});
/// Retracts released marks, with a reason. Audited. kMarkRelease.
void retractMarks(SessionContext& session, const CohortId& cohortId, const std::string& occasionCode,
                  const std::string& reason);

/// A case and its stratum (stage and group).
struct OrderedCase {
  std::size_t index = 0;  ///< index used by the caller
  std::string stratum{};
};

/// Returns one rater's order with the strata spread evenly: rounds with at most one case of each stratum,
/// shuffled within the round. Same seed and rater, same order. `rater`: index in the panel.
[[nodiscard]] std::vector<std::size_t> counterbalancedOrder(std::vector<OrderedCase> cases,
                                                            std::uint64_t seed, std::uint64_t rater);

/// Returns `count` random unique labels such as "7F", none of them in `taken`. Omits the letters I and O.
/// Labels get another digit when the short ones are used up.
[[nodiscard]] std::vector<std::string> caseLabels(std::size_t count, const std::set<std::string>& taken,
                                                  std::uint64_t seed, std::uint64_t stream);

}  // namespace torsio
