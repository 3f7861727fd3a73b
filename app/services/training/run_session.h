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
  /// Why training continues although sheets of the real arm are missing (NextSteps::scoringDue).
  std::string reason{};
};

/// A trainee's run at a station, from the permission to the last logged second: the clock (TrainingRun), the
/// context of each recording, and the training time, which is logged in pieces so that a power cut loses
/// little. Permission is checked only at the start; with a `line`, the run never waits for the database. GUI
/// thread.
class RunSession {
 public:
  /// Checks all conditions. kTrialRecordOwn. Throws Error: {kPermission} without consent to the training
  /// record, {kDevice} if the device is not green for a graded run (or red for any run), {kBadParameter} if
  /// the module is locked, used up or unknown, all phases are over, or due sheets are missing and no reason
  /// is given (a reason is recorded as a deviation when the run starts). `line`: writes the run's data and
  /// sends heartbeats; outlives the session. Null: the session writes directly.
  RunSession(SessionContext& session, const RunRequest& request, const Clock& clock,
             StationWriter* line = nullptr);

  [[nodiscard]] const TrainingRun& run() const noexcept { return run_; }
  [[nodiscard]] const ModuleStep& step() const noexcept { return step_; }
  [[nodiscard]] bool graded() const noexcept { return graded_; }
  /// Returns whether this is the trainee's first attempt at any module.
  [[nodiscard]] bool firstEver() const noexcept;
  /// Returns the module of the current phase.
  [[nodiscard]] const TrainingModule& module() const;

  void start();
  /// Advances the clock, logs training time and sends the station's heartbeat. Call it often.
  std::vector<RunEvent> advance();
  /// Call instead of advance() while the machine is not ready: the trainee's clock stops.
  void hold();
  [[nodiscard]] bool rest();
  std::vector<RunEvent> resume();
  /// Stops early; `reason` is recorded as a deviation if a phase was cut short.
  void stop(const std::string& reason);

  /// Starts a new recording of the current phase, stored by recordingSink(). Virtual phases only.
  [[nodiscard]] RecordingSpec newTrial();
  /// Starts a tracker's recording of the current phase on the real arm, which is not an attempt at a module.
  /// Real phases only.
  [[nodiscard]] RecordingSpec newTrackedTrial();
  /// Returns the ids of the simulator's recordings so far.
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
  std::string reason_;  // why training continues while sheets are missing
  bool graded_;
  TrainingRun run_;
  std::int64_t utcOffset_us_ = 0;  // wall clock minus run clock at the start
  std::vector<TrialId> trials_;
  StationWriter* line_;
  StationHeartbeat heartbeat_;  // used only without a line
};

/// An interrupted run found at program start.
struct RecoveredTrial {
  TrialId trialId{};
  ModuleId moduleId{};
  std::string phaseLabel{};
  std::int64_t startedUtc_us = 0;
  double recorded_s = 0.0;
  double exposureAdded_s = 0.0;  ///< training time that was not logged yet
};
/// Cleans up this station's recordings (settleStation()). Returns the actor's interrupted ones.
/// kTrialRecordOwn.
std::vector<RecoveredTrial> recoverInterrupted(SessionContext& session,
                                               const std::filesystem::path& folder = unstoredFolder());

/// Stores the actor's decision about a purpose of consent. kTrialRecordOwn. Throws Error{kBadParameter}.
void decideOwnConsent(SessionContext& session, const std::string& purpose, bool granted,
                      const std::string& textVersion);
/// Returns the actor's latest decision for each purpose, if any. kTrialViewOwn.
[[nodiscard]] std::vector<ConsentDecision> ownConsents(SessionContext& session);

/// Returns whether the centre grades runs with mouse and keyboard (setting "graded_with_mouse": "yes").
[[nodiscard]] bool gradesWithMouse(SessionContext& session);
/// Returns whether a sound is played at a limit in addition to the text (setting "sound_at_limit": "yes").
[[nodiscard]] bool soundsAtLimit(SessionContext& session);

}  // namespace torsio
