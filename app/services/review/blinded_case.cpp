// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/blinded_case.h"

#include "app/services/recording/kept_digests.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "db/connection/connection.h"
#include "db/repository/rating/desk_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/record/content_hash.h"
#include "sim/record/trial.h"

namespace torsio {

namespace {

constexpr std::size_t kDigestDigits = 8;

BlindedTask taskOf(Connection& connection, const TrialId& trialId, const TrialHeader& header) {
  const std::optional<TrialContext> context = TrialRepository(connection).context(trialId);
  const AttemptRules rules = ExerciseRules().of(connection, header.sceneId, header.patternId,
                                                context ? context->moduleId : ModuleId());
  return {header.targetAngle_rad, recordedRules(rules, header)};
}

std::string placeOf(const std::string& label) {
  return "case " + label;
}

}  // namespace

TrialHeader blinded(const TrialHeader& header, const std::string& label) {
  TrialHeader copy = header;
  copy.trialId = placeOf(label);
  copy.traineeCode.clear();
  copy.phaseLabel.clear();
  copy.softwareVersion.clear();
  copy.startedUtc_us = 0;
  copy.model = TissueModel::kTwist;  // the scene is rebuilt from the parameters, which raters never see
  return copy;
}

std::string blindedDigest(const std::string& contentHash, const std::string& salt) {
  Digest digest;
  digest.update(contentHash);
  digest.update(salt);
  return digest.hex().substr(0, kDigestDigits);
}

std::optional<std::int64_t> blindedDue(const std::vector<QueueEntry>& queue) {
  BlindedDue due;
  for (const QueueEntry& entry : queue) {
    if (!entry.trialId.empty()) {
      due.add(entry.dueUtc_us);
    }
  }
  return due.latest();
}

Assignment ownAssignment(SessionContext& session, Operation operation, const AssignmentId& assignmentId) {
  session.require(operation);
  DeskRepository desk(session.connection());
  const std::optional<Assignment> found = desk.assignment(assignmentId);
  const std::string& person = session.actor().personId;
  if (!found || person.empty() || found->raterId != person) {
    throw Error(ErrorCode::kPermission, Text::tr("this case is not yours"), Text::tr("the queue"),
                Text::tr("Open a case from your own queue"));
  }
  if (desk.isWithdrawn(assignmentId)) {
    throw Error(ErrorCode::kPermission, Text::tr("this case was taken back"), placeOf(found->caseLabel),
                Text::tr("Continue with the next case in the queue"));
  }
  return *found;
}

BlindedCase blindedCase(SessionContext& session, const AssignmentId& assignmentId) {
  const Assignment found = ownAssignment(session, Operation::kMarkSubmit, assignmentId);
  BlindedCase shown{.assignmentId = assignmentId,
                    .label = found.caseLabel,
                    .live = found.trialId.empty(),
                    .dueUtc_us = found.dueUtc_us};
  if (!shown.live) {
    shown.dueUtc_us = blindedDue(SheetRepository(session.connection()).queue(found.raterId));
    shown.length_us = DeskRepository(session.connection()).trialLength_us(found.trialId);
  }
  return shown;
}

namespace {

Assignment ownRecordedCase(SessionContext& session, const AssignmentId& assignmentId) {
  Assignment found = ownAssignment(session, Operation::kTrialViewAssigned, assignmentId);
  if (found.trialId.empty()) {
    refuse(Text::tr("this case is scored live and has no recording"), placeOf(found.caseLabel),
           Text::tr("Use the live sheet"));
  }
  return found;
}

}  // namespace

BlindedTask blindedTask(SessionContext& session, const AssignmentId& assignmentId) {
  const Assignment found = ownRecordedCase(session, assignmentId);
  const std::optional<TrialHeader> header = TrialRepository(session.connection()).find(found.trialId);
  if (!header) {
    refuse(Text::tr("the recording cannot be opened"), placeOf(found.caseLabel),
           Text::tr("Try again, or tell an administrator"));
  }
  return taskOf(session.connection(), found.trialId, *header);
}

RecordingName recordingName(SessionContext& session, const AssignmentId& assignmentId) {
  const Assignment found = ownRecordedCase(session, assignmentId);
  const std::string hash =
      DeskRepository(session.connection()).contentHash(found.trialId).value_or(std::string());
  Digest key;
  key.update(std::string_view(found.trialId.text()));
  key.update(hash);
  return {key.hex(), blindedDigest(hash, assignmentId)};
}

BlindedRecording loadBlindedRecording(SessionContext& session, const AssignmentId& assignmentId) {
  const Assignment found = ownRecordedCase(session, assignmentId);
  return blindedRecordingOf(session.connection(), found.trialId, found.caseLabel, assignmentId);
}

BlindedRecording blindedRecordingOf(Connection& connection, const TrialId& trialId, const std::string& label,
                                    const std::string& salt) {
  try {
    Trial trial = TrialRepository(connection).load(trialId);
    verifyContent(trial);
    BlindedRecording recording;
    recording.label = label;
    recording.digest = blindedDigest(trial.summary.contentHash, salt);
    const std::uint64_t seed = detorsionSeed(trial.header.trialId);  // an organ that starts twisted depends
                                                                     // on it
    recording.task = taskOf(connection, trialId, trial.header);
    trial.header = blinded(trial.header, label);
    trial.header.seed = seed;
    trial.summary.contentHash.clear();  // would identify the trial
    recording.trial = std::move(trial);
    return recording;
  } catch (...) {
    rethrowBlinded(std::current_exception(), label);
  }
}

SceneRequest sceneOf(const BlindedRecording& recording, const std::filesystem::path& assets) {
  try {
    SceneRequest request = sceneRequestFor(recording.trial.header.parametersJson);
    request.assets = assets;
    request.id = recording.trial.header.sceneId;
    request.pattern = recording.trial.header.patternId;
    return request;
  } catch (...) {
    rethrowBlinded(std::current_exception(), recording.label);
  }
}

void checkScene(const BlindedRecording& recording, const Scene& scene) {
  const TrialHeader& header = recording.trial.header;
  if (scene.organHash == header.organHash && scene.parameterHash == header.parameterHash) {
    return;
  }
  throw Error(ErrorCode::kVerifyFailed, Text::tr("the organ here is not the one of the recording"),
              placeOf(recording.label),
              Text::tr("Score from the traces, or ask an administrator for the organ file"));
}

void rethrowBlinded(const std::exception_ptr& problem, const std::string& label) {
  try {
    std::rethrow_exception(problem);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::kPermission) {
      throw;
    }
    // The original text may contain an id: keep only the kind of error.
    const bool changed = error.code() == ErrorCode::kVerifyFailed;
    throw Error(error.code(),
                changed ? Text::tr("the recording is not what was recorded")
                        : Text::tr("the recording cannot be opened"),
                placeOf(label),
                changed ? Text::tr("Do not score it; tell an administrator")
                        : Text::tr("Try again, or tell an administrator"));
  }
}

}  // namespace torsio
