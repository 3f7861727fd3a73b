// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "assessment/metrics/detorsion.h"
#include "assessment/statistics/values.h"
#include "sim/base/live_types.h"

namespace torsio {

/// Whether a recording is that of an organ which came twisted and is to be undone.
[[nodiscard]] bool comesTwisted(std::span<const Sample> samples) noexcept;

/// Measures the untwisting of a recording that comesTwisted. `times_us` (sampleTimes) has one entry a sample;
/// without `peakShear_Pa` the stress of the wall stays undefined. Undefined as a whole with fewer than two
/// samples, a gap of more than 20 ms, or no rules.
[[nodiscard]] Outcome<DetorsionMetrics> measureRecordedDetorsion(
    std::span<const Sample> samples, std::span<const std::int64_t> times_us,
    const std::optional<DetorsionRules>& rules,
    const std::function<double(const Sample& sample)>& peakShear_Pa = {});

}  // namespace torsio
