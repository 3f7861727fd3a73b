// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "assessment/attempt/measured_trial.h"
#include "assessment/domain/ids.h"
#include "sim/servo/replay_trial.h"

namespace torsio {

/// Loads the stored trial whose id is `trialId` or uniquely begins with it. Opens the database read-only.
/// Throws Error for no or several matching trials, and errors of the database.
[[nodiscard]] Trial loadStoredTrial(const std::string& database, const TrialId& trialId);

/// A stored trial with its exercise's rules.
struct LoadedRun {
  Trial trial;
  AttemptRules rules;
};
/// Loads a trial like loadStoredTrial(), with the rules for judging it. `assets`: folder with the patterns;
/// empty: assetsFolder(). Throws the same.
[[nodiscard]] LoadedRun loadStoredRun(const std::string& database, const TrialId& trialId,
                                      const std::filesystem::path& assets = {});

struct ReplayRequest {
  std::string database;  ///< file or postgresql:// locator, opened read-only
  TrialId trialId;       ///< or a unique prefix
  std::filesystem::path assets;
  std::optional<std::filesystem::path> organFile;  ///< if the trial was recorded on a user's mesh
  double organScale_m = 0.001;
};

/// Result of replaying a trial.
struct ReplayResult {
  TrialHeader header;
  TrialSummary summary;
  ReplayReport report;
};

/// Loads a stored trial, rebuilds its scene, replays its device samples and compares every tick. Throws
/// Error: no such trial, damaged chunks, or an organ or parameters different from the recording's.
[[nodiscard]] ReplayResult replayStoredTrial(const ReplayRequest& request);

}  // namespace torsio
