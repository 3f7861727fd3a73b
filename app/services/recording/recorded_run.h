// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
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
#include "sim/record/trial.h"
#include "sim/scene/scene.h"
#include "sim/servo/servo_loop.h"
#include "sim/servo/servo_thread.h"

namespace torsio {

/// One run of an exercise, connected from the device to the sink of its recording. Every run of Torsio is one
/// of these: free practice, a trainee's run, the scripted hands of the demonstration and of the expert's
/// example. docs/architecture.md draws the same flow; recorded_run.cpp walks through it.
///
/// After start(), time is real, and servo and recorder have a thread each. Without start(), time advances by
/// step(), as fast as it is called. Both use the same servo loop. An asynchronous model has its own thread;
/// with step(), it gets a sixtieth of a second per frame.
///
/// Belongs to the thread that created it. Owns everything with the lifetime of the servo loop; sink and scene
/// are shared, because they outlive the run.
class RecordedRun {
 public:
  /// Connects the run without starting it. `sink`: receives the recording from the first tick; null: free
  /// practice without a recording. Throws Error{kBadParameter} if the device's limits or the target are
  /// invalid. `shape`: receives the shapes of an asynchronous model; may be null.
  RecordedRun(std::shared_ptr<const Scene> scene, std::unique_ptr<HapticDevice> device,
              const RecordingSpec& spec, std::shared_ptr<TrialSink> sink,
              std::shared_ptr<LatestShape> shape = nullptr);
  /// Stops. A recording without finish() stays with its sink as interrupted.
  ~RecordedRun();
  RecordedRun(const RecordedRun&) = delete;
  RecordedRun& operator=(const RecordedRun&) = delete;

  /// Runs in real time from now on. Call once, and not after step().
  void start();
  /// Runs `ticks` ticks on the run's manual clock, which starts at 0. Not after start().
  void step(std::int64_t ticks = 1);

  /// Sends a command to the servo. Returns false if the queue is full: the command is dropped, and the user
  /// must be told.
  [[nodiscard]] bool command(const ServoCommand& command) noexcept { return commands_.push(command); }
  /// Returns the latest snapshot, valid until the next call.
  [[nodiscard]] const LiveState& latest() noexcept { return live_.latest(); }
  /// Returns the configuration of the run, which is also the header of its recording.
  [[nodiscard]] const TrialHeader& header() const noexcept { return header_; }
  /// Tells whether the run is recorded.
  [[nodiscard]] bool recorded() const noexcept { return recorder_.has_value(); }
  /// Returns the worker of the asynchronous model; null if the scene has none.
  [[nodiscard]] const AsyncModelWorker* asyncModel() const noexcept { return asyncModel_.get(); }
  /// Returns the servo's thread, for its timing. Only after start().
  [[nodiscard]] const ServoThread& thread() const { return *thread_; }

  /// Stops the servo and passes the rest of the recording to its sink. Call once, only if recorded. Throws
  /// what Recorder::finish throws.
  [[nodiscard]] RecordingResult finish(TrialOutcome outcome);
  /// Stops the servo and returns the device with its force at zero. Afterwards only finish(), latest() and
  /// destruction are allowed.
  [[nodiscard]] std::unique_ptr<HapticDevice> releaseDevice();

 private:
  [[nodiscard]] ServoLoop::Links links() noexcept;

  // In the order of the flow, which is also a valid order of lifetimes: each refers only to those above.
  std::shared_ptr<const Scene> scene_;
  std::unique_ptr<HapticDevice> device_;
  TrialHeader header_;
  SpscRing<ServoCommand> commands_;
  LatestValue<LiveState> live_;
  std::unique_ptr<SpscRing<Sample>> samples_;  // null: not recorded
  AsyncLink asyncLink_;
  std::unique_ptr<AsyncModelWorker> asyncModel_;  // null: the servo computes everything itself
  ServoLoop loop_;
  std::shared_ptr<TrialSink> sink_;
  std::optional<Recorder> recorder_;
  ManualClock clock_;                  // for step()
  std::optional<ServoThread> thread_;  // only after start()
};

/// Wraps an object whose owner keeps it alive longer than the run, such as a scene or sink on the stack, in a
/// shared_ptr.
template <typename T>
[[nodiscard]] std::shared_ptr<T> borrowed(T& owned) noexcept {
  return std::shared_ptr<T>(std::shared_ptr<void>(), &owned);
}

/// A trial of a scripted hand.
struct ScriptedTrial {
  RecordingSpec recording{};
  std::uint64_t personSeed = 1;  ///< determines this person's learning and tremor
  std::uint64_t trialSeed = 1;   ///< determines every deviation of this trial
  double duration_s = 20.0;      ///< when untwisting, at least until the organ has been left alone
  double practisedBefore_min = 0.0;
  double practiceScale = 1.0;  ///< minutes of practice represented by one minute of the trial
  /// Minimum number of twists: the trial is longer if necessary and then represents the same total practice.
  std::size_t fewestTwists = 0;
  /// Turns that the hand omits at the end of an untwisting; the first one is always made.
  std::size_t turnsLeftOut = 0;
  /// Jaw closure on an organ being untwisted, 0 .. 1; empty: what its wall tolerates well.
  std::optional<double> closure{};
};

/// Records a scripted hand (RecordedRun) as fast as possible; the sink receives exactly what a real-time
/// trial would give it. Throws what the sink throws.
TrialSummary recordScriptedTrial(const Scene& scene, const ScriptedTrial& trial, TrialSink& sink);

/// Records one twist to `target_rad` by a scripted expert hand (RecordedRun); reproducible. Takes a fraction
/// of a second. Throws Error{kBadParameter} if the hand cannot reach the organ.
[[nodiscard]] Trial expertRun(const Scene& scene, double target_rad);

/// Label of stored expert runs (TrialHeader::phaseLabel).
inline constexpr const char* kExpertPhase = "example by an instructor";

}  // namespace torsio
