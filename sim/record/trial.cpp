// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/record/trial.h"

#include "sim/core/random.h"

namespace torsio {

std::uint64_t detorsionSeed(const TrialId& trialId) noexcept {
  std::uint64_t hash = 0xCBF29CE484222325ULL;  // FNV-1a
  for (const char c : trialId.text()) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  }
  return mixedBits(hash);
}

}  // namespace torsio
