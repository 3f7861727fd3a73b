// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

#include "sim/core/device_sample.h"
#include "sim/core/live_types.h"
#include "sim/scene/organ_state.h"
#include "sim/tissue/twist/twist_model.h"

namespace torsio {

/// Distance from the axis within which the tangential drive holds its angle.
inline constexpr double kNearAxis_m = 0.002;

/// Returns the distance of a point from an axis, m.
[[nodiscard]] double radiusAbout_m(const AxisFrame& axis, const Vec3& point_m) noexcept;

/// How the jaw has turned and moved about the axis of the grasped section since it closed. A plain value;
/// servo thread.
class JawMotion {
 public:
  explicit JawMotion(TwistDrive drive) noexcept : drive_(drive) {}

  /// Closes the jaw; the organ is turned by `organ_rad`.
  void close(const AxisFrame& axis, const ToolState& tool, double organ_rad) noexcept;
  /// Follows the tool of this tick.
  void follow(const ToolState& tool) noexcept { angle_rad_ = driveAngle(tool); }

  [[nodiscard]] const AxisFrame& axis() const noexcept { return axis_; }
  [[nodiscard]] TwistDrive drive() const noexcept { return drive_; }
  /// Returns the turn since the jaw closed or restart().
  [[nodiscard]] double turn_rad() const noexcept { return angle_rad_ - firstAngle_rad_; }
  /// Counts the turn from here on.
  void restart() noexcept { firstAngle_rad_ = angle_rad_; }
  /// Takes a part of the turn off: the jaw did not follow the hand.
  void takeOff(double turn_rad) noexcept { firstAngle_rad_ += turn_rad; }
  /// Returns how far the tip has moved along and across the axis.
  [[nodiscard]] Vec3 drift_m(const ToolState& tool) const noexcept;
  /// Returns the tool carried round the axis with the tissue, which is turned by `organ_rad`: a hand that
  /// twists by rolling may stay in place.
  [[nodiscard]] ToolState carried(const ToolState& tool, double organ_rad) const noexcept;

 private:
  [[nodiscard]] double tipAngle(const ToolState& tool) const noexcept;
  [[nodiscard]] double driveAngle(const ToolState& tool) const noexcept;

  TwistDrive drive_;
  AxisFrame axis_;
  double firstAngle_rad_ = 0.0;
  double angle_rad_ = 0.0;      // of the tool about the axis, unwrapped
  double organFrom_rad_ = 0.0;  // the rest: when the jaw closed
  double tipFrom_rad_ = 0.0;
  Quat orientationFrom_;
  double radiusFrom_m_ = 0.0;
  double heightFrom_m_ = 0.0;
};
static_assert(std::is_trivially_copyable_v<JawMotion>);

/// What happened in one tick; bits of ExerciseStep::events.
enum ExerciseEvent : std::uint32_t {
  kEventNone = 0,
  kEventTouched = 1U << 0,   ///< Tracking to Contact
  kEventLeft = 1U << 1,      ///< Contact to Tracking
  kEventGripped = 1U << 2,   ///< Contact to Twisting: the jaw holds the organ
  kEventReleased = 1U << 3,  ///< Twisting to Released: the jaw opened, or a view or a lost device let go
  kEventSlipped = 1U << 4,   ///< with kEventReleased: the tool pulled itself free
  kEventReturned = 1U << 5,  ///< the organ is at rest again
  kEventShaftTouched = 1U << 6,
  kEventShaftLeft = 1U << 7,
  kEventFolded = 1U << 8,  ///< with kEventReleased: the tissue would have folded, or slipped back by a turn
  // Of a hollow organ that came twisted.
  kEventBruised = 1U << 9,     ///< the jaw has pressed too hard for too long
  kEventTorn = 1U << 10,       ///< through the wall: the content leaves
  kEventClipped = 1U << 11,    ///< a clip or an assistant holds the mobile part
  kEventUnclipped = 1U << 12,  ///< and has let go
  kEventChecked = 1U << 13,    ///< a check of the blood flow has its answer
  kEventRelapsing = 1U << 14,  ///< the mobile part begins to turn back by itself
};

/// Events of one tick with their time, for readers that must not miss one.
struct ExerciseMoment {
  std::int64_t tick = 0;
  std::int64_t time_us = 0;
  std::uint32_t events = kEventNone;               ///< ExerciseEvent bits
  ExercisePhase phase = ExercisePhase::kTracking;  ///< after them
  friend constexpr bool operator==(const ExerciseMoment&, const ExerciseMoment&) = default;
};
static_assert(std::is_trivially_copyable_v<ExerciseMoment>);

/// Distance from the grasped section at which the jaw slips off.
inline constexpr double kSlipWay_m = 0.020;

/// What the instrument does to the organ in one tick.
struct JawState {
  std::int64_t time_us = 0;   ///< servo time
  bool holds = false;         ///< the jaw holds tissue
  bool touches = false;       ///< the instrument touches the organ
  bool secondButton = false;  ///< of the stylus
  double closure = 0.0;       ///< of the jaw, 0 .. 1
  double pull_N = 0.0;        ///< force of the hand on the organ, in the tick before
};

/// What the hand feels of the grasped tissue.
struct GripFeel {
  double torque_Nm = 0.0;
  Vec3 force_N{};
  bool late = false;  ///< the tissue's model has not answered in time: nothing is felt, not even the jaw
};

/// State of a released organ after a tick.
enum class TissueReturn : std::uint8_t {
  kMoving,    ///< on its way back
  kReturned,  ///< at rest, where it was at first or in another balance
  kStays,     ///< does not return by itself
};

/// The calls of GraspedTissue that most kinds of organ ignore or answer alike. A kind derives from it and
/// hides what it does otherwise.
struct CommonTissue {
  /// Returns how the organ lies at the start of the trial of this seed.
  [[nodiscard]] OrganState start(std::uint64_t /*seed*/) const { return {}; }
  /// Takes a command, for the next step.
  void apply(const ServoCommand& /*command*/) noexcept {}
  /// Takes what the tissue's model delivered before this tick, if it runs outside the servo.
  void takeAnswer(const AsyncAnswer& /*answer*/) noexcept {}
  /// Sets or takes off what holds the organ besides the jaw. Before the hand turns it.
  void setHolders(const JawState& /*jaw*/, OrganState& /*organ*/, std::uint32_t& /*events*/) noexcept {}
  /// Moves the organ on by a tick after the hand has turned it: friction, content, blood. Returns the energy
  /// that the tissue brings along into the grip, J.
  [[nodiscard]] double step(const JawState& /*jaw*/, OrganState& /*organ*/,
                            std::uint32_t& /*events*/) noexcept {
    return 0.0;
  }
  /// Returns the tool as it lies against tissue that is turned by a rolling hand.
  [[nodiscard]] ToolState carried(const ToolState& tool, const JawMotion& motion,
                                  const OrganState& organ) const noexcept {
    return motion.carried(tool, organ.twist.graspAngle_rad);
  }
  /// Tells whether the kind's own coupling keeps the jaw on the grasped section.
  [[nodiscard]] bool keepsJaw() const noexcept { return false; }
  /// Tells whether the organ returns to OrganState{} with nothing of the past left in the tissue.
  [[nodiscard]] bool forgets() const noexcept { return true; }
};

}  // namespace torsio
