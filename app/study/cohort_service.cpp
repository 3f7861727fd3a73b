// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/study/cohort_service.h"

#include <algorithm>
#include <set>
#include <tuple>

#include <nlohmann/json.hpp>

#include "app/study/day_plan.h"
#include "app/study/scoring_due.h"
#include "assessment/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/base/error.h"
#include "sim/base/ids.h"
#include "sim/base/refusal.h"

namespace torsio {

namespace {

Enrolment enrolmentOf(StudyRepository& study, const CohortId& cohortId, const EnrolmentId& enrolmentId) {
  for (Enrolment& enrolment : study.enrolments(cohortId)) {
    if (enrolment.id == enrolmentId) {
      return enrolment;
    }
  }
  refuse(Text::tr("nobody is enrolled here under this number"), enrolmentId,
         Text::tr("Choose one from the list"));
}

void checkName(StudyRepository& study, const CohortId& own, const std::string& name) {
  if (name.empty()) {
    refuseParameter(Text::tr("the cohort has no name"), Text::tr("cohort"), Text::tr("Enter one"));
  }
  for (const Cohort& other : study.cohorts()) {
    if (other.name == name && other.id != own) {
      refuseParameter(Text::tr("another cohort has this name"), name, Text::tr("Choose another name"));
    }
  }
}

void checkNewCohort(const NewCohort& cohort) {
  const auto bad = [](const Text& what, const Text& remedy) {
    throw Error(ErrorCode::kBadParameter, what, Text::tr("cohort"), remedy);
  };
  if (cohort.groups.empty() && cohort.curriculumVersionId.empty()) {
    bad(Text::tr("the cohort has no groups"),
        Text::tr("Name its groups, or choose a curriculum whose arms they follow"));
  }
  if (cohort.equivalenceMargin &&
      !(*cohort.equivalenceMargin > 0.0 && *cohort.equivalenceMargin <= kLargestMargin)) {
    bad(Text::tr("a margin of equivalence lies above 0 and is at most %1 points", kLargestMargin),
        Text::tr("Enter the largest difference that does not matter, or none"));
  }
  std::set<std::string> codes;
  for (const NewGroup& group : cohort.groups) {
    if (group.code.empty()) {
      bad(Text::tr("a group has no code"), Text::tr("Give each group a short code, such as G1"));
    }
    if (!codes.insert(group.code).second) {
      bad(Text::tr("two groups are called %1", group.code), Text::tr("Rename one of them"));
    }
  }
}

/// What a phase id means, within the arm of an enrolment.
const TrainingPhase* phaseOf(const StudyArm& arm, const PhaseId& phaseId) {
  const auto found = std::find_if(arm.phases.begin(), arm.phases.end(),
                                  [&](const TrainingPhase& phase) { return phase.id == phaseId; });
  return found == arm.phases.end() ? nullptr : &*found;
}

void checkPhase(SessionContext& session, const Cohort& cohort, const Enrolment& enrolment,
                const NewExposure& exposure) {
  if (exposure.phaseId.empty()) {
    return;
  }
  const auto version = CurriculumRepository(session.connection()).version(cohort.curriculumVersionId);
  if (!version) {
    refuse(Text::tr("the cohort follows no curriculum"), Text::tr("phase"),
           Text::tr("Record the time without a phase"));
  }
  StudyRepository study(session.connection());
  ArmId armId;
  for (const StudyGroup& group : study.groups(cohort.id)) {
    if (group.id == enrolment.groupId) {
      armId = group.armId;
    }
  }
  for (const StudyArm& arm : version->arms) {
    if (arm.id != armId) {
      continue;
    }
    const TrainingPhase* phase = phaseOf(arm, exposure.phaseId);
    if (phase == nullptr) {
      break;
    }
    if (exposure.kind == ExposureKind::kRest || exposure.kind == exposureIn(phase->kind)) {
      return;
    }
    refuse(Text::tr("the phase is %1, the time is %2", std::string(storedText(phase->kind)),
                    std::string(storedText(exposure.kind))),
           enrolment.traineeCode, Text::tr("Record it for the phase that it was spent in"));
  }
  refuse(Text::tr("this phase belongs to another arm"), enrolment.traineeCode,
         Text::tr("Choose a phase of the trainee's own arm"));
}

/// Where somebody is expected, called or training, or sheets are due by the end of the day.
std::set<CohortId> cohortsOfToday(SessionContext& session) {
  const std::int64_t from_us = session.now_us() - kHalfDay_us;
  const std::int64_t to_us = session.now_us() + kHalfDay_us;
  std::set<CohortId> today;
  for (const CohortId& id : StudyRepository(session.connection()).cohortsAtWork(from_us, to_us)) {
    today.insert(id);
  }
  for (const CohortId& id : SheetRepository(session.connection()).cohortsAwaited(from_us, to_us)) {
    today.insert(id);
  }
  return today;
}

}  // namespace

std::vector<CohortRow> cohorts(SessionContext& session) {
  session.require(Operation::kPersonViewCoded);
  StudyRepository study(session.connection());
  CurriculumRepository curricula(session.connection());
  std::vector<CohortRow> rows;
  const std::set<CohortId> today = cohortsOfToday(session);
  for (Cohort& cohort : study.cohorts()) {
    CohortRow row;
    row.groups = study.groups(cohort.id);
    for (const Enrolment& enrolment : study.enrolments(cohort.id)) {
      if (enrolment.state == EnrolmentState::kWithdrawn) {
        ++row.withdrawn;
        continue;
      }
      ++row.enrolled;
      if (!enrolment.groupId.empty()) {
        ++row.allocated;
      }
    }
    if (const auto version = curricula.version(cohort.curriculumVersionId)) {
      row.curriculumNumber = version->number;
      for (const Curriculum& curriculum : curricula.curricula()) {
        if (curriculum.id == version->curriculumId) {
          row.curriculumName = curriculum.name;
        }
      }
    }
    row.today = today.contains(cohort.id);
    row.cohort = std::move(cohort);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::size_t cohortShownFirst(std::span<const CohortRow> rows) {
  const auto rank = [](const CohortRow& row) {
    const CohortState state = row.cohort.state;
    return std::tuple(state != CohortState::kArchived, row.today,
                      row.allocated > 0 && state == CohortState::kRunning, row.allocated > 0, row.allocated);
  };
  std::size_t first = rows.size();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (first == rows.size() || !(rank(rows[i]) < rank(rows[first]))) {
      first = i;
    }
  }
  return first;
}

std::vector<Enrolment> enrolments(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kPersonViewCoded);
  std::vector<Enrolment> list = StudyRepository(session.connection()).enrolments(cohortId);
  if (session.may(Operation::kAllocationView)) {
    return list;
  }
  for (Enrolment& enrolment : list) {
    enrolment.groupId = {};
    enrolment.groupCode.clear();
    enrolment.numberInGroup = 0;
  }
  // The order tells the groups, too.
  std::sort(list.begin(), list.end(),
            [](const Enrolment& a, const Enrolment& b) { return a.traineeCode < b.traineeCode; });
  return list;
}

CohortId addCohort(SessionContext& session, const NewCohort& cohort) {
  session.require(Operation::kStudySetup);
  checkNewCohort(cohort);
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  checkName(study, {}, cohort.name);
  const CohortId id = session.ids().newUuid();
  std::vector<NewGroup> names = cohort.groups;
  CurriculumRepository curricula(session.connection());
  if (names.empty()) {
    const auto version = curricula.version(cohort.curriculumVersionId);
    if (!version) {
      refuse(Text::tr("there is no such curriculum"), cohort.curriculumVersionId,
             Text::tr("Choose one from the list"));
    }
    for (const StudyArm& arm : version->arms) {
      names.push_back({arm.code, arm.label});
    }
  }
  std::vector<StudyGroup> groups;
  for (const NewGroup& group : names) {
    groups.push_back(
        {session.ids().newUuid(), id, static_cast<std::int64_t>(groups.size() + 1), group.code, group.label});
  }
  study.addCohort({.id = id,
                   .name = cohort.name,
                   .description = cohort.description,
                   .createdUtc_us = session.now_us(),
                   .demonstration = cohort.demonstration,
                   .equivalenceMargin = cohort.equivalenceMargin},
                  groups);
  nlohmann::json now{{"groups", nlohmann::json::array()}, {"curriculum_version", cohort.curriculumVersionId}};
  for (const StudyGroup& group : groups) {
    now["groups"].push_back(group.code);
  }
  if (cohort.equivalenceMargin) {
    now["equivalence_margin"] = *cohort.equivalenceMargin;
  }
  if (!cohort.curriculumVersionId.empty()) {
    curricula.assign(id, cohort.curriculumVersionId);
  }
  session.note({.action = AuditAction::kCohortAdd,
                .objectKind = AuditObject::kCohort,
                .objectId = id,
                .newJson = now.dump()});
  transaction.commit();
  return id;
}

void renameCohort(SessionContext& session, const CohortId& cohortId, const std::string& name) {
  session.require(Operation::kStudySetup);
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const Cohort before = study.cohort(cohortId);
  checkName(study, cohortId, name);
  study.renameCohort(cohortId, name);
  session.note({.action = AuditAction::kCohortRename,
                .objectKind = AuditObject::kCohort,
                .objectId = cohortId,
                .oldJson = nlohmann::json{{"name", before.name}}.dump(),
                .newJson = nlohmann::json{{"name", name}}.dump()});
  transaction.commit();
}

namespace {

/// Throws where a cohort cannot go from the state it is in to another one.
void checkStep(SessionContext& session, const Cohort& cohort, CohortState state) {
  const bool closes = state == CohortState::kClosed && cohort.state == CohortState::kRunning;
  const bool archives = state == CohortState::kArchived && cohort.state == CohortState::kClosed;
  const bool opens = state == CohortState::kRunning &&
                     (cohort.state == CohortState::kClosed || cohort.state == CohortState::kArchived);
  if (!closes && !archives && !opens) {
    refuse(Text::tr("the cohort is %1 and cannot become %2", std::string(storedText(cohort.state)),
                    std::string(storedText(state))),
           cohort.name, Text::tr("Close a running cohort, archive a closed one, or open it again"));
  }
  if (closes && !StudyRepository(session.connection()).runningTrials(cohort.id).empty()) {
    refuse(Text::tr("somebody of this cohort is training"), cohort.name,
           Text::tr("Wait for the end of the run, or close what was cut off at its station"));
  }
  const std::int64_t open = archives ? SheetRepository(session.connection()).openAssignments(cohort.id) : 0;
  if (open > 0) {
    refuse(Text::tr("%1 sheets are still open", open), cohort.name,
           Text::tr("Wait for them, or take them back under Scoring"));
  }
}

}  // namespace

void setCohortState(SessionContext& session, const CohortId& cohortId, CohortState state,
                    const std::string& reason) {
  session.require(Operation::kStudySetup);
  if (reason.empty()) {
    refuseParameter(Text::tr("it is not said why"), cohortId, Text::tr("Say in a few words why"));
  }
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const Cohort before = study.cohort(cohortId);
  checkStep(session, before, state);
  study.setCohortState(cohortId, state, reason, session.actor().userId, session.now_us());
  session.note({.action = AuditAction::kCohortSetState,
                .objectKind = AuditObject::kCohort,
                .objectId = cohortId,
                .oldJson = nlohmann::json{{"state", storedText(before.state)}}.dump(),
                .newJson = nlohmann::json{{"state", storedText(state)}}.dump(),
                .reason = reason});
  transaction.commit();
}

void refuseWhenClosed(const Cohort& cohort) {
  if (cohort.state == CohortState::kClosed || cohort.state == CohortState::kArchived) {
    refuse(Text::tr("this cohort is closed"), cohort.name,
           Text::tr("Choose another cohort, or have an administrator open it again"));
  }
}

void assignCurriculum(SessionContext& session, const CohortId& cohortId,
                      const CurriculumVersionId& versionId) {
  session.require(Operation::kStudySetup);
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const Cohort before = study.cohort(cohortId);
  refuseWhenClosed(before);
  if (!study.exposures(cohortId).empty()) {
    refuse(Text::tr("training has begun: the curriculum of this cohort stays"), before.name,
           Text::tr("Make another cohort for the other curriculum"));
  }
  CurriculumRepository(session.connection()).assign(cohortId, versionId);
  session.note({.action = AuditAction::kCohortAssignCurriculum,
                .objectKind = AuditObject::kCohort,
                .objectId = cohortId,
                .oldJson = nlohmann::json{{"curriculum_version", before.curriculumVersionId}}.dump(),
                .newJson = nlohmann::json{{"curriculum_version", versionId}}.dump()});
  transaction.commit();
}

std::vector<EnrolmentId> enrolTrainees(SessionContext& session, const CohortId& cohortId,
                                       const std::vector<TraineeId>& traineeIds) {
  session.require(Operation::kStudyEnrol);
  if (traineeIds.empty()) {
    refuse(Text::tr("nobody was chosen"), Text::tr("enrolment"), Text::tr("Choose at least one trainee"));
  }
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const Cohort cohort = study.cohort(cohortId);
  refuseWhenClosed(cohort);
  std::set<TraineeId> enrolled;
  for (const Enrolment& enrolment : study.enrolments(cohortId)) {
    enrolled.insert(enrolment.traineeId);
  }
  PeopleRepository people(session.connection());
  std::vector<Enrolment> records;
  std::vector<EnrolmentId> ids;
  for (const TraineeId& traineeId : traineeIds) {
    const auto person = people.find(traineeId);
    if (!person || person->state != PersonState::kActive || !people.findTrainee(person->code)) {
      refuse(Text::tr("this is no active trainee"), person ? person->code : traineeId.text(),
             Text::tr("Choose one from the list"));
    }
    if (!enrolled.insert(traineeId).second) {
      refuse(Text::tr("is enrolled in this cohort already"), person->code, Text::tr("Leave them out"));
    }
    ids.push_back(session.ids().newUuid());
    records.push_back({.id = ids.back(),
                       .cohortId = cohortId,
                       .traineeId = traineeId,
                       .enrolledUtc_us = session.now_us(),
                       .demonstration = cohort.demonstration});
    session.note({.action = AuditAction::kEnrolmentAdd,
                  .objectKind = AuditObject::kEnrolment,
                  .objectId = ids.back(),
                  .newJson = nlohmann::json{{"cohort", cohortId}, {"trainee", person->code}}.dump()});
  }
  study.enrol(records);
  transaction.commit();
  return ids;
}

void setEnrolmentState(SessionContext& session, const CohortId& cohortId, const EnrolmentId& enrolmentId,
                       EnrolmentState state, const std::string& reason) {
  session.require(Operation::kStudyEnrol);
  if (state == EnrolmentState::kWithdrawn && reason.empty()) {
    refuse(Text::tr("a withdrawal needs a reason"), enrolmentId, Text::tr("Say in a few words why"));
  }
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const Enrolment before = enrolmentOf(study, cohortId, enrolmentId);
  study.setEnrolmentState(enrolmentId, state);
  session.note({.action = AuditAction::kEnrolmentSetState,
                .objectKind = AuditObject::kEnrolment,
                .objectId = enrolmentId,
                .oldJson = nlohmann::json{{"state", storedText(before.state)}}.dump(),
                .newJson = nlohmann::json{{"state", storedText(state)}}.dump(),
                .reason = reason});
  transaction.commit();
}

namespace {

/// Training that goes on while sheets of the real arm are missing is a deviation, whoever logs it.
void noteMissingSheets(SessionContext& session, const NewExposure& exposure, const Enrolment& enrolment) {
  if (exposure.kind == ExposureKind::kRest) {
    return;
  }
  StudyRepository study(session.connection());
  std::int64_t trained_us = 0;
  for (const Exposure& one : study.exposures(exposure.cohortId)) {
    if (one.enrolmentId == enrolment.id && one.kind != ExposureKind::kRest) {
      trained_us += one.duration_us;
    }
  }
  if (const auto due = scoringDue(session.connection(), exposure.cohortId, enrolment.id, trained_us)) {
    study.addDeviation(trainedBeforeScoring(session, *due, exposure.cohortId, enrolment.id,
                                            "training time was logged", enrolment.demonstration));
  }
}

}  // namespace

ExposureId recordExposure(SessionContext& session, const NewExposure& exposure) {
  session.requireEither(Operation::kStudySetup, Operation::kTrialRecordOwn);
  if (exposure.duration_us <= 0) {
    refuse(Text::tr("no time was spent"), Text::tr("exposure"), Text::tr("Enter the minutes"));
  }
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const Cohort cohort = study.cohort(exposure.cohortId);
  const Enrolment enrolment = enrolmentOf(study, exposure.cohortId, exposure.enrolmentId);
  if (!session.may(Operation::kStudySetup)) {
    session.requireOwn(Operation::kTrialRecordOwn, enrolment.traineeId);
  }
  if (enrolment.state == EnrolmentState::kWithdrawn) {
    refuse(Text::tr("has withdrawn from the study"), enrolment.traineeCode,
           Text::tr("Nothing is recorded any more"));
  }
  checkPhase(session, cohort, enrolment, exposure);
  noteMissingSheets(session, exposure, enrolment);
  Exposure stored{session.ids().newUuid(), exposure.enrolmentId,   exposure.phaseId,
                  exposure.kind,           exposure.startedUtc_us, exposure.duration_us,
                  session.actor().userId,  enrolment.demonstration};
  study.addExposures(std::span(&stored, 1));
  session.note({.action = AuditAction::kExposureRecord,
                .objectKind = AuditObject::kExposure,
                .objectId = stored.id,
                .newJson = nlohmann::json{{"enrolment", exposure.enrolmentId},
                                          {"kind", storedText(exposure.kind)},
                                          {"phase", exposure.phaseId},
                                          {"duration_us", exposure.duration_us}}
                               .dump()});
  transaction.commit();
  return stored.id;
}

}  // namespace torsio
