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
  kLocked,  ///< other modules must be mastered first
  kOpen,
  kMastered,  ///< can be repeated
  kUsedUp,    ///< no attempts left, not mastered
};

/// A module as seen by its trainee.
struct ModuleStep {
  TrainingModule module{};
  StepState state = StepState::kOpen;
  std::vector<std::string> missing{};  ///< titles of modules to master first
  std::vector<std::string> unlocks{};  ///< titles of modules that need this one
  std::vector<RuleProgress> rules{};
  std::int64_t attempts = 0;                      ///< number of attempts that counted
  std::optional<std::int64_t> attemptsLeft{};     ///< empty: no limit
  std::optional<Attempt> last{};                  ///< latest, whether counted or not
  std::optional<CompetenceVerdict> competence{};  ///< of a mastered module, with its error rates
  std::int64_t needed_us = 0;                     ///< maximum time of the next attempt
};

/// Content of a trainee's start page.
struct NextSteps {
  PersonId personId{};
  std::string traineeCode{};
  EnrolmentId enrolmentId{};  ///< empty: not in a cohort yet
  CohortId cohortId{};
  std::string cohortName{};
  std::string armLabel{};  ///< "20 min virtual, 20 min real arm"; empty: no arm
  bool demonstration = false;
  bool hasCurriculum = false;     ///< false: the cohort follows none yet
  Cohort cohort{};                ///< of the enrolment
  bool recordingAllowed = false;  ///< consent to the training record was given
  std::vector<ModuleStep> modules{};
  std::optional<std::size_t> next{};  ///< what to do now; empty: nothing
  /// The rest of the arm; without phases: modules at any time.
  RunPlan plan{};
  std::int64_t exposureDone_us = 0;
  std::int64_t exposureTotal_us = 0;  ///< 0: the arm has no phases
  bool allPhasesDone = false;
  std::optional<ScoringDue> scoringDue{};  ///< sheets due before training continues
  std::vector<Attempt> interrupted{};      ///< the trainee's interrupted trials, latest first
  std::size_t unreadRemarks = 0;
};

/// Maximum duration of a run outside any phase.
inline constexpr std::int64_t kModuleTime_us = 600'000'000;

/// Returns the modules of the running curriculum of the trainee's cohort, what is open, what is locked and
/// why. kTrialViewOwn, the actor's person.
[[nodiscard]] NextSteps nextSteps(SessionContext& session, const PersonId& personId);

/// Returns the step of one module. Throws Error{kBadParameter} if the curriculum has no such module.
[[nodiscard]] const ModuleStep& stepOf(const NextSteps& steps, const ModuleId& moduleId);

}  // namespace torsio
