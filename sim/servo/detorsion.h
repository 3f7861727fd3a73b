// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

#include "sim/record/trial.h"
#include "sim/scene/hollow_organ.h"
#include "sim/servo/grasp.h"

namespace torsio {

/// Time constant with which the content leaves by an open way, of the hand's time; assumed.
inline constexpr double kVentTime_s = 3.0;
/// Time constant with which it leaves through a torn wall: nearly all within 5 s; assumed.
inline constexpr double kLeakTime_s = 5.0 / 3.0;
/// Angle over which the torque of relapse sets in, so that the hand feels no step.
inline constexpr double kRelapseRamp_rad = 0.1;
/// Turn by the jaw that breaks a check of the blood flow off.
inline constexpr double kCheckTurn_rad = 0.035;
/// Share by which tissue without blood bears less.
inline constexpr double kIschaemicWeakness = 0.5;

/// Says what a check of the blood flow costs the hand and how far it is out; both assumed.
struct FlowCheckCost {
  std::int64_t time_us = 0;
  double deviation = 0.0;  ///< standard deviation of the answer
};
[[nodiscard]] FlowCheckCost flowCheckCost(FlowCheck check) noexcept;

/// A hollow organ that came twisted and is undone, tick by tick (docs/model.md U): who holds its mobile part,
/// friction and relapse, pressure, blood, what the jaw does to the wall, checks. Lives on
/// OrganState::hollow and the angle; the jaw's turn is GraspedHollow's. A plain value; servo thread,
/// noexcept, allocation-free; + - * / and roots only.
class DetorsionStep {
 public:
  explicit DetorsionStep(std::int64_t tickPeriod_us) noexcept
      : tick_s_(static_cast<double>(tickPeriod_us) * 1e-6) {}

  /// Takes the seed of the trial, for the errors of the checks.
  void begin(std::uint64_t seed) noexcept {
    seed_ = seed;
    filled_ = false;
  }

  /// Asks a clip or an assistant to hold the mobile part where it is, or to let go, in the next step.
  void hold(bool held) noexcept { holdAsked_ = held ? Ask::kOn : Ask::kOff; }
  /// Asks to open or to close the way out for the content; only what the scene lets out leaves.
  void vent(bool open) noexcept { ventAsked_ = open ? Ask::kOn : Ask::kOff; }
  /// Asks to look, touch or listen whether blood flows; refused while another check runs.
  void check(FlowCheck check) noexcept { checkAsked_ = check; }

  /// Closes the jaw at an angle round the grasped section, from its frame's e1.
  void grip(double round_rad) noexcept { round_rad_ = round_rad; }
  /// Sets or takes off the clip as the button and the commands ask. Before the hand turns the organ.
  void setHolders(const JawState& jaw, OrganState& organ, std::uint32_t& events) noexcept;
  /// Moves the organ on by a tick: what nothing holds slips or relapses, content leaves, blood flows, the jaw
  /// bruises, checks end. `events`: gets ExerciseEvent bits.
  void step(const HollowOrgan& hollow, const JawState& jaw, OrganState& organ,
            std::uint32_t& events) noexcept;

  /// Returns the torque of weight and gas on the mobile part, N m: towards the angle of the start, beyond
  /// that from which it relapses.
  [[nodiscard]] static double relapse_Nm(const HollowOrgan& hollow, const OrganState& organ) noexcept;

 private:
  enum class Ask : std::uint8_t { kNothing, kOn, kOff };

  void slip(const HollowOrgan& hollow, OrganState& organ, std::uint32_t& events) noexcept;
  void moveContent(const HollowOrgan& hollow, double angle_rad, HollowPose& pose) noexcept;
  void press(const HollowOrgan& hollow, const JawState& jaw, OrganState& organ,
             std::uint32_t& events) noexcept;
  void mark(bool torn, OrganState& organ) const noexcept;
  void look(const JawState& jaw, OrganState& organ, std::uint32_t& events) noexcept;
  [[nodiscard]] double told(double flow, FlowCheck check, std::int32_t count) const noexcept;

  double tick_s_ = 0.001;
  std::uint64_t seed_ = 0;
  std::int64_t ticks_ = 0;
  Ask holdAsked_ = Ask::kNothing;
  Ask ventAsked_ = Ask::kNothing;
  FlowCheck checkAsked_ = FlowCheck::kNone;
  bool buttonDown_ = true;  // one that is held down at the start sets no clip
  bool relapsing_ = false;
  bool filled_ = false;     // gas_J_ is known: since the first tick
  double gas_J_ = 0.0;      // of a sealed gas
  double pressed_s_ = 0.0;  // so long the jaw has pressed too hard
  bool bruised_ = false;    // in this grip
  bool torn_ = false;
  double round_rad_ = 0.0;
  double checkedAt_rad_ = 0.0;
};
static_assert(std::is_trivially_copyable_v<DetorsionStep>);

}  // namespace torsio
