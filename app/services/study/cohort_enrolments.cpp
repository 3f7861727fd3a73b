// SPDX-License-Identifier: GPL-3.0-or-later
// Enrolments of cohorts, their training times and protocol deviations.
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
  session.note(AuditAction::kDeviationReport, AuditObject::kDeviation, id,
               {{"kind", kTrainedBesidePlan}, {"cohort", exposure.cohortId}, {"enrolment", enrolment.id}});
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
      refuse(Text::tr("not an active trainee"), person ? person->code : traineeId.text(),
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
    session.note(AuditAction::kEnrolmentAdd, AuditObject::kEnrolment, ids.back(),
                 {{"cohort", cohortId}, {"trainee", person->code}});
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
  session.noteChange(AuditAction::kEnrolmentSetState, AuditObject::kEnrolment, enrolmentId,
                     {{"state", storedText(before.state)}}, {{"state", storedText(state)}}, reason);
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
  session.note(AuditAction::kExposureRecord, AuditObject::kExposure, stored.id,
               {{"enrolment", exposure.enrolmentId},
                {"kind", storedText(exposure.kind)},
                {"phase", exposure.phaseId},
                {"duration_us", exposure.duration_us}});
  transaction.commit();
  return stored.id;
}

namespace {

void checkDeviation(const NewDeviation& deviation) {
  const auto kind = fromStoredText<DeviationKind>(deviation.kind);
  if (!kind || *kind >= DeviationKind::kTrainedBeforeScoring) {
    refuse(Text::tr("this kind of deviation is not known"), deviation.kind,
           Text::tr("Choose one from the list"));
  }
  if (kind == DeviationKind::kOther && deviation.description.empty()) {
    refuse(Text::tr("\"other\" needs a description"), Text::tr("deviation"),
           Text::tr("Say in a few words what happened"));
  }
}

}  // namespace

DeviationId reportDeviation(SessionContext& session, const NewDeviation& deviation) {
  session.require(Operation::kStudySetup);
  checkDeviation(deviation);
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const Cohort cohort = study.cohort(deviation.cohortId);
  const std::vector<Enrolment> enrolled = study.enrolments(cohort.id);
  if (!deviation.enrolmentId.empty() &&
      std::none_of(enrolled.begin(), enrolled.end(),
                   [&](const Enrolment& one) { return one.id == deviation.enrolmentId; })) {
    refuse(Text::tr("nobody is enrolled here under this number"), deviation.enrolmentId,
           Text::tr("Choose one from the list"));
  }
  const std::int64_t now_us = session.now_us();
  const DeviationId id = session.ids().newUuid();
  study.addDeviation({id, cohort.id, deviation.enrolmentId, deviation.kind, deviation.description,
                      deviation.happenedUtc_us == 0 ? now_us : deviation.happenedUtc_us,
                      session.actor().userId, now_us, cohort.demonstration});
  // The description is free text that may contain names, so it is not audited.
  session.note(AuditAction::kDeviationReport, AuditObject::kDeviation, id,
               {{"kind", deviation.kind}, {"cohort", cohort.id}, {"enrolment", deviation.enrolmentId}});
  transaction.commit();
  return id;
}

void reportDeviations(SessionContext& session, std::span<const NewDeviation> deviations) {
  session.require(Operation::kStudySetup);
  Transaction transaction(session.connection());
  for (const NewDeviation& one : deviations) {
    static_cast<void>(reportDeviation(session, one));
  }
  transaction.commit();
}

void correctDeviations(SessionContext& session, const CohortId& cohortId,
                       std::span<const DeviationId> deviationIds, const std::string& reason) {
  session.require(Operation::kStudySetup);
  if (reason.empty()) {
    refuse(Text::tr("a correction needs a reason"), Text::tr("deviation"), Text::tr("Say what was wrong"));
  }
  const std::set<DeviationId> wrong(deviationIds.begin(), deviationIds.end());
  std::vector<NewDeviation> corrections;
  for (const ProtocolDeviation& one : StudyRepository(session.connection()).deviations(cohortId)) {
    if (wrong.contains(one.id)) {
      corrections.push_back({.cohortId = cohortId,
                             .enrolmentId = one.enrolmentId,
                             .kind = std::string(storedText(DeviationKind::kOther)),
                             .description = "entered in error: \"" + one.kind +
                                            (one.description.empty() ? "" : ": " + one.description) +
                                            "\": " + reason,
                             .happenedUtc_us = one.happenedUtc_us});
    }
  }
  if (corrections.size() != wrong.size() || wrong.empty()) {
    refuse(Text::tr("this deviation is not of the cohort"), cohortId, Text::tr("Read the list again"));
  }
  reportDeviations(session, corrections);
}

std::vector<ProtocolDeviation> deviations(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kPersonViewCoded);
  return StudyRepository(session.connection()).deviations(cohortId);
}

}  // namespace torsio
