// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "app/services/recording/async_model_worker.h"
#include "app/services/recording/recording_spec.h"
#include "sim/core/clock.h"
#include "sim/core/latest_value.h"
#include "sim/core/live_types.h"
#include "sim/core/spsc_ring.h"
#include "sim/device/haptic_device.h"
#include "sim/record/recorder.h"
#include "sim/scene/scene.h"
#include "sim/servo/servo_loop.h"
#include "sim/servo/servo_thread.h"

namespace torsio {

/// One run of an exercise, wired from the device to the sink of its recording. Every run of Torsio is one of
/// these: free practice, a trainee's run, the scripted hands of the demonstration and of the expert's
/// example. docs/architecture.md draws the same flow; recorded_run.cpp walks through it.
///
/// After start() the time is real, and the servo and the recorder have a thread each. Without start() the
/// time is that of step(), as fast as it is called. The device is read and answered by the same servo loop.
/// Where an asynchronous model answers, it has a thread too; in the time of step() it is given a sixtieth
/// of a second for each frame.
///
/// Belongs to the thread that made it. Owns all that must live and die together with a servo loop; the sink
/// and the scene are shared, because they outlive the run.
class RecordedRun {
 public:
  /// Wires the run; nothing moves yet. `sink`: gets the recording from the first tick on; null: free
  /// practice, of which nothing is kept. Throws Error{kBadParameter} when the limits of the device or the
  /// target make no sense. `shape`: gets what an asynchronous model makes of the organ; null: nobody
  /// looks.
  RecordedRun(std::shared_ptr<const Scene> scene, std::unique_ptr<HapticDevice> device,
              const RecordingSpec& spec, std::shared_ptr<TrialSink> sink,
              std::shared_ptr<LatestShape> shape = nullptr);
  /// Stops. A recording that was not finished stays with its sink as interrupted.
  ~RecordedRun();
  RecordedRun(const RecordedRun&) = delete;
  RecordedRun& operator=(const RecordedRun&) = delete;

  /// Runs in real time from now on. Once, and not after step().
  void start();
  /// Runs `ticks` ticks on the run's own manual clock, which begins at 0. Not after start().
  void step(std::int64_t ticks = 1);

  /// Hands a wish to the servo. False when too many wait: the wish is refused, and must be said so.
  [[nodiscard]] bool command(const ServoCommand& command) noexcept { return commands_.push(command); }
  /// Returns the newest snapshot, which is valid until the next call.
  [[nodiscard]] const LiveState& latest() noexcept { return live_.latest(); }
  /// Returns what the run was wired for; the header of its recording when there is one.
  [[nodiscard]] const TrialHeader& header() const noexcept { return header_; }
  /// Tells whether the run is recorded.
  [[nodiscard]] bool recorded() const noexcept { return recorder_.has_value(); }
  /// Returns who runs the asynchronous model; null where the servo needs none.
  [[nodiscard]] const AsyncModelWorker* asyncModel() const noexcept { return asyncModel_.get(); }
  /// Returns the thread of the servo, for its timing. After start().
  [[nodiscard]] const ServoThread& thread() const { return *thread_; }

  /// Stops the servo and hands the rest of the recording to its sink. Once, and only when recorded. Throws
  /// what Recorder::finish throws.
  [[nodiscard]] RecordingResult finish(TrialOutcome outcome);
  /// Stops the servo and hands out the device, its force at zero. Nothing but finish(), latest() and
  /// destruction may follow.
  [[nodiscard]] std::unique_ptr<HapticDevice> releaseDevice();

 private:
  [[nodiscard]] ServoLoop::Links links() noexcept;

  // In the order of the flow, which is also the order in which they may live: each knows only those above.
  std::shared_ptr<const Scene> scene_;
  std::unique_ptr<HapticDevice> device_;
  TrialHeader header_;
  SpscRing<ServoCommand> commands_;
  LatestValue<LiveState> live_;
  std::unique_ptr<SpscRing<Sample>> samples_;  // null: not recorded
  AsyncLink asyncLink_;
  std::unique_ptr<AsyncModelWorker> asyncModel_;  // null: the servo answers alone
  ServoLoop loop_;
  std::shared_ptr<TrialSink> sink_;
  std::optional<Recorder> recorder_;
  ManualClock clock_;                  // of step()
  std::optional<ServoThread> thread_;  // after start()
};

/// Lends something that its owner keeps alive for longer than the run: a scene or a sink on the stack.
template <typename T>
[[nodiscard]] std::shared_ptr<T> borrowed(T& owned) noexcept {
  return std::shared_ptr<T>(std::shared_ptr<void>(), &owned);
}

}  // namespace torsio
