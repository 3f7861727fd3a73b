// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial.h"
#include "sim/servo/servo_loop.h"

namespace torsio {

/// What a trial of this scene with this device must remember to be replayed.
inline TrialHeader headerOf(const Scene& scene, const HapticDevice& device) {
  TrialHeader header;
  header.sceneId = scene.id;
  header.organHash = scene.organHash;
  header.parameterHash = scene.parameterHash;
  header.parametersJson = scene.parametersJson;
  header.deviceLimits = deviceLimits(device.capabilities());
  return header;
}

/// Runs a loop on a manual clock and packs its samples second by second; `afterTick` is called after each.
template <typename AfterTick>
Trial recordedTrial(ServoLoop& loop, TrialHeader header, std::int64_t seconds, const AfterTick& afterTick) {
  constexpr std::int64_t kTicks = 1000;  // a second
  Trial trial;
  trial.header = std::move(header);
  for (std::int64_t second = 0; second < seconds; ++second) {
    std::vector<Sample> samples;
    for (std::int64_t i = 0; i < kTicks; ++i) {
      loop.tick((second * kTicks + i) * kTickPeriod_us);
      samples.push_back(loop.lastSample());
      afterTick();
    }
    trial.chunks.push_back(encodeChunk(second, samples));
  }
  trial.summary = {seconds * kTicks, 0, loop.lateTicks(), TrialOutcome::kCompleted, {}};
  trial.summary.contentHash = contentHash(trial);
  return trial;
}

inline Trial recordedTrial(ServoLoop& loop, TrialHeader header, std::int64_t seconds) {
  return recordedTrial(loop, std::move(header), seconds, [] {});
}

/// The straight bar of the recordings in tests/data: its outline has the same bits on every machine.
[[nodiscard]] const Scene& recordedBar();

/// Runs a scripted hand for eight seconds on recordedBar(), and returns what the servo loop answered as a
/// finished trial. `tests/data/trials` was made by it.
[[nodiscard]] Trial recordOnBar(const TrialId& trialId, const std::string& traineeCode, TwistDrive drive);

}  // namespace torsio
