// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/competence_service.h"

#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/recording/competence.h"
#include "app/services/recording/kept_digests.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/excuse_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::int64_t kRunsOfOne = 10'000;

TrainingModule publishedModule(Connection& connection, const ModuleId& moduleId) {
  CurriculumRepository repository(connection);
  for (const Curriculum& curriculum : repository.curricula()) {
    for (const CurriculumVersionId& id : repository.versionIds(curriculum.id)) {
      CurriculumVersion version = repository.version(id).value();
      for (TrainingModule& module : version.modules) {
        if (module.id == moduleId) {
          return std::move(module);
        }
      }
    }
  }
  refuse(Text::tr("there is no such exercise in a published curriculum"), moduleId,
         Text::tr("Choose one from the list"));
}

/// Returns the mean absolute error of a person's completed twists at an exercise, degrees; empty if none.
std::optional<double> meanError_deg(Connection& connection, const EnrolmentId& enrolmentId,
                                    const TrainingModule& module, ExerciseRules& rules, std::int64_t now_us) {
  TrialFilter filter;
  filter.enrolmentId = enrolmentId;
  filter.sceneId = module.sceneId;
  filter.limit = kRunsOfOne;
  double sum = 0.0;
  std::int64_t twists = 0;
  for (const TrialListing& trial : TrialRepository(connection).list(filter)) {
    if (trial.patternId != module.patternId || !trial.summary ||
        trial.summary->outcome == TrialOutcome::kInterrupted) {
      continue;
    }
    const TrialDigest digest = digestOf(connection, trial, rules, now_us);
    for (const JudgedTwist& twist : digest.measures.twists) {
      sum += twist.error_deg;
      ++twists;
    }
  }
  return twists > 0 ? std::optional(sum / static_cast<double>(twists)) : std::nullopt;
}

nlohmann::ordered_json designJson(const CompetenceDesign& design) {
  nlohmann::ordered_json json;
  json["version"] = design.version;
  json["tolerance_rad"] = design.tolerance_rad;
  json["tolerance_source"] = storedText(design.source);
  json["experts"] = design.experts;
  json["adequate"] = design.adequate;
  json["inadequate"] = design.inadequate;
  json["attempts"] = design.attempts;
  json["false_pass_most"] = design.falsePassMost;
  json["false_fail_most"] = design.falseFailMost;
  json["session_correlation"] = design.sessionCorrelation;
  json["lag_correlation"] = design.lagCorrelation;
  json["runs_per_session"] = design.runsPerSession;
  json["dependence_runs"] = design.dependenceRuns;
  json["valid_days"] = design.validDays;
  json["limit"] = design.limit;
  return json;
}

}  // namespace

std::vector<ExerciseDesigns> competenceDesigns(SessionContext& session,
                                               const CurriculumVersionId& versionId) {
  session.require(Operation::kPersonViewCoded);
  CurriculumRepository repository(session.connection());
  const CompetenceRepository designs(session.connection());
  std::vector<ExerciseDesigns> all;
  bool found = versionId.empty();
  for (const Curriculum& curriculum : repository.curricula()) {
    for (const CurriculumVersionId& id : repository.versionIds(curriculum.id)) {
      if (!versionId.empty() && id != versionId) {
        continue;
      }
      found = true;
      const CurriculumVersion version = repository.version(id).value();
      for (const TrainingModule& module : version.modules) {
        const CompetenceDesign shipped = shippedCompetence(module.id, module.tolerance_rad);
        const std::vector<CompetenceDesign> registered = designs.ofModule(module.id);
        all.push_back({module.id, curriculum.name, version.number, module.code, module.title, shipped,
                       registered, ruleOf(module, designInForce(registered, shipped, std::nullopt))});
      }
    }
  }
  if (!found) {
    refuse(Text::tr("there is no such version"), versionId, Text::tr("Choose one from the list"));
  }
  return all;
}

CompetenceDesign registerCompetence(SessionContext& session, const CompetenceDesign& design) {
  session.require(Operation::kCurriculumEdit);
  CompetenceDesign planned = design;
  if (planned.source == ToleranceSource::kChosen && planned.reason.empty()) {
    refuseParameter(Text::tr("a tolerance chosen by hand needs a reason"), Text::tr("competence design"),
                    Text::tr("Write why, in a few words"));
  }
  Transaction transaction(session.connection());
  const TrainingModule module = publishedModule(session.connection(), planned.moduleId);
  if (planned.source == ToleranceSource::kExercise) {
    planned.tolerance_rad = module.tolerance_rad;
  }
  setDependence(planned, dependenceOfRuns(session, planned.moduleId));
  planned = plannedCompetence(planned);
  requireFalseFailKept(planned);
  planned.registeredUtc_us = session.now_us();
  planned = CompetenceRepository(session.connection()).add(std::move(planned));
  session.note(AuditAction::kCompetenceRegister, AuditObject::kCompetenceDesign, planned.moduleId,
               designJson(planned), planned.reason);
  transaction.commit();
  return planned;
}

EstimatedDependence dependenceOfRuns(SessionContext& session, const ModuleId& moduleId) {
  session.require(Operation::kCurriculumEdit);
  ExerciseRules rules;
  return centreDependence(session.connection(), publishedModule(session.connection(), moduleId), rules,
                          session.now_us());
}

ProficiencyThreshold expertTolerance_deg(SessionContext& session, const ModuleId& moduleId,
                                         const CohortId& expertCohortId) {
  session.require(Operation::kCurriculumEdit);
  Connection& connection = session.connection();
  const TrainingModule module = publishedModule(connection, moduleId);
  ExerciseRules rules;
  std::vector<double> errors;
  for (const Enrolment& enrolment : StudyRepository(connection).enrolments(expertCohortId)) {
    if (const auto error = meanError_deg(connection, enrolment.id, module, rules, session.now_us())) {
      errors.push_back(*error);
    }
  }
  if (errors.size() < kMinExperts) {
    refuse(Text::tr("%1 {person of this cohort has|people of this cohort have} a finished run at this "
                    "exercise; %2 {is|are} needed",
                    errors.size(), kMinExperts),
           module.title, Text::tr("Let more experts make a run, or keep the tolerance of the exercise"));
  }
  const Outcome<ProficiencyThreshold> threshold = proficiencyThreshold(errors);
  if (!threshold) {
    refuse(threshold.reason(), module.title, Text::tr("Keep the tolerance of the exercise"));
  }
  return *threshold;
}

std::vector<InterruptedRun> interruptedRuns(SessionContext& session, const ModuleId& moduleId) {
  session.require(Operation::kPersonViewCoded);
  const TrainingModule module = publishedModule(session.connection(), moduleId);
  TrialFilter filter;
  filter.moduleId = moduleId;
  filter.limit = kRunsOfOne;
  const ExcuseRepository excuses(session.connection());
  std::vector<InterruptedRun> runs;
  for (const TrialListing& trial : TrialRepository(session.connection()).list(filter)) {
    if (trial.summary && trial.summary->outcome == TrialOutcome::kInterrupted &&
        countsAt(module, trial.attemptMode)) {
      const std::optional<RunExcuse> excuse = excuses.of(trial.trialId);
      runs.push_back({trial.trialId, trial.traineeCode, trial.startedUtc_us, excuse.has_value(),
                      excuse ? excuse->reason : std::string()});
    }
  }
  return runs;
}

void excuseRun(SessionContext& session, const TrialId& trialId, const std::string& reason) {
  session.require(Operation::kStudySetup);
  if (reason.empty()) {
    refuseParameter(Text::tr("an excuse needs a reason"), Text::tr("interrupted run"),
                    Text::tr("Write why, in a few words"));
  }
  Transaction transaction(session.connection());
  const std::optional<TrialListing> trial = TrialRepository(session.connection()).listing(trialId);
  if (!trial || !trial->summary || trial->summary->outcome != TrialOutcome::kInterrupted) {
    refuse(Text::tr("there is no such interrupted run"), trialId, Text::tr("Choose one from the list"));
  }
  const std::optional<Trainee> trainee =
      PeopleRepository(session.connection()).findTrainee(trial->traineeCode);
  if (trainee && !session.actor().personId.empty() && trainee->person.id == session.actor().personId) {
    refuse(Text::tr("nobody excuses a run of their own"), trialId, Text::tr("Ask another administrator"));
  }
  ExcuseRepository excuses(session.connection());
  if (excuses.of(trialId)) {
    refuse(Text::tr("this run is excused already"), trialId, Text::tr("Nothing is left to do"));
  }
  excuses.add({trialId, session.actor().userId, session.now_us(), reason});
  session.note(AuditAction::kTrialExcuse, AuditObject::kTrial, trialId, {}, reason);
  transaction.commit();
}

}  // namespace torsio
