// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "sim/record/trial.h"
#include "sim/scene/scene.h"

namespace torsio {

/// A trial of a scripted hand.
struct ScriptedTrial {
  std::string trialId;
  std::string traineeCode;  ///< empty: nobody's
  std::string phaseLabel;
  std::uint64_t personSeed = 1;  ///< decides how this person learns and trembles
  std::uint64_t trialSeed = 1;   ///< decides every deviation of this trial
  double duration_s = 20.0;
  double practisedBefore_min = 0.0;
  double practiceScale = 1.0;  ///< minutes of practice that one minute of the trial stands for
  std::int64_t startedUtc_us = 0;
  bool demonstration = false;
};

/// The wiring of the whole flow, on a manual clock: scripted hand -> servo loop -> ring -> recorder -> sink.
/// Runs as fast as it can; the sink sees exactly what a real-time trial would give it. Throws what the sink
/// throws.
TrialSummary recordScriptedTrial(const Scene& scene, const ScriptedTrial& trial, TrialSink& sink);

}  // namespace torsio
