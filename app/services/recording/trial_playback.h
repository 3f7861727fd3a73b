// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "sim/core/live_types.h"
#include "sim/record/trial.h"
#include "sim/servo/pose_track.h"

namespace torsio {

/// A recorded trial to be looked at: any instant, any speed. It shows the answers as they were recorded;
/// that the same device samples give them again bit for bit is replayTrial's business (sim/servo).
///
/// The chunks stay as they were recorded; only those round the playhead lie decoded, so that forty minutes
/// take tens of megabytes and not hundreds. One thread.
class TrialPlayback {
 public:
  /// The samples of one chunk after the other.
  using Reader = std::function<void(std::span<const Sample>)>;

  /// Decodes every chunk once, so that nothing can fail while it plays, and shows its samples to `reader`
  /// (may be empty). Throws Error{kBadData} for a trial that cannot be decoded or holds no sample.
  explicit TrialPlayback(Trial trial, const Reader& reader = {});

  [[nodiscard]] const TrialHeader& header() const noexcept { return header_; }
  /// What is played, bit for bit as it was recorded.
  [[nodiscard]] const std::vector<TrialChunk>& chunks() const noexcept { return chunks_; }
  [[nodiscard]] std::int64_t duration_us() const noexcept { return duration_us_; }
  [[nodiscard]] std::int64_t position_us() const noexcept { return position_us_; }
  void seek_us(std::int64_t position_us) noexcept;

  [[nodiscard]] bool playing() const noexcept { return playing_; }
  /// From the end it begins again.
  void setPlaying(bool playing) noexcept;
  [[nodiscard]] double speed() const noexcept { return speed_; }
  /// `speed` > 0; 1 is as it happened.
  void setSpeed(double speed);
  /// Moves on when playing; stops at the end.
  void advance(double elapsed_s) noexcept;

  /// Gives the shapes of an organ that is a rod, which a recording does not hold.
  void setPoses(PoseTrack poses) { poses_ = std::move(poses); }

  /// What was shown at this instant. The chunk is found by halving and decoded unless it is at hand: a
  /// recording of hours answers as fast as one of seconds (about a millisecond).
  [[nodiscard]] LiveState state() const;

 private:
  /// Where a chunk lies in time, and the target in force before its first sample.
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
  std::vector<Place> places_;  // one a chunk
  PoseTrack poses_;
  std::int64_t duration_us_ = 0;
  std::int64_t position_us_ = 0;
  double speed_ = 1.0;
  bool playing_ = false;
  mutable std::vector<Decoded> near_;  // newest last
};

}  // namespace torsio
