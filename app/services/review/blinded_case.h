// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/attempt/measured_trial.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"

namespace torsio {

class Connection;

/// Everything that a rater may know about what is judged: the one de-identification layer. Pages, titles,
/// file names, exports, logs and error texts of the physician's desk are made from it and never from a trial,
/// an enrolment or a person. There is no name, no pseudonym, no group, no stage, no date and no id of a trial
/// in it.
struct BlindedCase {
  AssignmentId assignmentId{};  ///< handle for the services; never shown
  std::string label{};          ///< "7F"
  bool live = false;            ///< on the real arm: nothing to replay
  /// Of a recorded case the same for all of the rater's: blindedDue().
  std::optional<std::int64_t> dueUtc_us{};
  std::optional<std::int64_t> length_us{};  ///< of the recording
  friend bool operator==(const BlindedCase&, const BlindedCase&) = default;
};

/// What the exercise of a recording asks for, so that accuracy can be judged. It is the same for everybody
/// who does the exercise: no title, no mode, no stage, nothing of a person.
struct BlindedTask {
  double target_rad = 0.0;  ///< at the beginning of the recording; 0 of an untwisting
  AttemptRules rules{};     ///< tolerance, hold, number of twists, limits
  [[nodiscard]] bool untwisting() const noexcept { return rules.detorsion.has_value(); }
};

/// A recording without whose it is. `trial` decodes and plays like the original, sample by sample, but its
/// header is blinded().
struct BlindedRecording {
  std::string label{};
  Trial trial{};
  /// Eight hexadecimal digits to compare with the centre's list: BLAKE2b of content hash and salt. Another
  /// one for each rater and case, so that it links nothing.
  std::string digest{};
  BlindedTask task{};
};

/// `header` without trial id, trainee, phase, date, program version and model; what a replay needs stays.
[[nodiscard]] TrialHeader blinded(const TrialHeader& header, const std::string& label);
/// The deadline that is told for each recorded case of a rater's whole queue (BlindedDue).
[[nodiscard]] std::optional<std::int64_t> blindedDue(const std::vector<QueueEntry>& queue);
/// The digits of BlindedRecording::digest.
[[nodiscard]] std::string blindedDigest(const std::string& contentHash, const std::string& salt);

/// The assignment behind a case, for services only. Throws Error{kPermission}: the actor may not, or it is
/// another rater's or nobody's (which of the two is not told), or it was withdrawn.
[[nodiscard]] Assignment ownAssignment(SessionContext& session, Operation operation,
                                       const AssignmentId& assignmentId);
/// kMarkSubmit, own case.
[[nodiscard]] BlindedCase blindedCase(SessionContext& session, const AssignmentId& assignmentId);

/// kTrialViewAssigned, own case. Throws as loadBlindedRecording, without reading the recording.
[[nodiscard]] BlindedTask blindedTask(SessionContext& session, const AssignmentId& assignmentId);

/// What a recording of an own case is called.
struct RecordingName {
  std::string key{};     ///< the same for whoever may see it, for what a server keeps of it; never told
  std::string digest{};  ///< as BlindedRecording::digest
};
/// kTrialViewAssigned, own case. Throws as loadBlindedRecording, without reading the recording.
[[nodiscard]] RecordingName recordingName(SessionContext& session, const AssignmentId& assignmentId);

/// Loads the recording of an own case and checks it against its content hash, so that what is played is what
/// was recorded, bit for bit. kTrialViewAssigned, and only while the case is assigned. Throws
/// Error{kPermission}, {kBadData}: a live case; {kVerifyFailed}: the recording was changed. No text names the
/// trial.
[[nodiscard]] BlindedRecording loadBlindedRecording(SessionContext& session,
                                                    const AssignmentId& assignmentId);

/// The recording `trialId` under `label`, checked as above: for services that have decided who may see it.
[[nodiscard]] BlindedRecording blindedRecordingOf(Connection& connection, const TrialId& trialId,
                                                  const std::string& label, const std::string& salt);

/// What rebuilds the scene of a recording: organ, pattern and model parameters. Throws Error{kBadData}.
[[nodiscard]] SceneRequest sceneOf(const BlindedRecording& recording, const std::filesystem::path& assets);
/// Throws Error{kVerifyFailed} when `scene` is not the one of the recording.
void checkScene(const BlindedRecording& recording, const Scene& scene);

/// Rethrows `problem` as an Error whose place is the case and nothing else; permission errors and broken
/// contracts pass unchanged.
[[noreturn]] void rethrowBlinded(const std::exception_ptr& problem, const std::string& label);

}  // namespace torsio
