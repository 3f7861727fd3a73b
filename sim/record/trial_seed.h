// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/core/ids.h"

namespace torsio {

/// Returns the seed of a trial: the twist that a hollow organ comes with and the errors of checks hang on it.
/// Of no id the same one always. Any thread.
[[nodiscard]] std::uint64_t detorsionSeed(const TrialId& trialId) noexcept;

}  // namespace torsio
