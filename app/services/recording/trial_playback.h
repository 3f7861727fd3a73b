// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "assessment/attempt/measured_trial.h"
#include "assessment/domain/ids.h"
#include "sim/core/live_types.h"
#include "sim/record/trial.h"
#include "sim/servo/pose_track.h"
#include "sim/servo/replay_trial.h"

namespace torsio {

/// Plays a recorded trial, from any instant at any speed. Shows the recorded values; replayTrial (sim/servo)
/// proves that the device samples reproduce them.
///
/// Keeps the chunks encoded; only those near the playhead are decoded, so that forty minutes need tens of
/// megabytes instead of hundreds. One thread.
class TrialPlayback {
 public:
  /// Receives the samples of one chunk after another.
  using Reader = std::function<void(std::span<const Sample>)>;

  /// Decodes every chunk once, so that playing cannot fail, and passes its samples to `reader` (may be
  /// empty). Throws Error{kBadData} for a trial that cannot be decoded or has no samples.
  explicit TrialPlayback(Trial trial, const Reader& reader = {});

  [[nodiscard]] const TrialHeader& header() const noexcept { return header_; }
  /// Returns the recorded chunks, bit for bit.
  [[nodiscard]] const std::vector<TrialChunk>& chunks() const noexcept { return chunks_; }
  [[nodiscard]] std::int64_t duration_us() const noexcept { return duration_us_; }
  [[nodiscard]] std::int64_t position_us() const noexcept { return position_us_; }
  void seek_us(std::int64_t position_us) noexcept;

  [[nodiscard]] bool playing() const noexcept { return playing_; }
  /// At the end, playing starts again from the beginning.
  void setPlaying(bool playing) noexcept;
  [[nodiscard]] double speed() const noexcept { return speed_; }
  /// `speed` > 0; 1 is real time.
  void setSpeed(double speed);
  /// Moves on if playing; stops at the end.
  void advance(double elapsed_s) noexcept;

  /// Sets the shapes of a rod-like organ, which a recording does not contain.
  void setPoses(PoseTrack poses) { poses_ = std::move(poses); }

  /// Returns the state at this instant. Finds the chunk by binary search and decodes it unless cached:
  /// recordings of hours are as fast as short ones (about a millisecond).
  [[nodiscard]] LiveState state() const;

 private:
  /// Time range of a chunk, and the target before its first sample.
  struct Place {
    std::int64_t begin_us = 0;
    double target_rad = 0.0;
  };
  struct Decoded {
    std::size_t chunk = 0;
    std::vector<Sample> samples;
  };
  [[nodiscard]] const Decoded& decoded(std::size_t chunk) const;

  TrialHeader header_;
  std::vector<TrialChunk> chunks_;
  std::vector<Place> places_;  // one per chunk
  PoseTrack poses_;
  std::int64_t duration_us_ = 0;
  std::int64_t position_us_ = 0;
  double speed_ = 1.0;
  bool playing_ = false;
  mutable std::vector<Decoded> near_;  // latest last
};

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
