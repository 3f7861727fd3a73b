// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "assessment/attempt/measured_trial.h"
#include "sim/record/trial.h"

namespace torsio {

/// What leads the instrument in a random run.
enum class HostileHand {
  kCareful,     ///< a planned twist or untwisting, possibly pressing too deep
  kFromBehind,  ///< the same from the other side of the organ
  kWheel,       ///< mouse and wheel, pushed through the organ, gripping wherever that ends
  kWandering,   ///< around the organ and into it, gripping now and then
};
inline constexpr std::array kHostileHands{HostileHand::kCareful, HostileHand::kFromBehind,
                                          HostileHand::kWheel, HostileHand::kWandering};

/// A recorded run and the rules of its exercise except the force limit.
struct HostileRun {
  HostileHand hand = HostileHand::kCareful;
  std::string scene;
  Trial trial;
  AttemptRules rules;
};

/// Creates run number `stream`, the same on every machine: a random hand on the training centre's bar, or in
/// every fifth run on a shipped organ (twist on sections, rod, untwisting). The device is read at one of the
/// adapters' rates (1, 2, 5, 8, 16 ms), renders a random share of the force, and may be lost or return
/// garbage for a moment; single readings are up to 30 mm off, preferably at the first contact, when the jaw
/// opens and at chunk boundaries of the recording. Commands are interspersed, and the run may end at any
/// moment.
[[nodiscard]] HostileRun hostileRun(std::uint64_t seed, std::uint64_t stream);

}  // namespace torsio
