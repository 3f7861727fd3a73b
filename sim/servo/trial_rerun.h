// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/base/spsc_ring.h"
#include "sim/device/haptic_device.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"
#include "sim/servo/servo_loop.h"

namespace torsio {

/// The servo loop on the device samples and commands of a recorded trial: gives its answers again bit for
/// bit. `scene` outlives it. One thread.
class TrialRerun {
 public:
  /// Prepares a loop. It follows the rules of its scene, which those stamped on the samples are.
  TrialRerun(const Scene& scene, const TrialHeader& header);

  /// Runs the tick of `recorded`, the next sample of the trial; returns its answer.
  const Sample& next(const Sample& recorded);
  /// Returns how the organ lies after the last tick.
  [[nodiscard]] const OrganState& organ() const noexcept { return loop_.organ(); }

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
  BesideLink beside_;  // hands on what the model beside the servo had said
  std::int64_t deliveries_ = 0;
  HandedSample device_;
  ServoLoop loop_;
};

}  // namespace torsio
