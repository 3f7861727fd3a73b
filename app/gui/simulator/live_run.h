// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "sim/base/latest_value.h"
#include "sim/base/live_types.h"
#include "sim/base/spsc_ring.h"
#include "sim/device/virtual/pointer_device.h"
#include "sim/record/recorder.h"
#include "sim/scene/scene.h"
#include "sim/servo/servo_loop.h"
#include "sim/servo/servo_thread.h"

namespace torsio::gui {

struct RunSetup {
  Pose start;                            ///< of the instrument before the first input
  TwistDrive drive = TwistDrive::kRoll;  ///< a mouse cannot be led round an organ: it turns
  double targetAngle_rad = 0.0;
};

/// One exercise with the pointer as device: everything that must live and die together with a servo loop, in
/// the order in which it must. Built and destroyed on the GUI thread; while it runs the servo has its thread,
/// and the recorder, when there is one, another.
class LiveRun {
 public:
  /// Free practice: nothing is recorded. `device` null: the pointer.
  LiveRun(std::shared_ptr<const Scene> scene, const RunSetup& setup,
          std::unique_ptr<HapticDevice> device = nullptr);
  /// Recorded from the first tick on. Device, drive and target of `header` are filled in here.
  LiveRun(std::shared_ptr<const Scene> scene, const RunSetup& setup, TrialHeader header,
          std::unique_ptr<TrialSink> sink);
  /// The same with another device than the pointer; null: the pointer.
  LiveRun(std::shared_ptr<const Scene> scene, const RunSetup& setup, TrialHeader header,
          std::unique_ptr<TrialSink> sink, std::unique_ptr<HapticDevice> device);
  /// Stops; a recording that was not finished stays with its sink as interrupted.
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  /// Real time from now on. Without it a test calls loop().tick() itself.
  void start();
  [[nodiscard]] ServoLoop& loop() noexcept { return loop_; }

  void steer(const PointerInput& input) noexcept { pointer_.publish(input); }
  /// False when too many commands wait: the wish is refused, and must be said so.
  [[nodiscard]] bool command(const ServoCommand& command) noexcept { return commands_.push(command); }
  /// Stops the servo and hands out the device that was given, its force at zero; null: it was the pointer.
  /// Nothing but finish() and destruction may follow.
  [[nodiscard]] std::unique_ptr<HapticDevice> releaseDevice();
  /// The newest snapshot. GUI thread.
  [[nodiscard]] const LiveState& latest() noexcept { return live_.latest(); }
  /// How punctual the servo is. Any thread.
  [[nodiscard]] const ServoThread& thread() const noexcept { return thread_; }
  [[nodiscard]] bool recorded() const noexcept { return recorder_ != nullptr; }
  /// Tests that tick the loop themselves hand on what was recorded so far. Not after start().
  void pump() { recorder_->pump(); }

  /// Stops the servo and hands the rest of the recording to its sink. Once, and only when recorded. Throws
  /// what Recorder::finish throws.
  [[nodiscard]] RecordingResult finish(TrialOutcome outcome);

 private:
  [[nodiscard]] static ServoOptions options(const RunSetup& setup);
  [[nodiscard]] HapticDevice& device() noexcept {
    return device_ ? *device_ : static_cast<HapticDevice&>(pointer_);
  }

  std::shared_ptr<const Scene> scene_;
  PointerDevice pointer_;
  std::unique_ptr<HapticDevice> device_;  // null: the pointer
  LatestValue<LiveState> live_;
  SpscRing<ServoCommand> commands_;
  std::unique_ptr<SpscRing<Sample>> samples_;  // null: not recorded
  std::unique_ptr<TrialSink> sink_;
  std::unique_ptr<Recorder> recorder_;
  ServoLoop loop_;
  ServoThread thread_;
};

}  // namespace torsio::gui
