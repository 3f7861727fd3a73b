// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/record/trial.h"
#include "sim/scene/scene.h"

namespace torsio {

/// The first difference between a replay and the record.
struct ReplayDifference {
  std::int64_t tick = 0;
  std::string field;  ///< "torque", "phase" ...; "exact answers" when only the last bits differ
  double recorded = 0.0;
  double replayed = 0.0;
};

/// What a replay found.
struct ReplayReport {
  std::int64_t samples = 0;           ///< replayed
  std::int64_t differentSamples = 0;  ///< in an integer field or by a stored step or more
  std::int64_t chunks = 0;
  std::int64_t differentChunks = 0;          ///< whose exact doubles have another digest
  bool contentIntact = false;                ///< digests and content hash of the record itself fit
  std::optional<std::int64_t> gapAfterTick;  ///< the record lacks samples from here: replay stops
  std::optional<ReplayDifference> first;

  /// Tells whether the replay gave bit for bit what was recorded, from an intact record without a gap.
  [[nodiscard]] bool identical() const noexcept {
    return contentIntact && !gapAfterTick && differentSamples == 0 && differentChunks == 0;
  }
};

/// Runs the servo loop again over the recorded device samples and commands and compares: integers exactly,
/// answers in stored steps, and the digest over the exact bits of all answers, chunk by chunk. The loop
/// follows the rules that are stamped on the samples (kServoRules). Throws Error{kVerifyFailed} when `scene`
/// is not the one that was recorded (organ or parameters) or the rules are newer than this version, and
/// Error{kBadData} when the record cannot be decoded. `threads`: that may compute at the same time
/// (ExerciseAhead); 0: as many as the machine has. The report does not depend on it.
[[nodiscard]] ReplayReport replayTrial(const Scene& scene, const Trial& trial, unsigned threads = 0);

}  // namespace torsio
