// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/study/scoring_due.h"
#include "app/services/training/attempts.h"
#include "app/services/training/training_run.h"
#include "assessment/attempt/competence.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"

namespace torsio {

enum class StepState {
  kLocked,  ///< other modules come first
  kOpen,
  kMastered,  ///< may be repeated
  kUsedUp,    ///< no attempt is left; not mastered
};

/// One module as its trainee sees it.
struct ModuleStep {
  TrainingModule module{};
  StepState state = StepState::kOpen;
  std::vector<std::string> missing{};  ///< titles of the modules that must be mastered first
  std::vector<std::string> unlocks{};  ///< titles of the modules that wait for this one
  std::vector<RuleProgress> rules{};
  std::int64_t attempts = 0;                      ///< that counted
  std::optional<std::int64_t> attemptsLeft{};     ///< empty: no limit
  std::optional<Attempt> last{};                  ///< newest one, counted or not
  std::optional<CompetenceVerdict> competence{};  ///< of a mastered one: by what error rates one is able
  std::int64_t needed_us = 0;                     ///< time that the next attempt takes at most
};

/// Everything the first page of a trainee shows.
struct NextSteps {
  PersonId personId{};
  std::string traineeCode{};
  EnrolmentId enrolmentId{};  ///< empty: in no cohort yet
  CohortId cohortId{};
  std::string cohortName{};
  std::string armLabel{};  ///< "20 min virtual, 20 min real arm"; empty: no arm
  bool demonstration = false;
  bool hasCurriculum = false;     ///< false: the cohort follows none yet
  Cohort cohort{};                ///< of the enrolment
  bool recordingAllowed = false;  ///< consent for the training record was given
  std::vector<ModuleStep> modules{};
  std::optional<std::size_t> next{};  ///< what to do now; empty: nothing is open
  /// What is left of the arm; without phases: modules at any time.
  RunPlan plan{};
  std::int64_t exposureDone_us = 0;
  std::int64_t exposureTotal_us = 0;  ///< 0: the arm has no phases
  bool allPhasesDone = false;
  std::optional<ScoringDue> scoringDue{};  ///< sheets that should be in before training goes on
  std::vector<Attempt> interrupted{};      ///< own trials that ended in an interruption, newest first
  std::size_t unreadRemarks = 0;
};

/// A run outside any phase ends after this time at the latest.
inline constexpr std::int64_t kModuleTime_us = 600'000'000;

/// Modules of the running curriculum of the trainee's cohort, what is open, what is locked and why.
/// kTrialViewOwn, own person only.
[[nodiscard]] NextSteps nextSteps(SessionContext& session, const PersonId& personId);

/// The step of one module. Throws Error{kBadParameter} when the curriculum has no such module.
[[nodiscard]] const ModuleStep& stepOf(const NextSteps& steps, const ModuleId& moduleId);

}  // namespace torsio
