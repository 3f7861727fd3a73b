// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

namespace torsio {

enum class BesideState : std::uint8_t {
  kNothing = 0,  ///< nothing arrived
  kSound = 1,    ///< the numbers are finite
  kBroken = 2,   ///< the model has failed or said something that is no number; the others are then 0
};

/// What a model beside the servo says of the grip: an input of the tick in which it arrives, recorded with
/// that tick as the device's sample is. SI.
struct BesideAnswer {
  BesideState state = BesideState::kNothing;
  double angle_rad = 0.0;         ///< at which it was computed
  double torque_Nm = 0.0;         ///< of the jaw there
  double slope_Nm_per_rad = 0.0;  ///< of the torque over the angle
  friend constexpr bool operator==(const BesideAnswer&, const BesideAnswer&) = default;
};
static_assert(std::is_trivially_copyable_v<BesideAnswer>);

}  // namespace torsio
