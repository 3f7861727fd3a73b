// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/core/live_types.h"
#include "sim/core/spsc_ring.h"
#include "sim/device/haptic_device.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"
#include "sim/servo/exercise.h"
#include "sim/servo/servo_loop.h"

namespace torsio {

/// What the exercise of a recorded trial answered, computed again on several threads: the trial is cut where
/// the record says that nothing is touched and the organ lies at rest, and each piece is begun as if it were
/// so. What a piece ended with decides: only when it was so are the answers of the next piece taken, else it
/// is stepped on from there. So every answer is that of one exercise stepped from the first sample on, bit
/// for bit, whatever the record says.
///
/// A scene with a wall that came twisted, or with an asynchronous model, never comes to such a place: it
/// is stepped on one thread. One thread asks.
class ExerciseAhead {
 public:
  /// Prepares for `recorded`, consecutive samples from tick 0 on, which outlive it as `scene` does. `threads`
  /// >= 1: that compute at the same time.
  ExerciseAhead(const Scene& scene, const ExerciseOptions& options, std::span<const Sample> recorded,
                unsigned threads);

  /// Tells whether the answers of this scene can be computed ahead.
  [[nodiscard]] static bool suits(const Scene& scene) noexcept;
  /// Returns the answer of the next sample; there is one.
  [[nodiscard]] const ExerciseStep& next();
  /// Returns how many pieces did not begin as the record said and were stepped again.
  [[nodiscard]] std::size_t piecesAgain() const noexcept { return again_; }

 private:
  /// Samples of one thread, and how the exercise was behind them.
  struct Piece {
    std::size_t first = 0;
    std::size_t end = 0;
    Exercise exercise;
  };

  [[nodiscard]] std::size_t pieceEnd(std::size_t first);
  void step(Piece& piece) noexcept;
  void computeMore();

  const Scene& scene_;
  ExerciseOptions options_;
  std::span<const Sample> recorded_;
  unsigned threads_;
  Exercise exercise_;                  // behind the last answer that counts
  std::vector<ExerciseStep> answers_;  // from begun_ on
  std::size_t begun_ = 0;
  std::size_t at_ = 0;
  bool jawClosed_ = true;  // behind the last sample that was looked at
  std::size_t again_ = 0;
};

/// The servo loop on the device samples and commands of a recorded trial: gives its answers again bit for
/// bit. `scene` outlives it. One thread.
class TrialRerun {
 public:
  /// Returns the options of the exercise of a trial that follows `rules`.
  [[nodiscard]] static ExerciseOptions exerciseOptions(const TrialHeader& header, std::uint32_t rules);

  /// Prepares a loop that follows the `rules` stamped on the samples.
  TrialRerun(const Scene& scene, const TrialHeader& header, std::uint32_t rules);

  /// Runs the tick of `recorded`, the next sample of the trial; returns its answer. `known`: that of the
  /// exercise, where it is known already (ExerciseAhead); organ() then stays as it was.
  const Sample& next(const Sample& recorded, const ExerciseStep* known = nullptr);
  /// Returns how the organ lies after the last tick.
  [[nodiscard]] const OrganState& organ() const noexcept { return loop_.organ(); }
  /// Returns the ExerciseEvent bits of the last tick.
  [[nodiscard]] std::uint32_t lastEvents() const noexcept { return loop_.lastEvents(); }

 private:
  /// Gives the sample that it was handed.
  class HandedSample final : public HapticDevice {
   public:
    explicit HandedSample(const TrialHeader& header);
    void hand(const DeviceSample& sample) noexcept { sample_ = sample; }
    [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
    [[nodiscard]] DeviceSample read(std::int64_t) noexcept override { return sample_; }
    void write(const ForceCommand&) noexcept override {}

   private:
    DeviceCapabilities capabilities_;
    DeviceSample sample_;
  };

  SpscRing<ServoCommand> commands_{1};
  AsyncLink asyncLink_;  // hands on what the asynchronous model had said
  std::int64_t deliveries_ = 0;
  HandedSample device_;
  ServoLoop loop_;
};

/// Runs a recorded trial again, `samples` from its first tick on, and returns each tick in which one of
/// `wanted` (ExerciseEvent bits) happened, with these alone: a recording holds what the hand did, not what
/// came of it. About 10 us a tick of a hollow organ. Any one thread.
[[nodiscard]] std::vector<ExerciseMoment> rerunMoments(const Scene& scene, const TrialHeader& header,
                                                       std::span<const Sample> samples, std::uint32_t wanted);

/// The first difference between a replay and the record.
struct ReplayDifference {
  std::int64_t tick = 0;
  std::string field;  ///< "torque", "phase" ...; "exact answers" when only the last bits differ
  double recorded = 0.0;
  double replayed = 0.0;
};

/// What a replay found.
struct ReplayReport {
  std::int64_t samples = 0;           ///< replayed
  std::int64_t differentSamples = 0;  ///< in an integer field or by a stored step or more
  std::int64_t chunks = 0;
  std::int64_t differentChunks = 0;          ///< whose exact doubles have another digest
  bool contentIntact = false;                ///< digests and content hash of the record itself fit
  std::optional<std::int64_t> gapAfterTick;  ///< the record lacks samples from here: replay stops
  std::optional<ReplayDifference> first;

  /// Tells whether the replay gave bit for bit what was recorded, from an intact record without a gap.
  [[nodiscard]] bool identical() const noexcept {
    return contentIntact && !gapAfterTick && differentSamples == 0 && differentChunks == 0;
  }
};

/// Runs the servo loop again over the recorded device samples and commands and compares: integers exactly,
/// answers in stored steps, and the digest over the exact bits of all answers, chunk by chunk. The loop
/// follows the rules that are stamped on the samples (kServoRules). Throws Error{kVerifyFailed} when `scene`
/// is not the one that was recorded (organ or parameters) or the rules are newer than this version, and
/// Error{kBadData} when the record cannot be decoded. `threads`: that may compute at the same time
/// (ExerciseAhead); 0: as many as the machine has. The report does not depend on it.
[[nodiscard]] ReplayReport replayTrial(const Scene& scene, const Trial& trial, unsigned threads = 0);

}  // namespace torsio
