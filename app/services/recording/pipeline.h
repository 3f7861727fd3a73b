// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "app/services/recording/recording_spec.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"

namespace torsio {

/// A trial of a scripted hand.
struct ScriptedTrial {
  RecordingSpec recording{};
  std::uint64_t personSeed = 1;  ///< determines this person's learning and tremor
  std::uint64_t trialSeed = 1;   ///< determines every deviation of this trial
  double duration_s = 20.0;      ///< when untwisting, at least until the organ has been left alone
  double practisedBefore_min = 0.0;
  double practiceScale = 1.0;  ///< minutes of practice represented by one minute of the trial
  /// Minimum number of twists: the trial is longer if necessary and then represents the same total practice.
  std::size_t fewestTwists = 0;
  /// Turns that the hand omits at the end of an untwisting; the first one is always made.
  std::size_t turnsLeftOut = 0;
  /// Jaw closure on an organ being untwisted, 0 .. 1; empty: what its wall tolerates well.
  std::optional<double> closure{};
};

/// Records a scripted hand (RecordedRun) as fast as possible; the sink receives exactly what a real-time
/// trial would give it. Throws what the sink throws.
TrialSummary recordScriptedTrial(const Scene& scene, const ScriptedTrial& trial, TrialSink& sink);

/// Records one twist to `target_rad` by a scripted expert hand (RecordedRun); reproducible. Takes a fraction
/// of a second. Throws Error{kBadParameter} if the hand cannot reach the organ.
[[nodiscard]] Trial expertRun(const Scene& scene, double target_rad);

/// Label of stored expert runs (TrialHeader::phaseLabel).
inline constexpr const char* kExpertPhase = "example by an instructor";

}  // namespace torsio
