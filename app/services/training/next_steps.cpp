// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/next_steps.h"

#include <algorithm>
#include <set>

#include "app/services/recording/competence.h"
#include "app/services/study/day_board.h"
#include "app/services/training/remarks.h"
#include "app/services/training/trainee_record.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

bool mastered(const ModuleStep& step) {
  if (step.rules.empty()) {
    return step.attempts > 0;
  }
  return std::all_of(step.rules.begin(), step.rules.end(), [](const RuleProgress& p) { return p.met; });
}

ModuleStep stepFor(const TrainingModule& module, const std::vector<Attempt>& all) {
  ModuleStep step;
  step.module = module;
  step.rules = ruleProgress(module, all);
  // A rest splits the recording of a phase in two, which is still one attempt.
  std::set<std::string> counted;
  for (const Attempt& attempt : all) {
    if (attempt.moduleId != module.id || !attempt.ended) {
      continue;
    }
    step.last = attempt;
    if (counts(attempt, module)) {
      counted.insert(attempt.phaseId.empty() ? attempt.trialId.text() : attempt.phaseId.text());
    }
  }
  step.attempts = static_cast<std::int64_t>(counted.size());
  if (module.attemptLimit) {
    step.attemptsLeft = std::max<std::int64_t>(0, *module.attemptLimit - step.attempts);
  }
  step.needed_us = kModuleTime_us;
  return step;
}

/// Determines which modules are locked, and the dependencies between them.
void decideStates(std::vector<ModuleStep>& steps) {
  std::set<std::string> done;
  for (const ModuleStep& step : steps) {
    if (mastered(step)) {
      done.insert(step.module.id);
    }
  }
  for (ModuleStep& step : steps) {
    for (const ModuleStep& other : steps) {
      const auto& needs = other.module.requires_;
      if (std::find(needs.begin(), needs.end(), step.module.id) != needs.end()) {
        step.unlocks.push_back(other.module.title);
      }
      const auto& mine = step.module.requires_;
      const bool needed = std::find(mine.begin(), mine.end(), other.module.id) != mine.end();
      if (needed && !done.contains(other.module.id)) {
        step.missing.push_back(other.module.title);
      }
    }
    if (done.contains(step.module.id)) {
      step.state = StepState::kMastered;
    } else if (!step.missing.empty()) {
      step.state = StepState::kLocked;
    } else if (step.attemptsLeft && *step.attemptsLeft == 0) {
      step.state = StepState::kUsedUp;
    }
  }
}

/// Adds verdicts with error rates, which "mastered" alone does not have.
void judgeMastered(SessionContext& session, const std::string& code, std::vector<ModuleStep>& steps) {
  ExerciseRules rules;
  for (ModuleStep& step : steps) {
    if (step.state == StepState::kMastered) {
      step.competence = competenceOf(session.connection(), code, step.module, rules, session.now_us());
    }
  }
}

/// Sets the rest of the arm after the logged time.
void planArm(Connection& connection, const TraineeRecord& record, NextSteps& steps) {
  if (!record.arm) {
    return;
  }
  std::vector<Exposure> own = StudyRepository(connection).exposures(record.cohort.id);
  std::erase_if(own, [&](const Exposure& e) { return e.enrolmentId != record.enrolment->id; });
  const PhaseProgress progress = phaseProgress(*record.arm, own);
  for (std::size_t i = 0; i < record.arm->phases.size(); ++i) {
    const TrainingPhase& stored = record.arm->phases[i];
    RunPhase phase{.phaseId = stored.id,
                   .label = stored.label,
                   .arm = stored.kind,
                   .duration_us = stored.duration_us,
                   .moduleId = stored.moduleId};
    if (i < progress.phase) {
      phase.done_us = phase.duration_us;
    }
    if (i == progress.phase) {
      phase.done_us = phase.duration_us - progress.left_us;
    }
    steps.exposureTotal_us += phase.duration_us;
    steps.exposureDone_us += phase.done_us;
    steps.plan.phases.push_back(std::move(phase));
  }
  steps.plan.restAllowance_us = record.arm->restAllowance_us;
  steps.plan.restSplittable = record.arm->restSplittable;
  steps.plan.restTaken_us = record.arm->restAllowance_us - progress.restLeft_us;
  steps.allPhasesDone = !record.arm->phases.empty() && progress.phase >= record.arm->phases.size();
}

const RunPhase* presentPhase(const RunPlan& plan) {
  const auto open = std::find_if(plan.phases.begin(), plan.phases.end(),
                                 [](const RunPhase& p) { return p.done_us < p.duration_us; });
  return open == plan.phases.end() ? nullptr : &*open;
}

void chooseNext(NextSteps& steps) {
  const RunPhase* phase = presentPhase(steps.plan);
  if (steps.allPhasesDone) {
    return;
  }
  for (std::size_t i = 0; i < steps.modules.size(); ++i) {
    ModuleStep& step = steps.modules[i];
    if (phase != nullptr) {
      step.needed_us = phase->duration_us - phase->done_us;
    }
    const bool asked = phase != nullptr && phase->moduleId == step.module.id;
    const bool open = step.state == StepState::kOpen;
    if (asked && (open || step.state == StepState::kMastered)) {
      steps.next = i;
    } else if (open && !steps.next && (phase == nullptr || phase->moduleId.empty())) {
      steps.next = i;
    }
  }
}

}  // namespace

NextSteps nextSteps(SessionContext& session, const PersonId& personId) {
  session.requireOwn(Operation::kTrialViewOwn, personId);
  const TraineeRecord record = ownRecord(session, Operation::kTrialViewOwn);
  NextSteps steps;
  steps.personId = record.personId;
  steps.traineeCode = record.code;
  steps.demonstration = record.demonstration;
  steps.recordingAllowed = PeopleRepository(session.connection()).hasConsent(personId, "training_record");
  steps.unreadRemarks = unreadRemarks(session);
  const std::vector<Attempt> all = attemptsOf(session, personId);
  for (const Attempt& attempt : all) {
    if (attempt.interrupted()) {
      steps.interrupted.insert(steps.interrupted.begin(), attempt);
    }
  }
  if (!record.enrolment) {
    return steps;
  }
  steps.enrolmentId = record.enrolment->id;
  steps.cohortId = record.cohort.id;
  steps.cohortName = record.cohort.name;
  steps.cohort = record.cohort;
  if (record.arm) {
    steps.armLabel = record.arm->label;
  }
  steps.hasCurriculum = record.version.has_value();
  if (!record.version) {
    return steps;
  }
  for (const TrainingModule& module : record.version->modules) {
    steps.modules.push_back(stepFor(module, all));
  }
  decideStates(steps.modules);
  judgeMastered(session, record.code, steps.modules);
  planArm(session.connection(), record, steps);
  chooseNext(steps);
  steps.scoringDue =
      scoringDue(session.connection(), steps.cohortId, steps.enrolmentId, steps.exposureDone_us);
  return steps;
}

const ModuleStep& stepOf(const NextSteps& steps, const ModuleId& moduleId) {
  const auto found = std::find_if(steps.modules.begin(), steps.modules.end(),
                                  [&](const ModuleStep& step) { return step.module.id == moduleId; });
  if (found != steps.modules.end()) {
    return *found;
  }
  refuseParameter(Text::tr("your curriculum has no such module"), moduleId,
                  Text::tr("Choose one from the list"));
}

}  // namespace torsio
