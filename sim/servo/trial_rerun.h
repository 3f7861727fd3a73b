// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/spsc_ring.h"
#include "sim/device/haptic_device.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"
#include "sim/servo/servo_loop.h"

namespace torsio {

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

}  // namespace torsio
