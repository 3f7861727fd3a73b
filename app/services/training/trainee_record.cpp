// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/trainee_record.h"

#include <algorithm>
#include <cmath>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/remark_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

bool takesNew(const Cohort& cohort) {
  return cohort.state == CohortState::kDraft || cohort.state == CohortState::kRunning;
}

/// Prefers an open cohort to a closed one, one with a curriculum to one without, and then the latest.
void findEnrolment(Connection& connection, TraineeRecord& record) {
  StudyRepository studies(connection);
  for (const Cohort& cohort : studies.cohorts()) {
    const bool open = takesNew(cohort) || !takesNew(record.cohort);
    if (record.enrolment && (!open || (!record.cohort.curriculumVersionId.empty() &&
                                       cohort.curriculumVersionId.empty() && takesNew(record.cohort)))) {
      continue;
    }
    for (const Enrolment& enrolment : studies.enrolments(cohort.id)) {
      if (enrolment.traineeId != record.personId || enrolment.state != EnrolmentState::kEnrolled) {
        continue;
      }
      record.enrolment = enrolment;
      record.cohort = cohort;
    }
  }
}

void findCurriculum(Connection& connection, TraineeRecord& record) {
  if (!record.enrolment || record.cohort.curriculumVersionId.empty()) {
    return;
  }
  record.version = CurriculumRepository(connection).version(record.cohort.curriculumVersionId);
  if (record.version && record.version->state == CurriculumState::kDraft) {
    record.version.reset();
  }
  if (!record.version) {
    return;
  }
  for (const StudyGroup& group : StudyRepository(connection).groups(record.cohort.id)) {
    if (group.id != record.enrolment->groupId) {
      continue;
    }
    for (const StudyArm& arm : record.version->arms) {
      if (arm.id == group.armId) {
        record.arm = arm;
      }
    }
  }
}

}  // namespace

const TrainingModule* TraineeRecord::module(const ModuleId& moduleId) const {
  if (!version) {
    return nullptr;
  }
  const auto found = std::find_if(version->modules.begin(), version->modules.end(),
                                  [&](const TrainingModule& m) { return m.id == moduleId; });
  return found == version->modules.end() ? nullptr : &*found;
}

TraineeRecord ownRecord(SessionContext& session, Operation operation) {
  const PersonId& personId = session.actor().personId;
  session.requireOwn(operation, personId);
  for (const Trainee& trainee : PeopleRepository(session.connection()).trainees()) {
    if (trainee.person.id != personId) {
      continue;
    }
    TraineeRecord record;
    record.personId = personId;
    record.code = trainee.person.code;
    record.demonstration = trainee.person.demonstration;
    findEnrolment(session.connection(), record);
    findCurriculum(session.connection(), record);
    return record;
  }
  throw Error(ErrorCode::kPermission, Text::tr("you are not enrolled as a trainee"), session.actor().login,
              Text::tr("Ask an administrator to add you to the roster"));
}

TrialListing ownTrial(SessionContext& session, const TraineeRecord& record, const TrialId& trialId) {
  TrialRepository trials(session.connection());
  TrialFilter filter;
  filter.traineeCode = record.code;
  filter.limit = kAllTrials;
  for (TrialListing& listing : trials.list(filter)) {
    if (listing.trialId == trialId) {
      return std::move(listing);
    }
  }
  if (trials.find(trialId)) {
    throw Error(ErrorCode::kPermission, Text::tr("this recording belongs to somebody else"), trialId,
                Text::tr("Open your own record"));
  }
  refuseParameter(Text::tr("there is no such recording"), trialId, Text::tr("Choose one from the list"));
}

RemarkId keepBookmark(SessionContext& session, const TrialListing& trial, double at_s,
                      const std::string& text) {
  const double length_s = trial.summary ? spanOf_s(trial.summary->samples) : 0.0;
  if (!std::isfinite(at_s) || at_s < 0.0 || at_s > length_s) {
    refuseParameter(Text::tr("the moment is outside the recording"), trial.trialId,
                    Text::tr("Choose a time within it"));
  }
  const RemarkId id = session.ids().newUuid();
  RemarkRepository(session.connection())
      .add({.id = id,
            .trialId = trial.trialId,
            .author = session.actor().userId,
            .authorPersonId = session.actor().personId,
            .purpose = "bookmark",
            .tick = std::llround(at_s * 1e3),
            .time_us = std::llround(at_s * 1e6),
            .text = text,
            .createdUtc_us = session.now_us(),
            .demonstration = trial.demonstration});
  return id;
}

}  // namespace torsio
