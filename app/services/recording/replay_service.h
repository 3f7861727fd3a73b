// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "assessment/attempt/measured_trial.h"
#include "assessment/domain/ids.h"
#include "sim/servo/replay_trial.h"

namespace torsio {

/// The stored trial whose id is `trialId` or, alone of all, begins with it. The database is opened read-only.
/// Throws Error: no such trial, several such trials, or what the database refuses.
[[nodiscard]] Trial loadStoredTrial(const std::string& database, const TrialId& trialId);

/// A stored trial with the rules of its exercise.
struct LoadedRun {
  Trial trial;
  AttemptRules rules;
};
/// Loads a trial as loadStoredTrial does, and finds by what it is judged. `assets`: where patterns are read;
/// empty: assetsFolder(). Throws the same.
[[nodiscard]] LoadedRun loadStoredRun(const std::string& database, const TrialId& trialId,
                                      const std::filesystem::path& assets = {});

struct ReplayRequest {
  std::string database;  ///< file or postgresql:// locator, opened read-only
  TrialId trialId;       ///< or its first characters, when no other trial begins so
  std::filesystem::path assets;
  std::optional<std::filesystem::path> organFile;  ///< when the trial was recorded on a user's mesh
  double organScale_m = 0.001;
};

/// A trial that was run again.
struct ReplayResult {
  TrialHeader header;
  TrialSummary summary;
  ReplayReport report;
};

/// Loads a stored trial, rebuilds its scene, runs it again from its device samples and compares every tick.
/// Throws Error: no such trial, damaged chunks, or an organ or parameters that are not those of the
/// recording.
[[nodiscard]] ReplayResult replayStoredTrial(const ReplayRequest& request);

}  // namespace torsio
