// SPDX-License-Identifier: GPL-3.0-or-later
// Enrolments of cohorts and their training times.
#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "app/services/study/cohort_service.h"
#include "app/services/study/day_board.h"
#include "app/services/study/scoring_due.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr std::string_view kTrainedBesidePlan = storedText(DeviationKind::kTrainedOutsidePlan);

Enrolment enrolmentOf(StudyRepository& study, const CohortId& cohortId, const EnrolmentId& enrolmentId) {
  for (Enrolment& enrolment : study.enrolments(cohortId)) {
    if (enrolment.id == enrolmentId) {
      return enrolment;
    }
  }
  refuse(Text::tr("nobody is enrolled here under this number"), enrolmentId,
         Text::tr("Choose one from the list"));
}

/// Finds a phase in an enrolment's arm.
const TrainingPhase* phaseOf(const StudyArm& arm, const PhaseId& phaseId) {
  const auto found = std::find_if(arm.phases.begin(), arm.phases.end(),
                                  [&](const TrainingPhase& phase) { return phase.id == phaseId; });
  return found == arm.phases.end() ? nullptr : &*found;
}

/// Returns the arm of an enrolment; empty if it has none or the cohort follows no curriculum.
std::optional<StudyArm> armOf(SessionContext& session, const Cohort& cohort, const Enrolment& enrolment) {
  const auto version = CurriculumRepository(session.connection()).version(cohort.curriculumVersionId);
  if (!version) {
    return std::nullopt;
  }
  ArmId armId;
  for (const StudyGroup& group : StudyRepository(session.connection()).groups(cohort.id)) {
    if (group.id == enrolment.groupId) {
      armId = group.armId;
    }
  }
  for (const StudyArm& arm : version->arms) {
    if (arm.id == armId) {
      return arm;
    }
  }
  return std::nullopt;
}

void checkPhase(const Cohort& cohort, const std::optional<StudyArm>& arm, const Enrolment& enrolment,
                const NewExposure& exposure) {
  if (cohort.curriculumVersionId.empty()) {
    refuse(Text::tr("the cohort follows no curriculum"), Text::tr("phase"),
           Text::tr("Record the time without a phase"));
  }
  const TrainingPhase* phase = arm ? phaseOf(*arm, exposure.phaseId) : nullptr;
  if (phase == nullptr) {
    refuse(Text::tr("this phase belongs to another arm"), enrolment.traineeCode,
           Text::tr("Choose a phase of the trainee's own arm"));
  }
  if (exposure.kind != ExposureKind::kRest && exposure.kind != exposureIn(phase->kind)) {
    refuse(Text::tr("the phase is %1, the time is %2", std::string(storedText(phase->kind)),
                    std::string(storedText(exposure.kind))),
           enrolment.traineeCode, Text::tr("Record it for the phase that it was spent in"));
  }
}

/// Formats "20 min" or "7.5 min".
std::string minutesText(std::int64_t time_us) {
  const std::int64_t tenths = (10 * time_us + kMinute_us / 2) / kMinute_us;
  return std::to_string(tenths / 10) + (tenths % 10 == 0 ? "" : "." + std::to_string(tenths % 10)) + " min";
}

/// Records training time outside the arm's plan as a deviation with its reason, since it makes the groups
/// alike.
void notePlan(SessionContext& session, const StudyArm& arm, const Enrolment& enrolment,
              const NewExposure& exposure) {
  if (isPlanned(arm, exposure.kind)) {
    return;
  }
  if (exposure.reason.empty()) {
    refuse(Text::tr("the arm of this trainee spends no time on this"), enrolment.traineeCode,
           Text::tr("Say why; it is noted as a deviation"));
  }
  const DeviationId id = session.ids().newUuid();
  StudyRepository(session.connection())
      .addDeviation({id, exposure.cohortId, enrolment.id, std::string(kTrainedBesidePlan),
                     minutesText(exposure.duration_us) + " " +
                         (exposure.kind == ExposureKind::kReal ? "on the real arm: " : "on the simulator: ") +
                         exposure.reason,
                     exposure.startedUtc_us, session.actor().userId, session.now_us(),
                     enrolment.demonstration});
  session.note({.action = AuditAction::kDeviationReport,
                .objectKind = AuditObject::kDeviation,
                .objectId = id,
                .newJson = nlohmann::json{{"kind", kTrainedBesidePlan},
                                          {"cohort", exposure.cohortId},
                                          {"enrolment", enrolment.id}}
                               .dump()});
}

/// Records training while sheets of the real arm are missing as a deviation, whoever logs it.
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
  // The order would also reveal the groups.
  std::sort(list.begin(), list.end(),
            [](const Enrolment& a, const Enrolment& b) { return a.traineeCode < b.traineeCode; });
  return list;
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
  const std::optional<StudyArm> arm = armOf(session, cohort, enrolment);
  if (!exposure.phaseId.empty()) {
    checkPhase(cohort, arm, enrolment, exposure);
  } else if (arm) {
    notePlan(session, *arm, enrolment, exposure);
  }
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
