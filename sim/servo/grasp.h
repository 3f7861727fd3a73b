// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/core/live_types.h"
#include "sim/scene/organ_state.h"
#include "sim/servo/exercise_event.h"
#include "sim/servo/jaw_motion.h"

namespace torsio {

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
