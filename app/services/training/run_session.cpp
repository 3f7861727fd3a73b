// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/run_session.h"

#include <algorithm>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/recording/recording_spec.h"
#include "app/services/study/cohort_service.h"
#include "app/services/training/trainee_record.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

/// Throws the first reason why this run may not begin.
void checkPermission(const NextSteps& steps, const RunRequest& request) {
  if (!steps.recordingAllowed) {
    throw Error(ErrorCode::kPermission, Text::tr("you have not agreed to be recorded"), Text::tr("consent"),
                Text::tr("Read and confirm the consent first, or use free practice, which is not recorded"));
  }
  refuseWhenClosed(steps.cohort);
  const Light light = request.device.light();
  if (light == Light::kRed) {
    throw Error(ErrorCode::kDevice, Text::tr("the device is not ready"), request.device.device,
                Text::tr("Repeat the device check, or practise with mouse and keyboard"));
  }
  if (request.graded && light != Light::kGreen) {
    throw Error(ErrorCode::kDevice, Text::tr("the device is good enough for practice only"),
                request.device.device, Text::tr("Practise, or put right what the device check shows"));
  }
  if (steps.allPhasesDone) {
    refuseParameter(Text::tr("all phases of your training are over"), steps.armLabel,
                    Text::tr("Ask an administrator what comes next"));
  }
  if (steps.scoringDue && request.reason.empty()) {
    refuseParameter(
        Text::tr("sheets of the occasion \"%3\" that are in: %1 of %2", steps.scoringDue->submitted,
                 steps.scoringDue->asked, steps.scoringDue->occasion.label),
        steps.traineeCode,
        Text::tr("Be scored on the real arm first, or say why the training begins nevertheless"));
  }
}

bool hasVirtualTime(const RunPlan& plan) {
  return plan.phases.empty() ||
         std::any_of(plan.phases.begin(), plan.phases.end(), [](const RunPhase& phase) {
           return phase.arm == PhaseKind::kVirtual && phase.done_us < phase.duration_us;
         });
}

ModuleStep chosenStep(const NextSteps& steps, const RunRequest& request) {
  checkPermission(steps, request);
  if (request.moduleId.empty() && !hasVirtualTime(steps.plan)) {
    return {};
  }
  const ModuleStep& step = stepOf(steps, request.moduleId);
  if (step.state == StepState::kLocked) {
    refuseParameter(Text::tr("this module is locked: first master %1", step.missing.front()),
                    step.module.title, Text::tr("Choose an open module"));
  }
  if (step.state == StepState::kUsedUp && request.graded) {
    refuseParameter(Text::tr("no attempt is left for this module"), step.module.title,
                    Text::tr("Ask an administrator for another attempt"));
  }
  return step;
}

RunPlan planOf(const NextSteps& steps, const ModuleStep& step) {
  if (!steps.plan.phases.empty()) {
    return steps.plan;
  }
  RunPlan plan;
  plan.phases.push_back({.label = step.module.title,
                         .arm = PhaseKind::kVirtual,
                         .duration_us = kModuleTime_us,
                         .moduleId = step.module.id});
  return plan;
}

}  // namespace

RunSession::RunSession(SessionContext& session, const RunRequest& request, const Clock& clock,
                       StationWriter* line)
    : session_(session),
      clock_(&clock),
      steps_((session.require(Operation::kTrialRecordOwn), nextSteps(session, session.actor().personId))),
      step_(chosenStep(steps_, request)),
      reason_(request.reason),
      graded_(request.graded),
      run_(planOf(steps_, step_), clock),
      line_(line),
      heartbeat_(session) {
  heartbeat_.showDevice(stationDevice(request.device, session.now_us()));
}

void RunSession::write(StationWriter::Write write) {
  if (line_ != nullptr) {
    line_->write(std::move(write));
  } else {
    write(session_);
  }
}

void RunSession::show(const TrialId& trialId) {
  if (line_ != nullptr) {
    line_->show(trialId);
  } else {
    heartbeat_.show(trialId);
  }
}

AttemptMode RunSession::mode() const noexcept {
  return graded_ ? AttemptMode::kGraded : AttemptMode::kPractice;
}

void RunSession::heartbeat() {
  if (line_ == nullptr) {
    heartbeat_.send();
  }
}

void RunSession::start() {
  run_.start();
  utcOffset_us_ = session_.now_us() - clock_->now_us();
  const nlohmann::json what{{"module", step_.module.id}, {"mode", storedText(mode())}};
  write([note = AuditNote{.action = AuditAction::kRunStart,
                          .objectKind = AuditObject::kEnrolment,
                          .objectId = steps_.enrolmentId,
                          .newJson = what.dump()}](SessionContext& own) { own.note(note); });
  if (steps_.scoringDue) {
    write([deviation = trainedBeforeScoring(session_, *steps_.scoringDue, steps_.cohortId, steps_.enrolmentId,
                                            reason_, steps_.demonstration)](SessionContext& own) {
      StudyRepository(own.connectionWithoutRight()).addDeviation(deviation);  // authorised when the run began
    });
  }
  heartbeat();
}

void RunSession::log(bool all) {
  for (const ExposurePiece& piece : run_.takeExposure(all)) {
    if (piece.duration_us <= 0) {
      continue;
    }
    write([exposure = NewExposure{.cohortId = steps_.cohortId,
                                  .enrolmentId = steps_.enrolmentId,
                                  .phaseId = piece.phaseId,
                                  .kind = piece.kind,
                                  .startedUtc_us = piece.begun_us + utcOffset_us_,
                                  .duration_us = piece.duration_us}](SessionContext& own) {
      recordExposure(own, exposure);
    });
  }
}

std::vector<RunEvent> RunSession::advance() {
  const RunState before = run_.state();
  std::vector<RunEvent> events = run_.advance();
  log(run_.state() != before || run_.over());
  if (run_.over()) {
    show("");
  }
  heartbeat();
  return events;
}

void RunSession::hold() {
  run_.hold();
  heartbeat();
}

const TrainingModule& RunSession::module() const {
  const RunPhase& phase = run_.phase();
  return phase.moduleId.empty() ? step_.module : stepOf(steps_, phase.moduleId).module;
}

bool RunSession::rest() {
  static_cast<void>(advance());
  if (!run_.rest()) {
    return false;
  }
  log(true);
  return true;
}

std::vector<RunEvent> RunSession::resume() {
  std::vector<RunEvent> events = advance();
  run_.resume();
  for (const RunEvent& event : run_.advance()) {
    events.push_back(event);
  }
  log(true);
  return events;
}

void RunSession::stop(const std::string& reason) {
  if (run_.over() || run_.state() == RunState::kReady) {
    return;
  }
  static_cast<void>(run_.advance());
  const bool early = !run_.over();
  run_.stop();
  log(true);
  const AuditNote note{.action = AuditAction::kRunStop,
                       .objectKind = AuditObject::kEnrolment,
                       .objectId = steps_.enrolmentId,
                       .reason = reason};
  if (early && !run_.phase().phaseId.empty()) {
    const ProtocolDeviation deviation{.id = session_.ids().newUuid(),
                                      .cohortId = steps_.cohortId,
                                      .enrolmentId = steps_.enrolmentId,
                                      .kind = "phase cut short",
                                      .description = reason,
                                      .happenedUtc_us = session_.now_us(),
                                      .reportedBy = session_.actor().userId,
                                      .reportedUtc_us = session_.now_us(),
                                      .demonstration = steps_.demonstration};
    // Authorised when the run began.
    write([deviation, note](SessionContext& own) {
      Transaction transaction(own.connectionWithoutRight());
      StudyRepository(own.connectionWithoutRight()).addDeviation(deviation);
      own.note(note);
      transaction.commit();
    });
  } else {
    write([note](SessionContext& own) { own.note(note); });
  }
  show("");
  heartbeat();
}

/// Returns the specification for recordings of the current phase.
RecordingSpec RunSession::orderTrial() {
  const RunPhase& phase = run_.phase();
  RecordingSpec recording{.trialId = session_.ids().newUuid(),
                          .traineeCode = steps_.traineeCode,
                          .phaseLabel = phase.label,
                          .startedUtc_us = session_.now_us(),
                          .demonstration = steps_.demonstration,
                          .context = {.station = session_.station(),
                                      .enrolmentId = steps_.enrolmentId,
                                      .phaseId = phase.phaseId,
                                      .host = thisHost()}};
  show(recording.trialId);
  return recording;
}

RecordingSpec RunSession::newTrial() {
  const TrainingModule& practised = module();
  RecordingSpec recording = orderTrial();
  recording.targetAngle_rad = practised.targetAngle_rad;
  recording.context.moduleId = practised.id;
  recording.context.attemptMode = mode();
  trials_.push_back(recording.trialId);
  return recording;
}

RecordingSpec RunSession::newTrackedTrial() {
  TORSIO_EXPECTS(run_.phase().arm == PhaseKind::kReal);
  return orderTrial();
}

std::vector<RecoveredTrial> recoverInterrupted(SessionContext& session, const std::filesystem::path& folder) {
  const TraineeRecord record = ownRecord(session, Operation::kTrialRecordOwn);
  std::vector<RecoveredTrial> own;
  for (const SettledTrial& settled : settleStation(session, folder).trials) {
    const TrialListing& trial = settled.trial;
    if (trial.traineeCode != record.code || trial.summary->outcome != TrialOutcome::kInterrupted) {
      continue;
    }
    own.push_back({.trialId = trial.trialId,
                   .moduleId = trial.moduleId,
                   .phaseLabel = trial.phaseLabel,
                   .startedUtc_us = trial.startedUtc_us,
                   .recorded_s = spanOf_s(trial.summary->samples),
                   .exposureAdded_s = static_cast<double>(settled.exposureAdded_us) * 1e-6});
  }
  return own;
}

void decideOwnConsent(SessionContext& session, const std::string& purpose, bool granted,
                      const std::string& textVersion) {
  const TraineeRecord record = ownRecord(session, Operation::kTrialRecordOwn);
  if (textVersion.empty()) {
    refuseParameter(Text::tr("it is not known which text was shown"), purpose,
                    Text::tr("Open the consent again"));
  }
  Transaction transaction(session.connection());
  PeopleRepository(session.connection())
      .recordConsent({.personId = record.personId,
                      .purpose = purpose,
                      .granted = granted,
                      .textVersion = textVersion,
                      .decidedUtc_us = session.now_us(),
                      .recordedBy = session.actor().userId,
                      .demonstration = record.demonstration});
  const nlohmann::json what{{"purpose", purpose}, {"granted", granted}, {"text", textVersion}};
  session.note(AuditAction::kConsentOwn, AuditObject::kPerson, record.personId, what);
  transaction.commit();
}

std::vector<ConsentDecision> ownConsents(SessionContext& session) {
  session.require(Operation::kTrialViewOwn);
  std::map<std::string, ConsentDecision> newest;
  for (ConsentDecision& one : PeopleRepository(session.connection()).consents(session.actor().personId)) {
    newest[one.purpose] = std::move(one);  // oldest first
  }
  std::vector<ConsentDecision> own;
  for (auto& [purpose, decision] : newest) {
    own.push_back(std::move(decision));
  }
  return own;
}

bool gradesWithMouse(SessionContext& session) {
  session.require(Operation::kPractice);
  return centreSetting<kGradedWithMouse>(session.connection());
}

bool soundsAtLimit(SessionContext& session) {
  session.require(Operation::kPractice);
  return centreSetting<kSoundAtLimit>(session.connection());
}

bool RunSession::firstEver() const noexcept {
  return std::none_of(steps_.modules.begin(), steps_.modules.end(),
                      [](const ModuleStep& step) { return step.last.has_value(); });
}

}  // namespace torsio
