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
  std::uint64_t personSeed = 1;  ///< decides how this person learns and trembles
  std::uint64_t trialSeed = 1;   ///< decides every deviation of this trial
  double duration_s = 20.0;      ///< of an organ that is undone at least until it has been left alone
  double practisedBefore_min = 0.0;
  double practiceScale = 1.0;  ///< minutes of practice that one minute of the trial stands for
  /// Twists that the hand makes at least: the trial is longer when it needs to be, and then stands for the
  /// same practice as a whole.
  std::size_t fewestTwists = 0;
  /// Turns that the hand leaves out at the end of an untwisting; the first one is always made.
  std::size_t turnsLeftOut = 0;
  /// How far the jaw closes on an organ that is undone, 0 .. 1; none: as its wall bears well.
  std::optional<double> closure{};
};

/// Records a scripted hand (RecordedRun) as fast as the machine can; the sink sees exactly what a real-time
/// trial would give it. Throws what the sink throws.
TrialSummary recordScriptedTrial(const Scene& scene, const ScriptedTrial& trial, TrialSink& sink);

/// Records one twist to `target_rad` by a scripted hand that has nothing left to learn (RecordedRun); the
/// same every time. Takes a fraction of a second. Throws Error{kBadParameter} when the hand cannot reach the
/// organ.
[[nodiscard]] Trial expertRun(const Scene& scene, double target_rad);

/// Label of stored expert runs (TrialHeader::phaseLabel).
inline constexpr const char* kExpertPhase = "example by an instructor";

}  // namespace torsio
