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

/// Everything that a rater may know about a case: the only de-identification layer. Pages, titles, file
/// names, exports, logs and errors of the physician's desk are built from it and never from a trial, an
/// enrolment or a person. Contains no name, pseudonym, group, stage, date or trial id.
struct BlindedCase {
  AssignmentId assignmentId{};  ///< argument of services; never shown
  std::string label{};          ///< "7F"
  bool live = false;            ///< on the real arm: nothing to replay
  /// For a recorded case, the same for all of the rater's cases: blindedDue().
  std::optional<std::int64_t> dueUtc_us{};
  std::optional<std::int64_t> length_us{};  ///< of the recording
  friend bool operator==(const BlindedCase&, const BlindedCase&) = default;
};

/// The exercise of a recording, for judging accuracy. The same for everybody who does the exercise: no title,
/// mode, stage or personal data.
struct BlindedTask {
  double target_rad = 0.0;  ///< at the beginning of the recording; 0 for an untwisting
  AttemptRules rules{};     ///< tolerance, hold, number of twists, limits
  [[nodiscard]] bool untwisting() const noexcept { return rules.detorsion.has_value(); }
};

/// An anonymous recording. `trial` decodes and plays like the original, sample by sample, but its header is
/// blinded().
struct BlindedRecording {
  std::string label{};
  Trial trial{};
  /// Eight hexadecimal digits for comparison with the centre's list: BLAKE2b of content hash and salt.
  /// Differs between raters and cases, so that they cannot be linked.
  std::string digest{};
  BlindedTask task{};
};

/// Returns `header` without trial id, trainee, phase, date, program version and model; keeps what a replay
/// needs.
[[nodiscard]] TrialHeader blinded(const TrialHeader& header, const std::string& label);
/// Returns the common deadline shown for all recorded cases of a rater's queue (BlindedDue).
[[nodiscard]] std::optional<std::int64_t> blindedDue(const std::vector<QueueEntry>& queue);
/// Returns BlindedRecording::digest.
[[nodiscard]] std::string blindedDigest(const std::string& contentHash, const std::string& salt);

/// Returns the assignment of a case; for services only. Throws Error{kPermission} if the actor lacks the
/// right, the case is another rater's or does not exist (indistinguishable), or it was withdrawn.
[[nodiscard]] Assignment ownAssignment(SessionContext& session, Operation operation,
                                       const AssignmentId& assignmentId);
/// kMarkSubmit, the actor's case.
[[nodiscard]] BlindedCase blindedCase(SessionContext& session, const AssignmentId& assignmentId);

/// kTrialViewAssigned, the actor's case. Throws like loadBlindedRecording(), without reading the recording.
[[nodiscard]] BlindedTask blindedTask(SessionContext& session, const AssignmentId& assignmentId);

/// Identifiers of the recording of the actor's case.
struct RecordingName {
  std::string key{};     ///< the same for everybody who may see it, for a server's cache; never shown
  std::string digest{};  ///< see BlindedRecording::digest
};
/// kTrialViewAssigned, the actor's case. Throws like loadBlindedRecording(), without reading the recording.
[[nodiscard]] RecordingName recordingName(SessionContext& session, const AssignmentId& assignmentId);

/// Loads the recording of the actor's case and verifies its content hash. kTrialViewAssigned, and only while
/// the case is assigned. Throws Error{kPermission}, {kBadData} for a live case; {kVerifyFailed} if the
/// recording was changed. Errors never identify the trial.
[[nodiscard]] BlindedRecording loadBlindedRecording(SessionContext& session,
                                                    const AssignmentId& assignmentId);

/// Returns recording `trialId` under `label`, verified like loadBlindedRecording(); for services that have
/// checked access.
[[nodiscard]] BlindedRecording blindedRecordingOf(Connection& connection, const TrialId& trialId,
                                                  const std::string& label, const std::string& salt);

/// Returns what rebuilds a recording's scene: organ, pattern and model parameters. Throws Error{kBadData}.
[[nodiscard]] SceneRequest sceneOf(const BlindedRecording& recording, const std::filesystem::path& assets);
/// Throws Error{kVerifyFailed} if `scene` is not the recording's.
void checkScene(const BlindedRecording& recording, const Scene& scene);

/// Rethrows `problem` as an Error that identifies only the case; permission errors and broken contracts pass
/// unchanged.
[[noreturn]] void rethrowBlinded(const std::exception_ptr& problem, const std::string& label);

}  // namespace torsio
