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
#include "assessment/domain/rating/sheet_state.h"
#include "assessment/domain/study/occasion.h"

namespace torsio {

/// A recording that stands for a trainee at an occasion. Cases without one are scored live, on the real
/// arm.
struct CaseRecording {
  EnrolmentId enrolmentId{};
  std::string occasionCode{};
  TrialId trialId{};
};

/// Who is asked to score whom, when.
struct ScoringPlan {
  CohortId cohortId{};
  std::vector<std::string> occasionCodes{};  ///< codes of occasions
  std::vector<RaterId> raterIds{};
  std::vector<EnrolmentId> enrolmentIds{};  ///< empty: everybody who has not withdrawn
  std::vector<CaseRecording> recordings{};
  RubricRevisionId rubricRevisionId{};
  std::optional<std::int64_t> dueUtc_us{};
  std::optional<std::uint64_t> seed{};  ///< of order and labels; empty: drawn, and kept in the audit trail
};

/// What a plan made.
struct ScoringPlanOutcome {
  std::size_t created = 0;
  std::size_t already = 0;  ///< asked before: left as they are
  std::uint64_t seed = 0;
};

/// Makes one assignment a rater, trainee and occasion. Each rater gets an order of their own in which
/// groups and stages are spread evenly over the sitting (counterbalanced), so that tiredness and drift hit
/// all alike. Case labels ("7F") are drawn at random and tell neither stage nor group, nor does their order;
/// a live case has one label for all raters (it is called out in the room), a recorded one another for each.
/// Audited. kStudySetup. Throws Error{kBadParameter}: nobody to score, an unknown rater, rubric or
/// occasion.
ScoringPlanOutcome createAssignments(SessionContext& session, const ScoringPlan& plan);

/// One cell of the matrix.
struct ScoringCell {
  AssignmentId assignmentId{};  ///< empty: this rater was not asked
  SheetState state = SheetState::kOpen;
  std::string caseLabel{};
  std::optional<std::int64_t> dueUtc_us{};
  std::int64_t changedUtc_us = 0;  ///< of the newest draft or mark; 0: none
};
struct ScoringMatrix {
  struct Rater {
    RaterId id{};
    std::string code{};
    std::string classCode{};
    std::size_t open = 0;  ///< sheets that are open or drafts
    std::size_t submitted = 0;
  };
  struct Line {
    EnrolmentId enrolmentId{};
    std::string traineeCode{};
    Occasion occasion{};
    std::vector<ScoringCell> cells{};  ///< one a rater
    std::size_t missing = 0;           ///< open or draft
  };
  std::vector<Rater> raters{};
  std::vector<Line> lines{};  ///< by occasion, then trainee
  Occasions occasions{};      ///< of the cohort: what can be asked for
};
/// Who has scored whom; no marks. kStudySetup.
[[nodiscard]] ScoringMatrix scoringMatrix(SessionContext& session, const CohortId& cohortId);

/// What stands before a release.
struct ReleaseState {
  Occasion occasion{};
  bool released = false;
  std::size_t sheets = 0;
  std::size_t missing = 0;  ///< not submitted yet
};
/// In order of time. kMarkRelease.
[[nodiscard]] std::vector<ReleaseState> releaseStates(SessionContext& session, const CohortId& cohortId);
/// Shows the marks of an occasion to the trainees. While sheets are missing only with a reason. Audited.
/// kMarkRelease.
void releaseMarks(SessionContext& session, const CohortId& cohortId, const std::string& occasionCode,
                  const std::string& reason = {});
/// Takes them back; the reason is required. Audited. kMarkRelease.
void retractMarks(SessionContext& session, const CohortId& cohortId, const std::string& occasionCode,
                  const std::string& reason);

/// A case as the order needs to know it: which stratum (stage and group) it belongs to.
struct OrderedCase {
  std::size_t index = 0;  ///< of the caller
  std::string stratum{};
};

/// An order for one rater in which the strata are spread evenly: it is made of rounds with at most one case
/// of each stratum, shuffled within the round. Same seed and rater, same order. `rater`: position in the
/// panel.
[[nodiscard]] std::vector<std::size_t> counterbalancedOrder(std::vector<OrderedCase> cases,
                                                            std::uint64_t seed, std::uint64_t rater);

/// `count` labels of the form "7F", at random and without repetition, none of them in `taken`. The letters I
/// and O are left out. Labels grow a digit when the short ones are used up.
[[nodiscard]] std::vector<std::string> caseLabels(std::size_t count, const std::set<std::string>& taken,
                                                  std::uint64_t seed, std::uint64_t stream);

}  // namespace torsio
