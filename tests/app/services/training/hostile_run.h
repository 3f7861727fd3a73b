// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "assessment/attempt/measured_trial.h"
#include "sim/record/trial.h"

namespace torsio::testing {

/// What leads the instrument in a run by chance.
enum class HostileHand {
  kCareful,     ///< a planned twist, or an untwisting, that may press too deep
  kFromBehind,  ///< the same from the other side of the organ
  kWheel,       ///< mouse and wheel, pushed on through the organ, gripping wherever that ends
  kWandering,   ///< round the organ and into it, gripping now and then
};
inline constexpr std::array kHostileHands{HostileHand::kCareful, HostileHand::kFromBehind,
                                          HostileHand::kWheel, HostileHand::kWandering};

/// A recorded run and the rules of its exercise, but for the limit of force.
struct HostileRun {
  HostileHand hand = HostileHand::kCareful;
  std::string scene;
  Trial trial;
  AttemptRules rules;
};

/// Makes run number `stream`, the same on every machine: a hand by chance on the bar of the training centre,
/// in every fifth run on a shipped organ (twist on sections, rod, untwisting). The device is read at the
/// rate of one of the adapters (1, 2, 5, 8, 16 ms), gives as little force as chance has it, may be lost or
/// give nonsense for a moment; single readings are up to 30 mm off, by preference at the first contact, as
/// the jaw opens and where two chunks of the recording meet. Commands come in between, and the time may end
/// at any moment.
[[nodiscard]] HostileRun hostileRun(std::uint64_t seed, std::uint64_t stream);

}  // namespace torsio::testing
