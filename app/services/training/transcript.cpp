// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/transcript.h"

#include "app/services/base/build_info.h"
#include "app/services/training/trend.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

void addTimes(SessionContext& session, const NextSteps& steps, Transcript& transcript) {
  if (steps.cohortId.empty()) {
    return;
  }
  for (const Exposure& exposure : StudyRepository(session.connection()).exposures(steps.cohortId)) {
    if (exposure.enrolmentId != steps.enrolmentId) {
      continue;
    }
    const double minutes = static_cast<double>(exposure.duration_us) / kMinute_us;
    if (exposure.kind == ExposureKind::kVirtual) {
      transcript.virtual_min += minutes;
    }
    if (exposure.kind == ExposureKind::kReal) {
      transcript.real_min += minutes;
    }
    if (exposure.kind == ExposureKind::kRest) {
      transcript.rest_min += minutes;
    }
  }
}

}  // namespace

Transcript transcript(SessionContext& session, const PersonId& personId) {
  const NextSteps steps = nextSteps(session, personId);
  Transcript transcript;
  if (const auto centre = StudyRepository(session.connection()).centre()) {
    transcript.centre = centre->name;
  }
  if (const auto identity = PeopleRepository(session.connection()).identity(personId)) {
    transcript.fullName = identity->fullName;
  }
  transcript.traineeCode = steps.traineeCode;
  transcript.cohortName = steps.cohortName;
  transcript.armLabel = steps.armLabel;
  transcript.demonstration = steps.demonstration;
  transcript.madeUtc_us = session.now_us();
  transcript.softwareVersion = softwareVersion();
  for (const ModuleStep& step : steps.modules) {
    TranscriptModule module;
    module.step = step;
    module.attempts = attemptsOf(session, personId, step.module.id);
    module.competence = trend(session, personId, step.module.id).competence;
    transcript.modules.push_back(std::move(module));
  }
  transcript.realArm = realArmRuns(session, personId);
  addTimes(session, steps, transcript);
  session.note(AuditAction::kTranscriptMake, AuditObject::kPerson, personId);
  return transcript;
}

}  // namespace torsio
