// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/devices/device_readiness.h"
#include "app/services/recording/recording_spec.h"
#include "app/services/recording/station_heartbeat.h"
#include "app/services/recording/station_start.h"
#include "app/services/recording/station_writer.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/training_run.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/consent.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/domain/study/protocol_terms.h"
#include "sim/record/trial.h"

namespace torsio {

struct RunRequest {
  ModuleId moduleId{};
  bool graded = false;
  DeviceReadiness device{};
  /// Why training goes on although sheets of the real arm are missing (NextSteps::scoringDue).
  std::string reason{};
};

/// One run of a trainee at a station, from the permission to begin to the last logged second: the clock
/// (TrainingRun), what each recording belongs to, and the exposure, which goes to the database piece by piece
/// so that a power cut takes little of it. Who may begin may go on: once it runs, the permission is not asked
/// again, and with a `line` nothing waits for the database. GUI thread.
class RunSession {
 public:
  /// Checks everything that must be in order. kTrialRecordOwn. Throws Error: {kPermission} without consent
  /// for the training record, {kDevice} when a graded run meets a device that is not green (or any run a red
  /// one), {kBadParameter} when the module is locked, used up or unknown, all phases are over, or sheets that
  /// should be in are missing and no reason is given (with one it becomes a deviation when the run starts).
  /// `line`: writes what comes up in the course of the run, and sends the heartbeats; it outlives the
  /// session. Null: the session writes at once.
  RunSession(SessionContext& session, const RunRequest& request, const Clock& clock,
             StationWriter* line = nullptr);

  [[nodiscard]] const TrainingRun& run() const noexcept { return run_; }
  [[nodiscard]] const ModuleStep& step() const noexcept { return step_; }
  [[nodiscard]] bool graded() const noexcept { return graded_; }
  /// Whether the trainee has not tried any module before.
  [[nodiscard]] bool firstEver() const noexcept;
  /// What is practised in the present phase.
  [[nodiscard]] const TrainingModule& module() const;

  void start();
  /// Moves the clock, logs exposure and sends the station's heartbeat. Call it often.
  std::vector<RunEvent> advance();
  /// In place of advance() while the machine is not ready: the trainee's time stands still.
  void hold();
  [[nodiscard]] bool rest();
  std::vector<RunEvent> resume();
  /// Given up; `reason` goes to the study's deviations when a phase was cut short.
  void stop(const std::string& reason);

  /// Orders a new recording for the present phase, kept where recordingSink says. Virtual phases only.
  [[nodiscard]] RecordingSpec newTrial();
  /// Orders a recording of what a tracker sees of the present phase on the real arm. It is no attempt at a
  /// module. Real phases only.
  [[nodiscard]] RecordingSpec newTrackedTrial();
  /// Ids of the recordings of the simulator so far.
  [[nodiscard]] const std::vector<TrialId>& trials() const noexcept { return trials_; }

 private:
  void log(bool all);
  void write(StationWriter::Write write);
  void show(const TrialId& trialId);
  [[nodiscard]] RecordingSpec orderTrial();
  [[nodiscard]] AttemptMode mode() const noexcept;
  void heartbeat();

  SessionContext& session_;
  const Clock* clock_;
  NextSteps steps_;
  ModuleStep step_;
  std::string reason_;  // why training goes on while sheets are missing
  bool graded_;
  TrainingRun run_;
  std::int64_t utcOffset_us_ = 0;  // wall clock minus run clock at the start
  std::vector<TrialId> trials_;
  StationWriter* line_;
  StationHeartbeat heartbeat_;  // unless there is a line
};

/// An interrupted run that was found at the start of the program.
struct RecoveredTrial {
  TrialId trialId{};
  ModuleId moduleId{};
  std::string phaseLabel{};
  std::int64_t startedUtc_us = 0;
  double recorded_s = 0.0;
  double exposureAdded_s = 0.0;  ///< training time of the recording that had not been logged yet
};
/// Puts the recordings of this station in order (settleStation). Returns those of the actor that were cut
/// off. kTrialRecordOwn.
std::vector<RecoveredTrial> recoverInterrupted(SessionContext& session,
                                               const std::filesystem::path& folder = unstoredFolder());

/// The actor's own decision about a purpose of consent. kTrialRecordOwn. Throws Error{kBadParameter}.
void decideOwnConsent(SessionContext& session, const std::string& purpose, bool granted,
                      const std::string& textVersion);
/// The actor's newest decision about each purpose that they decided about. kTrialViewOwn.
[[nodiscard]] std::vector<ConsentDecision> ownConsents(SessionContext& session);

/// Whether the centre grades runs with mouse and keyboard (setting "graded_with_mouse": "yes").
[[nodiscard]] bool gradesWithMouse(SessionContext& session);
/// Whether a sound tells that a limit is reached (setting "sound_at_limit": "yes"); else the sentence alone.
[[nodiscard]] bool soundsAtLimit(SessionContext& session);

}  // namespace torsio
