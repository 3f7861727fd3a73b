// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/base/clock.h"
#include "sim/base/latest_value.h"
#include "sim/base/live_types.h"
#include "sim/base/spsc_ring.h"
#include "sim/device/force_governor.h"
#include "sim/device/haptic_device.h"
#include "sim/scene/scene.h"
#include "sim/servo/exercise.h"

namespace torsio {

struct ServoOptions {
  TwistDrive drive = TwistDrive::kTangential;
  double targetAngle_rad = 0.0;
  double forceScale = 1.0;  ///< 0..1, shown; the material is never rescaled
  std::int64_t tickPeriod_us = 1000;
};

/// One exercise at 1 kHz. It has no thread: ServoThread calls tick() on deadlines, replay and tests call it
/// with a manual clock. All pointees outlive the loop.
class ServoLoop {
 public:
  struct Links {
    HapticDevice* device = nullptr;
    const Scene* scene = nullptr;
    SpscRing<Sample>* recording = nullptr;       ///< may be null: nothing recorded
    LatestValue<LiveState>* live = nullptr;      ///< may be null
    SpscRing<ServoCommand>* commands = nullptr;  ///< may be null
  };

  ServoLoop(const Links& links, const ServoOptions& options);

  /// Drain one command, read, collide, step the tissue, govern, write, record, publish.
  /// Allocates nothing, locks nothing, logs nothing; on any doubt the force is zero.
  void tick(std::int64_t time_us) noexcept;

  [[nodiscard]] const Sample& lastSample() const noexcept { return sample_; }

 private:
  Links links_;
  ServoOptions options_;
  Exercise exercise_;
  ForceGovernor governor_;
  Sample sample_;
  std::int64_t nextTick_ = 0;
  double lastTickDuration_us_ = 0.0;
  std::int64_t lateTicks_ = 0;
};

}  // namespace torsio
