// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sim/base/live_types.h"
#include "sim/record/trial.h"

namespace torsio::gui {

/// A recorded trial to be looked at: any instant, any speed. It shows the answers as they were recorded;
/// that the same device samples give them again bit for bit is replayTrial's business (sim/servo).
class TrialPlayback {
 public:
  /// Throws Error{kBadData} for a trial that cannot be decoded or holds no sample.
  explicit TrialPlayback(const Trial& trial);

  [[nodiscard]] const TrialHeader& header() const noexcept { return header_; }
  [[nodiscard]] std::int64_t duration_us() const noexcept;
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

  /// All of it, in order, as it was recorded: for traces.
  [[nodiscard]] const std::vector<Sample>& samples() const noexcept { return samples_; }

  /// What was shown at this instant. Found by halving: a recording of hours answers as fast as one of
  /// seconds.
  [[nodiscard]] LiveState state() const noexcept;

 private:
  [[nodiscard]] const Sample& sample() const noexcept;

  TrialHeader header_;
  std::vector<Sample> samples_;
  std::vector<double> targets_rad_;  // in force at each sample
  std::int64_t position_us_ = 0;
  double speed_ = 1.0;
  bool playing_ = false;
};

}  // namespace torsio::gui
