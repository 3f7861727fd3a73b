// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

#include "sim/base/device_sample.h"

namespace torsio {

/// Stages of one exercise (paper Fig. 6): no force and no deformation before contact.
enum class ExercisePhase : std::uint8_t {
  kTracking = 0,  ///< the instrument moves freely
  kContact = 1,   ///< it touches the organ: contact force only
  kTwisting = 2,  ///< the jaw holds the organ and turns it
  kReleased = 3,  ///< let go: the organ returns elastically, then Tracking
};

/// How the hand's motion becomes the twist angle at the grasp.
enum class TwistDrive : std::uint8_t {
  kTangential = 0,  ///< way of the tip round the organ's axis
  kRoll = 1,        ///< turn of the stylus about the organ's axis (mouse, wrist)
};

/// What the tissue answers to the tool in one tick. SI, world frame.
struct TwistResponse {
  double angle_rad = 0.0;   ///< twist of the grasped section, unwrapped
  double torque_Nm = 0.0;   ///< torque that holds that angle
  Vec3 force_N;             ///< wanted on the tool, before the ForceGovernor
  double depth_m = 0.0;     ///< penetration of the tip, >= 0
  double graspArc_m = 0.0;  ///< arc length of the grasped section from the fixed end
  friend constexpr bool operator==(const TwistResponse&, const TwistResponse&) = default;
};

/// A force for the device, already limited. The only thing that flows back.
struct ForceCommand {
  Vec3 force_N;
  std::uint32_t limits = 0;  ///< ForceLimit bits: what the governor did
};

/// Bits of Sample::limits: why the felt force is not the computed one.
enum ForceLimit : std::uint32_t {
  kForceFull = 0,
  kForceNotFinite = 1U << 0,
  kForceStale = 1U << 1,
  kForceWorkspace = 1U << 2,
  kForceThermal = 1U << 3,
  kForceEnergy = 1U << 4,
  kForceSaturated = 1U << 5,  ///< norm clamped, direction kept
  kForceSlew = 1U << 6,
  kForceEngaging = 1U << 7,
  kForceInhibited = 1U << 8,
};

/// A wish of a view. At most one is obeyed at the start of each tick, and it is recorded with that tick.
struct ServoCommand {
  enum class Kind : std::uint8_t {
    kNone,
    kReleaseTissue,  ///< let go and return to rest
    kSetForceScale,  ///< value: 0 .. 1
    kSetTarget,      ///< value: target angle in rad
    kEnableForce,    ///< value: 0 off, 1 on
  };
  Kind kind = Kind::kNone;
  double value = 0.0;
  friend constexpr bool operator==(const ServoCommand&, const ServoCommand&) = default;
};

/// One tick, complete: what the device said and what was answered. Recorded, never changed.
struct Sample {
  std::int64_t tick = 0;  ///< 0, 1, 2 ... without gaps unless the ring refused (then counted)
  DeviceSample device;
  ServoCommand command;  ///< obeyed at the start of this tick; kNone mostly
  ExercisePhase phase = ExercisePhase::kTracking;
  std::uint32_t limits = kForceFull;
  TwistResponse response;  ///< response.force_N: before the governor
  Vec3 force_N;            ///< sent to the device
  friend bool operator==(const Sample&, const Sample&) = default;
};

/// Snapshot for views; may be overwritten before anyone looked.
struct LiveState {
  std::int64_t time_us = 0;
  std::int64_t tick = 0;
  Pose tool;
  double grip = 0.0;
  ExercisePhase phase = ExercisePhase::kTracking;
  TwistResponse response;
  Vec3 force_N;
  std::uint32_t limits = kForceFull;
  double targetAngle_rad = 0.0;
  double tickDuration_us = 0.0;  ///< of the previous tick, measured on the monotonic clock
  std::int64_t refusedSamples = 0;
  std::int64_t lateTicks = 0;
};

static_assert(std::is_trivially_copyable_v<Sample>);
static_assert(std::is_trivially_copyable_v<LiveState>);
static_assert(std::is_trivially_copyable_v<ServoCommand>);
static_assert(std::is_trivially_copyable_v<ForceCommand>);

}  // namespace torsio
