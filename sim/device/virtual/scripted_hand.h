// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/core/random.h"
#include "sim/device/haptic_device.h"

namespace torsio {

/// How a simulated person learns and trembles. Assumed ranges, for demonstration only: no such figures are
/// measured for twist exercises.
struct HandProfile {
  double initialSkill = 0.15;        ///< before any practice, 0..1
  double finalSkill = 0.92;          ///< after endless practice, initial..1
  double learningTime_min = 14.0;    ///< time constant of the exponential learning curve, > 0
  double tremorFrequency_Hz = 10.0;  ///< centre of the person's physiological tremor, 8..12
};

/// Makes the person with this seed: initial skill 0.05..0.30, final 0.80..0.98, learning time 9..22 min.
[[nodiscard]] HandProfile handProfile(std::uint64_t seed);

/// Returns the skill after `practised_min` minutes of practice: final - (final - initial) exp(-t / learning
/// time).
[[nodiscard]] double skillAfter(const HandProfile& profile, double practised_min) noexcept;

/// How a hand of one skill moves; linear in skill between a novice (0) and an expert (1).
struct HandMotion {
  double reach_s = 0.0;              ///< way from the start to above the grasp point
  double approach_s = 0.0;           ///< from there into contact
  double jaw_s = 0.0;                ///< closing and opening
  double meanTwist_rad_per_s = 0.0;  ///< mean rate of the main twist (peak: 15/8 of it)
  double correction_s = 0.0;         ///< second movement, from overshoot to the final angle
  double hold_s = 0.0;
  double overshoot = 0.0;       ///< mean share of the target that the main twist exceeds
  double angleError_rad = 0.0;  ///< standard deviation of the final angle
  double graspError_m = 0.0;    ///< standard deviation of the grasp point along the surface
  double pressError_m = 0.0;    ///< standard deviation of the pressing depth
  double tremor_m = 0.0;        ///< of the position, root mean square an axis, 8-12 Hz
  double tremor_rad = 0.0;      ///< of the orientation, root mean square an axis, 8-12 Hz
  double drift_m = 0.0;         ///< of the position, root mean square an axis, 0.1-0.5 Hz
  double drift_rad = 0.0;       ///< of the twist angle, root mean square, 0.1-0.5 Hz
};

[[nodiscard]] HandMotion handMotion(double skill) noexcept;

/// One of several turns of a task: between two the hand lets go and turns back.
struct HandTurn {
  Vec3 graspPoint_m;       ///< on the surface as it lies then
  double angle_rad = 0.0;  ///< by which the hand turns
  double rest_s = 0.0;     ///< how much longer than usual the hand waits afterwards
};

/// Task of a scripted hand as plain geometry in the world frame; handTask (sim/servo/hand_task.h) makes it
/// from a scene.
struct HandTask {
  Vec3 start_m;                       ///< where the tip rests between two twists; away from the organ
  Vec3 graspPoint_m;                  ///< on the organ's surface, not on the axis
  Vec3 axisCentre_m;                  ///< any point of the line that the twist turns about
  Vec3 axisDirection{0.0, 0.0, 1.0};  ///< unit; a positive angle turns right-handed about it
  Vec3 outwards;                      ///< unit, across the axis: from where the hand comes; 0: from the axis
  double targetAngle_rad = 0.0;
  double tipRadius_m = 0.0025;  ///< of the instrument: contact begins this far above the surface
  double closure = 1.0;         ///< of the jaw that holds, 0 .. 1
  /// Turns of an organ that is undone, in place of graspPoint_m and targetAngle_rad: each once, then the hand
  /// rests. What one misses the next makes up for. Between two the second button sets a clip before the jaw
  /// opens and takes it off after it has closed again.
  std::vector<HandTurn> turns{};
};

struct ScriptedHandOptions {
  std::uint64_t seed = 1;  ///< every deviation of this trial; use another one for each trial of a person
  HandTask task;
  HandProfile profile;
  double practisedBefore_min = 0.0;  ///< practice before this trial
  /// Minutes of practice that one minute of the trial stands for (demonstration: 60).
  double practiceScale = 1.0;
  double duration_s = 20.0;  ///< a further twist begins only if it can be finished within it
};

/// A hand that twists by a plan: minimum-jerk reach to above the grasp point, approach into contact, grip,
/// minimum-jerk twist with overshoot and correction, hold, release, retreat; again until the duration ends.
/// Band-limited tremor (8-12 Hz) and drift (0.1-0.5 Hz) are added to the plan; skill grows with practice.
/// The plan is made at construction from seed and parameters; time 0 is the first read. The hand does not
/// give way to forces.
/// kButtonSecond is pressed for 0.1 s where it clips; the status is kDeviceEnded after the duration.
class ScriptedHand final : public HapticDevice {
 public:
  /// Plans the whole movement. Throws Error{kBadParameter}: grasp point on the axis, axis not unit, times
  /// not positive.
  explicit ScriptedHand(const ScriptedHandOptions& options);

  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override;
  void write(const ForceCommand&) noexcept override {}

  /// Returns the number of twists in the plan.
  [[nodiscard]] std::size_t cycles() const noexcept { return cycles_.size(); }
  /// Returns the angle at which twist `cycle` is held, without tremor and drift.
  [[nodiscard]] double heldAngle_rad(std::size_t cycle) const { return cycles_.at(cycle).held_rad; }
  /// Returns the skill during twist `cycle`.
  [[nodiscard]] double skill(std::size_t cycle) const { return cycles_.at(cycle).skill; }
  /// Returns when the last twist has ended, seconds after the first read.
  [[nodiscard]] double ends_s() const { return span_s(cycles_.size() - 1)[1]; }
  /// Returns when twist `cycle` begins and ends, seconds after the first read.
  [[nodiscard]] std::array<double, 2> span_s(std::size_t cycle) const;

 private:
  /// Legs of one twist, in order.
  enum Leg : std::size_t {
    kReach,
    kApproach,
    kClose,
    kTwist,
    kCorrect,
    kHold,
    kOpen,
    kLift,
    kReturn,
    kPause,
    kLegs
  };
  struct Cycle {
    std::array<double, kLegs + 1> begins_s{};  // of each leg, and the end
    Vec3 above_m;                              // hover point, before the twist
    Vec3 pressed_m;                            // tip in contact, before the twist
    double reached_rad = 0.0;                  // after the main twist
    double held_rad = 0.0;                     // after the correction
    double skill = 0.0;
    bool unclips = false;     // the clip of the turn before, once the jaw has closed
    bool clipsAfter = false;  // before the jaw opens
    HandMotion motion;
  };
  /// Sums of sines with unit root mean square: x y z of the position, x y z of the orientation.
  static constexpr std::size_t kChannels = 6;
  struct Wave {
    double frequency_Hz = 0.0;
    std::array<double, kChannels> sine{};
    std::array<double, kChannels> cosine{};
  };
  static constexpr std::size_t kTremorWaves = 3;
  static constexpr std::size_t kDriftWaves = 2;
  using Channels = std::array<double, kChannels>;

  [[nodiscard]] Cycle plan(double begin_s, double skill, const HandTurn& turn, Random& random) const;
  /// Plans the turns of an organ that is undone.
  void planTurns(const ScriptedHandOptions& options, Random& random);
  [[nodiscard]] static bool pressesSecond(const Cycle& cycle, double t_s) noexcept;
  [[nodiscard]] DeviceReading at(double t_s) noexcept;
  template <std::size_t N>
  [[nodiscard]] static Channels sum(const std::array<Wave, N>& waves, double t_s) noexcept;

  DeviceCapabilities capabilities_;
  HandTask task_;
  Vec3 outward_;  // unit, from the axis to the grasp point
  Quat upright_;  // stylus towards the axis
  double duration_s_;
  std::vector<Cycle> cycles_;
  std::array<Wave, kTremorWaves> tremor_;
  std::array<Wave, kDriftWaves> drift_;
  std::size_t current_ = 0;
  bool started_ = false;
  std::int64_t first_us_ = 0;
  DeviceSample sample_;
};

}  // namespace torsio
