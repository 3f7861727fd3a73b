// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "sim/core/async_model.h"
#include "sim/core/device_sample.h"
#include "sim/core/organ_pose.h"

namespace torsio {

/// Version of the rules by which a tick answers; stamped on every sample, so that a trial replays by the
/// rules that it was recorded with. 1: jaw and shaft collide, contact is a virtual coupling to a surface that
/// gives way, passivity is kept. 2: passivity is the last stage (no force beyond the energy that the hand has
/// put in), a falling force is not held back, a jaw that lets go touches anew. 3: so, of a hollow organ that
/// came twisted, which a hand undoes. 4 and 5: as 2 and 3, but while a reading stands still the force fades
/// at once, and what it may have given meanwhile counts until the contact ends.
inline constexpr std::uint32_t kRulesOfStoredEnergy = 2;
inline constexpr std::uint32_t kRulesOfDetorsion = 3;
inline constexpr std::uint32_t kRulesOfStandstill = 4;
inline constexpr std::uint32_t kRulesOfDetorsionStandstill = 5;
inline constexpr std::uint32_t kServoRules = kRulesOfDetorsionStandstill;

/// Tells whether these rules are of a hollow organ that came twisted.
[[nodiscard]] constexpr bool areOfDetorsion(std::uint32_t rules) noexcept {
  return rules == kRulesOfDetorsion || rules == kRulesOfDetorsionStandstill;
}

/// Returns the rules that a loop with these ones stamps on the samples of a scene.
[[nodiscard]] constexpr std::uint32_t stampedRules(std::uint32_t rules, bool comesTwisted) noexcept {
  if (rules >= kRulesOfStandstill) {
    return comesTwisted ? kRulesOfDetorsionStandstill : kRulesOfStandstill;
  }
  if (comesTwisted) {
    return kRulesOfDetorsion;
  }
  return rules < kRulesOfStoredEnergy ? rules : kRulesOfStoredEnergy;
}

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

/// A force for the device, already limited: the only thing that flows back to it.
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
  kForcePassivity = 1U << 9,  ///< made smaller: the hand would get more energy than it has put in
  /// The asynchronous model has failed, or said nothing for too long: the grip is not felt.
  kForceModelLate = 1U << 10,
};

/// Bits of Sample::contact: which parts of the instrument touch the organ.
enum ToolContact : std::uint32_t {
  kContactNone = 0,
  kContactJaw = 1U << 0,    ///< the tip or a blade of the jaw
  kContactShaft = 1U << 1,  ///< the shaft behind the jaw
  kContactHeld = 1U << 2,   ///< tissue between the blades
};

/// Where the surface gives way under a part of the instrument. World frame, of the deformed organ. The law of
/// its shape stands in sim/servo/contact_coupling.h; a depth of 0 means that nothing is touched.
struct ContactPatch {
  Vec3 point_m;               ///< of the surface before it gives way
  Vec3 normal;                ///< unit, outwards
  double depth_m = 0.0;       ///< by which the surface gives way under the part
  double toolRadius_m = 0.0;  ///< of the part
  double radius_m = 0.0;      ///< of the patch: beyond it nothing moves
  friend constexpr bool operator==(const ContactPatch&, const ContactPatch&) = default;
};

/// When the stages of an exercise were last reached, servo time; -1: never yet.
struct ExerciseTimes {
  std::int64_t phaseSince_us = 0;  ///< the present phase
  std::int64_t touched_us = -1;
  std::int64_t gripped_us = -1;
  std::int64_t released_us = -1;
  std::int64_t slipped_us = -1;
  std::int64_t folded_us = -1;  ///< the jaw let go before the tissue folded
  std::int64_t returned_us = -1;
  friend constexpr bool operator==(const ExerciseTimes&, const ExerciseTimes&) = default;
};

/// A command from a view. The servo applies at most one at the start of each tick and records it with it.
struct ServoCommand {
  enum class Kind : std::uint8_t {
    kNone,
    kReleaseTissue,  ///< open the jaw and let the organ return to rest
    kSetForceScale,  ///< value: 0 .. 1
    kSetTarget,      ///< value: target angle in rad
    kEnableForce,    ///< value: 0 off, 1 on
    kHoldOrgan,      ///< value: 1 a clip or an assistant holds a hollow organ in place, 0 releases it
    kVent,           ///< value: 1 opens the vent for the content, 0 closes it
    kCheckFlow,      ///< value: FlowCheck
  };
  Kind kind = Kind::kNone;
  double value = 0.0;
  friend constexpr bool operator==(const ServoCommand&, const ServoCommand&) = default;
};

/// One tick, complete: what the device said and what was answered. Recorded, never changed.
struct Sample {
  std::int64_t tick = 0;  ///< 0, 1, 2 ... without gaps unless the ring refused (then counted)
  DeviceSample device;
  ServoCommand command;  ///< applied at the start of this tick; usually kNone
  AsyncAnswer async;     ///< arrived before this tick; usually kNothing
  ExercisePhase phase = ExercisePhase::kTracking;
  std::uint32_t limits = kForceFull;
  TwistResponse response;                ///< response.force_N: before the governor
  Vec3 force_N;                          ///< sent to the device
  std::uint32_t contact = kContactNone;  ///< ToolContact bits
  std::uint32_t rules = 1;               ///< by which this tick was answered, up to kServoRules
  HollowReading hollow;                  ///< of an organ with a wall
  friend bool operator==(const Sample&, const Sample&) = default;
};

/// Snapshot of a tick for views; it may be overwritten before a view reads it.
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
  std::uint32_t deviceStatus = kDeviceOk;  ///< DeviceStatus bits of the last reading
  std::uint32_t contact = kContactNone;    ///< ToolContact bits
  /// Where the surface gives way under the jaw and under the shaft.
  std::array<ContactPatch, 2> patches{};
  ExerciseTimes times;
  RodPose pose;       ///< of an organ that is a rod; no nodes: at rest
  HollowPose hollow;  ///< of a hollow organ that came twisted
  /// Energy that the hand has put into the rendered force since that force was last zero; below 0 the hand
  /// got more back.
  double portEnergy_J = 0.0;
};

static_assert(std::is_trivially_copyable_v<Sample>);
static_assert(std::is_trivially_copyable_v<LiveState>);
static_assert(std::is_trivially_copyable_v<ServoCommand>);
static_assert(std::is_trivially_copyable_v<ForceCommand>);

/// Gives what a view sees of a tick, live or played back: time, tool, phase, answer and contact. What only
/// the servo loop knows (target, device status, delays, patches) is left as it is at rest.
[[nodiscard]] LiveState liveStateOf(const Sample& sample) noexcept;

}  // namespace torsio
