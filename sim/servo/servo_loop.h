// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "sim/core/async_model.h"
#include "sim/core/latest_value.h"
#include "sim/core/live_types.h"
#include "sim/core/spsc_ring.h"
#include "sim/core/time_units.h"
#include "sim/device/haptic_device.h"
#include "sim/device/safety/force_governor.h"
#include "sim/device/safety/passivity.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"
#include "sim/servo/exercise.h"
#include "sim/servo/surface_proxy.h"

namespace torsio {

class PinnedFloatMode;

struct ServoOptions {
  TwistDrive drive = TwistDrive::kTangential;
  double targetAngle_rad = 0.0;
  double forceScale = 1.0;  ///< 0..1, shown; the material is never rescaled
  std::int64_t tickPeriod_us = kTickPeriod_us;
  std::uint32_t rules = kServoRules;  ///< 1 .. kServoRules; older ones replay older trials
  /// Whether the instrument is held at the surface (SurfaceProxy): of a run by hand. What was recorded is
  /// held already.
  bool holdsBack = false;
  /// Of a hollow organ: the twist that it begins with and the errors of the checks (detorsionSeed).
  std::uint64_t seed = 0;
};

/// Gives the options with which a trial of this header runs, when it is recorded and when it is replayed.
[[nodiscard]] ServoOptions servoOptions(const TrialHeader& header) noexcept;

/// The part of the device's capabilities that a trial must remember (TrialHeader::deviceLimits).
[[nodiscard]] DeviceLimits deviceLimits(const DeviceCapabilities& capabilities) noexcept;

/// One exercise at 1 kHz. The loop has no thread: ServoThread calls tick() on deadlines, replay and tests
/// call it with a manual clock. All pointees outlive the loop.
class ServoLoop {
 public:
  struct Links {
    HapticDevice* device = nullptr;
    const Scene* scene = nullptr;
    SpscRing<Sample>* recording = nullptr;       ///< may be null: nothing recorded
    LatestValue<LiveState>* live = nullptr;      ///< may be null
    SpscRing<ServoCommand>* commands = nullptr;  ///< may be null
    SpscRing<ExerciseMoment>* events = nullptr;  ///< may be null: each tick in which something happened
    /// Of a scene that an asynchronous model answers; null: it stays silent, and nothing is felt of it.
    AsyncLink* async = nullptr;
  };

  /// Returns the options of the exercise of such a loop.
  [[nodiscard]] static ExerciseOptions exerciseOptions(const DeviceCapabilities& device,
                                                       const ServoOptions& options) noexcept;

  /// Wires the loop; what it computes once is computed as in tick(). Throws Error{kBadParameter} for options
  /// out of range or a device whose limits make no sense.
  ServoLoop(const Links& links, const ServoOptions& options);

  /// Runs one tick: drain one command, read, hold the tool at the surface, collide, step the tissue, govern,
  /// keep the force to the energy that the hand has put in, write, record, publish. Rounding and the like are
  /// the processor's defaults while it runs, whatever its thread has set. `time_us` never decreases; it is
  /// the time of the sample, whatever the device reports. Allocates nothing, locks nothing, logs nothing; on
  /// any doubt the force is zero. `known`: what the exercise answers in this tick, where that is known
  /// (ExerciseAhead); null: it is stepped.
  void tick(std::int64_t time_us, const ExerciseStep* known = nullptr) noexcept;

  [[nodiscard]] const Sample& lastSample() const noexcept { return sample_; }
  /// Returns the ExerciseEvent bits of the last tick.
  [[nodiscard]] std::uint32_t lastEvents() const noexcept { return events_; }
  /// Returns how the organ lies after the last tick.
  [[nodiscard]] const OrganState& organ() const noexcept { return exercise_.organ(); }
  /// Returns when the stages of the exercise were last reached.
  [[nodiscard]] const ExerciseTimes& times() const noexcept { return times_; }
  /// Returns the energy that the hand has put into the force, J.
  [[nodiscard]] double portEnergy_J() const noexcept {
    return energyLast() ? storedEnergy_.energy_J() : passivity_.energy_J();
  }
  /// Asks the device to let go of the hand until the next write: for a watchdog. Any thread.
  void dropForce() noexcept { links_.device->dropForce(); }
  [[nodiscard]] std::int64_t tickPeriod_us() const noexcept { return options_.tickPeriod_us; }
  /// Returns how often the jaw has gripped the organ.
  [[nodiscard]] std::int64_t grips() const noexcept { return exercise_.grips(); }
  [[nodiscard]] GovernorState governorState() const noexcept { return governor_.state(); }
  /// Returns the number of ticks that did not come in time: whole periods missing between two ticks.
  [[nodiscard]] std::int64_t lateTicks() const noexcept { return lateTicks_; }
  /// Returns the number of pauses after which the force is zero and comes back by a ramp.
  [[nodiscard]] std::int64_t forceCuts() const noexcept { return forceCuts_; }
  [[nodiscard]] std::int64_t ticks() const noexcept { return nextTick_; }

 private:
  ServoLoop(const Links& links, const ServoOptions& options, const PinnedFloatMode& defaults);
  [[nodiscard]] bool energyLast() const noexcept { return options_.rules >= kRulesOfStoredEnergy; }
  [[nodiscard]] ServoCommand nextCommand() noexcept;
  void apply(const ServoCommand& command) noexcept;
  /// Takes the newest answer of the asynchronous model, if it belongs to the present grip.
  [[nodiscard]] AsyncAnswer asyncAnswer() noexcept;
  /// Tells the asynchronous model how far the grip is turned.
  void askAsyncModel() noexcept;
  void countLate(std::int64_t time_us) noexcept;
  /// Returns the wanted force of this tick, scaled, by rules 1 kept passive; NaN when the answer of the
  /// tissue is not finite.
  [[nodiscard]] Vec3 wantedForce_N(const ExerciseStep& step, const ToolState& tool,
                                   std::uint32_t& limits) noexcept;
  /// Puts the state of a hollow organ into the sample. False when it is not finite: the last sound state is
  /// recorded then.
  [[nodiscard]] bool readHollow() noexcept;
  void noteEvents(const ExerciseStep& step) noexcept;
  void publish() noexcept;

  Links links_;
  ServoOptions options_;
  Exercise exercise_;
  SurfaceProxy proxy_;
  PassivityController passivity_;
  ForceGovernor governor_;
  StoredEnergyLimit storedEnergy_;
  Sample sample_;
  HollowReading soundReading_;  // the last that was finite
  std::array<ContactPatch, 2> patches_{};
  ExerciseTimes times_;
  std::uint32_t events_ = kEventNone;
  std::int64_t lastDelivery_ = 0;
  std::int64_t nextTick_ = 0;
  std::int64_t last_us_ = 0;
  double lastTickDuration_us_ = 0.0;
  std::int64_t lateTicks_ = 0;
  std::int64_t forceCuts_ = 0;
};

}  // namespace torsio
